// SPDX-License-Identifier: MIT
#include "attractor/samples/linked_samples.h"

#include "attractor/cut/address_cut.h"
#include "attractor/folds/chaos_game_fold.h"
#include "attractor/folds/density_fold.h"
#include "attractor/folds/drawing.h"
#include "attractor/folds/prefractal_fold.h"
#include "attractor/samples/chaos_game.h"
#include "attractor/systems.h"
#include "ifs/links/linked_measure.h"
#include "ifs/links/linked_systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <numeric>
#include <set>

using namespace attractor;
using namespace linked_systems;

namespace {

std::vector<SampleSet> drawn(const PreparedSystem& system) {
    std::vector<SampleSet> sets(1 + std::ranges::max(system.sampleSetOf));
    drawLinkedSamples(system, 1, 0, sets);
    return sets;
}

double meanX(const PreparedSystem& system, const SampleSet& set) {
    return system.centre.x() + system.halfExtent.x() *
                                   std::accumulate(set.x.begin(), set.x.begin() + SampleSet::size, 0.0) /
                                   SampleSet::size;
}

// Rauzy's tile, and a map that comes once in a hundred thousand steps.
System rarely() {
    System result = rauzy();
    ifs::append(result, similarity(.3, .2), 1e-5);
    return result;
}

} // namespace

class TestLinkedSamples : public QObject {
    Q_OBJECT

private slots:
    void setsAreWhatTheMapsAreAppliedTo() {
        const PreparedSystem system = prepared(threeOnALine());
        QCOMPARE(system.sampleSetOf, (std::vector<std::uint32_t>{0, 1, 2}));
        const auto sets = drawn(system);
        const double known[]{39 / 44.0, 13 / 44.0, 58 / 88.0};
        for (std::size_t j = 0; j < 3; ++j)
            QVERIFY(std::abs(meanX(system, sets[j]) - known[j]) < 0.01);
        for (const SampleSet& set : sets) {
            QVERIFY(set.lowX >= -1 && set.highX <= 1 && set.lowX < set.highX);
            QVERIFY(
                std::equal(set.x.begin(), set.x.begin() + SampleSet::size, set.x.begin() + SampleSet::size));
        }
        const auto again = drawn(system);
        QVERIFY(again[2].x == sets[2].x);
    }

    void likeColumnsShareASet() {
        QCOMPARE(prepared(rauzy()).sampleSetOf, (std::vector<std::uint32_t>{0, 1, 2}));
        System system = threeOnALine();
        ifs::setLinks(system, std::vector<double>{1, 2, 1, 1, 2, 0, 1, 2, 1});
        QCOMPARE(prepared(system).sampleSetOf, (std::vector<std::uint32_t>{0, 0, 1}));
    }

    // Also of a map that an orbit hardly ever comes to.
    void setsOfRareMapsAreFull() {
        const PreparedSystem system = prepared(rarely());
        const auto sets = drawn(system);
        std::set<float> different(sets.back().x.begin(), sets.back().x.begin() + SampleSet::size);
        QVERIFY(different.size() > SampleSet::size / 4);
    }

