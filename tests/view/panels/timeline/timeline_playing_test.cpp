// SPDX-License-Identifier: MIT
#include "document/fractal/recurring_branches.h"
#include "panels/timeline/track_view.h"
#include "panels/timeline/transport_bar.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/panels/timeline/timeline_fixture.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QLabel>
#include <QMouseEvent>
#include <QScrollBar>
#include <QThread>
#include <QTimer>
#include <QToolButton>

#include <cstdlib>

// Keys that snap where frames lie close together, time that runs on whatever drawing takes, and rows.
class TimelinePlayingTest : public TimelineFixture {
    Q_OBJECT

private slots:
    void draggedKeysSnap();
    void playingFollowsTheClock();
    void timeIsNeverLate();
    void picturesAreAskedForBeforeTheyAreDue();
    void itStopsWithinAFrame();
    void theRateIsShown();
    void undoLeavesTheRowsInPlace();
    void playingDoesNotScrollTheRows();
    void rowsNameTheirBranches();

private:
    view::Timeline& timeline() { return m_panel->timeline(); }
    view::TrackView& tracks() { return *m_panel->trackView(); }
    void key(int row, int frame);
    void drag(const QPoint& from, const QPoint& to);
    int lastKey() { return timeline().tracks()[0].keys.back().frame; }
};

namespace {

constexpr int second = 1000; // milliseconds

// As long as drawing takes. A fixed time, because it stands for work and waits for nothing.
void draw() {
    QThread::msleep(70);
}

// With more rows than are seen at once.
document::Fractal manyMaps() {
    document::Fractal fractal = document::sierpinskiTriangle();
    for (int i = 0; i < 20; ++i)
        ifs::append(document::plane(fractal)->system, ifs::affineMap(.3, 0, 0, .3, .03 * i, .2), .1);
    return fractal;
}

} // namespace

void TimelinePlayingTest::rowsNameTheirBranches() {
    document::Fractal fractal = document::sierpinskiTriangle();
    document::Shape<2>& shape = *document::plane(fractal);
    const std::vector<ifs::MapId> word{shape.system.maps[2].id, shape.system.maps[0].id};
    shape.moved = {{word, {}}, {document::recurringWord(word), {}}};
    m_document->edit(QStringLiteral("test"), fractal);
    const auto names = [this] {
        QStringList all;
        for (int row = 0; row < int(timeline().tracks().size()); ++row)
            all << timeline().rowName(row);
        return all;
    };
    QTRY_VERIFY(names().contains(QStringLiteral("Branch 3 1")));
    QVERIFY2(names().contains(QStringLiteral("Branch 3 1, inside itself")), qPrintable(names().join(u'|')));
}

void TimelinePlayingTest::key(int row, int frame) {
    timeline().setRow(row);
    timeline().setFrame(frame);
    timeline().keys().set();
}

void TimelinePlayingTest::drag(const QPoint& from, const QPoint& to) {
    QWidget* viewport = tracks().viewport();
    const auto send = [&](QEvent::Type type, const QPoint& at, Qt::MouseButton button) {
        QMouseEvent event(type, at, viewport->mapToGlobal(at), button,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, {});
        QApplication::sendEvent(viewport, &event);
    };
    send(QEvent::MouseButtonPress, from, Qt::LeftButton);
    send(QEvent::MouseMove, (from + to) / 2, Qt::NoButton);
    send(QEvent::MouseMove, to, Qt::NoButton);
    send(QEvent::MouseButtonRelease, to, Qt::LeftButton);
}

// To a key of another row, to the playhead and to the end; elsewhere they stay where they are dropped.
void TimelinePlayingTest::draggedKeysSnap() {
    timeline().setTiming(QStringLiteral("long"), {{24, 1}, 800, animation::Loop::Off});
    key(0, 100);
    key(1, 200);
    timeline().setFrame(500);
    timeline().select({});
    tracks().fitLength();
    QVERIFY(tracks().pixelsPerFrame() < 2);
    const auto dragTo = [this](int frame, int pixels) {
        drag(tracks().keyPosition(0, lastKey()), tracks().keyPosition(0, frame) + QPoint(pixels, 0));
        return lastKey();
    };
    QCOMPARE(dragTo(200, 4), 200);
    QCOMPARE(dragTo(500, -4), 500);
    QCOMPARE(dragTo(800, -4), 800);
    const int free = dragTo(350, 0);
    QVERIFY2(std::abs(free - 350) <= 2, qPrintable(QString::number(free)));
    const int beside = dragTo(200, 40); // too far from 200
    QVERIFY2(beside > 210, qPrintable(QString::number(beside)));
}

