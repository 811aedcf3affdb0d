// SPDX-License-Identifier: MIT
#include "document/analysis/analysis_thread.h"
#include "document/fractal/fractal_geometry.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QtTest>

#include <algorithm>
#include <atomic>
#include <chrono>

using namespace document;

namespace {

using ifs::Vector;

// Waits for a condition that another thread brings about; fails the test after a minute.
template <class Condition> bool eventually(Condition condition) {
    return QTest::qWaitFor(condition, 60'000);
}

// Its unit square about the triangle (0, 0), (1, 0), (0, 1), carried there by the cage.
Fractal placedSierpinski(std::vector<Vector<2>> current) {
    System2 system;
    for (const auto& shift : {Vector<2>(0, 0), Vector<2>(.5, 0), Vector<2>(0, .5)})
        ifs::append(system, {ifs::Matrix<2>::Identity() / 2, shift}, 1);
    Fractal fractal = support::fractalOf(std::move(system));
    std::vector<Vector<2>> rest{{0, 0}, {1, 0}, {0, 1}};
    if (current.size() == 4) rest = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    plane(fractal)->cage = ifs::ControlCage<2>{std::move(rest), std::move(current)};
    return fractal;
}

AnalysisRequest requestFor(const Fractal& fractal, std::set<Outline> outlines = {}, int depth = 1,
                           std::uint64_t revision = 1) {
    return {std::make_shared<const Fractal>(fractal), std::move(outlines), depth, revision};
}

Analysis analysed(const AnalysisRequest& request) {
    Analyser analyser;
    return *analyser.completed(analyser.begun(request), {});
}

bool sameCorners(ifs::Polygon a, const ifs::Polygon& b) {
    return a.size() == b.size() && std::ranges::all_of(b, [&](const Vector<2>& corner) {
               return std::ranges::any_of(a, [&](const Vector<2>& x) { return (x - corner).norm() < 1e-9; });
           });
}

} // namespace

class AnalysisTest : public QObject {
    Q_OBJECT

private slots:
    void isOfThePictureWhereItsCagePutsIt() {
        const Analysis analysis = analysed(requestFor(placedSierpinski({{1, 1}, {5, 1}, {1, 4}})));
        QVERIFY(!analysis.isOfCode && analysis.isComplete);
        QVERIFY((analysis.facts.box->min - Vector<2>(1, 1)).norm() < 1e-9);
        QVERIFY((analysis.facts.box->max - Vector<2>(5, 4)).norm() < 1e-9);
        QVERIFY(std::abs(analysis.facts.hull->area - 6) < 1e-9);
        QVERIFY((analysis.facts.moments->mean - Vector<2>(1 + 4. / 3, 2)).norm() < 1e-12);
        QVERIFY(sameCorners(analysis.fixedPoints, {{1, 1}, {5, 1}, {1, 4}}));
        QVERIFY(std::abs(*analysis.facts.affinityDimension - std::log2(3)) < 1e-12);
        QVERIFY(std::abs(analysis.boxCounting->fit.slope - std::log2(3)) < 0.1);
    }

