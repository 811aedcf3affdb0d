// SPDX-License-Identifier: MIT
#include "messages/tour.h"

#include "app/gui/window_fixture.h"
#include "canvas/geometry/canvas_geometry.h"
#include "canvas/items/note_item.h"
#include "dialogs/export/export_dialog.h"
#include "document/edits/timeline/motion_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "panels/maps/maps_panel.h"
#include "panels/timeline/timeline_panel.h"
#include "support/events.h"
#include "support/forget_settings.h"
#include "support/languages.h"
#include "support/named.h"
#include "support/named_test.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QGraphicsScene>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

#include <cmath>

// The tour says one sentence at a time where things are, waits until it has been done, and locks nothing.
class TourTest : public WindowFixture {
    Q_OBJECT

private slots:
    void everyStepIsOneSentence_data() { support::addLanguages(); }
    void everyStepIsOneSentence();
    void sixStepsAreDoneByTheHand();
    void threeMoreShowWhatIsBehind();
    void stepsCanBeSkipped();
    void theFirstHintGoesWithTheTour();
    void theCardCoversNothingTheCanvasSays();
    void theCardCoversNoCorner();
    void theWindIsThereWhateverMoves();
    void theDialogKeepsTheKeyboard();
    void afterItAllIsAsBefore();
    void theCardCoversNoPanelItSpeaksOf();
    void theCardFollowsTheCanvas();
    void aClosedPanelIsSaid();
    void theCardCanBeDragged();
    void theWindowMayCloseMeanwhile();

private:
    document::Document& document() const { return m_window->document(); }
    Tour* tour() const { return m_window->findChild<Tour*>(); }
    void start() const { Tour::start(m_window.get(), &document(), m_window->panels()); }
    QAbstractButton* button(const char* name) const { return support::button(*tour(), name); }
    bool isShown(const char* name) const {
        const auto* found = tour()->findChild<QAbstractButton*>(QLatin1String(name));
        return found && found->isVisible();
    }
    QAbstractButton* next() const { return button(isShown("skip") ? "skip" : "go-on"); }
    void settle() const {
        QCoreApplication::processEvents();
        QCoreApplication::processEvents();
    }
    view::CanvasView& canvas() const { return *m_window->findChild<view::CanvasView*>(); }
    QPoint corner(int index) const {
        return canvas().canvas().positionOf({view::CanvasPart::Kind::Vertex, index}).toPoint();
    }
    // As a hand does it, in small steps.
    void drag(const QPoint& from, const QPoint& to) const {
        QWidget* viewport = canvas().viewport();
        QTest::mousePress(viewport, Qt::LeftButton, {}, from);
        for (int part = 1; part <= 8; ++part)
            QTest::mouseMove(viewport, from + (to - from) * part / 8);
        QTest::mouseRelease(viewport, Qt::LeftButton, {}, to);
    }
    void cleanUp() const { document().undoStack()->setClean(); }
};

void TourTest::everyStepIsOneSentence() {
    QFETCH(QString, language);
    const support::Spoken spoken(language);
    QVERIFY(spoken.isInstalled());
    start();
    for (int step = 0; step < 11; ++step) {
        settle();
        QCOMPARE(tour()->step(), step);
        const QString text = tour()->accessibleDescription();
        QVERIFY2(text.endsWith(u'.') && text.count(QStringLiteral(". ")) == 0 &&
                     text.size() <= (language == u"en" ? 130 : 140),
                 qPrintable(text));
        QVERIFY(m_window->rect().contains(tour()->geometry()));
        if (step < 10) next()->click();
    }
    button("done")->click();
    QTRY_VERIFY(!tour());
}

