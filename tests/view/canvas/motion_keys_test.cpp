// SPDX-License-Identifier: MIT
#include "canvas/items/motion_path_item.h"
#include "document/edits/timeline/animation_edits.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/canvas/canvas_fixture.h"

#include <cmath>

using document::Track;

// Keys on the paths of the canvas, which are dragged where they are, whatever moment is shown.
class MotionKeysTest : public CanvasFixture {
    Q_OBJECT

private slots:
    void init() { open(); }
    void cleanup() { close(); }

    void keysOfTheCageAreDragged() {
        key({Track::Kind::Cage, {}});
        const auto before = vertices();
        show(24);
        drag(vertex(1), {-60, 40});
        const auto moved = vertices();
        const QPoint place = vertex(1);
        show(0);
        QVERIFY(vertices() == before);
        QCOMPARE(paths().ways().size(), std::size_t(3));
        QCOMPARE(paths().ways()[1].keys.size(), 2);
        const int step = steps();
        drag(place, {0, 30});
        QCOMPARE(steps(), step + 1);
        QVERIFY(m_document->moment() == animation::moment(24));
        QVERIFY((vertex(1) - place - QPoint(0, 30)).manhattanLength() <= 2);
        QCOMPARE(vertices()[0], moved[0]);
        show(0);
        QVERIFY(vertices() == before);
        m_document->undoStack()->undo();
        show(24);
        QVERIFY(vertices() == moved);
    }

    void keysOfMapsAreDragged() {
        m_canvas->setTool(CanvasView::Tool::Maps);
        const ifs::MapId id = system().maps[2].id;
        key({Track::Kind::Map, {id}});
        const ifs::AffineMap<2> before = system().maps[2].map;
        show(24);
        document::Fractal shifted = m_document->fractal();
        document::plane(shifted)->system.maps[2].map.translation += Vector<2>(0.2, 0.15);
        m_document->edit(QStringLiteral("Shift"), shifted);
        const ifs::AffineMap<2> moved = system().maps[2].map;
        const QPointF place = paths().ways()[0].keys[1];
        show(0);
        const int step = steps();
        drag(place, {25, 10});
        QCOMPARE(steps(), step + 1);
        QVERIFY(m_document->moment() == animation::moment(24));
        QCOMPARE(system().maps[2].map.linear, moved.linear);
        const Vector<2> by = view::worldOffset(m_canvas->camera(), {25, 10});
        QVERIFY((system().maps[2].map.translation - moved.translation - by).norm() < 1e-9);
        show(0);
        QVERIFY(system().maps[2].map == before);
    }

    void aClickOnAKeyGoesToItsMoment() {
        key({Track::Kind::Cage, {}});
        show(24);
        drag(vertex(1), {-60, 40});
        const QPoint place = vertex(1);
        show(7);
        const int step = steps();
        click(place);
        QCOMPARE(steps(), step);
        QVERIFY(m_document->moment() == animation::moment(24));
    }

    // The cage as the key before and the one after have it.
    void neighbouringKeysAreGhosts() {
        key({Track::Kind::Cage, {}});
        for (const int frame : {12, 24}) {
            show(frame);
            drag(vertex(1), {-20, 15});
        }
        QCOMPARE(paths().ghosts().size(), std::size_t(1)); // after the last key there is none
        show(12);
        QCOMPARE(paths().ghosts().size(), std::size_t(2));
        show(18);
        QCOMPARE(paths().ghosts().size(), std::size_t(2));
        QCOMPARE(paths().ghosts()[0].size(), 3);
        show(0);
        QCOMPARE(paths().ghosts().size(), std::size_t(1));
    }

    void theCanvasFollowsTheCamera() {
        const attractor::View from = attractor::viewOf(m_canvas->camera());
        attractor::View to = from;
        to.centre += Vector<2>(0.1, 0.2);
        to.height /= 4;
        to.rotation = 0.5;
        document::Fractal entry = m_document->entryFractal();
        document::plane(entry)->animation.emplace().camera = {{0, from, {}}, {24, to, {}}};
        m_document->editEntry(QStringLiteral("Camera"), entry);
        const auto shows = [this](const attractor::View& view) {
            const attractor::View seen = attractor::viewOf(m_canvas->camera());
            return (seen.centre - view.centre).norm() < 1e-9 && std::abs(seen.height - view.height) < 1e-9 &&
                   std::abs(seen.rotation - view.rotation) < 1e-6;
        };
        show(24);
        QTRY_VERIFY(shows(to));
        show(0);
        QTRY_VERIFY(shows(from));
        show(12);
        attractor::View half = to; // r = 1/4: two thirds of the way, at half the height
        half.centre = from.centre + 2.0 / 3 * (to.centre - from.centre);
        half.height = from.height / 2;
        half.rotation = 0.25;
        QTRY_VERIFY(shows(half));
    }

private:
    void show(int frame) { m_document->setMoment(animation::moment(frame)); }
    using CanvasFixture::key;
    void key(const Track& track) {
        m_document->editEntry(QStringLiteral("Key"),
                              document::withKey(m_document->entryFractal(), track, 0, {}));
    }
    const view::MotionPathItem& paths() const {
        for (const QGraphicsItem* item : scene().items())
            if (const auto* found = dynamic_cast<const view::MotionPathItem*>(item)) return *found;
        qFatal("there are no paths");
    }
};

BARYCAGE_TEST(MotionKeysTest, QApplication);
#include "motion_keys_test.moc"