    void outlinesWhatIsAskedFor() {
        using enum Outline;
        const Fractal fractal = placedSierpinski({{1, 1}, {5, 1}, {1, 4}});
        const std::set<Outline> all{Box, Hull, Simplex, FixedPoints, Ellipse, Cylinders};
        const Analysis analysis = analysed(requestFor(fractal, all, 2));
        const auto of = [&](Outline kind) {
            std::vector<OutlineShape> shapes;
            std::ranges::copy_if(analysis.shapes, std::back_inserter(shapes),
                                 [=](const auto& shape) { return shape.kind == kind; });
            return shapes;
        };
        QVERIFY(sameCorners(of(Box).at(0).points, {{1, 1}, {5, 1}, {5, 4}, {1, 4}}));
        QVERIFY(sameCorners(of(Hull).at(0).points, {{1, 1}, {5, 1}, {1, 4}}));
        QVERIFY(sameCorners(of(Simplex).at(0).points, {{1, 1}, {5, 1}, {1, 5}}));
        QCOMPARE(of(FixedPoints).size(), std::size_t(3));
        QVERIFY(of(FixedPoints)[1].colour == attractor::categoricalColour(1));
        // On the ellipse (x − m)ᵀ C⁻¹ (x − m) = 4, and its middle.
        const auto ellipse = of(Ellipse);
        QCOMPARE(ellipse.size(), std::size_t(2));
        const auto& moments = *analysis.facts.moments;
        for (const auto& x : ellipse[0].points) {
            const Vector<2> offset = x - moments.mean;
            const ifs::Matrix<2>& c = moments.covariance;
            const double det = c(0, 0) * c(1, 1) - c(0, 1) * c(0, 1);
            const double squared =
                (c(1, 1) * offset.x() * offset.x() - 2 * c(0, 1) * offset.x() * offset.y() +
                 c(0, 0) * offset.y() * offset.y()) /
                det;
            QVERIFY(std::abs(squared - 4) < 1e-9);
        }
        QVERIFY(ellipse[1].points.front() == moments.mean);
        // Nine triangles of a quarter of the size, three to a colour.
        const auto cylinders = of(Cylinders);
        QCOMPARE(cylinders.size(), std::size_t(9));
        QVERIFY(std::ranges::any_of(cylinders, [](const OutlineShape& shape) { // 12: in 1, towards 2
            return shape.colour == attractor::categoricalColour(0) && shape.word == ifs::Word{0, 1} &&
                   sameCorners(shape.points, {{2, 1}, {3, 1}, {2, 1.75}});
        }));
        // With those that contain them: the hull, and three of half the size.
        const auto outer = analysed(requestFor(fractal, all, 2)).outerCylinders;
        QCOMPARE(outer.size(), std::size_t(4));
        for (std::size_t k = 1; k < outer.size(); ++k)
            QCOMPARE(outer[k].listed, ifs::Word{int(k) - 1});
        QVERIFY(analysed(requestFor(fractal)).shapes.empty());
    }

    void fewerCylindersThanAnybodyCanSeeApart() {
        const auto shapes =
            analysed(requestFor(placedSierpinski({{0, 0}, {1, 0}, {0, 1}}), {Outline::Cylinders}, 12)).shapes;
        QCOMPARE(shapes.size(), std::size_t(2187)); // 3⁷: 3⁸ are too many
    }

    void ofABentPictureTheCodeIsKnownAndDrawnBent() {
        const Fractal fractal = placedSierpinski({{0, 0}, {1, 0}, {3, 2}, {0, 1}});
        const Analysis analysis = analysed(requestFor(fractal, {Outline::Box}));
        QVERIFY(analysis.isOfCode);
        QVERIFY(std::abs(analysis.facts.hull->area - 0.5) < 1e-9);
        const ifs::Placement placed = placement(fractal);
        const auto& points = analysis.shapes.at(0).points;
        QVERIFY(points.size() > 40);
        for (const Vector<2>& corner : {Vector<2>(0, 0), Vector<2>(1, 0), Vector<2>(0, 1), Vector<2>(1, .5)})
            QVERIFY(std::ranges::any_of(
                points, [&](const Vector<2>& x) { return (x - placed(corner)).norm() < 1e-9; }));
    }

    // The corner 1 is shown three units farther left, where the cage at rest is, and six where it has
    // doubled.
    void ofMovedBranchesWhatIsShownIsKnown() {
        Fractal fractal = placedSierpinski({{0, 0}, {2, 0}, {0, 2}});
        Shape<2>& shape = *plane(fractal);
        shape.moved = {{{shape.system.maps[0].id}, {ifs::Matrix<2>::Identity(), {-3, 0}}}};
        const Analysis analysis =
            analysed(requestFor(fractal, {Outline::Box, Outline::FixedPoints, Outline::Cylinders}));
        QVERIFY(analysis.hasMovedBranches);
        QVERIFY((analysis.facts.box->min - Vector<2>(-6, 0)).norm() < 1e-9);
        QVERIFY((analysis.facts.box->max - Vector<2>(2, 2)).norm() < 1e-9);
        QVERIFY(std::abs(analysis.facts.hull->area - 4 * 2.75) < 1e-9);
        QVERIFY((analysis.facts.mean->point - Vector<2>(-4. / 3, 2. / 3)).norm() < 1e-12);
        QVERIFY(sameCorners(analysis.fixedPoints, {{-6, 0}, {2, 0}, {0, 2}}));
        QVERIFY(std::abs(*analysis.facts.affinityDimension - std::log2(3)) < 1e-12);
        const auto isShown = [&](const ifs::Polygon& polygon) {
            return std::ranges::any_of(analysis.shapes,
                                       [&](const auto& shown) { return sameCorners(shown.points, polygon); });
        };
        QVERIFY(isShown({{-6, 0}, {2, 0}, {2, 2}, {-6, 2}}));
        QVERIFY(isShown({{-6, 0}, {-5, 0}, {-6, 1}})); // the cylinder 1
        QVERIFY(isShown({{1, 0}, {2, 0}, {1, 1}}));
    }

