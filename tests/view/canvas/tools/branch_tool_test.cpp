// SPDX-License-Identifier: MIT
#include "bars/branch_bar.h"
#include "canvas/marks/address_walk.h"
#include "document/edits/timeline/animation_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/maps/map_handles.h"
#include "ifs/cage/map_handles.h"
#include "ifs/existence/attractor_existence.h"
#include "ifs/system/branch.h"
#include "ifs/system/map_interpolation.h"
#include "support/choose.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/canvas/canvas_fixture.h"

#include <QComboBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

using document::Document;
using ifs::Vector;
using ifs::Word;
using view::CanvasPart;
using view::CanvasView;
using Kind = view::CanvasPart::Kind;

// Addresses under the pointer, dragged branches, and maps that swing.
class BranchToolTest : public CanvasFixture {
    Q_OBJECT

    std::unique_ptr<view::BranchBar> m_bar;

    QPointF pixel(const Vector<2>& code) const {
        return view::pixelOf(m_canvas->camera(), document::placement(m_document->fractal())(code));
    }
    // A point of the attractor whose address begins like this and continues with map 1 forever.
    QPointF pointOf(const Word& word) const {
        return pixel(*ifs::addressPoint<2>(ifs::mapsOf(system()), word, {0}));
    }

    view::PointerPosition read(const QPointF& p) {
        QSignalSpy spy(m_canvas.get(), &CanvasView::pointerMoved);
        hover(p);
        return spy.last().first().value<view::PointerPosition>();
    }

private slots:
    void init() {
        open({800, 600});
        // Pieces that do not touch, so that every point has one address.
        document::Fractal fractal = m_document->fractal();
        for (ifs::WeightedMap<2>& map : document::system2(fractal)->maps)
            map.map.linear *= 0.8;
        m_document->edit(QStringLiteral("test"), fractal);
        m_document->undoStack()->clear();
        m_canvas->fit();
        m_canvas->setTool(CanvasView::Tool::Branch);
        m_bar = std::make_unique<view::BranchBar>(m_document.get(), m_canvas.get());
        m_bar->show();
    }

    void cleanup() {
        m_bar.reset();
        close();
    }

    void thePointerReadsAddresses() {
        const Word word{2, 1, 0, 1};
        const view::PointerPosition there = read(pointOf(word));
        QVERIFY(there.address.size() >= word.size());
        QVERIFY(std::equal(word.begin(), word.end(), there.address.begin()));
        QVERIFY(there.fixedPoint);
        QCOMPARE(there.fixedLength, std::size_t{2});
        const auto fixed = ifs::addressPoint<2>(ifs::mapsOf(system()), {}, {2, 1});
        QVERIFY((*there.fixedPoint - *fixed).norm() < 1e-12);
        QVERIFY(read({3, 3}).address.empty());
        m_canvas->setTool(CanvasView::Tool::Cage); // whatever the tool
        QVERIFY(!read(pointOf(word)).address.empty());
    }

    // The image under the word that is read contains the point, and is as small as a pixel. Followed by hand,
    // with more digits. The pieces are apart, so that the point has no other address.
    void addressesReachAsDeepAsTheView() {
        Word word;
        for (int n = 0; n < 60; ++n)
            word.push_back((n * n + n / 3) % 3);
        const Vector<2> point = *ifs::addressPoint<2>(ifs::mapsOf(system()), word, {0});
        for (const double zoom : {1e6, 1e9, 1e12}) {
            attractor::Camera camera = m_canvas->camera();
            camera.centre = document::placement(m_document->fractal())(point);
            camera.pixelsPerUnit = 100 * zoom; // 100 % is a hundred pixels for a unit
            m_canvas->navigation().setCamera(camera);
            QCOMPARE(m_canvas->camera().pixelsPerUnit, 100 * zoom);
            hover({3, 3});
            const Word address = read(pixel(point)).address;
            const double size = std::pow(0.4, double(address.size())), width = 1 / (100 * zoom);
            QVERIFY2(size < 3 * width && size > width / 10, qPrintable(QString::number(address.size())));
            QVERIFY(std::equal(address.begin(), address.end() - 2, word.begin()));
            long double x = 0.4L, y = 0.25L; // in the middle of the attractor
            for (auto symbol = address.rbegin(); symbol != address.rend(); ++symbol) {
                const ifs::AffineMap<2>& map = system().maps[std::size_t(*symbol)].map;
                const long double before = x;
                x = map.linear(0, 0) * before + map.linear(0, 1) * y + map.translation.x();
                y = map.linear(1, 0) * before + map.linear(1, 1) * y + map.translation.y();
            }
            QVERIFY(std::hypot(double(x - point.x()), double(y - point.y())) < width);
        }
    }

