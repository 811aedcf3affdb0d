// SPDX-License-Identifier: MIT
#include "messages/tour.h"

#include "app/gui/window_fixture.h"
#include "canvas/geometry/canvas_geometry.h"
#include "canvas/items/note_item.h"
#include "document/fractal/fractal_geometry.h"
#include "panels/maps/maps_panel.h"
#include "support/events.h"
#include "support/forget_settings.h"
#include "support/named_test.h"

#include <QApplication>
#include <QDockWidget>
#include <QGraphicsScene>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTableView>
#include <QTest>
#include <QToolBar>
#include <QToolButton>
#include <QUndoStack>

#include <cmath>

// The tour shows its six steps where things are, locks nothing, and leaves the window as it found it.
class TourTest : public WindowFixture {
    Q_OBJECT

private slots:
    void sixStepsPointAtWhatTheySpeakOf();
    void theBarIsPutAway();
    void theOfferIsMadeOnce();
    void theFirstHintGoesWithTheTour();
    void theCardCoversNothingTheCanvasSays();
    void theCardCoversNoCorner();
    void theWindowMayCloseMeanwhile();

private:
    Tour* tour() const { return m_window->findChild<Tour*>(); }
    QPushButton* button(const QString& text) const {
        for (auto* found : tour()->findChildren<QPushButton*>())
            if (found->isVisible() && found->text().remove(u'&') == text) return found;
        return nullptr;
    }
    void settle() const {
        QCoreApplication::processEvents();
        QCoreApplication::processEvents();
    }
};

void TourTest::sixStepsPointAtWhatTheySpeakOf() {
    for (auto* toggle : m_window->findChild<view::MapsPanel*>()->findChildren<QToolButton*>())
        if (toggle->accessibleName().endsWith(QStringLiteral("Properties"))) toggle->click(); // it hides them
    Tour::start(m_window.get());
    const char* targets[] = {"maps", "maps", "construction", "appearance", "", "analysis"};
    QSet<QString> texts;
    QPoint nextCorner;
    for (int step = 0; step < 6; ++step) {
        settle();
        QCOMPARE(tour()->step(), step);
        QVERIFY(tour()->target() && tour()->target()->isVisible());
        if (step < 2) { // the column that it speaks of is seen whole
            const auto* maps = m_window->findChild<view::MapsPanel*>();
            const int column = step == 0 ? view::MapsModel::Contraction : view::MapsModel::Enabled;
            const auto* table = maps->table();
            QTRY_VERIFY(!table->isColumnHidden(column) && table->columnViewportPosition(column) >= 0 &&
                        table->columnViewportPosition(column) + table->columnWidth(column) <=
                            table->viewport()->width());
        }
        if (*targets[step]) {
            QCOMPARE(tour()->target()->objectName(), QLatin1String(targets[step]));
            QTRY_VERIFY(!tour()->target()->visibleRegion().isEmpty()); // not behind another tab
        } else {
            QVERIFY(qobject_cast<view::CanvasView*>(tour()->target()));
        }
        // The banner is wholly in the window and leaves most of the canvas free.
        QVERIFY(m_window->rect().contains(tour()->geometry()));
        const QWidget* canvas = m_window->centralWidget();
        const QRect room(canvas->mapTo(m_window.get(), QPoint()), canvas->size());
        const QRect covered = room.intersected(tour()->geometry());
        QVERIFY(covered.width() * covered.height() < room.width() * room.height() * 45 / 100);
        texts << tour()->accessibleDescription();
        QCOMPARE(button(QStringLiteral("Back")) != nullptr, step > 0);
        QPushButton* next = button(step < 5 ? QStringLiteral("Next") : QStringLiteral("Done"));
        QVERIFY(next);
        const QPoint corner = next->mapTo(m_window.get(), next->rect().bottomRight());
        if (step > 0) QCOMPARE(corner, nextCorner); // under the pointer that has just clicked it
        nextCorner = corner;
        if (step < 5) next->click();
    }
    QCOMPARE(texts.size(), 6);
    button(QStringLiteral("Back"))->click();
    QCOMPARE(tour()->step(), 4);

    // Nothing is locked: the fractal can be edited while the banner is there.
    document::Fractal fractal = m_window->document().fractal();
    fractal.name = QStringLiteral("other");
    m_window->document().edit(QStringLiteral("rename"), fractal);
    QCOMPARE(m_window->document().undoStack()->count(), 1);
    button(QStringLiteral("Close"))->click();
    QTRY_VERIFY(!tour());
    m_window->document().undoStack()->setClean();
}

