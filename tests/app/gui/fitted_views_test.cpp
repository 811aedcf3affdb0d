// SPDX-License-Identifier: MIT
#include "stage/fitted_views.h"

#include "app/gui/window_fixture.h"
#include "panels/maps/symmetry_row.h"
#include "space/space_view.h"
#include "support/background_rest.h"
#include "support/choose.h"
#include "support/named_test.h"

#include <QComboBox>
#include <QTest>

#include <cmath>

using namespace Qt::StringLiterals;

// What an edit does to the view, undo takes back.
class FittedViewsTest : public WindowFixture {
    Q_OBJECT

private slots:
    void undoOfASymmetryTakesTheViewBack();
    void undoTakesBackAFitAfterTheEdit();
    void aFitAfterAnotherColourStays();
    void theViewThatTheUserMovedStays();
    void anEditThatLeavesTheViewIsUndoneWithoutIt();
    void solidsAreFittedAgain();
    void undoOfCameraKeysTakesTheViewBack_data();
    void undoOfCameraKeysTakesTheViewBack();

private:
    document::Document& document() { return m_window->document(); }
    QUndoStack& history() { return *document().undoStack(); }
    view::CanvasView& canvas() const { return *m_window->findChild<view::CanvasView*>(); }
    view::CanvasNavigation& plane() const { return canvas().navigation(); }
    void scale(double factor) {
        document::Fractal changed = document().fractal();
        if (auto* shape = document::plane(changed))
            for (auto& map : shape->system.maps)
                map.map.translation *= factor;
        if (auto* shape = document::space(changed))
            for (auto& map : shape->system.maps)
                map.map.translation *= factor;
        document().edit(u"Scale"_s, changed);
    }
    void chooseSymmetry(ifs::SymmetryGroup group) const {
        support::choose(m_window->findChild<view::SymmetryRow*>()->groups(), group);
    }
    // Fits the plane, and waits until the extent that is sought in the background has been fitted.
    void fitAndRest() const {
        plane().fit();
        QVERIFY(support::backgroundRests());
    }
    // Until what is searched in the background has been found.
    void awaitFit(const attractor::Camera& before) const { QTRY_VERIFY(!(plane().camera() == before)); }
};

void FittedViewsTest::undoOfASymmetryTakesTheViewBack() {
    fitAndRest();
    const attractor::Camera before = plane().camera();
    chooseSymmetry(ifs::SymmetryGroup::Mirror);
    awaitFit(before);
    const attractor::Camera symmetric = plane().camera();
    history().undo();
    QCOMPARE(plane().camera(), before);
    QVERIFY(plane().isFitted());
    history().redo();
    QCOMPARE(plane().camera(), symmetric);
    history().undo();
    QCOMPARE(plane().camera(), before);
}

void FittedViewsTest::undoTakesBackAFitAfterTheEdit() {
    fitAndRest();
    const attractor::Camera before = plane().camera();
    scale(0.25);
    QCOMPARE(plane().camera(), before); // the edit alone does not move it
    fitAndRest();
    awaitFit(before);
    scale(0.5);
    history().setIndex(0);
    QCOMPARE(plane().camera(), before);
    // A step that was never undone is no redo.
    const attractor::Camera fitted = plane().camera();
    scale(3);
    QCOMPARE(plane().camera(), fitted);
}

void FittedViewsTest::aFitAfterAnotherColourStays() {
    fitAndRest();
    const attractor::Camera before = plane().camera();
    document::Fractal changed = document().fractal();
    changed.appearance.background.alpha = 0;
    document().edit(u"Transparent"_s, changed);
    plane().setFittedToo(document::Box{{-9, -9}, {9, 9}});
    fitAndRest();
    awaitFit(before);
    const attractor::Camera fitted = plane().camera();
    history().undo();
    QCOMPARE(plane().camera(), fitted);
    history().redo();
    QCOMPARE(plane().camera(), fitted);
}

void FittedViewsTest::theViewThatTheUserMovedStays() {
    fitAndRest();
    chooseSymmetry(ifs::SymmetryGroup::Mirror);
    plane().zoomBy(3);
    const attractor::Camera zoomed = plane().camera();
    history().undo();
    QCOMPARE(plane().camera(), zoomed);
    history().redo();
    QCOMPARE(plane().camera(), zoomed);
}

void FittedViewsTest::anEditThatLeavesTheViewIsUndoneWithoutIt() {
    fitAndRest();
    scale(0.3);
    scale(0.5); // the view is still that of the first picture, not fitted to this one
    const attractor::Camera before = plane().camera();
    history().undo();
    QCOMPARE(plane().camera(), before);
    history().undo();
    QCOMPARE(plane().camera(), before);
    history().redo();
    QCOMPARE(plane().camera(), before);
}

void FittedViewsTest::solidsAreFittedAgain() {
    document::Fractal solid;
    solid.name = u"solid"_s;
    ifs::IteratedFunctionSystem<3> system;
    for (const ifs::Vector<3>& corner : {ifs::Vector<3>(0, 0, 0), ifs::Vector<3>(1, 0, 0),
                                         ifs::Vector<3>(0, 1, 0), ifs::Vector<3>(0, 0, 1)}) {
        ifs::AffineMap<3> map;
        map.linear = 0.5 * ifs::Matrix<3>::Identity();
        map.translation = corner / 2;
        ifs::append(system, map, 0.25);
    }
    solid.shape = document::Shape<3>{std::move(system)};
    document().setFile(document::fileOf(solid));
    view::SpaceNavigation& space = m_window->findChild<view::SpaceView*>()->navigation();
    space.fit();
    const double height = space.camera().height;
    scale(0.25);
    space.fit();
    QVERIFY(space.camera().height < height / 2);
    history().undo();
    QVERIFY(std::abs(space.camera().height / height - 1) < 1e-9);
    QVERIFY(space.isFitted());
}

void FittedViewsTest::undoOfCameraKeysTakesTheViewBack_data() {
    QTest::addColumn<bool>("isFitted");
    QTest::newRow("fitted") << true;
    QTest::newRow("moved by the user") << false;
}

// As after Zoom In Endlessly.
void FittedViewsTest::undoOfCameraKeysTakesTheViewBack() {
    QFETCH(bool, isFitted);
    fitAndRest();
    if (!isFitted) plane().zoomBy(2);
    const attractor::Camera before = plane().camera();
    document::Fractal keyed = document().entryFractal();
    attractor::View close = attractor::viewOf(before);
    document::plane(keyed)->animation.emplace();
    auto& keys = document::plane(keyed)->animation->camera;
    keys.push_back({0, close, {}});
    close.height /= 20;
    keys.push_back({24, close, {}});
    document().editEntry(u"Zoom"_s, keyed);
    document().setMoment(animation::moment(24));
    QVERIFY(plane().camera().pixelsPerUnit > 10 * before.pixelsPerUnit);
    history().undo();
    QVERIFY(std::abs(plane().camera().pixelsPerUnit / before.pixelsPerUnit - 1) < 1e-9);
    QVERIFY((plane().camera().centre - before.centre).norm() < 1e-9);
    QCOMPARE(plane().isFitted(), isFitted);
}

BARYCAGE_TEST(FittedViewsTest, QApplication);
#include "fitted_views_test.moc"
