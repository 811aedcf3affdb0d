// SPDX-License-Identifier: MIT
#include "attractor/folds/chaos_game_fold.h"

#include "attractor/folds/drawing.h"
#include "attractor/systems.h"
#include "support/named_test.h"

#include <QtTest>

using namespace attractor;

namespace {

using GameDrawing = folds::Drawing<ChaosGameFold>;

RenderRequest requestOf(std::uint64_t samples) {
    RenderRequest request = systems::request(systems::fern(), samples, 60, 40);
    request.algorithm = Algorithm::ChaosGame;
    request.seed = 7;
    return request;
}

// The cell of a point in the rows of the picture; nullopt outside.
std::optional<std::size_t> cellOf(const PreparedRequest& prepared, const ifs::Vector<2>& x) {
    const Projection& projection = prepared.projection();
    const ifs::Vector<2> cell = projection.cell(projection.cage(x));
    const Camera& camera = prepared.request().camera;
    if (!(cell.minCoeff() >= 0 && cell.x() < camera.width && cell.y() < camera.height)) return std::nullopt;
    return std::size_t(cell.y()) * std::size_t(camera.width) + std::size_t(cell.x());
}

} // namespace

class TestChaosGameFold : public QObject {
    Q_OBJECT

private slots:
    void plotsThePointsOfOneOrbit() {
        RenderRequest request = requestOf(20'000);
        request.camera.pixelsPerUnit *= 1.5; // some points are outside the picture
        GameDrawing drawing(request);
        QVERIFY(!drawing.fold.finished());
        QVERIFY(drawing.pass(request.samples));
        QVERIFY(drawing.fold.finished());
        QCOMPARE(drawing.fold.samples(), request.samples);
        std::vector<std::uint64_t> expected(60 * 40);
        std::uint64_t inside = 0;
        Orbit orbit(drawing.prepared.system(), request.seed);
        for (std::uint64_t n = 0; n < request.samples; ++n)
            if (const auto cell = cellOf(drawing.prepared, orbit.next().x)) {
                ++expected[*cell];
                ++inside;
            }
        QVERIFY(inside > 1000 && inside < request.samples);
        QVERIFY(folds::countsOf(drawing.sums()) == expected);
    }

    void samplesHaveTheColoursOfTheirPoints() {
        RenderRequest request = requestOf(3000);
        request.appearance.colourBy = ColourBy::Map;
        GameDrawing drawing(request);
        QVERIFY(drawing.pass(request.samples));
        std::uint64_t red = 0, expected = 0;
        std::vector<CellSums::Sum> row;
        for (int y = 0; y < request.camera.height; ++y) {
            drawing.sums().sumsOfRow(y, row);
            for (const CellSums::Sum& sum : row)
                red += sum.red;
        }
        Orbit orbit(drawing.prepared.system(), request.seed);
        for (std::uint64_t n = 0; n < request.samples; ++n) {
            const Orbit::Point point = orbit.next();
            if (cellOf(drawing.prepared, point.x))
                expected += drawing.prepared.colourOf(point.lastMap, point.addressCoordinate).red;
        }
        QVERIFY(expected > 0);
        QCOMPARE(red, expected);
    }

    // The orbit goes on where the last pass has left it, up to what the request asks for.
    void passesAreOneOrbit() {
        const RenderRequest request = requestOf(20'000);
        GameDrawing whole(request);
        QVERIFY(whole.pass(20'000));
        GameDrawing parts(request);
        QVERIFY(parts.pass(1));
        QVERIFY(parts.pass(9999));
        QCOMPARE(parts.fold.samples(), std::uint64_t{10'000});
        QVERIFY(!parts.fold.finished());
        QVERIFY(parts.pass(1'000'000));
        QVERIFY(parts.fold.finished());
        QCOMPARE(parts.fold.samples(), std::uint64_t{20'000});
        QVERIFY(folds::countsOf(parts.sums()) == folds::countsOf(whole.sums()));
        parts.rewind();
        QCOMPARE(folds::totalOf(parts.sums()), std::uint64_t{0});
        QVERIFY(!parts.fold.finished());
        QVERIFY(parts.pass(20'000));
        QVERIFY(folds::countsOf(parts.sums()) == folds::countsOf(whole.sums()));
    }

    void aStoppedPassIsCompleted() {
        const RenderRequest request = requestOf(20'000);
        GameDrawing drawing(request);
        drawing.fold.begin(request.samples);
        std::stop_source stopped;
        stopped.request_stop();
        QVERIFY(!drawing.fold.complete(stopped.get_token()));
        QVERIFY(drawing.fold.interrupted() && !drawing.fold.finished());
        QVERIFY(drawing.fold.complete({}));
        QVERIFY(!drawing.fold.interrupted() && drawing.fold.finished());
        QCOMPARE(drawing.fold.samples(), request.samples);
    }
};

BARYCAGE_TEST(TestChaosGameFold);
#include "chaos_game_fold_test.moc"
