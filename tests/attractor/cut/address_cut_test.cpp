// SPDX-License-Identifier: MIT
#include "attractor/cut/address_cut.h"

#include "attractor/cells/cell_sums.h"
#include "attractor/cells/splat.h"
#include "attractor/samples/chaos_game.h"
#include "attractor/systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <random>
#include <set>

using namespace attractor;

namespace {

AddressCut cutOf(const ifs::IteratedFunctionSystem<2>& system, const Camera& camera, int words = 512) {
    CutSettings settings;
    settings.words = words;
    return addressCut(prepared(system), projection(camera, {}, 1), settings);
}

std::vector<std::uint32_t> counted(const AddressCut& cut, const SampleSet& samples, const CellWindow& window,
                                   double perMeasure) {
    std::vector<std::uint32_t> counts(window.cells() + overflowCells);
    for (const Word& word : cut.words)
        splat(word, samples, static_cast<std::uint64_t>(word.probability * perMeasure), window,
              counts.data());
    return counts;
}

} // namespace

class TestAddressCut : public QObject {
    Q_OBJECT

private slots:
    void wordsShareTheWholeMeasure() {
        for (const auto& system : {systems::maple(), systems::fern(), systems::flower(), systems::dragon()}) {
            const AddressCut cut = cutOf(system, systems::camera(system, 300, 200));
            QVERIFY(std::abs(cut.probability - 1) < 1e-12);
            double sum = 0;
            for (const Word& word : cut.words) {
                sum += word.probability;
                QVERIFY(word.probability <= 1.0 / 512 || std::abs(word.xx) + std::abs(word.xy) < 1);
                QVERIFY(word.addressCoordinate > 0 && word.addressCoordinate < 1);
            }
            QVERIFY(std::abs(sum - 1) < 1e-12);
        }
    }

    // The union over the words is the measure: its mean is the exact one.
    void meanOverTheWordsIsExact() {
        const PreparedSystem system = prepared(systems::fern());
        const Camera camera = systems::camera(systems::fern(), 400, 400);
        const AddressCut cut = cutOf(systems::fern(), camera);
        SampleSet samples;
        ifs::Vector<2> sum = ifs::Vector<2>::Zero();
        double n = 0;
        for (std::uint64_t pass = 0; pass < 4; ++pass) {
            drawSamples(system, 3, pass, samples);
            for (const Word& word : cut.words)
                for (std::uint32_t k = 0; k < 64; ++k) {
                    const float x = samples.x[word.offset + k];
                    const float y = samples.y[word.offset + k];
                    sum += word.probability * ifs::Vector<2>(word.xx * x + word.xy * y + word.x,
                                                             word.yx * x + word.yy * y + word.y);
                }
            n += 64;
        }
        const ifs::Vector<2> mean = toWorld(camera, sum / n);
        QVERIFY(std::abs(mean.x() - 0.796833224540832) < 0.01);
        QVERIFY(std::abs(mean.y() - 6.167579195598532) < 0.02);
    }

    void cullingChangesNothingInTheView() {
        const auto maple = systems::maple();
        const Camera camera = systems::camera(maple, 320, 320);
        const AddressCut whole = cutOf(maple, camera);
        SampleSet samples;
        drawSamples(prepared(maple), 1, 0, samples);
        const CellWindow all{320, 0, 320};
        const CellWindow part{320, 96, 160};
        const auto everything = counted(whole, samples, all, 2e6);
        const auto rows = counted(whole, samples, part, 2e6);
        for (std::size_t cell = 0; cell < part.cells(); ++cell)
            QCOMPARE(rows[cell], everything[cell + 96U * 320U]);
    }

    // Two Takagi curves: the words 13 and 31 are the same map, and so are 24 and 42.
    void wordsOfOneMapBecomeOne() {
        const auto system = systems::system({{{.5, 0, .5, .5, 0, 0}, .25},
                                             {{.5, 0, -.5, .5, .5, .5}, .25},
                                             {{.5, 0, -.5, .5, 0, 0}, .25},
                                             {{.5, 0, .5, .5, .5, -.5}, .25}});
        QVERIFY(prepared(system).coincides);
        QVERIFY(!prepared(systems::maple()).coincides);
        QVERIFY(!prepared(systems::fern()).coincides);
        const Camera camera = systems::camera(system, 320, 320);
        CutSettings settings;
        settings.words = 256;
        const auto shown = [](const AddressCut& cut) {
            std::set<std::array<float, 6>> maps;
            for (const Word& word : cut.words)
                maps.insert(
                    {word.xx, word.xy, word.yx, word.yy, std::round(16 * word.x), std::round(16 * word.y)});
            return maps;
        };
        const AddressCut each = addressCut(prepared(system), projection(camera, {}, 1), settings);
        QVERIFY(shown(each).size() < each.words.size());
        settings.mergesCoinciding = true;
        const AddressCut merged = addressCut(prepared(system), projection(camera, {}, 1), settings);
        QCOMPARE(shown(merged).size(), merged.words.size());
        QVERIFY(merged.words.size() >= 256);
        QVERIFY(std::abs(merged.probability - each.probability) < 1e-12);
        for (const Word& word : merged.words)
            QVERIFY(word.probability <= 1.0 / 256);
    }

