// SPDX-License-Identifier: MIT
#include "canvas/geometry/canvas_geometry.h"
#include "canvas/tools/branch_choice.h"
#include "document/edits/animation_edits.h"
#include "document/space_map_handles.h"
#include "space/four_views.h"
#include "support/patient_tries.h"
#include "view/space/space_window.h"

#include <QSignalSpy>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

using document::BranchEdit;
using ifs::Word;
using view::SpaceView;
using namespace space_window;

namespace {

using Corners = document::SpaceMapHandles::Corners;

Corners cornersOf(const document::Document& document, const Word& branch) {
    const auto cage = *document::spaceCage(document.fractal());
    return *document::SpaceMapHandles::of(document.sharedFractal(), cage)->corners(branch);
}

double farthest(const Corners& corners, const std::vector<ifs::Vector<3>>& vertices) {
    double most = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        most = std::max(most, (corners[i] - vertices[i]).norm());
    return most;
}

// A window in which branches are chosen.
struct BranchWindow : Window {
    view::BranchChoice choice{document};
    QSignalSpy said{view.get(), &SpaceView::message};

    BranchWindow() {
        view->setBranchChoice(&choice);
        view->setTarget(SpaceView::Target::Branch);
    }
    void click(const ifs::Vector<3>& at) const {
        const QPointF pixel = view::toPoint(toScreen(camera(), at).pixel);
        send(QEvent::MouseButtonPress, pixel, Qt::LeftButton);
        send(QEvent::MouseButtonRelease, pixel, Qt::LeftButton);
    }
    // On the face x = 1 of the cube: in the eighth at (1, 1, 0), and of that at (1, 0.2, 0.6).
    void clickTheFace() const { click({1, 0.6, 0.3}); }
    QString lastSaid() const { return said.isEmpty() ? QString() : said.last().first().toString(); }
    const view::SpaceCageItem& held() const { return view->mapItem(); }
};

} // namespace

class SpaceBranchTest : public QObject {
    Q_OBJECT

private slots:
    void aClickSelectsTheBranchUnderThePointer();
    void theDepthIsChosenByWheelAndKeys();
    void aDragTurnsTheViewAndSelectsNothing();
    void aBranchBecomesAMapOfItsOwnInOneStep();
    void theLastMapOfItsAddressChanges();
    void escapeBringsTheBranchBack();
    void theKeyboardMovesTheBranch();
    void anotherEntryEndsTheDrag();
    void whatCannotBeDoneIsSaid();
    void fourViewsShowTheSameBranch();
};

void SpaceBranchTest::aClickSelectsTheBranchUnderThePointer() {
    BranchWindow window;
    QVERIFY(window.rests());
    QVERIFY(window.view->note().contains(QStringLiteral("Click a point")));
    QCOMPARE(window.held().count(), std::size_t(0));
    window.click({3, 3, 3}); // beside it
    QVERIFY(window.choice.address().empty());
    window.clickTheFace();
    QCOMPARE(window.choice.branch(), (Word{3, 5}));
    QVERIFY(window.choice.address().size() >= 4);
    QCOMPARE(window.lastSaid(), QStringLiteral("Branch 4 6"));
    QCOMPARE(window.view->note(), QString());
    // It is held by its corners and its middle, and filled with the colour of its last map.
    QCOMPARE(window.held().count(), std::size_t(5));
    QVERIFY(window.held().isVisible());
    QVERIFY(farthest(cornersOf(window.document, {3, 5}), window.held().vertices()) < 1e-12);
    const document::Fractal& fractal = window.document.fractal();
    const auto colour = attractor::mapColour(fractal.appearance, document::system3(fractal)->maps[5].id, 5);
    QCOMPARE(window.held().fill().red(), int(colour.red));
    QVERIFY(window.held().fill().alpha() > 0 && window.held().fill().alpha() < 255);
    // The other tools hold what they did.
    window.view->setTarget(SpaceView::Target::Maps);
    QVERIFY(!window.held().fill().isValid());
    QVERIFY(farthest(cornersOf(window.document, {0}), window.held().vertices()) < 1e-12);
    window.view->setTarget(SpaceView::Target::Branch);
    QVERIFY(farthest(cornersOf(window.document, {3, 5}), window.held().vertices()) < 1e-12);
}

