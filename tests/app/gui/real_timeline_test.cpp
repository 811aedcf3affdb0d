// SPDX-License-Identifier: MIT
#include "document/moments/animated_fractal.h"
#include "panels/timeline/timeline_panel.h"
#include "panels/timeline/track_view.h"
#include "panels/timeline/transport_bar.h"
#include "support/window_on_x.h"

#include <QDockWidget>
#include <QMenu>
#include <QPushButton>
#include <QToolBar>
#include <QToolButton>

using ifs::Vector;

// The timeline with a real pointer and real keys.
class RealTimelineTest : public support::WindowOnX {
    Q_OBJECT

private slots:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void aKeyIsMadeAndPlayed();
    void windInOneClick();
    void aMotionOfTheMenuShowsTheTimeline();
    void diamondsAreDragged();
    void altTakesLaterKeysAlong();
    void aRightClickChangesTheEase();

private:
    view::TimelinePanel& panel() const { return *window().findChild<view::TimelinePanel*>(); }
    view::TrackView& tracks() const { return *panel().trackView(); }
    QPoint inTracks(const QPoint& at) const { return tracks().viewport()->mapToGlobal(at); }
    std::vector<int> framesOf(std::size_t row) const;
    std::size_t cageKeys() const { return panel().timeline().tracks().front().keys.size(); }
    std::vector<animation::Ease::Kind> easesOf(std::size_t row) const;
    QPoint onKey(int frame) const { return inTracks(tracks().keyPosition(0, frame)); }
    void openTimeline();
    void openKeys(); // of the cage, at frames 0, 12 and 24; the playhead is elsewhere
};

void RealTimelineTest::openTimeline() {
    for (auto* button : window().findChild<QToolBar*>(QStringLiteral("tools"))->findChildren<QToolButton*>())
        if (button->defaultAction() &&
            button->defaultAction()->text().remove(u'&') == QLatin1String("Animate"))
            click(button);
    QTRY_VERIFY(panel().isVisible());
    support::handleEvents(); // until the canvas has its new size
}

void RealTimelineTest::aKeyIsMadeAndPlayed() {
    openTimeline();
    click(named<QPushButton>(panel(), QStringLiteral("Make Keys")));
    QTRY_VERIFY(panel().showsTracks());
    QTRY_COMPARE(cageKeys(), std::size_t(1));
    const auto start = vertices();
    hand().drag(inTracks(tracks().rulerPosition(0)),
                {inTracks(tracks().rulerPosition(10)), inTracks(tracks().rulerPosition(24))});
    QTRY_COMPARE(panel().timeline().frame(), 24);
    const int before = steps();
    dragBy(vertex(1), {-40, 30});
    QTRY_COMPARE(steps(), before + 1);
    QCOMPARE(cageKeys(), std::size_t(2));
    const auto end = vertices();
    QVERIFY(end != start);
    photograph(QStringLiteral("timeline-keys.png"));

    hand().drag(inTracks(tracks().rulerPosition(24)),
                {inTracks(tracks().rulerPosition(12)), inTracks(tracks().rulerPosition(0))});
    QTRY_VERIFY(vertices() == start);
    const QImage picture = canvas().picture();
    click(panel().transport()->play());
    QTRY_VERIFY(panel().timeline().frame() > 6);
    QTRY_VERIFY(canvas().picture() != picture); // what plays is seen
    hand().clickAt(insideTheCage() + QPoint(0, 0));
    hand().key("space");
    QTRY_VERIFY(!panel().timeline().playback().isPlaying());
    hand().key("Control+z");
    QTRY_COMPARE(cageKeys(), std::size_t(1));
    hand().key("Control+z");
    QTRY_COMPARE(cageKeys(), std::size_t(0));
    QVERIFY(vertices() == start);
}

void RealTimelineTest::windInOneClick() {
    openTimeline();
    const document::Fractal still = fractal();
    click(named<QToolButton>(panel(), QStringLiteral("Breathe")));
    QTRY_COMPARE(steps(), 1);
    QTRY_VERIFY(panel().timeline().playback().isPlaying());
    QTRY_VERIFY(fractal() != still);
    dragBy(vertex(1), {-30, 20}); // while it moves
    QTRY_COMPARE(steps(), 2);
    QVERIFY(panel().timeline().playback().isPlaying());
    hand().key("space");
    QTRY_VERIFY(!panel().timeline().playback().isPlaying());
    photograph(QStringLiteral("timeline-breathing.png"));
    hand().key("Control+z");
    hand().key("Control+z");
    QTRY_VERIFY(document::frameAt(document().entryFractal(), {}).fractal == still);
}

void RealTimelineTest::aMotionOfTheMenuShowsTheTimeline() {
    QVERIFY(!panel().isVisible());
    panel().motions().front()->menu()->actions().front()->trigger();
    QTRY_VERIFY(panel().timeline().playback().isPlaying());
    QTRY_VERIFY(panel().isVisible());
    QVERIFY(panel().showsTracks());
}