    void aStoppedCutIsEmpty() {
        std::stop_source stop;
        stop.request_stop();
        const Camera camera = systems::camera(systems::maple(), 320, 320);
        QVERIFY(addressCut(prepared(systems::maple()), projection(camera, {}, 1), {}, stop.get_token())
                    .words.empty());
    }

    // What a word that is partly in view has outside is drawn for nothing.
    void wordsAtTheBorderAreSmall() {
        const auto maple = systems::maple();
        Camera camera = systems::camera(maple, 640, 400);
        camera.pixelsPerUnit *= 16;
        CutSettings settings;
        settings.words = 128;
        const AddressCut coarse = addressCut(prepared(maple), attractor::projection(camera, {}, 1), settings);
        settings.samples = 1e6;
        const AddressCut cut = addressCut(prepared(maple), attractor::projection(camera, {}, 1), settings);
        QVERIFY(cut.probability < 0.8 * coarse.probability);
        int straddling = 0;
        for (const Word& word : cut.words) {
            const float halfX = std::abs(word.xx) + std::abs(word.xy);
            const float halfY = std::abs(word.yx) + std::abs(word.yy);
            if (word.x >= halfX && word.x + halfX <= 640 && word.y >= halfY && word.y + halfY <= 400)
                continue;
            ++straddling;
            QVERIFY(word.probability * settings.samples <= 512);
        }
        QVERIFY(straddling > 10);
    }

    // Around a corner of the gasket one word of each length fills the view; others only touch its edge.
    void zoomKeepsTheMeasureExactly() {
        const auto gasket = systems::sierpinski();
        for (const int depth : {4, 20, 40}) {
            Camera camera = systems::camera(gasket, 256, 256);
            camera.centre = {0, 0};
            camera.pixelsPerUnit =
                127 * std::pow(2.0, depth); // the view shows [0, 2^−depth)² and a little more
            const AddressCut cut = cutOf(gasket, camera);
            const double expected = std::pow(3.0, -depth);
            QVERIFY2(cut.probability > 0.999 * expected && cut.probability < 1.25 * expected,
                     qPrintable(QString::number(cut.probability / expected)));
            QVERIFY(cut.words.size() >= 512);
            for (const Word& word : cut.words)
                QVERIFY(std::abs(word.x) < 600 && std::abs(word.y) < 600);
        }
    }

    // Far inside, positions agree with those computed from the fixed point, which is the centre of the view.
    void deepWordsAreInPlace() {
        const auto fern = systems::fern();
        Camera camera = systems::camera(fern, 512, 512);
        const auto fixed = ifs::fixedPoint(fern.maps[1].map);
        QVERIFY(fixed.has_value());
        camera.centre = *fixed;
        const double scale = camera.pixelsPerUnit;
        const ifs::Matrix<2> a = fern.maps[1].map.linear;
        // Similarity of ratio r about the fixed point: zooming by r^−k and turning back gives the same
        // picture, so the measure in view shrinks by 0.85 a step up to what the other maps add and the view
        // cuts.
        const double r = ifs::spectralNorm<2>(a);
        camera.pixelsPerUnit = scale * std::pow(r, -60);
        const double at60 = cutOf(fern, camera).probability;
        camera.pixelsPerUnit = scale * std::pow(r, -160);
        const double at160 = cutOf(fern, camera).probability;
        QVERIFY(std::abs(std::log(at160 / at60) / 100 - std::log(0.85)) < 0.01);
    }