void TimelinePlayingTest::playingFollowsTheClock() {
    key(0, 40);
    timeline().setTiming(QStringLiteral("cycle"), {{24, 1}, 48, animation::Loop::Cycle});
    timeline().setFrame(0);
    m_panel->transport()->play()->click();
    QVERIFY(timeline().playback().isPlaying());
    QTRY_VERIFY(timeline().frame() > 3);
    document::Fractal after = m_document->fractal(); // edited while it plays
    after.appearance.gamma = 3;
    m_document->edit(QStringLiteral("Gamma"), after);
    QCOMPARE(m_document->fractal().appearance.gamma, 3.0);
    QVERIFY(timeline().playback().isPlaying());
    m_panel->transport()->play()->click();
    const int stopped = timeline().frame();
    QVERIFY(!timeline().playback().isPlaying());
    document::Document another;
    another.setFile(document::fileOf(m_document->entryFractal()));
    view::Playback running(&another);
    running.setPlaying(true);
    QTRY_VERIFY(running.position() > 3); // meanwhile
    QCOMPARE(timeline().frame(), stopped);
}

// Each moment is that of the clock at a time after the picture before it was drawn.
void TimelinePlayingTest::timeIsNeverLate() {
    key(0, 10);
    timeline().setTiming(QStringLiteral("fast"), {{100, 1}, 100'000, animation::Loop::Off});
    timeline().setFrame(0);
    QElapsedTimer before, after; // the clock of the playback starts in between
    qint64 drawn = 0;            // when the last picture was finished
    int pictures = 0;
    QString flaw;
    QObject scope;
    connect(m_document.get(), &document::Document::changed, &scope, [&](const document::Change& change) {
        if (!(change.parts & document::Change::Time) || !timeline().playback().isPlaying()) return;
        const qint64 now = before.elapsed();
        const int frame = timeline().playback().position();
        if (frame < drawn / 10 - 1 || frame > now / 10 + 1)
            flaw = QStringLiteral("frame %1 between %2 and %3 ms").arg(frame).arg(drawn).arg(now);
        ++pictures;
        draw();
        drawn = after.elapsed();
    });
    before.start();
    timeline().playback().setPlaying(true);
    after.start();
    QTRY_VERIFY_WITH_TIMEOUT(pictures >= 12, 60'000);
    timeline().playback().setPlaying(false);
    QVERIFY2(flaw.isEmpty(), qPrintable(flaw));
    QVERIFY(timeline().frame() >= 60); // 100 a second, and not one for each picture
}

// What takes 30 ms to be drawn is there when it is due, but never half a frame too early.
void TimelinePlayingTest::picturesAreAskedForBeforeTheyAreDue() {
    constexpr int period = 100, drawing = 30; // milliseconds
    key(0, 10);
    timeline().setTiming(QStringLiteral("slow"), {{second / period, 1}, 100'000, animation::Loop::Off});
    timeline().setFrame(0);
    view::Playback& playback = timeline().playback();
    QElapsedTimer before; // the clock of the playback starts later
    int early = 0;
    qint64 earliest = 0;
    QObject scope;
    connect(m_document.get(), &document::Document::changed, &scope, [&](const document::Change& change) {
        if (!(change.parts & document::Change::Time) || !playback.isPlaying()) return;
        const qint64 until = period * playback.position() - before.elapsed();
        early += until > 0;
        earliest = std::max(earliest, until);
        QTimer::singleShot(drawing, &scope, [&playback] { playback.countPicture(); });
    });
    before.start();
    playback.setPlaying(true);
    QTRY_VERIFY_WITH_TIMEOUT(early >= 5, 60'000);
    playback.setPlaying(false);
    QVERIFY2(earliest <= period / 2, qPrintable(QString::number(earliest)));
}

// Asked to stop while a picture is drawn that takes as long as seven frames, it shows at most one more
// moment, comes to rest there, and stays.
void TimelinePlayingTest::itStopsWithinAFrame() {
    key(0, 10);
    timeline().setTiming(QStringLiteral("fast"), {{100, 1}, 100'000, animation::Loop::Off});
    timeline().setFrame(0);
    view::Playback& playback = timeline().playback();
    bool isAsked = false;
    int before = 0, running = 0, resting = 0; // moments shown
    QObject scope;
    connect(m_document.get(), &document::Document::changed, &scope, [&](const document::Change& change) {
        if (!(change.parts & document::Change::Time)) return;
        if (!playback.isPlaying()) {
            ++resting;
            return;
        }
        ++(isAsked ? running : before);
        draw();
        if (before < 5 || isAsked) return;
        isAsked = true;
        QMetaObject::invokeMethod(
            &scope, [&] { m_panel->transport()->play()->click(); }, Qt::QueuedConnection);
    });
    playback.setPlaying(true);
    QTRY_VERIFY_WITH_TIMEOUT(!playback.isPlaying(), 60'000);
    QVERIFY(isAsked);
    QVERIFY2(running <= 1, qPrintable(QString::number(running)));
    QCOMPARE(resting, 1);
    const int frame = timeline().frame();
    document::Document another;
    another.setFile(document::fileOf(m_document->entryFractal()));
    view::Playback other(&another);
    other.setPlaying(true);
    QTRY_VERIFY(other.position() > 10); // frames, of which none may come here
    QCOMPARE(timeline().frame(), frame);
    QCOMPARE(resting, 1);
    QCOMPARE(before, 5);
}

void TimelinePlayingTest::theRateIsShown() {
    QLabel* label = nullptr;
    for (auto* one : m_panel->transport()->findChildren<QLabel*>())
        if (one->toolTip().contains(QStringLiteral("drawn per second"))) label = one;
    QVERIFY(label);
    key(0, 40);
    timeline().setTiming(QStringLiteral("cycle"), {{24, 1}, 48, animation::Loop::Cycle});
    view::Playback& playback = timeline().playback();
    playback.countPicture(); // does not count: nothing plays
    QCOMPARE(playback.picturesPerSecond(), 0.0);
    playback.setPlaying(true);
    QCOMPARE(label->text(), QString());
    QTimer pictures;
    connect(&pictures, &QTimer::timeout, this, [&] { playback.countPicture(); });
    pictures.start(20);
    QTRY_VERIFY_WITH_TIMEOUT(label->text().endsWith(QStringLiteral(" fps")), 60'000);
    const double rate = label->text().section(u' ', 0, 0).toDouble();
    QVERIFY2(rate > 0 && rate < 60, qPrintable(label->text())); // one every 20 ms at most
    playback.setPlaying(false);
    QCOMPARE(label->text(), QString());
}

// With a motion its row comes and goes; what is scrolled and selected is as before, and nothing plays on.
void TimelinePlayingTest::undoLeavesTheRowsInPlace() {
    m_document->setFile(document::fileOf(manyMaps()));
    key(0, 0); // so that the rows stay when the motion goes
    m_panel->motions().front()->trigger();
    QTRY_COMPARE(timeline().motions().size(), std::size_t(1));
    const int row = timeline().rowCount() - 1;
    QTRY_COMPARE(timeline().row(), row);
    const QScrollBar& bar = *tracks().verticalScrollBar();
    QTRY_VERIFY(bar.maximum() > 0 && bar.value() == bar.maximum());
    const int scrolled = bar.value();
    m_document->undoStack()->undo();
    QVERIFY(timeline().motions().empty());
    QTRY_VERIFY(bar.value() < scrolled);
    m_document->undoStack()->redo();
    QCOMPARE(timeline().row(), row);
    QTRY_COMPARE(bar.value(), scrolled);

    // The first motion of all: without it nothing moves, and time stands still.
    m_document->setFile(document::fileOf(document::sierpinskiTriangle()));
    m_panel->motions().front()->trigger();
    QTRY_VERIFY(timeline().playback().isPlaying());
    QTRY_VERIFY(timeline().frame() > 1);
    m_document->undoStack()->undo();
    QVERIFY(!timeline().playback().isPlaying());
    m_document->undoStack()->redo();
    QVERIFY(!timeline().playback().isPlaying());
}

// A playhead that runs does not draw the rows back to the current one.
void TimelinePlayingTest::playingDoesNotScrollTheRows() {
    m_document->setFile(document::fileOf(manyMaps()));
    key(0, 0);
    timeline().setRow(timeline().rowCount() - 1);
    m_panel->activateWindow();
    tracks().setFocus();
    QTRY_VERIFY(tracks().hasFocus());
    tracks().verticalScrollBar()->setValue(0);
    QTRY_VERIFY(tracks().verticalScrollBar()->maximum() > 0);
    timeline().setFrame(5);
    QCOMPARE(tracks().verticalScrollBar()->value(), 0);
    timeline().playback().setPlaying(true);
    QTRY_VERIFY(timeline().frame() > 6);
    QCOMPARE(tracks().verticalScrollBar()->value(), 0);
}

BARYCAGE_TEST(TimelinePlayingTest, QApplication);
#include "timeline_playing_test.moc"