    void partsThatNeverMeetAreAllDrawn() {
        System system = threeOnALine();
        ifs::setLinks(system, std::vector<double>{1, 0, 0, 0, 1, 1, 0, 1, 1});
        const PreparedSystem linked = prepared(system);
        for (const SampleSet& set : drawn(linked))
            QVERIFY(std::abs(set.x[0]) <= 1 && std::abs(set.x[SampleSet::size - 1]) <= 1);
        folds::Drawing<DensityFold> drawing(systems::request(system, 100'000, 300, 100));
        QVERIFY(drawing.pass(100'000));
        const auto counts = folds::countsOf(drawing.sums());
        QVERIFY(std::ranges::max(counts) > 30'000); // the fixed point of the first map: a third of all
    }

    // Σ p_σ w_σ(samples) has the moments of the measure.
    void wordsMakeUpTheMeasure() {
        for (const System& code : {threeOnALine(), goldenMean(), rauzy(), dragonBoundary(), rarely()}) {
            const PreparedSystem system = prepared(code);
            QVERIFY(system.note == RenderNote::None);
            const auto sets = drawn(system);
            const Camera camera = systems::camera(code, 400, 400);
            CutSettings settings;
            settings.words = 256;
            const Projection seen = projection(camera, {}, 1);
            const AddressCut cut = addressCut(system, seen, settings);
            QVERIFY(cut.words.size() > 10);
            QVERIFY(std::abs(cut.probability - 1) < 1e-12);
            double x = 0, y = 0;
            for (std::size_t k = 0; k < cut.words.size(); ++k) {
                const Word& word = cut.words[k];
                const SampleSet& set = sets[cut.sampleSet(k)];
                const double a = std::accumulate(set.x.begin(), set.x.begin() + SampleSet::size, 0.0);
                const double b = std::accumulate(set.y.begin(), set.y.begin() + SampleSet::size, 0.0);
                x += word.probability * (word.x + (word.xx * a + word.xy * b) / SampleSet::size);
                y += word.probability * (word.y + (word.yx * a + word.yy * b) / SampleSet::size);
            }
            const auto moments = ifs::linkedMoments<2>(system);
            const ifs::Vector<2> mean = seen.cell(moments->mean);
            QVERIFY((mean - ifs::Vector<2>(x, y)).norm() < 0.5);
        }
    }

    void orbitsKeepToTheLinks() {
        const PreparedSystem system = prepared(threeOnALine());
        Orbit orbit(system, 7);
        std::array<int, 3> counts{};
        std::uint32_t before = orbit.next().lastMap;
        for (int n = 0; n < 40'000; ++n) {
            const auto point = orbit.next();
            QVERIFY(system.links[before * 3 + point.lastMap] > 0);
            before = point.lastMap;
            ++counts[before];
            QVERIFY(point.x.x() >= 7 / 26.0 - 1e-6 && point.x.x() <= 1 + 1e-6);
        }
        QVERIFY(std::abs(counts[0] - 10'000) < 400 && std::abs(counts[2] - 20'000) < 400);
    }

    // The areas of the parts of Rauzy's tile are as 1 : 1/t : 1/t² with the tribonacci root t.
    void areasOfTheRauzyTile() {
        const PreparedSystem system = prepared(rauzy());
        constexpr int side = 256;
        std::array<std::vector<char>, 3> covered;
        covered.fill(std::vector<char>(side * side, 0));
        Orbit orbit(system, 3);
        for (int n = 0; n < 4'000'000; ++n) {
            const auto point = orbit.next();
            const ifs::Vector<2> at = (point.x - system.centre).cwiseQuotient(system.halfExtent);
            const int column = int((at.x() + 1) / 2 * side), row = int((at.y() + 1) / 2 * side);
            covered[point.lastMap][std::size_t(row * side + column)] = 1;
        }
        std::array<double, 3> area{};
        for (std::size_t j = 0; j < 3; ++j)
            area[j] = std::accumulate(covered[j].begin(), covered[j].end(), 0.0);
        QVERIFY(area[2] > 1000);
        QVERIFY(std::abs(area[0] / area[1] - tribonacci) < 0.1);
        QVERIFY(std::abs(area[1] / area[2] - tribonacci) < 0.1);
    }

    // The same system as the one without links, whatever constant its rows hold: the same pixels.
    void evenLinksChangeNothing() {
        for (const auto& plain : {systems::fern(), systems::maple()}) {
            auto linked = plain;
            const std::size_t n = plain.maps.size();
            std::vector<double> matrix;
            for (std::size_t i = 0; i < n * n; ++i)
                matrix.push_back(1 + double(i / n));
            ifs::setLinks(linked, matrix);
            QVERIFY(!linked.links.empty());
            for (const Algorithm algorithm :
                 {Algorithm::Density, Algorithm::ChaosGame, Algorithm::Deterministic}) {
                RenderRequest request = systems::request(plain, 200'000);
                request.algorithm = algorithm;
                request.iterations = 4;
                RenderRequest same = request;
                same.system = linked;
                QVERIFY(render(same).pixels == render(request).pixels);
            }
        }
    }

    // Density and chaos game count the same measure.
    void densityAgreesWithTheChaosGame() {
        for (const System& code : {rauzy(), dragonBoundary()}) {
            RenderRequest request = systems::request(code, 2'000'000, 24, 24);
            folds::Drawing<DensityFold> density(request);
            QVERIFY(density.pass(2'000'000));
            request.algorithm = Algorithm::ChaosGame;
            folds::Drawing<ChaosGameFold> chaos(request);
            QVERIFY(chaos.pass(2'000'000));
            const auto a = folds::countsOf(density.sums()), b = folds::countsOf(chaos.sums());
            double worst = 0;
            for (std::size_t k = 0; k < a.size(); ++k)
                worst = std::max(worst, std::abs(double(a[k]) - double(b[k])));
            QVERIFY2(worst < 0.002 * 2e6, QByteArray::number(worst));
        }
    }

    void theSameBytesForAnyThreads() {
        RenderRequest request = systems::request(rauzy(), 300'000);
        const auto one = render(request).pixels;
        request.threads = 3;
        QVERIFY(render(request).pixels == one);
    }

    // The images of the polygon under the admissible words alone.
    void imagesOfAdmissibleWords() {
        RenderRequest request = systems::request(threeOnALine(), 1, 810, 810);
        request.algorithm = Algorithm::Deterministic;
        request.iterations = 3;
        const std::vector<ifs::Vector<2>> corners{{0, -.1}, {1, -.1}, {1, .1}, {0, .1}};
        request.cage = ifs::ControlCage<2>{corners, corners};
        request.camera = fitted(request.camera, {0, -.5}, {1, .5});
        folds::Drawing<PrefractalFold> drawing(request);
        QVERIFY(drawing.pass(1));
        const auto counts = folds::countsOf(drawing.sums());
        const auto at = [&](int digits) { // the middle of the interval with these three digits, in thirds
            const double x =
                (digits / 100 % 10) / 3.0 + (digits / 10 % 10) / 9.0 + (digits % 10) / 27.0 + 1 / 54.0;
            const auto pixel = ifs::Vector<2>(worldToPixel(request.camera)(ifs::Vector<2>(x, 0)));
            return counts[std::size_t(405) * 810 + std::size_t(pixel.x())];
        };
        for (const int word : {222, 221, 210, 22, 21, 102}) // newest digit first: 3←3, 3←2, 2←1, 1←3
            QVERIFY2(at(word) > 0, QByteArray::number(word));
        for (const int word : {0, 111, 212, 220, 10, 120, 201})
            QVERIFY2(at(word) == 0, QByteArray::number(word));
    }

    void deepInside() {
        RenderRequest request = systems::request(rauzy(), 100'000, 200, 200);
        request.camera.centre = ifs::Vector<2>(*ifs::fixedPoint(rauzy().maps[0].map));
        request.camera.pixelsPerUnit = 1e14;
        const auto frame = render(request);
        QVERIFY(systems::meanGrey(frame) > 20); // 0 is an inner point of the tile
    }

    void hostileMatrices() {
        System system = threeOnALine();
        ifs::setLinks(system, std::vector<double>(9, 0));
        QVERIFY(prepared(system).note == RenderNote::NoMaps);
        QVERIFY(render(systems::request(system, 1000)).note == RenderNote::NoMaps);
        system = threeOnALine();
        for (auto& map : system.maps)
            map.map.linear *= 4;
        QVERIFY(prepared(system).note == RenderNote::NoAttractor);
        QCOMPARE(render(systems::request(system, 1000)).pixels.size(), std::size_t(320 * 200));
        system = threeOnALine();
        system.maps[1].map.translation.x() = std::numeric_limits<double>::infinity();
        QCOMPARE(prepared(system).index, (std::vector<std::size_t>{2})); // 1 and 2 need each other
    }
};

BARYCAGE_TEST(TestLinkedSamples);
#include "linked_samples_test.moc"
