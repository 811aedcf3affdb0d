// SPDX-License-Identifier: MIT
#include "space/seen_line.h"

#include "canvas/geometry/canvas_geometry.h"
#include "space/slice_item.h"
#include "space/space_cage_item.h"
#include "space/space_outlines_item.h"
#include "support/named_test.h"

#include <QImage>
#include <QPainter>
#include <QtTest>

using ifs::Vector;

namespace {

attractor::OrbitCamera perspective() {
    attractor::OrbitCamera camera; // the eye is at (0, 0, 2.7)
    camera.projection = attractor::OrbitCamera::Projection::Perspective;
    camera.height = 2;
    camera.size = {600, 500};
    return camera;
}

class Painted {
public:
    explicit Painted(view::OverlayItem& item) : m_image(600, 500, QImage::Format_ARGB32_Premultiplied) {
        m_image.fill(Qt::transparent);
        QPainter painter(&m_image);
        item.paint(&painter, nullptr, nullptr);
    }
    bool isNear(const QPointF& at) const {
        for (int y = -6; y <= 6; ++y)
            for (int x = -6; x <= 6; ++x)
                if (qAlpha(m_image.pixel(at.toPoint() + QPoint(x, y))) > 0) return true;
        return false;
    }

private:
    QImage m_image;
};

const Vector<3> left(-0.5, -0.3, 0), right(0.5, -0.3, 0), behind(0, 0.1, 5);

} // namespace

// Lines that reach behind the eye of a perspective camera.
class SeenLineTest : public QObject {
    Q_OBJECT

private slots:
    void linesEndInFrontOfTheEye() {
        const attractor::OrbitCamera camera = perspective();
        QVERIFY(view::inFront(camera, left) > 0 && view::inFront(camera, behind) < 0);
        const auto line = view::seenLine(camera, left, behind);
        QVERIFY(line);
        QCOMPARE(line->p1(), view::toPoint(toScreen(camera, left).pixel));
        for (const double way : {0.1, 0.3, 0.5}) { // what is seen of it is on the line
            const QPointF there = view::toPoint(toScreen(camera, left + way * (behind - left)).pixel);
            const QLineF part(line->p1(), there);
            QVERIFY(part.length() < line->length() && std::abs(part.angleTo(*line)) < 1e-6);
        }
        const auto back = view::seenLine(camera, behind, left);
        QCOMPARE(back->p2(), line->p1());
        QVERIFY(!view::seenLine(camera, behind, behind + Vector<3>(1, 0, 0)));
        attractor::OrbitCamera flat = camera;
        flat.projection = attractor::OrbitCamera::Projection::Orthographic;
        QCOMPARE(view::seenLine(flat, left, behind)->p2(), view::toPoint(toScreen(flat, behind).pixel));
    }

    // Inside the cage, edges go on past the border of the view towards vertices behind the eye.
    void edgesOfTheCageAreSeen() {
        attractor::OrbitCamera camera = perspective();
        const std::vector<Vector<3>> vertices{left, right, {0, 0.5, 0}, behind};
        QVERIFY(eyeDistance(camera) < 5 && !toScreen(camera, behind).pixel.allFinite());
        view::SpaceCageItem item;
        item.setHandlesVisible(false);
        const auto faces = view::SpaceCageItem::facesOf(vertices);
        item.layOut(camera, vertices, faces, [](const auto&) { return false; });
        const Painted painted(item);
        for (const Vector<3>& vertex : {left, right}) {
            const QPointF end = view::toPoint(toScreen(camera, vertex).pixel);
            for (const double way : {0.1, 0.2, 0.3, 0.4}) {
                const Vector<3> point = vertex + way * (behind - vertex);
                QVERIFY(painted.isNear(view::toPoint(toScreen(camera, point).pixel)));
            }
            QVERIFY(!painted.isNear(end - QPointF(50, 50))); // towards nowhere in particular
            QVERIFY(item.boundingRect().contains(end));
        }
        QVERIFY(item.boundingRect().intersects(QRectF(0, 490, 600, 10)));
        // Far outside, an edge keeps its direction.
        camera.projection = attractor::OrbitCamera::Projection::Orthographic;
        item.layOut(camera, {{0, 0, 0}, {4e3, 1e3, 0}, {-1, 0, 0}, {0, 0, 1}}, faces,
                    [](const auto&) { return false; });
        QVERIFY(Painted(item).isNear(view::toPoint(toScreen(camera, {0.8, 0.2, 0}).pixel)));
    }

    void theBorderOfASliceIsSeen() {
        const attractor::OrbitCamera camera = perspective();
        view::SlicePlane plane;
        plane.corners = {left, right, right + Vector<3>(0, 0.2, 5), left + Vector<3>(0, 0.2, 5)};
        plane.centre = (left + right) / 2;
        plane.normal = Vector<3>::UnitY();
        view::SliceItem item;
        item.layOut(camera, plane);
        const Painted painted(item);
        for (const Vector<3>& corner : {left, right}) {
            const Vector<3> way(0, 0.2, 5);
            for (const double share : {0.1, 0.2, 0.3})
                QVERIFY(painted.isNear(view::toPoint(toScreen(camera, corner + share * way).pixel)));
            QVERIFY(!painted.isNear(view::toPoint(toScreen(camera, corner).pixel) - QPointF(50, 50)));
        }
    }

    void edgesOfOutlinesAreSeen() {
        const attractor::OrbitCamera camera = perspective();
        document::SpaceOutline shape;
        shape.points = {left, behind};
        shape.edges = {{0, 1}};
        view::SpaceOutlinesItem item;
        item.setShapes({shape});
        item.layOut(camera);
        const Painted painted(item);
        QVERIFY(painted.isNear(view::toPoint(toScreen(camera, left + 0.2 * (behind - left)).pixel)));
        QVERIFY(!painted.isNear(view::toPoint(toScreen(camera, left).pixel) - QPointF(50, 50)));
    }
};

BARYCAGE_TEST(SeenLineTest, QApplication);
#include "seen_line_test.moc"
