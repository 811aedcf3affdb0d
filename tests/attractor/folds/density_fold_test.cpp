// SPDX-License-Identifier: MIT
#include "attractor/folds/density_fold.h"

#include "attractor/folds/drawing.h"
#include "attractor/systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>

using namespace attractor;

namespace {

using Drawing = folds::Drawing<DensityFold>;

} // namespace

class TestDensityFold : public QObject {
    Q_OBJECT

private slots:
    // From afar all of the fern falls into a few cells, so that refining to more than a 32-bit counter holds
    // takes no time.
    void countersNeverWrap_data() {
        QTest::addColumn<int>("colourBy");
        QTest::addColumn<quint64>("samples");
        QTest::newRow("density") << int(ColourBy::Density) << quint64{9'000'000'000};
        QTest::newRow("colours") << int(ColourBy::Map) << quint64{30'000'000};
    }
    void countersNeverWrap() {
        QFETCH(int, colourBy);
        QFETCH(quint64, samples);
        RenderRequest request = systems::request(systems::fern(), samples / 2, 48, 32);
        request.camera.pixelsPerUnit *= 1e-3;
        request.camera.centre += ifs::Vector<2>::Constant(0.4 / request.camera.pixelsPerUnit);
        request.appearance.colourBy = static_cast<ColourBy>(colourBy);
        request.threads = 2;
        Drawing drawing(request);
        for (int pass = 0; pass < 2; ++pass)
            QVERIFY(drawing.pass(request.samples));
        const CellSums& sums = drawing.sums();
        const std::uint64_t drawn = drawing.fold.samples();
        QVERIFY(drawn > samples - 10);
        QCOMPARE(folds::totalOf(sums), drawn);
        if (sums.kind() == CellKind::Count) {
            QVERIFY(sums.carried());
            return;
        }
        // Every sample has the colour of its first map, so that the sums follow from the words.
        std::uint64_t red = 0;
        std::vector<CellSums::Sum> row;
        for (int y = 0; y < request.camera.height; ++y) {
            sums.sumsOfRow(y, row);
            for (const CellSums::Sum& sum : row)
                red += sum.red;
        }
        double expected = 0;
        const std::vector<double>& probabilities = drawing.prepared.system().probabilities;
        for (std::size_t i = 0; i < probabilities.size(); ++i)
            expected += probabilities[i] * drawing.prepared.colourOf(static_cast<std::uint32_t>(i), 0).red;
        QVERIFY(red > std::uint64_t{1} << 32);
        QVERIFY(std::abs(static_cast<double>(red) / static_cast<double>(drawn) / expected - 1) < 1e-3);
    }

    // Every set of samples goes to other words where words stand for others.
    void thinnedWordsTakeTurns() {
        RenderRequest request;
        for (int i = 0; i < 4; ++i)
            ifs::append<2>(request.system, ifs::affineMap(.9, 0, 0, .9, .1 * (i % 2), .1 * (i / 2)));
        request.camera.width = request.camera.height = 400;
        request.camera.centre = {.5, .5};
        request.camera.pixelsPerUnit = 200'000;
        request.samples = 40'000'000;
        Drawing drawing(request);
        QVERIFY(drawing.pass(100'000)); // one set of samples
        const AddressCut first = *drawing.fold.cut();
        QVERIFY(first.isThinned);
        QVERIFY(drawing.pass(100'000));
        const AddressCut second = *drawing.fold.cut();
        QVERIFY(!first.words.empty() && !second.words.empty());
        std::size_t same = 0;
        for (const Word& word : first.words)
            same += std::ranges::count_if(second.words, [&](const Word& other) {
                return other.addressCoordinate == word.addressCoordinate && other.x == word.x;
            });
        QVERIFY(same < first.words.size() / 2);
    }

    // The sample sets of a pass are counted together, word by word. The sums are those of one set after the
    // other, also where the sets are those of an earlier picture.
    void setsCountedTogetherAreThoseCountedInTurn_data() {
        QTest::addColumn<double>("zoom"); // far away there are few words, with many samples each
        QTest::addColumn<quint64>("index");
        QTest::addColumn<quint64>("count");
        QTest::newRow("whole") << 1.0 << quint64{0} << quint64{1};
        QTest::newRow("few words") << 1e-3 << quint64{0} << quint64{1};
        QTest::newRow("part") << 1.0 << quint64{2} << quint64{3};
        QTest::newRow("one set of three") << 1.0 << quint64{70} << quint64{1000};
    }
    void setsCountedTogetherAreThoseCountedInTurn() {
        QFETCH(double, zoom);
        QFETCH(quint64, index);
        QFETCH(quint64, count);
        constexpr std::uint64_t set = 1U << 24;
        RenderRequest request = systems::request(systems::maple(), 2 * set + set / 3, 160, 100);
        request.camera.pixelsPerUnit *= zoom;
        request.threads = 2;
        Drawing inTurn(request);
        inTurn.fold.setPart({index, count});
        for (const std::uint64_t samples : {set, set, set / 3})
            QVERIFY(inTurn.pass(samples));
        Drawing together(request);
        for (int picture = 0; picture < 2; ++picture) {
            together.fold.start(together.workers);
            together.rewind();
            together.fold.setPart({index, count});
            QVERIFY(together.pass(request.samples));
            QVERIFY(folds::totalOf(together.sums()) > 0);
            QCOMPARE(together.fold.samplesOverAttractor(), inTurn.fold.samplesOverAttractor());
            QVERIFY(folds::countsOf(together.sums()) == folds::countsOf(inTurn.sums()));
        }
    }

    // A pass that is stopped with all its jobs planned, and completed, has the same sums as one that is not.
    void aStoppedPassIsCompleted() {
        RenderRequest request = systems::request(systems::maple(), 2'000'000, 160, 100);
        request.threads = 2;
        Drawing whole(request);
        QVERIFY(whole.pass(100'000));
        QVERIFY(whole.pass(request.samples));
        Drawing parts(request);
        QVERIFY(parts.pass(100'000));
        parts.fold.begin(request.samples);
        std::stop_source stopped;
        stopped.request_stop();
        QVERIFY(!parts.fold.complete(stopped.get_token()));
        QVERIFY(parts.fold.interrupted());
        QVERIFY(folds::totalOf(parts.sums()) < parts.fold.samples());
        QVERIFY(parts.fold.complete({}));
        QVERIFY(!parts.fold.interrupted());
        QCOMPARE(parts.fold.samples(), whole.fold.samples());
        QVERIFY(folds::countsOf(parts.sums()) == folds::countsOf(whole.sums()));
    }
};

BARYCAGE_TEST(TestDensityFold);
#include "density_fold_test.moc"
