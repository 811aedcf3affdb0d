// SPDX-License-Identifier: MIT
#include "canvas/geometry/canvas_geometry.h"
#include "canvas/geometry/grid_spacing.h"
#include "canvas/geometry/polygon_drag.h"
#include "canvas/geometry/snapping.h"
#include "canvas/items/gizmo_item.h"
#include "support/named_test.h"
#include "support/near.h"

#include <QRandomGenerator>
#include <QTest>

#include <cmath>
#include <numbers>

using namespace view;
using ifs::Vector;

namespace {

attractor::Camera camera(double pixelsPerUnit, Vector<2> centre = Vector<2>::Zero(),
                         attractor::YAxis yAxis = attractor::YAxis::Up) {
    return {centre, pixelsPerUnit, 640, 480, yAxis};
}

PolygonDrag drag(PolygonDrag::Mode mode, std::vector<int> vertices, Vector<2> press) {
    PolygonDrag result;
    result.mode = mode;
    result.vertices = std::move(vertices);
    result.points = {Vector<2>(0.1, 0.2), Vector<2>(1.3, 0.1), Vector<2>(0.2, 1.7)};
    result.pivot = {0.5, 0.7};
    result.press = press;
    result.snapVertex = result.vertices.front();
    return result;
}

using support::near;

} // namespace

class CanvasGeometryTest : public QObject {
    Q_OBJECT

private slots:
    void picturesFollowTheView() {
        QRandomGenerator random(7);
        for (int i = 0; i < 200; ++i) {
            const auto any = [&] { return random.bounded(4.0) - 2; };
            const auto axis = [&] {
                return random.bounded(2) == 0 ? attractor::YAxis::Up : attractor::YAxis::Down;
            };
            attractor::Camera from = camera(std::exp(any() * 3), {any(), any()}, axis());
            attractor::Camera to = camera(std::exp(any() * 3), {any(), any()}, axis());
            if (i % 2 == 1) from.rotation = any();
            if (i % 3 == 1) to.rotation = any();
            const Vector<2> world(any(), any());
            const QPointF direct = pixelOf(to, world);
            const QPointF mapped = pixelTransform(from, to).map(pixelOf(from, world));
            QVERIFY(std::hypot(direct.x() - mapped.x(), direct.y() - mapped.y()) <
                    1e-9 * to.pixelsPerUnit + 1e-9);
        }
    }

    void aTurnedBoxIsSurrounded() {
        attractor::Camera turned = camera(100);
        turned.rotation = attractor::rotationOf(45);
        const QRectF seen = pixelsOf(turned, {-1, -1}, {1, 1});
        QVERIFY(std::abs(seen.width() - 200 * std::numbers::sqrt2) < 1e-9);
        QVERIFY(QLineF(seen.center(), QPointF(320, 240)).length() < 1e-9);
        const Vector<2> moved = worldAt(turned, {110, 80}) - worldAt(turned, {100, 100});
        QVERIFY(near<2>(worldOffset(turned, {10, -20}), moved, 1e-12));
        QVERIFY(worldOffset(turned, {0, 0}).isZero(0));
    }

    void depthKeepsItsDigits() {
        const attractor::Camera deep = camera(1e14, {0.3, 0.7});
        const attractor::Camera panned = attractor::panned(deep, {10, -20});
        const QPointF moved = pixelTransform(deep, panned).map(QPointF(100, 100));
        // The centre itself is only known to a part of a pixel here.
        QVERIFY(std::abs(moved.x() - 110) < 0.02);
        QVERIFY(std::abs(moved.y() - 80) < 0.02);
        QVERIFY(withinDepth(camera(1e40, {0.3, 0.7})).pixelsPerUnit >= 1e13);
        QVERIFY(withinDepth(camera(1e40, {0.3, 0.7})).pixelsPerUnit < 1e15);
    }

    void fractionalPixelRatioKeepsTheCorner() {
        attractor::Camera view = camera(123.4, {0.1, -0.4});
        view.width = 333;
        view.height = 217;
        for (const double ratio : {1.0, 1.25, 1.5, 1.75, 2.0, 3.0}) {
            const attractor::Camera device = deviceCamera(view, ratio);
            QVERIFY(near<2>(worldAt(view, {0, 0}), worldAt(device, {0, 0}), 1e-12));
            QCOMPARE(device.width, int(std::lround(333 * ratio)));
        }
    }

    void gridFollowsTheZoom() {
        QRandomGenerator random(3);
        for (int i = 0; i < 500; ++i) {
            const double pixelsPerUnit = std::pow(10, random.bounded(24.0) - 10);
            const GridSpacing spacing = gridSpacing(pixelsPerUnit);
            QVERIFY(spacing.major * pixelsPerUnit >= 100 * (1 - 1e-9));
            QVERIFY(spacing.major * pixelsPerUnit < 251);
            QVERIFY(std::abs(spacing.minor * spacing.subdivisions / spacing.major - 1) < 1e-12);
            const double digit =
                spacing.major / std::pow(10, std::floor(std::log10(spacing.major * 1.0000001)));
            QVERIFY(std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 || std::abs(digit - 5) < 1e-6);
        }
        QCOMPARE(gridLabel(0.1, 3), QStringLiteral("0.3"));
        QCOMPARE(gridLabel(0.1, 0), QStringLiteral("0"));
    }

