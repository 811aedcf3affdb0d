// SPDX-License-Identifier: MIT
#include "stage/opened_motion.h"

#include "app/gui/window_fixture.h"
#include "canvas/canvas_view.h"
#include "desktop/preferences.h"
#include "dialogs/export/animation_export_dialog.h"
#include "dialogs/export/export_dialog.h"
#include "document/edits/entries_edits.h"
#include "document/edits/timeline/motion_edits.h"
#include "document/moments/animated_fractal.h"
#include "panels/timeline/timeline_panel.h"
#include "support/events.h"
#include "support/named_test.h"

#include <QAction>
#include <QDockWidget>
#include <QPointer>
#include <QPushButton>
#include <QTest>

// An entry that moves plays when it is opened.
class OpenedMotionTest : public WindowFixture {
    Q_OBJECT

private slots:
    void anEntryThatMovesPlays();
    void withoutItsTimelineItRests_data();
    void withoutItsTimelineItRests();
    void reducedMotionShowsAStillFrame();
    void undoBringsItBackAtRest();
    void itIsFittedToItsWholeMotion();
    void itsPictureLeadsToItsAnimation();

private:
    document::Document& document() const { return m_window->document(); }
    view::Playback& playback() const {
        return m_window->findChild<view::TimelinePanel*>()->timeline().playback();
    }
    QDockWidget& dock() const { return *m_window->findChild<QDockWidget*>(QStringLiteral("timeline")); }
    // Two entries, of which the second moves.
    document::FractalFile twoEntries() const {
        document::Fractal still = document().entryFractal();
        document::Fractal moving = *document::withOrbit(still);
        moving.name = QStringLiteral("moving");
        document::FractalFile file = document::fileOf(still);
        document::Entry entry;
        entry.fractal = std::make_shared<const document::Fractal>(moving);
        return document::inserted(std::move(file), {entry}, document::EntryId::None).file;
    }
};

void OpenedMotionTest::anEntryThatMovesPlays() {
    document().setFile(twoEntries());
    support::handleEvents();
    QVERIFY(!playback().isPlaying());
    QVERIFY(dock().isHidden());
    document().setCurrent(document().file().entries.back().id);
    QTRY_VERIFY(playback().isPlaying());
    QVERIFY(!dock().isHidden());
    QTRY_VERIFY(!(document().moment() == animation::moment(0)));
    document().setCurrent(document().file().entries.front().id);
    QVERIFY(!playback().isPlaying());
}

void OpenedMotionTest::withoutItsTimelineItRests_data() {
    QTest::addColumn<bool>("byTheToolBar");
    QTest::newRow("the button in the tool bar") << true;
    QTest::newRow("the cross of the panel") << false;
}

void OpenedMotionTest::withoutItsTimelineItRests() {
    QFETCH(bool, byTheToolBar);
    document().setFile(twoEntries());
    document().setCurrent(document().file().entries.back().id);
    QTRY_VERIFY(playback().isPlaying());
    if (byTheToolBar)
        m_window->findChild<QAction*>(QStringLiteral("animate"))->trigger();
    else
        dock().close();
    QVERIFY(dock().isHidden());
    QVERIFY(!playback().isPlaying());
    playback().setPlaying(true); // Space on the canvas
    QVERIFY(playback().isPlaying());
}

void OpenedMotionTest::reducedMotionShowsAStillFrame() {
    view::Preferences preferences;
    preferences.motion = view::Preferences::Motion::Reduced;
    preferences.store();
    document().setFile(twoEntries(), {});
    document().setCurrent(document().file().entries.back().id);
    QTRY_VERIFY(!dock().isHidden());
    support::handleEvents();
    QVERIFY(!playback().isPlaying());
    QCOMPARE(document().moment(), animation::moment(0));
    playback().setPlaying(true); // when it is asked for
    QVERIFY(playback().isPlaying());
    playback().setPlaying(false);
}

void OpenedMotionTest::undoBringsItBackAtRest() {
    document().setFile(twoEntries());
    document().setCurrent(document().file().entries.back().id);
    QTRY_VERIFY(playback().isPlaying());
    document::Fractal other = document().entryFractal();
    other.headerComment = QStringLiteral("mine");
    document().editEntry(QStringLiteral("Comment"), other);
    document().setCurrent(document().file().entries.front().id);
    QVERIFY(!playback().isPlaying());
    document().undoStack()->undo();
    QCOMPARE(document().currentId(), document().file().entries.back().id);
    support::handleEvents();
    QVERIFY(!playback().isPlaying());
}

// The picture turns about a centre beside it, so it is elsewhere at other moments.
void OpenedMotionTest::itIsFittedToItsWholeMotion() {
    document::FractalFile file = twoEntries();
    document::Fractal moving = *file.entries.back().fractal;
    auto& motions = document::plane(moving)->animation->motions;
    std::get<animation::Orbit<2>>(motions.front()).centre += ifs::Vector<2>(2, 0);
    file.entries.back().fractal = std::make_shared<const document::Fractal>(moving);
    document().setFile(file);
    document().setCurrent(document().file().entries.back().id);
    QTRY_VERIFY(playback().isPlaying());
    playback().setPlaying(false);
    const auto* canvas = m_window->findChild<view::CanvasView*>();
    const auto isSeen = [&] {
        for (int frame = 0; frame < document::animationFacts(moving)->length; frame += 7) {
            const auto box =
                document::displayedBox(document::frameAt(moving, animation::moment(frame)).fractal);
            for (const auto& corner : {box->min, box->max}) {
                const auto pixel = attractor::toPixel(canvas->camera(), corner);
                if (!canvas->viewport()->rect().contains(int(pixel.x()), int(pixel.y()))) return false;
            }
        }
        return true;
    };
    QTRY_VERIFY(isSeen());
}

void OpenedMotionTest::itsPictureLeadsToItsAnimation() {
    document().setFile(twoEntries());
    document().setCurrent(document().file().entries.back().id);
    m_window->findChild<QAction*>(QStringLiteral("export-picture"))->trigger();
    const QPointer<view::ExportDialog> dialog = m_window->findChild<view::ExportDialog*>();
    QVERIFY(dialog);
    auto* button = dialog->findChild<QPushButton*>(QStringLiteral("animation"));
    QVERIFY(button);
    button->click();
    QTRY_VERIFY(m_window->findChild<view::AnimationExportDialog*>());
    QTRY_VERIFY(!dialog || dialog->isHidden());
}

BARYCAGE_TEST(OpenedMotionTest, QApplication);
#include "opened_motion_test.moc"
