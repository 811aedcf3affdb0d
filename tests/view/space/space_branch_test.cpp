// SPDX-License-Identifier: MIT
#include "canvas/geometry/canvas_geometry.h"
#include "canvas/tools/branch_choice.h"
#include "document/branches/shown_branch.h"
#include "document/edits/cage/space_cage_edits.h"
#include "document/edits/timeline/animation_edits.h"
#include "document/maps/space_map_handles.h"
#include "ifs/cage/cage_surface.h"
#include "space/four_views.h"
#include "support/named_test.h"
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
    return *document::SpaceMapHandles(document.sharedFractal(), cage).corners(branch);
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
    void aThinTwigIsHitNearby();
    void theDepthIsChosenByWheelAndKeys();
    void aClickBesideTheSolidLetsTheBranchGo();
    void aDragTurnsTheViewAndSelectsNothing();
    void aBranchBecomesAMapOfItsOwnInOneStep();
    void theLastMapOfItsAddressChanges();
    void onlyHereTheCodeStays();
    void insideItselfItStaysSmaller();
    void aBentSolidIsTakenByItsBranches();
    void escapeBringsTheBranchBack();
    void theKeyboardMovesTheBranch();
    void anotherEntryEndsTheDrag();
    void undoEndsTheDrag();
    void whatCannotBeDoneIsSaid();
    void warningsComeBeforeTheHint();
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

// A few pixels beside the silhouette are as good as on it.
void SpaceBranchTest::aThinTwigIsHitNearby() {
    BranchWindow window;
    QVERIFY(window.rests());
    QPointF farRight(-1, 0);
    for (int corner = 0; corner < 8; ++corner) {
        const ifs::Vector<3> at(corner & 1, corner >> 1 & 1, corner >> 2);
        const QPointF pixel = view::toPoint(toScreen(window.camera(), at).pixel);
        if (pixel.x() > farRight.x()) farRight = pixel;
    }
    const auto clickBeside = [&](double pixels) {
        window.choice.choose({});
        const QPointF at = farRight + QPointF(pixels, 0);
        window.send(QEvent::MouseButtonPress, at, Qt::LeftButton);
        window.send(QEvent::MouseButtonRelease, at, Qt::LeftButton);
        return window.choice.branch();
    };
    QVERIFY(clickBeside(9).empty());
    const Word beside = clickBeside(2.5);
    QVERIFY(!beside.empty());
    QCOMPARE(beside, clickBeside(-2));
}