    void snapsToWhatIsAllowedAndNear() {
        SnapTargets targets{{}, camera(100), {{0.5, 0.52}}};
        const Vector<2> point(0.46, 0.5);
        QCOMPARE(snapped(targets, point).point, point);
        targets.snapping = SnapTo::Vertices;
        QCOMPARE(snapped(targets, point).point, Vector<2>(0.5, 0.52));
        QVERIFY(snapped(targets, point).vertex);
        targets.snapping = SnapTo::Grid; // every 0.2
        const Snapped grid = snapped(targets, {0.61, 0.29});
        QCOMPARE(grid.point, Vector<2>(0.6, 0.29));
        QVERIFY(grid.x && !grid.y);
        targets.snapping = SnapTo::Axes;
        QCOMPARE(snapped(targets, {0.05, 3}).point, Vector<2>(0, 3));
        QCOMPARE(snapped(targets, {0.09, 3}).point, Vector<2>(0.09, 3));
    }

    void noOffsetIsExactlyNoChange() {
        const SnapTargets targets{SnapTo::Grid | SnapTo::Vertices | SnapTo::Axes, camera(100), {{0.1, 0.2}}};
        for (const auto mode : {PolygonDrag::Mode::Move, PolygonDrag::Mode::Rotate, PolygonDrag::Mode::Scale})
            for (const auto constraint : {Constraint::Free, Constraint::Constrained})
                for (const Vector<2>& press : {Vector<2>(0.9, 0.4), Vector<2>(0.5, 0.7)}) {
                    const PolygonDrag start = drag(mode, {0, 1, 2}, press);
                    const DragResult result = dragged(start, Vector<2>::Zero(), constraint, targets);
                    QVERIFY(result.points == start.points);
                    QVERIFY(result.change == ifs::AffineMap<2>{});
                }
    }

    void rotatesAboutThePivotInSteps() {
        const SnapTargets targets{{}, camera(100), {}};
        const PolygonDrag start = drag(PolygonDrag::Mode::Rotate, {0, 1, 2}, {1.5, 0.7});
        // A quarter turn and a little more, from the right of the pivot to above it.
        const Vector<2> offset = Vector<2>(0.45, 1.75) - start.press;
        const auto free = dragged(start, offset, Constraint::Free, targets);
        const auto stepped = dragged(start, offset, Constraint::Constrained, targets);
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector<2> arm = start.points[i] - start.pivot;
            QVERIFY(near<2>(stepped.points[i], start.pivot + Vector<2>(-arm.y(), arm.x()), 1e-12));
            QVERIFY(std::abs((free.points[i] - start.pivot).norm() - arm.norm()) < 1e-12);
            QVERIFY(near<2>(stepped.change(start.points[i]), stepped.points[i], 1e-12));
        }
        QVERIFY(!near<2>(free.points[0], stepped.points[0], 1e-3));
    }

    void scalesAboutThePivot() {
        const SnapTargets targets{{}, camera(100), {}};
        const PolygonDrag start = drag(PolygonDrag::Mode::Scale, {0, 1, 2}, {1.5, 1.7});
        const auto across = dragged(start, {1, 0}, Constraint::Constrained, targets);
        const auto both = dragged(start, {1, 1}, Constraint::Free, targets);
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector<2> arm = start.points[i] - start.pivot;
            QVERIFY(near<2>(across.points[i], start.pivot + Vector<2>(2 * arm.x(), arm.y()), 1e-12));
            QVERIFY(near<2>(both.points[i], start.pivot + 2 * arm, 1e-12));
            QVERIFY(near<2>(both.change(start.points[i]), both.points[i], 1e-12));
        }
    }

    void shiftKeepsADirection() {
        const SnapTargets targets{{}, camera(100), {}};
        const PolygonDrag start = drag(PolygonDrag::Mode::Move, {1}, {1.3, 0.1});
        const auto moved = dragged(start, {0.3, 0.1}, Constraint::Constrained, targets);
        QCOMPARE(moved.points[1], Vector<2>(1.3 + 0.3, 0.1));
        QCOMPARE(moved.points[0], start.points[0]);
    }

    // The area that a clipped polygon covers is that of the polygon inside: no more, and no less.
    void fillsEndAtTheRectangle() {
        QRandomGenerator random(23);
        const QRectF view(0, 0, 64, 48);
        for (int i = 0; i < 400; ++i) {
            const double size = std::pow(10.0, random.bounded(7));
            QPolygonF polygon;
            for (int v = 3 + random.bounded(3); v > 0; --v)
                polygon << QPointF((random.generateDouble() - 0.5) * size + 32,
                                   (random.generateDouble() - 0.5) * size + 24);
            const QPolygonF part = clippedTo(view, polygon);
            for (const QPointF& corner : part)
                QVERIFY(view.adjusted(-1e-9, -1e-9, 1e-9, 1e-9).contains(corner));
            for (int n = 0; n < 40; ++n) {
                const QPointF at(random.bounded(64.0), random.bounded(48.0));
                QCOMPARE(part.containsPoint(at, Qt::OddEvenFill), polygon.containsPoint(at, Qt::OddEvenFill));
            }
        }
        QVERIFY(clippedTo(view, QPolygonF(QRectF(100, 100, 5, 5))).isEmpty());
        QVERIFY(clippedTo(view, {}).isEmpty());
    }

    void handlesBesideTheCageStayInSight() {
        QRandomGenerator random(11);
        const QRectF view(0, 0, 640, 480);
        for (int i = 0; i < 300; ++i) {
            QPolygonF cage;
            for (int v = 0; v < 3; ++v)
                cage << QPointF(random.bounded(2000.0) - 700, random.bounded(2000.0) - 700);
            const GizmoLayout layout = gizmoLayout(cage, cage.boundingRect().center(), view);
            QVERIFY(view.contains(layout.rotate));
            QVERIFY(view.contains(layout.scale));
            QVERIFY(QLineF(layout.rotate, layout.scale).length() >= 24);
        }
    }
};

BARYCAGE_TEST(CanvasGeometryTest, QApplication);
#include "canvas_geometry_test.moc"
