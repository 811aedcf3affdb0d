// SPDX-License-Identifier: MIT
#include "attractor/colour/srgb_transfer.h"
#include "attractor/folds/chaos_game_fold.h"
#include "attractor/folds/density_fold.h"
#include "attractor/folds/drawing.h"
#include "attractor/systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>
#include <random>

using namespace attractor;

namespace {

constexpr int side = 48;      // cells of the picture
constexpr int coarse = 12;    // cells in one of the means
constexpr double full = 4095; // of a channel
constexpr int columns = side / coarse;

struct Mean {
    double red = 0;
    double samples = 0;
};
using Means = std::vector<Mean>;

std::size_t coarseCell(double x, double y) {
    return std::size_t(y / coarse) * columns + std::size_t(x / coarse);
}

Means meansOf(const CellSums& sums) {
    Means means(columns * columns);
    std::vector<CellSums::Sum> row;
    for (int y = 0; y < side; ++y) {
        if (!sums.sumsOfRow(y, row)) continue;
        for (int x = 0; x < side; ++x) {
            Mean& mean = means[coarseCell(x, y)];
            mean.red += double(row[std::size_t(x)].red) / full;
            mean.samples += double(row[std::size_t(x)].samples);
        }
    }
    return means;
}

// Flames as they are defined: one orbit, whose colour goes with it.
Means bruteForce(const PreparedRequest& prepared, const std::vector<MapBlend>& blends) {
    const PreparedSystem& system = prepared.system();
    std::mt19937_64 random(5);
    std::discrete_distribution<std::size_t> next(system.probabilities.begin(), system.probabilities.end());
    ifs::Vector<2> x = system.centre;
    double c = 0.5;
    Means means(columns * columns);
    for (int n = 0; n < 4'000'000; ++n) {
        const std::size_t i = next(random);
        x = system.maps[i](x);
        c = (1 - blends[i].speed) * c + blends[i].speed * blends[i].coordinate;
        const ifs::Vector<2> cell = prepared.projection().cell(x);
        if (n < 100 || !(cell.minCoeff() >= 0 && cell.maxCoeff() < side)) continue;
        Mean& mean = means[coarseCell(cell.x(), cell.y())];
        const double code = colourAt(prepared.request().appearance.palette, c).red;
        mean.red += linearLight(std::uint8_t(code));
        mean.samples += 1;
    }
    return means;
}

} // namespace

class TestBlendFold : public QObject {
    Q_OBJECT

private slots:
    void meansAreThoseOfTheChaosGame_data() {
        QTest::addColumn<std::vector<double>>("speeds");
        QTest::addColumn<double>("tolerance"); // of red light from 0 to 1
        QTest::newRow("usual") << std::vector<double>{0.5, 0.5, 0.5, 0.5} << 0.01;
        QTest::newRow("fast") << std::vector<double>{1, 0.9, 0.95, 0.8} << 0.01;
        QTest::newRow("slow") << std::vector<double>{0.3, 0.05, 0.2, 0.2} << 0.02;
        QTest::newRow("mixed") << std::vector<double>{0, 0.4, 1, 0.1} << 0.02;
    }
    void meansAreThoseOfTheChaosGame() {
        QFETCH(std::vector<double>, speeds);
        QFETCH(double, tolerance);
        const std::vector<double> places{0.9, 0.4, 0, 1};
        RenderRequest request = systems::request(systems::fern(), 4'000'000, side, side);
        request.appearance.colourBy = ColourBy::Blend;
        request.appearance.palette = {"red", {{0, {0, 0, 0, 255}}, {1, {255, 0, 0, 255}}}};
        request.threads = 2;
        std::vector<MapBlend> blends;
        for (std::size_t i = 0; i < 4; ++i) {
            blends.push_back({places[i], speeds[i]});
            request.appearance.mapBlends[request.system.maps[i].id] = blends.back();
        }
        folds::Drawing<DensityFold> density(request);
        QVERIFY(density.pass(request.samples));
        request.algorithm = Algorithm::ChaosGame;
        folds::Drawing<ChaosGameFold> orbit(request);
        QVERIFY(orbit.pass(request.samples));
        const Means wanted = bruteForce(density.prepared, blends);
        const Means byWords = meansOf(density.sums()), byPoints = meansOf(orbit.sums());
        int compared = 0;
        for (std::size_t k = 0; k < wanted.size(); ++k) {
            if (wanted[k].samples < 20'000) continue;
            const double red = wanted[k].red / wanted[k].samples;
            const double ofWords = byWords[k].red / byWords[k].samples;
            QVERIFY2(std::abs(ofWords - red) < tolerance,
                     qPrintable(QStringLiteral("cell %1: %2, not %3").arg(k).arg(ofWords).arg(red)));
            QVERIFY(std::abs(byPoints[k].red / byPoints[k].samples - red) < 0.01);
            ++compared;
        }
        QVERIFY(compared >= 6);
    }
};

BARYCAGE_TEST(TestBlendFold);
#include "blend_fold_test.moc"