void SpaceBranchTest::aClickBesideTheSolidLetsTheBranchGo() {
    BranchWindow window;
    QVERIFY(window.rests());
    window.clickTheFace();
    QCOMPARE(window.choice.branch(), (Word{3, 5}));
    const QPointF beside(3, 3);
    window.send(QEvent::MouseButtonPress, beside, Qt::LeftButton); // an orbit
    window.send(QEvent::MouseMove, beside + QPointF(20, 9), Qt::LeftButton);
    window.send(QEvent::MouseButtonRelease, beside + QPointF(20, 9), Qt::LeftButton);
    QCOMPARE(window.choice.branch(), (Word{3, 5}));
    QVERIFY(window.rests());
    window.send(QEvent::MouseButtonPress, beside, Qt::LeftButton);
    window.send(QEvent::MouseButtonRelease, beside, Qt::LeftButton);
    QVERIFY(window.choice.branch().empty());
    QVERIFY(window.view->note().contains(QStringLiteral("Click a point")));
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

void SpaceBranchTest::onlyHereTheCodeStays() {
    BranchWindow window;
    QVERIFY(window.rests());
    window.choice.setEdit(BranchEdit::Display);
    window.clickTheFace();
    const document::Fractal before = window.document.fractal();
    const Corners was = cornersOf(window.document, {3, 5});
    const QPointF middle = window.held().handle(view::SpaceMaps::middle);
    window.drag(middle, middle + QPointF(120, -60));
    QCOMPARE(window.document.undoStack()->count(), 1);
    QVERIFY(document::isSameSystem(window.document.fractal(), before));
    QCOMPARE(document::space(window.document.fractal())->moved.size(), std::size_t(1));
    QCOMPARE(window.choice.branch(), (Word{3, 5}));
    // The handles are where the branch is now, and a click there finds it again.
    const Corners is = cornersOf(window.document, {3, 5});
    QVERIFY(farthest(is, window.held().vertices()) < 1e-12);
    QVERIFY((is[0] - was[0]).norm() > 0.1);
    QVERIFY(window.rests());
    const ifs::Vector<3> shift = is[0] - was[0];
    window.choice.choose({});
    window.click(ifs::Vector<3>(1, 0.6, 0.3) + shift);
    QCOMPARE(window.choice.branch(), (Word{3, 5}));
    window.document.undoStack()->undo();
    QVERIFY(window.document.fractal() == before);
    window.document.undoStack()->redo();
    QVERIFY(cornersOf(window.document, {3, 5}) == is);
}

// It is held back where it would no longer shrink from one branch to the next.
void SpaceBranchTest::insideItselfItStaysSmaller() {
    BranchWindow window;
    QVERIFY(window.rests());
    window.choice.setEdit(BranchEdit::Inside);
    window.choice.setDepth(1);
    window.clickTheFace();
    QCOMPARE(window.choice.branch(), Word{3});
    const QPointF middle = window.held().handle(view::SpaceMaps::middle);
    const QPointF corner = window.held().handle(0);
    window.send(QEvent::MouseButtonPress, corner, Qt::LeftButton, Qt::AltModifier);
    const QPointF far = middle + 40 * (corner - middle);
    window.send(QEvent::MouseMove, far, Qt::LeftButton, Qt::AltModifier);
    QVERIFY2(window.view->note().startsWith(QStringLiteral("Stopped")), qPrintable(window.view->note()));
    const auto step = document::recurringMap(*document::space(window.document.fractal()), {3});
    QVERIFY(ifs::spectralRadius<3>(step.linear) < 1);
    QVERIFY(ifs::spectralRadius<3>(step.linear) > 0.9);
    window.send(QEvent::MouseButtonRelease, far, Qt::LeftButton, Qt::AltModifier);
    QVERIFY(window.view->note().isEmpty());
    QCOMPARE(document::system3(window.document.fractal())->maps.size(), std::size_t(8));
}

// A cage of more vertices bends the solid, and its branches are chosen and dragged all the same.
void SpaceBranchTest::aBentSolidIsTakenByItsBranches() {
    BranchWindow window;
    document::Fractal bent =
        *document::withPolyhedronFitted(window.document.fractal(), document::SpacePolyhedron::Box);
    document::space(bent)->cage->current[0] -= ifs::Vector<3>(0.2, 0.3, 0.1);
    QVERIFY(ifs::bends(*document::space(bent)->cage));
    window.document.edit(QStringLiteral("Bend"), bent);
    QVERIFY(window.rests());
    const auto& cage = *document::space(bent)->cage;
    const ifs::CageDeformation bend(cage.rest, cage.current);
    window.click(bend({1, 0.6, 0.3}));
    QCOMPARE(window.choice.branch(), (Word{3, 5}));
    QCOMPARE(window.held().count(), std::size_t(5));
    const Corners was = cornersOf(window.document, {3, 5});
    QVERIFY(farthest(was, window.held().vertices()) < 1e-12);
    window.choice.setEdit(BranchEdit::Display);
    const QPointF corner = window.held().handle(1);
    window.drag(corner, corner + QPointF(12, -7));
    const Corners is = cornersOf(window.document, {3, 5});
    const QPointF moved = view::toPoint(toScreen(window.camera(), is[1]).pixel);
    QVERIFY(QLineF(moved, corner + QPointF(12, -7)).length() < 1);
    QVERIFY((is[0] - was[0]).norm() < 1e-7);
    QVERIFY(window.lastSaid() == QStringLiteral("Branch 4 6"));
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
    window.send(QEvent::MouseButtonRelease, corner + QPointF(9, 9), Qt::LeftButton);
    QTest::keyClick(window.view.get(), Qt::Key_Escape);
    QVERIFY(window.choice.branch().empty());
}

void SpaceBranchTest::theKeyboardMovesTheBranch() {
    BranchWindow window;
    QVERIFY(window.rests());
    window.clickTheFace();
    QTest::keyClick(window.view.get(), Qt::Key_Tab);
    QVERIFY(window.view->accessibleDescription().startsWith(QStringLiteral("Corner 1 of the branch")));
    for (int corner = 1; corner < 5; ++corner)
        QTest::keyClick(window.view.get(), Qt::Key_Tab);
    QVERIFY(
        window.view->accessibleDescription().startsWith(QStringLiteral("The middle of the branch at 0.")));
    for (int corner = 1; corner < 5; ++corner)
        QTest::keyClick(window.view.get(), Qt::Key_Backtab);
    QTest::keyClick(window.view.get(), Qt::Key_Right);
    QCOMPARE(window.document.undoStack()->undoText(), QStringLiteral("Move corner 1 of branch 4 6"));
    QCOMPARE(document::system3(window.document.fractal())->maps.size(), std::size_t(15));
    QCOMPARE(window.choice.branch(), Word{0});
    QTest::keyClick(window.view.get(), Qt::Key_Right); // the same corner, of a map now
    QCOMPARE(document::system3(window.document.fractal())->maps.size(), std::size_t(15));
    QCOMPARE(window.document.undoStack()->undoText(), QStringLiteral("Move corner 1 of branch 1"));

    // Without a branch there is no corner to move: the keys turn the view.
    const int steps = window.document.undoStack()->index();
    QTest::keyClick(window.view.get(), Qt::Key_Escape);
    QVERIFY(window.choice.branch().empty());
    const auto before = window.camera().orientation;
    QTest::keyClick(window.view.get(), Qt::Key_Right);
    QVERIFY(!(window.camera().orientation.coeffs() == before.coeffs()));
    QCOMPARE(window.document.undoStack()->index(), steps);
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

// Undone in the middle of the next drag, which fingers can hold while a key is pressed, the first one gives
// back its branch, and nothing of the other stays.
void SpaceBranchTest::undoEndsTheDrag() {
    BranchWindow window;
    QVERIFY(window.rests());
    window.clickTheFace();
    const document::Fractal before = window.document.fractal();
    const QPointF corner = window.held().handle(2);
    window.drag(corner, corner + QPointF(9, 9));
    QCOMPARE(window.choice.branch(), Word{0});
    window.choice.choose({2, 1});
    const QPointF other = window.held().handle(2);
    for (const bool isMovedOn : {true, false}) {
        window.send(QEvent::MouseButtonPress, other, Qt::LeftButton);
        window.send(QEvent::MouseMove, other + QPointF(9, 9), Qt::LeftButton);
        QCOMPARE(window.choice.branch(), Word{0});
        window.document.undoStack()->undo();
        QVERIFY(window.document.fractal() == before);
        const qsizetype said = window.said.count();
        if (isMovedOn) window.send(QEvent::MouseMove, other + QPointF(20, 9), Qt::LeftButton);
        window.send(QEvent::MouseButtonRelease, other + QPointF(20, 9), Qt::LeftButton);
        QVERIFY(window.document.fractal() == before);
        QCOMPARE(window.choice.branch(), (Word{3, 5}));
        QVERIFY(!window.choice.before());
        QCOMPARE(window.said.count(), said); // no map was made
        window.document.undoStack()->redo();
        QCOMPARE(window.choice.branch(), Word{0});
        window.choice.choose({2, 1});
    }
}

void SpaceBranchTest::whatCannotBeDoneIsSaid() {
    BranchWindow window;
    QVERIFY(window.rests());
    window.clickTheFace();
    document::Fractal fractal = window.document.fractal();
    const QPointF corner = window.held().handle(1);
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

void SpaceBranchTest::warningsComeBeforeTheHint() {
    BranchWindow window;
    QVERIFY(window.rests());
    document::Fractal fractal = window.document.fractal();
    document::system3(fractal)->maps[0].map.linear *= 4;
    window.document.edit(QStringLiteral("Enlarge"), fractal);
    QVERIFY2(window.view->note().contains(QStringLiteral("no attractor")), qPrintable(window.view->note()));
    window.document.undoStack()->undo();
    QVERIFY2(window.view->note().contains(QStringLiteral("Click a point")), qPrintable(window.view->note()));
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

BARYCAGE_TEST(SpaceBranchTest, QApplication);
#include "space_branch_test.moc"
