// SPDX-License-Identifier: MIT
#include "attractor/folds/prefractal_fold.h"

#include "attractor/folds/drawing.h"
#include "attractor/folds/prefractal.h"
#include "attractor/systems.h"
#include "support/named_test.h"

#include <QtTest>

using namespace attractor;

namespace {

using PrefractalDrawing = folds::Drawing<PrefractalFold>;

RenderRequest requestOf(const ifs::IteratedFunctionSystem<2>& system, int iterations) {
    RenderRequest request = systems::request(system, 1, 400, 400);
    request.algorithm = Algorithm::Deterministic;
    request.iterations = iterations;
    return request;
}

} // namespace

class TestPrefractalFold : public QObject {
    Q_OBJECT

private slots:
    void onePassIsAll() {
        PrefractalDrawing drawing(requestOf(systems::sierpinski(), 4));
        QVERIFY(!drawing.fold.finished());
        QVERIFY(drawing.pass(1));
        QVERIFY(drawing.fold.finished());
        const auto counts = folds::countsOf(drawing.sums());
        drawing.rewind();
        QVERIFY(!drawing.fold.finished());
        QCOMPARE(folds::totalOf(drawing.sums()), std::uint64_t{0});
        QVERIFY(drawing.pass(1));
        QVERIFY(folds::countsOf(drawing.sums()) == counts);
    }

    void aStoppedPassIsDrawnAnew() {
        PrefractalDrawing whole(requestOf(systems::sierpinski(), 6));
        QVERIFY(whole.pass(1));
        PrefractalDrawing drawing(requestOf(systems::sierpinski(), 6));
        drawing.fold.begin(1);
        std::stop_source stopped;
        stopped.request_stop();
        QVERIFY(!drawing.fold.complete(stopped.get_token()));
        QVERIFY(drawing.fold.interrupted() && !drawing.fold.finished());
        QVERIFY(drawing.fold.complete({}));
        QVERIFY(folds::countsOf(drawing.sums()) == folds::countsOf(whole.sums()));
    }

    void tooManyIterationsAreTold() {
        const PrefractalDrawing few(requestOf(systems::fern(), 5));
        QCOMPARE(few.fold.iterations(), 5);
        QVERIFY(few.fold.note() == RenderNote::None);
        const PrefractalDrawing many(requestOf(systems::fern(), 60));
        QCOMPARE(many.fold.iterations(), affordableIterations(4, 60));
        QVERIFY(many.fold.iterations() >= 9 && many.fold.iterations() < 60);
        QVERIFY(many.fold.note() == RenderNote::FewerIterations);
    }

    void exposureNeedsNoMeasuring() {
        PrefractalDrawing drawing(requestOf(systems::sierpinski(), 2));
        QVERIFY(drawing.fold.hasFixedExposure());
        const auto before = drawing.fold.exposure({});
        QVERIFY(drawing.pass(1));
        const auto after = drawing.fold.exposure({});
        QVERIFY(before && before == after);
    }
};

BARYCAGE_TEST(TestPrefractalFold);
#include "prefractal_fold_test.moc"