void TourTest::sixStepsAreDoneByTheHand() {
    QTRY_VERIFY(canvas().canvas().handles().cage().has_value());
    start();
    QTRY_VERIFY(tour()->target() == &canvas());
    // Drag.
    drag(corner(0), corner(0) + QPoint(30, -15));
    QTRY_COMPARE(tour()->step(), 1);
    // Squeeze it flat and open it again.
    const QPoint open = corner(2);
    drag(corner(2), (corner(0) + corner(1)) / 2);
    settle();
    QCOMPARE(tour()->step(), 1);
    drag(corner(2), open);
    QTRY_COMPARE(tour()->step(), 2);
    document().undoStack()->undo(); // of the opening: the picture is flat
    settle();
    QCOMPARE(tour()->step(), 2);
    document().undoStack()->undo();
    QTRY_COMPARE(tour()->step(), 3);
    // A picture of the collection.
    QCOMPARE(tour()->target()->objectName(), QStringLiteral("collection"));
    document::Fractal other = document().entryFractal();
    other.name = QStringLiteral("other");
    document().setFile(document::fileOf(other));
    QTRY_COMPARE(tour()->step(), 4);
    QCOMPARE(tour()->target()->objectName(), QStringLiteral("timeline"));
    m_window->findChild<view::TimelinePanel*>()->motions().front()->trigger();
    QTRY_COMPARE(tour()->step(), 5);
    m_window->findChild<QAction*>(QStringLiteral("export-picture"))->trigger();
    settle();
    QCOMPARE(tour()->step(), 5); // nothing is saved yet
    const QTemporaryDir folder;
    m_window->findChild<view::ExportDialog*>()->exportTo(folder.filePath(QStringLiteral("a.png")));
    QTRY_COMPARE(tour()->step(), 6);
    QVERIFY(isShown("go-on"));
    cleanUp();
}

void TourTest::threeMoreShowWhatIsBehind() {
    QTRY_VERIFY(canvas().canvas().handles().cage().has_value());
    start();
    for (int step = 0; step < 7; ++step)
        next()->click();
    QCOMPARE(tour()->step(), 7);
    QCOMPARE(tour()->target()->objectName(), QStringLiteral("maps"));
    const auto editMap = [this](double factor) {
        document::Fractal fractal = document().fractal();
        document::plane(fractal)->system.maps.front().map.linear *= factor;
        document().edit(QStringLiteral("Edit"), fractal);
    };
    editMap(0.9);
    QTRY_COMPARE(tour()->step(), 8);
    QCOMPARE(canvas().tool(), view::CanvasView::Tool::Branch);
    canvas().tools().branchTool().choice().choose({0, 1, 0, 1, 0});
    QTRY_COMPARE(tour()->step(), 9);
    editMap(10); // which leaves no attractor
    settle();
    QCOMPARE(tour()->step(), 9);
    editMap(0.09);
    QTRY_COMPARE(tour()->step(), 10);
    button("done")->click();
    QTRY_VERIFY(!tour());
    cleanUp();
}

void TourTest::stepsCanBeSkipped() {
    start();
    QPoint nextCorner;
    for (int step = 0; step < 6; ++step) {
        settle();
        QCOMPARE(tour()->step(), step);
        QCOMPARE(isShown("back"), step > 0);
        QAbstractButton* skip = button("skip");
        QVERIFY(skip);
        const QPoint place = skip->mapTo(m_window.get(), skip->rect().bottomRight());
        const bool yields = step >= 4; // to the timeline, which takes its room from the canvas
        if (step > 0 && !yields) QCOMPARE(place, nextCorner); // under the pointer that has just clicked it
        nextCorner = place;
        skip->click();
    }
    button("back")->click();
    QCOMPARE(tour()->step(), 5);
    // Nothing is locked: the fractal can be edited while the banner is there.
    document::Fractal fractal = document().fractal();
    fractal.name = QStringLiteral("other");
    document().edit(QStringLiteral("rename"), fractal);
    QCOMPARE(document().undoStack()->count(), 1);
    button("close")->click();
    QTRY_VERIFY(!tour());
    cleanUp();
}

// What it says would stand beside the first step.
void TourTest::theFirstHintGoesWithTheTour() {
    support::forgetSettings();
    m_window->openFirstPicture();
    QVERIFY(!canvas().hint().isEmpty());
    start();
    QCOMPARE(tour()->step(), 0);
    QVERIFY(canvas().hint().isEmpty());
}