void SpaceBranchTest::theDepthIsChosenByWheelAndKeys() {
    BranchWindow window;
    QVERIFY(window.rests());
    window.clickTheFace();
    const attractor::OrbitCamera before = window.camera();
    const auto turn = [&](int angle) {
        QWheelEvent event({300, 250}, window.view->viewport()->mapToGlobal(QPointF(300, 250)), {}, {0, angle},
                          Qt::NoButton, Qt::ShiftModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(window.view->viewport(), &event);
    };
    turn(120);
    QCOMPARE(window.choice.branch().size(), std::size_t(3));
    turn(-240);
    QCOMPARE(window.choice.branch(), Word{3});
    QVERIFY(window.camera().height == before.height);
    QTest::keyClick(window.view.get(), Qt::Key_PageDown);
    QCOMPARE(window.choice.branch(), (Word{3, 5}));
    QTest::keyClick(window.view.get(), Qt::Key_PageUp);
    QCOMPARE(window.choice.branch(), Word{3});
    QVERIFY(farthest(cornersOf(window.document, {3}), window.held().vertices()) < 1e-12);
}

void SpaceBranchTest::aDragTurnsTheViewAndSelectsNothing() {
    BranchWindow window;
    QVERIFY(window.rests());
    const attractor::OrbitCamera before = window.camera();
    const QPointF face = view::toPoint(toScreen(window.camera(), ifs::Vector<3>(1, 0.6, 0.3)).pixel);
    window.drag(face, face + QPointF(50, 20));
    QVERIFY(window.camera().orientation.coeffs() != before.orientation.coeffs());
    QVERIFY(window.choice.address().empty());
    QCOMPARE(window.document.undoStack()->count(), 0);
}

void SpaceBranchTest::aBranchBecomesAMapOfItsOwnInOneStep() {
    BranchWindow window;
    QVERIFY(window.rests());
    window.clickTheFace();
    const document::Fractal before = window.document.fractal();
    const Corners was = cornersOf(window.document, {3, 5});
    const QPointF corner = window.held().handle(1);
    window.drag(corner, corner + QPointF(14, -9));
    QCOMPARE(window.document.undoStack()->count(), 1);
    QCOMPARE(window.document.undoStack()->undoText(), QStringLiteral("Move corner 2 of branch 4 6"));
    const auto& maps = document::system3(window.document.fractal())->maps;
    QCOMPARE(maps.size(), std::size_t(15)); // the branch, its seven sisters, and the other seven maps
    const Corners is = cornersOf(window.document, {0});
    QVERIFY((is[1] - was[1]).norm() > 0.01);
    for (const std::size_t other : {0, 2, 3})
        QVERIFY((is[other] - was[other]).norm() < 1e-12);
    const QPointF moved = view::toPoint(toScreen(window.camera(), is[1]).pixel);
    QVERIFY(QLineF(moved, corner + QPointF(14, -9)).length() < 1);
    // It is map 1 now, and still held.
    QVERIFY(window.lastSaid().contains(QStringLiteral("now map 1")));
    QCOMPARE(window.choice.branch(), Word{0});
    QVERIFY(farthest(is, window.held().vertices()) < 1e-12);
    // Undo and redo lead back to it.
    window.document.undoStack()->undo();
    QVERIFY(window.document.fractal() == before);
    QCOMPARE(window.choice.branch(), (Word{3, 5}));
    QVERIFY(farthest(was, window.held().vertices()) < 1e-12);
    window.document.undoStack()->redo();
    QCOMPARE(window.choice.branch(), Word{0});
}

void SpaceBranchTest::theLastMapOfItsAddressChanges() {
    BranchWindow window;
    QVERIFY(window.rests());
    window.choice.setEdit(BranchEdit::LastMap);
    window.clickTheFace();
    const document::Fractal before = window.document.fractal();
    const Corners was = cornersOf(window.document, {3, 5});
    const QPointF middle = window.held().handle(view::SpaceMaps::middle);
    window.drag(middle, middle + QPointF(-6, 8));
    QCOMPARE(window.document.undoStack()->undoText(), QStringLiteral("Move branch 4 6"));
    const auto& maps = document::system3(window.document.fractal())->maps;
    QCOMPARE(maps.size(), std::size_t(8));
    for (std::size_t i = 0; i < maps.size(); ++i)
        QCOMPARE(maps[i].map == document::system3(before)->maps[i].map, i != 5);
    // The branch went where it was pulled, although its last map is seen through the map around it.
    const Corners is = cornersOf(window.document, {3, 5});
    const QPointF centre =
        view::toPoint(toScreen(window.camera(), ((is[0] + is[1] + is[2] + is[3]) / 4).eval()).pixel);
    QVERIFY(QLineF(centre, middle + QPointF(-6, 8)).length() < 1);
    for (std::size_t i = 1; i < is.size(); ++i)
        QVERIFY(((is[i] - is[0]) - (was[i] - was[0])).norm() < 1e-12);
    QCOMPARE(window.choice.branch(), (Word{3, 5}));
}

void SpaceBranchTest::escapeBringsTheBranchBack() {
    BranchWindow window;
    QVERIFY(window.rests());
    window.clickTheFace();
    const document::Fractal before = window.document.fractal();
    const QPointF corner = window.held().handle(2);
    window.send(QEvent::MouseButtonPress, corner, Qt::LeftButton);
    window.send(QEvent::MouseMove, corner + QPointF(9, 9), Qt::LeftButton);
    QVERIFY(!(window.document.fractal() == before));
    QCOMPARE(window.choice.branch(), Word{0});
    window.send(QEvent::MouseMove, corner, Qt::LeftButton); // where it began
    QVERIFY(window.document.fractal() == before);
    QCOMPARE(window.choice.branch(), (Word{3, 5}));
    window.send(QEvent::MouseMove, corner + QPointF(9, 9), Qt::LeftButton);
    QTest::keyClick(window.view.get(), Qt::Key_Escape);
    QVERIFY(window.document.fractal() == before);
    QCOMPARE(window.choice.branch(), (Word{3, 5}));
    QCOMPARE(window.document.undoStack()->count(), 0);
    QVERIFY(!window.choice.before());
}

void SpaceBranchTest::theKeyboardMovesTheBranch() {
    BranchWindow window;
    QVERIFY(window.rests());
    window.clickTheFace();
    QTest::keyClick(window.view.get(), Qt::Key_Tab);
    QVERIFY(window.view->accessibleDescription().startsWith(QStringLiteral("Corner 1 of the branch")));
    QTest::keyClick(window.view.get(), Qt::Key_Right);
    QCOMPARE(window.document.undoStack()->undoText(), QStringLiteral("Move corner 1 of branch 4 6"));
    QCOMPARE(document::system3(window.document.fractal())->maps.size(), std::size_t(15));
    QCOMPARE(window.choice.branch(), Word{0});
    QTest::keyClick(window.view.get(), Qt::Key_Right); // the same corner, of a map now
    QCOMPARE(document::system3(window.document.fractal())->maps.size(), std::size_t(15));
    QCOMPARE(window.document.undoStack()->undoText(), QStringLiteral("Move corner 1 of branch 1"));
}

// Another file has other branches; the drag of before does not come back.
void SpaceBranchTest::anotherEntryEndsTheDrag() {
    BranchWindow window;
    QVERIFY(window.rests());
    window.clickTheFace();
    const QPointF corner = window.held().handle(2);
    window.send(QEvent::MouseButtonPress, corner, Qt::LeftButton);
    window.send(QEvent::MouseMove, corner + QPointF(9, 9), Qt::LeftButton);
    window.document.setFile(document::fileOf(cubeOfEight()));
    QVERIFY(window.choice.address().empty());
    QVERIFY(!window.choice.before());
    window.send(QEvent::MouseMove, corner + QPointF(20, 9), Qt::LeftButton);
    window.send(QEvent::MouseButtonRelease, corner + QPointF(20, 9), Qt::LeftButton);
    QVERIFY(window.document.fractal() == cubeOfEight());
    QVERIFY(window.choice.address().empty());
}

void SpaceBranchTest::whatCannotBeDoneIsSaid() {
    BranchWindow window;
    QVERIFY(window.rests());
    window.clickTheFace();
    document::Fractal fractal = window.document.fractal();
    const QPointF corner = window.held().handle(1);
    window.choice.setEdit(BranchEdit::Display);
    window.drag(corner, corner + QPointF(10, 10));
    QVERIFY(window.lastSaid().contains(QStringLiteral("In space")));
    QVERIFY(window.document.fractal() == fractal);

    window.choice.setEdit(BranchEdit::OwnMap);
    auto label = fractal.mapLabels.of(document::system3(fractal)->maps[3].id);
    label.isLocked = true;
    fractal.mapLabels.set(document::system3(fractal)->maps[3].id, label);
    window.document.edit(QStringLiteral("Lock"), fractal);
    window.clickTheFace();
    window.drag(corner, corner + QPointF(10, 10));
    QVERIFY2(window.lastSaid().contains(QStringLiteral("locked")), qPrintable(window.lastSaid()));
    QVERIFY(window.document.fractal() == fractal);
    window.document.undoStack()->undo();

    const document::Fractal keyed =
        document::withKey(window.document.entryFractal(),
                          {document::Track::Kind::Map, {document::system3(fractal)->maps[5].id}}, 0, {});
    window.document.editEntry(QStringLiteral("Key"), keyed);
    window.clickTheFace();
    window.drag(corner, corner + QPointF(10, 10));
    QVERIFY2(window.lastSaid().startsWith(QStringLiteral("Map 6 has keys")), qPrintable(window.lastSaid()));
    QVERIFY(window.document.entryFractal() == keyed);
    window.document.undoStack()->undo();

    fractal = window.document.fractal();
    const auto cage = *document::spaceCage(fractal);
    document::space(fractal)->cage = cage;
    window.document.edit(QStringLiteral("Hold"), fractal);
    window.clickTheFace();
    QCOMPARE(window.choice.branch(), (Word{3, 5}));
    for (ifs::Vector<3>& vertex : document::space(fractal)->cage->current)
        vertex.z() = 0;
    window.document.edit(QStringLiteral("Squeeze"), fractal);
    window.choice.choose({3, 5});
    const QPointF flat = window.held().handle(1);
    window.drag(flat, flat + QPointF(10, 10));
    QVERIFY2(window.lastSaid().contains(QStringLiteral("flat")), qPrintable(window.lastSaid()));
    QVERIFY(window.document.fractal() == fractal);
}

void SpaceBranchTest::fourViewsShowTheSameBranch() {
    document::Document document;
    document.edit(QStringLiteral("Begin"), cubeOfEight());
    view::SolidBridge bridge(&document);
    view::BranchChoice choice(document);
    view::FourViews views(&document, &bridge);
    views.setBranchChoice(&choice);
    views.resize(800, 600);
    views.show();
    views.setTarget(SpaceView::Target::Branch);
    views.showFour(true);
    QVERIFY(!views.main()->note().isEmpty());
    for (const SpaceView* other : views.others())
        QCOMPARE(other->note(), QString()); // what is to be done is said once
    choice.choose({1, 2, 4});
    const Corners corners = cornersOf(document, {1, 2});
    QVERIFY(farthest(corners, views.main()->mapItem().vertices()) < 1e-12);
    for (const SpaceView* other : views.others())
        QVERIFY(farthest(corners, other->mapItem().vertices()) < 1e-12);
}

QTEST_MAIN(SpaceBranchTest)
#include "space_branch_test.moc"
