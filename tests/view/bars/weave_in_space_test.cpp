// SPDX-License-Identifier: MIT
#include "bars/branch_bar.h"
#include "bridges/render_bridge.h"
#include "document/space_map_handles.h"
#include "support/patient_tries.h"
#include "view/space/space_window.h"

#include <QSignalSpy>
#include <QSlider>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace space_window;

namespace {

// The window into space beside the canvas that it takes its tool from.
struct Weaving : Window {
    view::RenderBridge render{&document};
    view::CanvasView canvas{&document, &render};
    view::BranchBar bar{&document, &canvas};

    explicit Weaving(const document::Fractal& fractal = cubeOfEight()) : Window(fractal) {
        bar.setSpace(view.get(), QStringLiteral("Click a corner"));
        view->setTarget(view::SpaceView::Target::Maps);
        canvas.setTool(view::CanvasView::Tool::Maps);
        bar.show();
    }
    const document::System3& system() const { return *document::system3(document.fractal()); }
    // Pulled with the mouse, so that it stays until it is let go.
    void pull(int degrees) const {
        bar.swing()->setSliderDown(true);
        bar.swing()->setValue(degrees);
    }
    void letGo() const { bar.swing()->setSliderDown(false); }
};

} // namespace

// The held map swings about its root, as it is seen, in one step.
class WeaveInSpaceTest : public QObject {
    Q_OBJECT

private slots:
    void theHeldMapSwingsAboutTheLineOfSight() {
        Weaving window;
        QVERIFY(window.bar.swing()->isEnabled());
        const document::Fractal before = window.document.fractal();
        window.view->holdMap(6);
        const auto& camera = window.camera();
        const ifs::Vector<3> root = *document::rootInSpace(before, ifs::Vector<3>::UnitY());
        const ifs::Vector<3> pivot = document::system3(before)->maps[6].map(root);
        const ifs::Vector<3> tip = document::system3(before)->maps[6].map(root + ifs::Vector<3>(0, 1, 0));
        const auto seen = [&](const ifs::Vector<3>& point) { return toScreen(camera, point); };
        window.pull(10);
        QCOMPARE(window.bar.swing()->value(), 10);
        const ifs::AffineMap<3> swung = window.system().maps[6].map;
        QVERIFY((swung(root) - pivot).norm() < 1e-12);
        // What it moves keeps its distance from the eye, and turns by so much, counter-clockwise.
        const ifs::Vector<3> moved = swung(root + ifs::Vector<3>(0, 1, 0));
        QVERIFY(std::abs(seen(moved).depth - seen(tip).depth) < 1e-12);
        const auto inView = [&](const ifs::Vector<3>& way) {
            return ifs::Vector<3>(camera.orientation.conjugate() * way);
        };
        const ifs::Vector<3> was = inView(tip - pivot), is = inView(moved - pivot);
        const double turned = std::atan2(is.y(), is.x()) - std::atan2(was.y(), was.x());
        QVERIFY(std::abs(turned - 10 * std::numbers::pi / 180) < 1e-9);
        window.pull(4); // counted from the middle
        window.pull(10);
        QVERIFY((window.system().maps[6].map.linear - swung.linear).norm() < 1e-12);
        QCOMPARE(window.document.undoStack()->count(), 0);
        window.letGo();
        QCOMPARE(window.document.undoStack()->count(), 1);
        QCOMPARE(window.bar.swing()->value(), 0);
        for (std::size_t i = 0; i < 8; ++i)
            QCOMPARE(window.system().maps[i].map == document::system3(before)->maps[i].map, i != 6);
        window.document.undoStack()->undo();
        QVERIFY(window.document.fractal() == before);
    }

    // A shear that contracts only when it comes several times: turned, it does no more.
    void itStopsWhereTheAttractorWouldBeLost() {
        document::Fractal sheared;
        document::Shape<3> shape;
        ifs::AffineMap<3> map{0.5 * ifs::Matrix<3>::Identity(), ifs::Vector<3>::Zero()};
        map.linear(0, 1) = 2;
        ifs::append<3>(shape.system, map);
        ifs::append<3>(shape.system, {0.3 * ifs::Matrix<3>::Identity(), ifs::Vector<3>(1, 0, 0)});
        ifs::append<3>(shape.system, {0.3 * ifs::Matrix<3>::Identity(), ifs::Vector<3>(0, 0, 1)});
        sheared.shape = shape;
        Weaving window(sheared);
        window.view->navigation().lookFrom(view::directions::front);
        QTRY_VERIFY((window.camera().orientation * ifs::Vector<3>::UnitZ() - ifs::Vector<3>::UnitZ()).norm() <
                    1e-9);
        QSignalSpy said(&window.canvas, &view::CanvasView::message);
        window.pull(60);
        const int reached = window.bar.swing()->value();
        // As in the plane, 7.5° is where the spectral radius comes to 1.
        QVERIFY2(reached < 8, qPrintable(QString::number(reached)));
        QVERIFY(!said.isEmpty() && said.last().first().toString().startsWith(QStringLiteral("Stopped")));
        window.letGo();
        window.canvas.tools().setAllowsNoAttractor(true);
        window.pull(60);
        QCOMPARE(window.bar.swing()->value(), 60);
        window.letGo();
    }

    void aFlatCageIsSaid() {
        Weaving window;
        document::Fractal flat = window.document.fractal();
        auto cage = *document::spaceCage(flat);
        for (ifs::Vector<3>& vertex : cage.current)
            vertex.z() = 0;
        flat = document::withSpaceCageMoved(flat, cage);
        window.document.edit(QStringLiteral("Squeeze"), flat);
        QSignalSpy said(&window.canvas, &view::CanvasView::message);
        window.pull(10);
        QVERIFY(!said.isEmpty() && said.last().first().toString().contains(QStringLiteral("flat")));
        QCOMPARE(window.bar.swing()->value(), 0);
        QVERIFY(window.document.fractal() == flat);
    }
};

QTEST_MAIN(WeaveInSpaceTest)
#include "weave_in_space_test.moc"