    void theNewestRequestWins() {
        std::atomic<int> announced = 0;
        AnalysisThread thread([&] { ++announced; });
        QVERIFY(thread.newest() == nullptr);
        for (std::uint64_t n = 1; n <= 100; ++n)
            thread.submit(requestFor(placedSierpinski({{0, 0}, {double(n), 0}, {0, 1}}), {}, 1, n),
                          n < 100 ? AnalysisThread::Haste::InTurn : AnalysisThread::Haste::Now);
        QVERIFY(eventually([&] {
            const auto newest = thread.newest();
            return newest && newest->revision == 100 && newest->isComplete;
        }));
        QVERIFY(std::abs(thread.newest()->facts.box->max.x() - 100) < 1e-9);
    }

    // A drag sends requests faster than they can be worked off: results must come all the same.
    void aStreamOfRequestsStarvesNothing() {
        AnalysisThread thread([] {});
        std::uint64_t sent = 0;
        QVERIFY(eventually([&] {
            ++sent;
            thread.submit(requestFor(placedSierpinski({{0, 0}, {1, 0}, {0, 1 + double(sent)}}), {}, 1, sent),
                          AnalysisThread::Haste::InTurn);
            const auto newest = thread.newest();
            return newest && newest->revision > 2;
        }));
    }

    // The affinity dimension and the box counting are those of a moment ago; another place has to be counted.
    void otherOutlinesAreCompleteAtOnce() {
        Analyser analyser;
        const Fractal fractal = placedSierpinski({{1, 1}, {5, 1}, {1, 4}});
        Analysis begun = analyser.begun(requestFor(fractal));
        QVERIFY(!begun.isComplete);
        const Analysis first = *analyser.completed(std::move(begun), {});
        const Analysis again = analyser.begun(requestFor(fractal, {Outline::Cylinders}));
        QVERIFY(again.isComplete);
        QCOMPARE(again.shapes.size(), std::size_t(3));
        QCOMPARE(again.facts.affinityDimension, first.facts.affinityDimension);
        QCOMPARE(again.facts.invariants.lyapunovExponent, first.facts.invariants.lyapunovExponent);
        QCOMPARE(again.boxCounting->fit.slope, first.boxCounting->fit.slope);
        QVERIFY(!analyser.begun(requestFor(placedSierpinski({{1, 1}, {5, 2}, {1, 4}}))).isComplete);
        QVERIFY(analyser.begun(requestFor(fractal)).isComplete);
        Fractal other = fractal;
        plane(other)->system.maps.pop_back();
        QVERIFY(!analyser.begun(requestFor(other)).isComplete);
    }

    void anAbandonedOneIsNotCompleted() {
        Analyser analyser;
        std::stop_source stop;
        stop.request_stop();
        System2 system;
        ifs::append(system, ifs::affineMap(.5, .2, 0, .3, 0, 0));
        ifs::append(system, ifs::affineMap(.5, 0, .3, .4, 1, 0));
        Fractal fractal = support::fractalOf(system);
        const auto request = requestFor(fractal);
        QVERIFY(!analyser.completed(analyser.begun(request), stop.get_token()));
        const auto later = analyser.completed(analyser.begun(request), {}); // nothing half known was kept
        QVERIFY(later && later->facts.affinityDimension && later->boxCounting);
    }
};

BARYCAGE_TEST(AnalysisTest);
#include "analysis_test.moc"