void TourTest::theCardCoversNothingTheCanvasSays() {
    document::Fractal fractal = m_window->document().fractal();
    for (auto& map : document::plane(fractal)->system.maps)
        map.enabled = false;
    m_window->document().edit(QStringLiteral("switch off"), fractal);
    auto* canvas = m_window->findChild<view::CanvasView*>();
    QTRY_VERIFY(!canvas->note().isEmpty()); // at the top, in the middle
    const auto notes = [canvas] {
        QList<QRect> boxes;
        for (const QGraphicsItem* item : canvas->scene()->items())
            if (const auto* note = dynamic_cast<const view::NoteItem*>(item);
                note && note->text() == canvas->note())
                boxes << canvas->mapFromScene(note->sceneBoundingRect()).boundingRect();
        return boxes;
    };
    QCOMPARE(notes().size(), 1);
    const auto isInTheMiddle = [&] {
        return std::abs(notes().first().center().x() - canvas->viewport()->rect().center().x()) <= 20;
    };
    QVERIFY(isInTheMiddle());
    for (const int width : {1280, 900}) { // beside the card, or below it
        m_window->resize(width, 800);
        start();
        for (int step = 0; step < 5; ++step) {
            settle();
            const auto overlaps = [&] {
                const QRect card(canvas->viewport()->mapFrom(m_window.get(), tour()->pos()), tour()->size());
                return !notes().isEmpty() && card.intersects(notes().first());
            };
            QTRY_VERIFY2(!overlaps(), qPrintable(QStringLiteral("%1, step %2").arg(width).arg(step)));
            next()->click();
        }
    }
    m_window->resize(1280, 800);
    tour()->close();
    QTRY_VERIFY(!tour());
    QTRY_VERIFY(isInTheMiddle()); // which is free again
    m_window->document().undoStack()->setClean();
}

void TourTest::theCardCoversNoCorner() {
    auto* canvas = m_window->findChild<view::CanvasView*>();
    canvas->fit();
    QTRY_VERIFY(canvas->canvas().handles().cage().has_value());
    start();
    for (int step = 0; step < 6; ++step) {
        settle();
        QTRY_VERIFY(tour()->isVisible() && tour()->step() == step);
        const QRect card(canvas->viewport()->mapFrom(m_window.get(), tour()->pos()), tour()->size());
        const auto& cage = canvas->canvas().handles().cage();
        for (const QPointF& corner : view::pixelsOf(canvas->camera(), cage->current))
            QVERIFY2(!card.adjusted(-12, -12, 12, 12).contains(corner.toPoint()),
                     qPrintable(QStringLiteral("step %1").arg(step)));
        if (step < 5) next()->click();
    }
    // Where the upper right corner is free, it stays there.
    tour()->close();
    QTRY_VERIFY(!tour());
    canvas->navigation().pan(QPointF(-5000, 0));
    start();
    settle();
    QTRY_VERIFY(tour()->geometry().center().x() > m_window->centralWidget()->geometry().center().x());
    QVERIFY(tour()->geometry().center().y() < m_window->centralWidget()->geometry().center().y());
}

void TourTest::theWindIsThereWhateverMoves() {
    start();
    for (int step = 0; step < 4; ++step)
        next()->click();
    settle();
    const auto* timeline = m_window->findChild<view::TimelinePanel*>();
    QVERIFY(!timeline->showsTracks());
    const QString still = tour()->accessibleDescription();
    const auto moving = document::withTurn(document().entryFractal(), {});
    QVERIFY(moving);
    tour()->findChild<QAbstractButton*>(QStringLiteral("back"))->click();
    document().editEntry(QStringLiteral("Turn"), *moving);
    next()->click();
    QTRY_VERIFY(timeline->showsTracks());
    QTRY_VERIFY(tour()->accessibleDescription() != still);
    const QString name = timeline->motionMenu()->title().remove(u'&');
    QVERIFY2(tour()->accessibleDescription().contains(name), qPrintable(name)); // where the wind is now
    document().undoStack()->undo();
    QTRY_COMPARE(tour()->accessibleDescription(), still);
    cleanUp();
}

// Whatever the tour does meanwhile.
void TourTest::theDialogKeepsTheKeyboard() {
    start();
    for (int step = 0; step < 5; ++step)
        next()->click();
    m_window->findChild<QAction*>(QStringLiteral("export-picture"))->trigger();
    auto* dialog = m_window->findChild<view::ExportDialog*>();
    QVERIFY(QTest::qWaitForWindowActive(dialog));
    next()->click();
    settle();
    QVERIFY(dialog->isActiveWindow());
}