    void overlapsAreThinnedWithoutBias() {
        const auto maple = systems::maple();
        Camera camera = systems::camera(maple, 400, 300);
        const auto fixed = ifs::fixedPoint(maple.maps[2].map);
        camera.centre = *fixed;
        camera.pixelsPerUnit *= 1e8;
        CutSettings settings;
        settings.words = 512;
        double sum = 0;
        double squares = 0;
        constexpr int seeds = 6;
        for (int seed = 0; seed < seeds; ++seed) {
            settings.seed = static_cast<std::uint64_t>(seed) + 1;
            const AddressCut cut = addressCut(prepared(maple), projection(camera, {}, 1), settings);
            QVERIFY(!cut.words.empty());
            QVERIFY(cut.words.size() < 200'000);
            sum += cut.probability;
            squares += cut.probability * cut.probability;
        }
        const double mean = sum / seeds;
        QVERIFY(std::sqrt(std::abs(squares / seeds - mean * mean)) < 0.2 * mean);
    }

    // 200 maps, each a quarter of the square: 40,000 words, many over each point, and none stands for
    // another.
    void manyMapsAreNotThinned() {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> position(0, .75);
        ifs::IteratedFunctionSystem<2> system;
        system.maps.resize(200);
        for (auto& map : system.maps)
            map.map = ifs::affineMap(.25, 0, 0, .25, position(random), position(random));
        const AddressCut cut = cutOf(system, systems::camera(system, 400, 400), 610);
        QVERIFY(!cut.isThinned);
        QCOMPARE(cut.words.size(), std::size_t{40'000});
    }

    // Some of these maps stretch although words contract, as under a cage that shears: zoom is as deep as for
    // other maps.
    void shearedCodesAreDeepToo() {
        const ifs::AffineMap<2> shear = ifs::affineMap(1, 3, 0, 1, 0, 0);
        const auto sheared = *ifs::conjugate(shear, systems::flower());
        QVERIFY(ifs::spectralNorm<2>(sheared.maps[0].map.linear) > 1);
        const PreparedSystem system = prepared(sheared);
        QVERIFY(system.meanLogarithm < 0);
        Camera camera = systems::camera(sheared, 250, 250);
        camera.centre = *ifs::fixedPoint(sheared.maps[0].map);
        camera.pixelsPerUnit *= 1e6;
        const AddressCut cut = cutOf(sheared, camera);
        QVERIFY(cut.words.size() > 100);
        QVERIFY(cut.probability < 1e-3);
    }

    // Words that lie side by side are all needed: none may stand for another, however many maps there are.
    void tilesAreAllThere_data() {
        QTest::addColumn<int>("columns");
        QTest::addColumn<int>("rows");
        QTest::addColumn<int>("words");
        QTest::addColumn<double>("zoom");
        QTest::newRow("20 maps, many words") << 5 << 4 << 4096 << 1.0;
        QTest::newRow("150 maps") << 15 << 10 << 610 << 1.0;
        QTest::newRow("256 maps") << 16 << 16 << 610 << 1.0;
        QTest::newRow("256 maps from near") << 16 << 16 << 610 << 23.0;
        QTest::newRow("1000 maps") << 40 << 25 << 610 << 1.0;
        QTest::newRow("1000 maps from near") << 40 << 25 << 610 << 7.0;
        QTest::newRow("1000 maps from very near") << 40 << 25 << 610 << 4000.0;
        QTest::newRow("100,000 maps") << 400 << 250 << 610 << 1.0;
        QTest::newRow("100,000 maps from near") << 400 << 250 << 610 << 50.0;
    }
    void tilesAreAllThere() {
        QFETCH(int, columns);
        QFETCH(int, rows);
        QFETCH(int, words);
        QFETCH(double, zoom);
        const auto system = systems::tiling(columns, rows);
        Camera camera;
        camera.width = camera.height = 500;
        camera.pixelsPerUnit = 490 * zoom;
        camera.centre = zoom == 1 ? ifs::Vector<2>(.5, .5) : ifs::Vector<2>(.4321, .5678);
        CutSettings settings;
        settings.words = words;
        settings.samples = 1e7;
        const AddressCut cut = addressCut(prepared(system), projection(camera, {}, 1), settings);
        QVERIFY2(cut.words.size() <= 2U * columns * rows + 70'000,
                 qPrintable(QString::number(cut.words.size())));
        double area = 0; // in view
        for (const Word& word : cut.words) {
            const double depth = std::log(1 / word.probability) / std::log(columns * rows);
            QVERIFY2(std::abs(depth - std::round(depth)) < 1e-9, "a word stands for others");
            const auto inView = [](double middle, double half) {
                return std::max(0.0, std::min(middle + half, 500.0) - std::max(middle - half, 0.0));
            };
            area += inView(word.x, std::abs(word.xx)) * inView(word.y, std::abs(word.yy));
        }
        const double square = zoom == 1 ? 490.0 * 490 : 500.0 * 500;
        // Boxes are a hundredth larger than what is in them.
        QVERIFY2(area >= square && area < 1.03 * square, qPrintable(QString::number(area / square)));
    }
};

BARYCAGE_TEST(TestAddressCut);
#include "address_cut_test.moc"