std::vector<int> RealTimelineTest::framesOf(std::size_t row) const {
    std::vector<int> frames;
    for (const auto& key : panel().timeline().tracks()[row].keys)
        frames.push_back(key.frame);
    return frames;
}

std::vector<animation::Ease::Kind> RealTimelineTest::easesOf(std::size_t row) const {
    std::vector<animation::Ease::Kind> eases;
    for (const auto& key : panel().timeline().tracks()[row].keys)
        eases.push_back(key.ease.kind);
    return eases;
}

void RealTimelineTest::openKeys() {
    openTimeline();
    click(named<QPushButton>(panel(), QStringLiteral("Make Keys")));
    QTRY_VERIFY(panel().showsTracks());
    for (const int frame : {12, 24}) {
        hand().clickAt(inTracks(tracks().rulerPosition(frame)));
        QTRY_COMPARE(panel().timeline().frame(), frame);
        hand().clickAt(inTracks(tracks().toggleOf(0)));
        QTRY_COMPARE(framesOf(0).back(), frame);
    }
    hand().clickAt(inTracks(tracks().rulerPosition(40)));
    QTRY_COMPARE(panel().timeline().frame(), 40);
    QCOMPARE(framesOf(0), (std::vector<int>{0, 12, 24}));
}

// Moved, copied with Ctrl, selected in a band, and deleted.
void RealTimelineTest::diamondsAreDragged() {
    openTimeline();
    click(named<QPushButton>(panel(), QStringLiteral("Make Keys")));
    QTRY_VERIFY(panel().showsTracks());
    hand().clickAt(inTracks(tracks().rulerPosition(12)));
    QTRY_COMPARE(panel().timeline().frame(), 12);
    hand().clickAt(inTracks(tracks().toggleOf(0)));
    QTRY_COMPARE(framesOf(0), (std::vector<int>{0, 12}));
    const auto at = [this](int frame) { return inTracks(tracks().keyPosition(0, frame)); };
    hand().drag(at(12), {at(16), at(24)});
    QTRY_COMPARE(framesOf(0), (std::vector<int>{0, 24}));
    hand().hold("Control");
    hand().drag(at(24), {at(30), at(36)});
    hand().letUp("Control");
    QTRY_COMPARE(framesOf(0), (std::vector<int>{0, 24, 36}));
    QCOMPARE(steps(), 4);
    photograph(QStringLiteral("timeline-diamonds.png"));

    const QPoint below = inTracks(tracks().keyPosition(1, 40));
    hand().drag(at(18) - QPoint(0, 6), {at(30), below});
    QTRY_COMPARE(panel().timeline().selected().size(), std::size_t(2));
    hand().key("Delete");
    QTRY_COMPARE(framesOf(0), std::vector<int>{0});
    hand().key("Control+z");
    QTRY_COMPARE(framesOf(0), (std::vector<int>{0, 24, 36}));
}

void RealTimelineTest::altTakesLaterKeysAlong() {
    openKeys();
    const int before = steps();
    hand().hold("Alt");
    hand().drag(onKey(12), {onKey(15), onKey(18)});
    hand().letUp("Alt");
    QTRY_COMPARE(framesOf(0), (std::vector<int>{0, 18, 30}));
    QCOMPARE(steps(), before + 1);
    photograph(QStringLiteral("timeline-ripple.png"));
    hand().key("Control+z");
    QTRY_COMPARE(framesOf(0), (std::vector<int>{0, 12, 24}));
    QCOMPARE(document().undoStack()->index(), before);
}

void RealTimelineTest::aRightClickChangesTheEase() {
    using Kind = animation::Ease::Kind;
    openKeys();
    const std::vector<Kind> eases = easesOf(0);
    QVERIFY(eases[1] != Kind::Hold);
    const int before = steps();
    hand().clickAt(onKey(12), support::XInput::Right);
    QTRY_VERIFY(qobject_cast<QMenu*>(QApplication::activePopupWidget()));
    photograph(QStringLiteral("timeline-menu.png"));
    chooseFrom(qobject_cast<QMenu*>(QApplication::activePopupWidget()), QStringLiteral("Hold"));
    QTRY_COMPARE(steps(), before + 1);
    QVERIFY((easesOf(0) == std::vector<Kind>{eases[0], Kind::Hold, eases[2]})); // of this key alone
    QTRY_VERIFY(!QApplication::activePopupWidget());
    hand().key("Control+z");
    QTRY_VERIFY(easesOf(0) == eases);
    QCOMPARE(document().undoStack()->index(), before);
}

BARYCAGE_TEST_ON_X(RealTimelineTest);

#include "real_timeline_test.moc"