    void aClickSelectsTheBranchToItsDepth() {
        click(pointOf({1, 2, 0, 2}));
        QCOMPARE(scene().handles().branch(), (Word{1, 2}));
        // It is outlined: the image of the cage under w_σ.
        const ifs::AffineMap<2> map = ifs::composed<2>(ifs::mapsOf(system()), {1, 2});
        for (int i = 0; i < 3; ++i)
            QVERIFY(
                QLineF(at({Kind::Vertex, i, 0}), pixel(map(scene().handles().cage()->rest[std::size_t(i)])))
                    .length() < 1e-6);
        m_bar->depth()->setValue(3);
        QCOMPARE(scene().handles().branch(), (Word{1, 2, 0}));
        QWheelEvent wheel(QPointF(300, 200), m_canvas->mapToGlobal(QPointF(300, 200)), {}, {0, -240},
                          Qt::NoButton, Qt::ShiftModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(m_canvas->viewport(), &wheel);
        QCOMPARE(m_canvas->tools().branchTool().choice().depth(), 1);
        QCOMPARE(m_bar->depth()->value(), 1);
        QCOMPARE(scene().handles().branch(), (Word{1}));
        QTest::keyClick(m_canvas.get(), Qt::Key_PageDown);
        QCOMPARE(scene().handles().branch(), (Word{1, 2}));
        QCOMPARE(steps(), 0);
    }

    // Keys belong to maps that the cut set would not have.
    void branchesOfKeyedMapsStay() {
        const document::Fractal keyed = document::withKey(
            m_document->entryFractal(), {document::Track::Kind::Map, {system().maps[1].id}}, 0, std::nullopt);
        m_document->editEntry(QStringLiteral("Key"), keyed);
        m_document->setMoment(animation::moment(24));
        click(pointOf({1, 2, 0, 2}));
        QSignalSpy said(m_canvas.get(), &CanvasView::message);
        const QPointF corner = at({Kind::Vertex, 0, 0});
        drag(corner, {40, 20});
        QVERIFY(m_document->entryFractal() == keyed);
        QVERIFY(!said.isEmpty());
        QVERIFY(said.last().first().toString().startsWith(QStringLiteral("Map 2 has keys")));
        // Where it is shown has nothing to do with them.
        support::choose(m_bar->edit(), document::BranchEdit::Display);
        drag(corner, {40, 20});
        QVERIFY(document::plane(m_document->entryFractal())->system == document::plane(keyed)->system);
        QCOMPARE(document::plane(m_document->entryFractal())->moved.size(), std::size_t(1));
    }

    // The images under the beginnings of its address are outlined, the last one is filled.
    void theWalkToABranchIsPainted() {
        auto* walk = new view::AddressWalk; // owned by the scene
        m_canvas->scene()->addItem(walk);
        click(pointOf({1, 2, 0, 2}));
        QCOMPARE(scene().handles().branch(), (Word{1, 2}));
        const auto images = view::addressWalk(m_document->fractal(), {1, 2});
        QCOMPARE(images.size(), std::size_t{2});
        QTRY_VERIFY_WITH_TIMEOUT(m_bridge->isCurrent(), 60'000);
        // No event comes between the two: the picture is the same.
        const QImage with = m_canvas->viewport()->grab().toImage();
        walk->setVisible(false);
        const QImage without = m_canvas->viewport()->grab().toImage();
        const auto differs = [&](const QPointF& p) {
            return with.pixel(p.toPoint()) != without.pixel(p.toPoint());
        };
        const QPolygonF outer = view::pixelsOf(m_canvas->camera(), images[0]);
        const QPolygonF last = view::pixelsOf(m_canvas->camera(), images[1]);
        int inside = 0, filled = 0; // handles lie over some of it
        for (int i = 1; i < 8; ++i)
            for (int j = 1; i + j < 8; ++j, ++inside)
                filled += differs((last[0] * i + last[1] * j + last[2] * (8 - i - j)) / 8);
        QVERIFY2(2 * filled > inside, qPrintable(QString::number(filled)));
        bool isOutlined = false; // if only by an edge that no other line covers
        for (int i = 0; i < 3; ++i)
            isOutlined = isOutlined || differs((outer[i] + outer[(i + 1) % 3]) / 2);
        QVERIFY(isOutlined);
        QVERIFY(!differs({3, 3}));
    }

    // As a map of its own, only this branch moves. The rest of the attractor is made by maps that are words.
    void aBranchBecomesAMapOfItsOwn() {
        const document::System2 before = system();
        const document::Fractal fractal = m_document->fractal();
        click(pointOf({1, 2, 0, 2}));
        const QPointF corner = at({Kind::Vertex, 0, 0});
        const QPointF other = at({Kind::Vertex, 1, 0});
        drag(corner, {9, -12});
        QCOMPARE(steps(), 1);
        QVERIFY(
            m_document->undoStack()->undoText().startsWith(QStringLiteral("Move corner 1 of branch 2 3 ")));
        QCOMPARE(system().maps.size(), std::size_t{5});
        QVERIFY(QLineF(at({Kind::Vertex, 0, 0}), corner + QPointF(9, -12)).length() < 1e-6);
        QVERIFY(QLineF(at({Kind::Vertex, 1, 0}), other).length() < 1e-6);
        QVERIFY(system().maps[1].map == before.maps[1].map * before.maps[0].map);
        QCOMPARE(scene().handles().branch(), (Word{0})); // stays selected
        QCOMPARE(scene().selection().maps(), std::vector{system().maps[0].id});
        drag(at({Kind::Inside, 0, 0}) * 0.55 + at({Kind::Vertex, 2, 0}) * 0.45, {5, 5}); // beside the pivot
        QCOMPARE(system().maps.size(), std::size_t{5});
        m_document->undoStack()->undo();
        m_document->undoStack()->undo();
        QVERIFY(m_document->fractal() == fractal);
        QCOMPARE(scene().handles().branch(), (Word{1, 2})); // still selected, as before the drag
        QCOMPARE(m_bar->depth()->value(), 2);
        m_document->undoStack()->redo();
        QCOMPARE(scene().handles().branch(), (Word{0}));
        QCOMPARE(m_bar->depth()->value(), 1); // of the map that it is now; the next click has two again
        QCOMPARE(m_canvas->tools().branchTool().choice().depth(), 2);
        m_document->setFile(document::fileOf(document::sierpinskiTriangle()));
        QVERIFY(scene().handles().branch().empty()); // another system has other branches
    }

    // With the keyboard, while the pointer holds the branch.
    void undoEndsTheDrag() {
        const document::Fractal before = m_document->fractal();
        click(pointOf({1, 2, 0, 2}));
        drag(at({Kind::Vertex, 0, 0}), {9, -12});
        for (const bool isMovedOn : {true, false}) {
            QCOMPARE(scene().handles().branch(), (Word{0}));
            m_canvas->tools().branchTool().choice().choose({2, 1});
            const QPointF corner = at({Kind::Vertex, 0, 0});
            press(corner);
            move(corner + QPointF(9, -12));
            m_document->undoStack()->undo();
            QVERIFY(m_document->fractal() == before);
            QSignalSpy said(m_canvas.get(), &CanvasView::message);
            if (isMovedOn) move(corner + QPointF(20, -12));
            release(corner + QPointF(20, -12));
            QVERIFY(m_document->fractal() == before);
            QCOMPARE(scene().handles().branch(), (Word{1, 2}));
            QVERIFY(!m_canvas->tools().branchTool().choice().before());
            QCOMPARE(said.size(), 0); // no map was made
            m_document->undoStack()->redo();
        }
    }

    void escapeLetsTheBranchGo() {
        click(pointOf({1, 2, 0, 2}));
        QCOMPARE(scene().handles().branch(), (Word{1, 2}));
        QTest::keyClick(m_canvas.get(), Qt::Key_Escape);
        QVERIFY(scene().handles().branch().empty());
        click(pointOf({1, 2, 0, 2}));
        QCOMPARE(scene().handles().branch(), (Word{1, 2}));
        QCOMPARE(steps(), 0);
    }

    void aClickBesideTheAttractorLetsTheBranchGo() {
        click(pointOf({1, 2, 0, 2}));
        QCOMPARE(scene().handles().branch(), (Word{1, 2}));
        click(at({Kind::Vertex, 0, -1}) + QPointF(-60, 60)); // outside the cage
        QVERIFY(scene().handles().branch().empty());
        QCOMPARE(steps(), 0);
    }

    void escapeLeavesBranchAndCode() {
        const document::Fractal before = m_document->fractal();
        click(pointOf({1, 2, 0, 2}));
        press(at({Kind::Vertex, 0, 0}));
        move(at({Kind::Vertex, 0, 0}) + QPointF(12, 3));
        QCOMPARE(scene().handles().branch(), (Word{0}));
        QTest::keyClick(m_canvas.get(), Qt::Key_Escape);
        QVERIFY(m_document->fractal() == before);
        QCOMPARE(scene().handles().branch(), (Word{1, 2}));
        release({300, 300});
        QCOMPARE(steps(), 0);
        // Control, pressed on the way, begins the gesture anew.
        press(at({Kind::Vertex, 0, 0}));
        move(at({Kind::Vertex, 0, 0}) + QPointF(12, 3));
        QMouseEvent turn(QEvent::MouseMove, QPointF(300, 300),
                         m_canvas->viewport()->mapToGlobal(QPointF(300, 300)), Qt::NoButton, Qt::LeftButton,
                         Qt::ControlModifier);
        QCoreApplication::sendEvent(m_canvas->viewport(), &turn);
        release({300, 300});
        QVERIFY(m_document->undoStack()->undoText().startsWith(QStringLiteral("Rotate branch 2 3 ")));
        QCOMPARE(system().maps.size(), std::size_t{5});
    }

    void orItsLastMapChanges() {
        const document::System2 before = system();
        support::choose(m_bar->edit(), document::BranchEdit::LastMap);
        click(pointOf({1, 2, 0, 2}));
        const QPointF corner = at({Kind::Vertex, 2, 0});
        drag(corner, {7, 6});
        QCOMPARE(system().maps.size(), std::size_t{3});
        QVERIFY(system().maps[1] == before.maps[1]);
        QVERIFY(system().maps[2].map.linear != before.maps[2].map.linear);
        QCOMPARE(steps(), 1);
        const ifs::AffineMap<2> branch = ifs::composed<2>(ifs::mapsOf(system()), {1, 2});
        QVERIFY(QLineF(pixel(branch(scene().handles().cage()->rest[2])), corner + QPointF(7, 6)).length() <
                1e-6);
    }

    // The code stays; the branch stays selected where it is shown, and can be put back.
    void aBranchIsMovedWhereItIsShown() {
        m_canvas->setTool(CanvasView::Tool::Branch);
        support::choose(m_bar->edit(), document::BranchEdit::Display);
        QVERIFY(!m_bar->putBackButton()->isVisibleTo(m_bar.get()));
        const document::Fractal before = m_document->fractal();
        click(pointOf({2, 1}));
        QCOMPARE(scene().handles().branch(), (Word{2, 1}));
        const QPointF corner = at({Kind::Vertex, 0, 0});
        drag(at({Kind::Inside, 0, 0}) * 0.55 + at({Kind::Vertex, 2, 0}) * 0.45,
             {90, -40}); // beside the pivot
        QCOMPARE(steps(), 1);
        QVERIFY(system() == *document::system2(before));
        QCOMPARE(scene().handles().branch(), (Word{2, 1}));
        QVERIFY(QLineF(corner + QPointF(90, -40), at({Kind::Vertex, 0, 0})).length() < 1e-6);
        drag(at({Kind::Vertex, 0, 0}), {-20, 10});
        QVERIFY(QLineF(corner + QPointF(70, -30), at({Kind::Vertex, 0, 0})).length() < 1e-6);
        QCOMPARE(document::plane(m_document->fractal())->moved.size(), 1U);
        const Vector<2> point = *ifs::addressPoint<2>(ifs::mapsOf(system()), {2, 1}, {0});
        const Word address =
            read(pixel(document::plane(m_document->fractal())->moved.front().change(point))).address;
        QVERIFY(address.size() > 2 && address[0] == 2 && address[1] == 1);
        QVERIFY(read(pixel(point)).address.empty());
        QVERIFY(m_bar->putBackButton()->isVisibleTo(m_bar.get()));
        m_bar->putBackButton()->click();
        QVERIFY(m_document->fractal() == before);
        QCOMPARE(steps(), 3);
        QVERIFY(!m_bar->putBackButton()->isVisibleTo(m_bar.get()));
        m_document->undoStack()->undo();
        QCOMPARE(document::plane(m_document->fractal())->moved.size(), 1U);
        click(pointOf({0, 0})); // another branch: the button is for all
        m_bar->putBackButton()->click();
        QVERIFY(m_document->fractal() == before);
    }

    // The branch inside the branch moves with it, and so on, as one step that can be put back.
    void orItChangesInsideItself() {
        support::choose(m_bar->edit(), document::BranchEdit::Inside);
        const document::Fractal before = m_document->fractal();
        click(pointOf({2, 1, 2, 1, 0}));
        QCOMPARE(scene().handles().branch(), (Word{2, 1}));
        const QPointF corner = at({Kind::Vertex, 0, 0});
        drag(at({Kind::Inside, 0, 0}) * 0.55 + at({Kind::Vertex, 2, 0}) * 0.45, {90, -40});
        QCOMPARE(steps(), 1);
        QVERIFY(system() == *document::system2(before));
        QVERIFY(QLineF(corner + QPointF(90, -40), at({Kind::Vertex, 0, 0})).length() < 1e-6);
        const ifs::AffineMap<2> step = document::recurringMap(m_document->fractal(), {2, 1});
        QVERIFY(step != document::recurringMap(before, {2, 1}));
        // A point of the branch in the branch, twice moved, has its address; where it was there is nothing.
        const Vector<2> point = *ifs::addressPoint<2>(ifs::mapsOf(system()), {0}, {0});
        const Word address = read(pixel(step(step(point)))).address;
        QVERIFY(address.size() > 4 &&
                std::equal(address.begin(), address.begin() + 5, Word{2, 1, 2, 1, 0}.begin()));
        m_bar->putBackButton()->click();
        QVERIFY(m_document->fractal() == before);
    }

    // It cannot be made so large that it does not get smaller inside itself.
    void itStopsWhereItWouldNotGetSmallerInside() {
        support::choose(m_bar->edit(), document::BranchEdit::Inside);
        m_bar->depth()->setValue(1);
        click(pointOf({1, 2, 0}));
        QCOMPARE(scene().handles().branch(), Word{1});
        const QPointF corner = at({Kind::Vertex, 1, 0}), far = corner + QPointF(3000, 0);
        press(corner);
        move(corner + QPointF(30, 0));
        QVERIFY(stopNote().isEmpty());
        move(far);
        QVERIFY2(stopNote().contains(QStringLiteral("smaller inside itself")), qPrintable(stopNote()));
        const auto radius = [&] {
            return ifs::spectralRadius<2>(document::recurringMap(m_document->fractal(), {1}).linear);
        };
        QVERIFY(radius() < 1 && radius() > 0.9);
        release(far);
        QVERIFY(stopNote().isEmpty());
        QCOMPARE(steps(), 1);
        m_document->undoStack()->undo();
        m_canvas->tools().setAllowsNoAttractor(true);
        drag(corner, {3000, 0});
        QVERIFY(radius() > 1);
    }

    void theSelectedMapsSwingAboutTheirRoots() {
        m_canvas->setTool(CanvasView::Tool::Maps);
        const document::Fractal before = m_document->fractal();
        const document::System2 code = system();
        QVERIFY(!m_bar->swing()->isEnabled());
        m_canvas->selectMaps({code.maps[1].id, code.maps[2].id});
        QVERIFY(m_bar->swing()->isEnabled());
        const Vector<2> root = *document::root(before);
        m_bar->swing()->setSliderDown(true);
        for (const int degrees : {5, 20, 30}) {
            m_bar->swing()->setValue(degrees);
            const ifs::AffineMap<2> expected =
                ifs::swung(code.maps[2].map, root, degrees * std::numbers::pi / 180);
            QVERIFY((system().maps[2].map.linear - expected.linear).norm() < 1e-12);
            QVERIFY((system().maps[2].map.translation - expected.translation).norm() < 1e-12);
        }
        QCOMPARE(steps(), 0);
        m_bar->swing()->setSliderDown(false);
        QCOMPARE(steps(), 1);
        QCOMPARE(m_bar->swing()->value(), 0);
        QVERIFY(system().maps[0] == code.maps[0]);
        m_document->undoStack()->undo();
        QVERIFY(m_document->fractal() == before);
    }

    // By a click beside the knob, by keys, and undone at once.
    void aSwingThatIsNotHeldIsAStepToo() {
        m_canvas->setTool(CanvasView::Tool::Maps);
        const document::Fractal before = m_document->fractal();
        m_canvas->selectMaps({system().maps[1].id});
        QSlider* slider = m_bar->swing();
        m_bar->resize(600, 40);
        QTest::mouseClick(slider, Qt::LeftButton, {}, {slider->width() - 4, slider->height() / 2});
        QCOMPARE(steps(), 1);
        QCOMPARE(slider->value(), 0);
        const document::Fractal clicked = m_document->fractal();
        QVERIFY(!(clicked == before));
        slider->setFocus();
        QTRY_VERIFY(slider->hasFocus());
        QTest::keyClick(slider, Qt::Key_Right);
        QTest::keyClick(slider, Qt::Key_Right);
        QVERIFY(!(m_document->fractal() == clicked));
        QTRY_COMPARE(steps(), 2);
        QCOMPARE(slider->value(), 0);
        QTest::keyClick(slider, Qt::Key_Right);
        QKeyEvent undo(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
        QCoreApplication::sendEvent(slider, &undo);
        QCOMPARE(steps(), 3);
        m_document->undoStack()->undo();
        m_document->undoStack()->undo();
        QVERIFY(m_document->fractal() == clicked);
        m_document->undoStack()->undo();
        QVERIFY(m_document->fractal() == before);
    }

    // A shear that contracts only when it comes several times: turned, it does no more.
    void weavingStopsWhereTheAttractorWouldBeLost() {
        document::Fractal sheared = m_document->fractal();
        document::System2 code;
        ifs::append(code, ifs::affineMap(0.5, 2, 0, 0.5, 0, 0), 1);
        ifs::append(code, ifs::affineMap(0.3, 0, 0, 0.3, 1, 0), 1);
        sheared.shape = document::Shape<2>{code};
        m_document->edit(QStringLiteral("test"), sheared);
        m_canvas->setTool(CanvasView::Tool::Maps);
        m_canvas->selectMaps({system().maps[0].id});
        const auto verdict = [this] { return ifs::classify<2>(ifs::activeMaps(system()).maps).verdict; };
        const Vector<2> root = *document::root(sheared);
        const auto swung = [&](int degrees) {
            return ifs::swung(code.maps[0].map, root, degrees * std::numbers::pi / 180);
        };
        QSlider* slider = m_bar->swing();
        slider->setSliderDown(true);
        slider->setValue(2);
        QCOMPARE(slider->value(), 2);
        QVERIFY(stopNote().isEmpty());
        slider->setValue(60);
        const int reached = slider->value();
        QVERIFY(reached > 2 && reached < 8); // 7.5° is where the spectral radius comes to 1
        QVERIFY((system().maps[0].map.linear - swung(reached).linear).norm() < 1e-12);
        QVERIFY(ifs::hasAttractor(ifs::classify<2>(ifs::activeMaps(system()).maps)));
        QVERIFY2(stopNote().contains(QStringLiteral("map 1")) &&
                     stopNote().contains(QStringLiteral("largest singular value")),
                 qPrintable(stopNote()));
        slider->setValue(1); // and back
        QVERIFY(stopNote().isEmpty());
        slider->setValue(60);
        slider->setSliderDown(false);
        QVERIFY(stopNote().isEmpty());
        QCOMPARE(steps(), 2);

        m_canvas->tools().setAllowsNoAttractor(true);
        slider->setSliderDown(true);
        slider->setValue(60);
        QCOMPARE(slider->value(), 60);
        QCOMPARE(verdict(), ifs::Verdict::None);
        slider->setSliderDown(false);
    }
};

BARYCAGE_TEST(BranchToolTest, QApplication);
#include "branch_tool_test.moc"
