// SPDX-License-Identifier: MIT
#include "first_minute.h"

#include "app/gui/window_fixture.h"
#include "bridges/render_bridge.h"
#include "canvas/canvas_view.h"
#include "desktop/preferences.h"
#include "dialogs/export/export_dialog.h"
#include "dialogs/export/export_size_editor.h"
#include "dialogs/variations/mutate_dialog.h"
#include "document/moments/animated_fractal.h"
#include "messages/first_chips.h"
#include "messages/message_banner.h"
#include "support/named.h"
#include "support/named_test.h"

#include <QAction>
#include <QPointer>
#include <QPushButton>
#include <QTest>

// What a user meets who has never dragged anything.
class FirstMinuteTest : public WindowFixture {
    Q_OBJECT

private slots:
    void theMapleSwaysAndRests();
    void theFirstPressEndsTheBreeze();
    void reducedMotionShowsAStillPicture();
    void noWindowOfTextIsOpened();
    void theFirstDragOffersThreeThings();
    void eachChipDoesWhatItSays_data();
    void eachChipDoesWhatItSays();
    void theChipsGoAwayByThemselves();

private:
    view::CanvasView& canvas() const { return *m_window->findChild<view::CanvasView*>(); }
    view::RenderBridge& render() const { return *m_window->findChild<view::RenderBridge*>(); }
    FirstMinute& minute() const { return *m_window->findChild<FirstMinute*>(); }
    FirstChips* chips() const { return m_window->findChild<FirstChips*>(); }
    void dragACorner() const {
        QWidget* viewport = canvas().viewport();
        const QPoint corner = canvas().canvas().positionOf({view::CanvasPart::Kind::Vertex, 0}).toPoint();
        QTest::mousePress(viewport, Qt::LeftButton, {}, corner);
        for (const QPoint by : {QPoint(10, -5), QPoint(25, -12), QPoint(40, -20)})
            QTest::mouseMove(viewport, corner + by);
        QTest::mouseRelease(viewport, Qt::LeftButton, {}, corner + QPoint(40, -20));
    }
    const QString m_invitation = QStringLiteral("Take a corner.");
};

void FirstMinuteTest::theMapleSwaysAndRests() {
    QTRY_VERIFY(canvas().canvas().handles().cage().has_value());
    const document::Fractal before = m_window->document().fractal();
    QTRY_VERIFY(render().isCurrent());
    const auto still = render().frame();
    QVERIFY(m_window->beginFirstMinute());
    QVERIFY(minute().isSwaying());
    QVERIFY(canvas().hint().isEmpty());
    QTRY_VERIFY(render().frame() != still && render().frame()->pixels != still->pixels);
    QTRY_VERIFY_WITH_TIMEOUT(!minute().isSwaying(), 20'000);
    QCOMPARE(canvas().hint(), m_invitation);
    QVERIFY(m_window->document().fractal() == before);
    QCOMPARE(m_window->document().undoStack()->count(), 0);
    QVERIFY(!m_window->isWindowModified());
}

void FirstMinuteTest::theFirstPressEndsTheBreeze() {
    QTRY_VERIFY(canvas().canvas().handles().cage().has_value());
    QVERIFY(m_window->beginFirstMinute());
    dragACorner();
    QVERIFY(!minute().isSwaying());
    QCOMPARE(m_window->document().undoStack()->count(), 1);
}

void FirstMinuteTest::reducedMotionShowsAStillPicture() {
    view::Preferences preferences;
    preferences.motion = view::Preferences::Motion::Reduced;
    preferences.store();
    QVERIFY(m_window->beginFirstMinute());
    QVERIFY(!minute().isSwaying());
    QCOMPARE(canvas().hint(), m_invitation);
}

void FirstMinuteTest::noWindowOfTextIsOpened() {
    QVERIFY(m_window->beginFirstMinute());
    QTRY_VERIFY_WITH_TIMEOUT(!minute().isSwaying(), 20'000);
    QVERIFY(!m_window->findChild<MessageBanner*>());
}

void FirstMinuteTest::theFirstDragOffersThreeThings() {
    QTRY_VERIFY(canvas().canvas().handles().cage().has_value());
    dragACorner();
    QTRY_VERIFY(chips() && chips()->isVisible());
    QStringList texts;
    for (const auto* button : chips()->findChildren<QPushButton*>())
        texts << button->text();
    QCOMPARE(texts, (QStringList{QStringLiteral("Make it sway"), QStringLiteral("Grow variations"),
                                 QStringLiteral("Save a poster")}));
    QVERIFY(canvas().hint().isEmpty());
    QTRY_VERIFY(m_window->rect().contains(chips()->geometry()));
    for (const auto* button : chips()->findChildren<QPushButton*>())
        QVERIFY(button->width() >= button->minimumSizeHint().width());
    dragACorner(); // whoever goes on has no need of them
    QTRY_VERIFY(!chips());
    dragACorner();
    QVERIFY(!chips()); // once
    QVERIFY(!m_window->beginFirstMinute());
    m_window->document().undoStack()->setClean();
}

void FirstMinuteTest::eachChipDoesWhatItSays_data() {
    QTest::addColumn<QByteArray>("chip");
    for (const char* chip : {"wind", "mutate", "export-picture"})
        QTest::newRow(chip) << QByteArray(chip);
}

void FirstMinuteTest::eachChipDoesWhatItSays() {
    QFETCH(QByteArray, chip);
    QTRY_VERIFY(canvas().canvas().handles().cage().has_value());
    dragACorner();
    QTRY_VERIFY(chips());
    support::button(*chips(), chip.constData())->click();
    const auto isDone = [&] {
        if (chip == "wind") return document::animationFacts(m_window->document().entryFractal()).has_value();
        if (chip == "mutate") return m_window->findChild<view::MutateDialog*>() != nullptr;
        const auto* dialog = m_window->findChild<view::ExportDialog*>();
        const auto* size = dialog ? dialog->findChild<view::ExportSizeEditor*>() : nullptr;
        return size && size->isOnPaper() && size->pixels().width() * size->pixels().height() > 15'000'000;
    };
    QTRY_VERIFY(isDone());
    QTRY_VERIFY(!chips());
    m_window->document().undoStack()->setClean();
}

void FirstMinuteTest::theChipsGoAwayByThemselves() {
    QAction action;
    const QPointer<FirstChips> shown =
        new FirstChips(m_window.get(), {{&action, QStringLiteral("Sway")}}, 50);
    QVERIFY(shown->isVisible());
    QTRY_VERIFY(!shown);
}

BARYCAGE_TEST(FirstMinuteTest, QApplication);
#include "first_minute_test.moc"