void TourTest::afterItAllIsAsBefore() {
    const auto shown = [this] {
        QStringList panels;
        for (const auto* panel : m_window->findChildren<QDockWidget*>())
            if (!panel->isHidden()) panels << panel->objectName();
        panels.sort();
        return panels;
    };
    const auto* table = m_window->findChild<view::MapsPanel*>()->table();
    const QStringList before = shown();
    QVERIFY(table->isColumnHidden(view::MapsModel::Contraction));
    const auto tool = canvas().tool();
    start();
    for (int step = 0; step < 9; ++step)
        next()->click();
    QTRY_VERIFY(!table->isColumnHidden(view::MapsModel::Contraction));
    QVERIFY(shown() != before);
    next()->click();
    button("done")->click();
    QTRY_VERIFY(!tour());
    QCOMPARE(canvas().tool(), tool);
    QVERIFY(table->isColumnHidden(view::MapsModel::Contraction));
    QCOMPARE(table->horizontalScrollBar()->value(), 0);
    QCOMPARE(shown(), before);
}

void TourTest::theCardCoversNoPanelItSpeaksOf() {
    for (const int height : {800, 700}) {
        m_window->resize(1280, height);
        start();
        for (int step = 0; step < 9; ++step) {
            settle();
            if (tour()->target() != &canvas()) {
                const auto covers = [this] {
                    const QWidget* panel = tour()->target();
                    return tour()->geometry().intersects(
                        {panel->mapTo(m_window.get(), QPoint()), panel->size()});
                };
                QTRY_VERIFY2(!covers(), qPrintable(QStringLiteral("%1, step %2").arg(height).arg(step)));
            }
            next()->click();
        }
        tour()->close();
        QTRY_VERIFY(!tour());
    }
}

void TourTest::theCardFollowsTheCanvas() {
    const int right = canvas().viewport()->width() - 60;
    drag(corner(0), QPoint(60, 60)); // no room at the top, so that the card is at the bottom
    drag(corner(1), QPoint(right, 60));
    start();
    QTRY_VERIFY(tour()->isVisible());
    settle();
    m_window->panels().show(Panel::Timeline);
    const auto isInside = [this] {
        const QWidget* canvas = m_window->centralWidget();
        const QRect room(canvas->mapTo(m_window.get(), QPoint()), canvas->size());
        return room.contains(tour()->geometry());
    };
    QTRY_VERIFY(isInside());
    m_window->panels().dock(Panel::Timeline)->hide();
    cleanUp();
}

void TourTest::aClosedPanelIsSaid() {
    start();
    for (int step = 0; step < 3; ++step) {
        settle();
        next()->click();
    }
    settle();
    QDockWidget* panel = m_window->panels().dock(Panel::Collection);
    QCOMPARE(tour()->target(), panel);
    const QString asked = tour()->accessibleDescription();
    panel->close();
    QTRY_VERIFY(tour()->accessibleDescription().contains(panel->windowTitle()));
    QVERIFY(tour()->accessibleDescription() != asked);
    panel->show();
    QTRY_COMPARE(tour()->accessibleDescription(), asked);
}

void TourTest::theCardCanBeDragged() {
    start();
    QTRY_VERIFY(tour()->isVisible());
    settle();
    const QPoint before = tour()->pos();
    QWidget* title = tour()->findChild<QLabel*>(QStringLiteral("progress"));
    const QPoint grip = title->rect().center();
    QTest::mousePress(title, Qt::LeftButton, {}, grip);
    QTest::mouseMove(title, grip + QPoint(-60, 40));
    QTest::mouseRelease(title, Qt::LeftButton, {}, grip + QPoint(-60, 40));
    QCOMPARE(tour()->pos(), before + QPoint(-60, 40));
    next()->click();
    settle();
    QCOMPARE(tour()->pos(), before + QPoint(-60, 40)); // where the user wants it
}

void TourTest::theWindowMayCloseMeanwhile() {
    start();
    for (int step = 0; step < 2; ++step)
        next()->click();
    m_window.reset();
    m_window = std::make_unique<MainWindow>();
}

BARYCAGE_TEST(TourTest, QApplication);
#include "tour_test.moc"