void TourTest::theBarIsPutAway() {
    auto* bar = m_window->findChild<QToolBar*>(QStringLiteral("construction"));
    QVERIFY(bar->isHidden());
    Tour::start(m_window.get());
    for (int step = 0; step < 2; ++step)
        button(QStringLiteral("Next"))->click();
    QVERIFY(!bar->isHidden());
    button(QStringLiteral("Next"))->click();
    QVERIFY(bar->isHidden());
    button(QStringLiteral("Back"))->click();
    QVERIFY(!bar->isHidden());
    QTest::keyClick(tour(), Qt::Key_Escape);
    QTRY_VERIFY(!tour());
    QVERIFY(bar->isHidden());
}

void TourTest::theOfferIsMadeOnce() {
    Tour::offer(m_window.get());
    QVERIFY(tour());
    QCOMPARE(tour()->step(), -1);
    QVERIFY(!button(QStringLiteral("Back")));
    button(QStringLiteral("Not Now"))->click();
    QTRY_VERIFY(!tour());
    Tour::offer(m_window.get());
    QVERIFY(!tour());
    support::forgetSettings();
    Tour::offer(m_window.get());
    button(QStringLiteral("Start the Tour"))->click();
    QCOMPARE(tour()->step(), 0);
    QWidget* canvas = m_window->findChild<view::CanvasView*>()->viewport();
    QTest::mouseClick(canvas, Qt::LeftButton, {}, QPoint(30, 30));
    support::handleEvents();
    QVERIFY(tour()); // which continues while the user tries its suggestions
    tour()->close();
    QTRY_VERIFY(!tour());
    support::forgetSettings();
    Tour::offer(m_window.get());
    QTest::mouseClick(canvas, Qt::LeftButton, {}, QPoint(30, 30));
    QTRY_VERIFY(!tour()); // who begins is not asked any more
}

// What it says would stand beside the first step.
void TourTest::theFirstHintGoesWithTheTour() {
    support::forgetSettings();
    m_window->openFirstPicture();
    const auto* canvas = m_window->findChild<view::CanvasView*>();
    QVERIFY(!canvas->hint().isEmpty());
    Tour::offer(m_window.get());
    QCOMPARE(tour()->step(), -1);
    QVERIFY(!canvas->hint().isEmpty()); // as long as it is only offered
    button(QStringLiteral("Start the Tour"))->click();
    QCOMPARE(tour()->step(), 0);
    QVERIFY(canvas->hint().isEmpty());
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
        Tour::start(m_window.get());
        for (int step = 0; step < 5; ++step) {
            settle();
            const auto overlaps = [&] {
                const QRect card(canvas->viewport()->mapFrom(m_window.get(), tour()->pos()), tour()->size());
                return !notes().isEmpty() && card.intersects(notes().first());
            };
            QTRY_VERIFY2(!overlaps(), qPrintable(QStringLiteral("%1, step %2").arg(width).arg(step)));
            button(QStringLiteral("Next"))->click();
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
    Tour::start(m_window.get());
    for (int step = 0; step < 6; ++step) {
        settle();
        QTRY_VERIFY(tour()->isVisible() && tour()->step() == step);
        const QRect card(canvas->viewport()->mapFrom(m_window.get(), tour()->pos()), tour()->size());
        const auto& cage = canvas->canvas().handles().cage();
        for (const QPointF& corner : view::pixelsOf(canvas->camera(), cage->current))
            QVERIFY2(!card.adjusted(-12, -12, 12, 12).contains(corner.toPoint()),
                     qPrintable(QStringLiteral("step %1").arg(step)));
        if (step < 5) button(QStringLiteral("Next"))->click();
    }
    // Where the upper right corner is free, it stays there.
    tour()->close();
    QTRY_VERIFY(!tour());
    canvas->navigation().pan(QPointF(-5000, 0));
    Tour::start(m_window.get());
    settle();
    QTRY_VERIFY(tour()->geometry().center().x() > m_window->centralWidget()->geometry().center().x());
    QVERIFY(tour()->geometry().center().y() < m_window->centralWidget()->geometry().center().y());
}

void TourTest::theWindowMayCloseMeanwhile() {
    Tour::start(m_window.get());
    for (int step = 0; step < 2; ++step)
        button(QStringLiteral("Next"))->click();
    m_window.reset();
    m_window = std::make_unique<MainWindow>();
}

BARYCAGE_TEST(TourTest, QApplication);
#include "tour_test.moc"
