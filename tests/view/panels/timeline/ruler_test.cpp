// SPDX-License-Identifier: MIT
#include "panels/timeline/ruler_marks.h"
#include "panels/timeline/track_view.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/panels/timeline/timeline_fixture.h"

#include <QApplication>
#include <QImage>
#include <QSet>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>

#include <algorithm>

// The ruler as it is painted, at any zoom.
class RulerTest : public TimelineFixture {
    Q_OBJECT

private slots:
    void labelsNeverMeet_data();
    void labelsNeverMeet();
    void ticksAreBetweenLabels();
    void keysHaveTicks();
    void rowsAreReadWhereTheyChange();

private:
    view::Timeline& timeline() { return m_panel->timeline(); }
    view::TrackView& tracks() { return *m_panel->trackView(); }
    QImage ruler() {
        const QRect area(0, 0, tracks().viewport()->width(), int(tracks().rulerPlace().area.height()));
        return tracks().viewport()->grab(area).toImage().convertToFormat(QImage::Format_RGB32);
    }
    void showSeconds(bool on);
    void zoom(int turned);
    void verifyLabels();
};

void RulerTest::showSeconds(bool on) {
    for (auto* button : tracks().findChildren<QToolButton*>())
        if (button->accessibleName() == QStringLiteral("Unit of the ruler")) button->setChecked(on);
}

void RulerTest::zoom(int turned) {
    const QPoint at = tracks().rulerPosition(timeline().frame()) + QPoint(30, 0);
    QWheelEvent turn(at, tracks().viewport()->mapToGlobal(at), {}, {0, turned}, Qt::NoButton,
                     Qt::ControlModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(tracks().viewport(), &turn);
}

void RulerTest::labelsNeverMeet_data() {
    QTest::addColumn<int>("length");
    QTest::addColumn<animation::FrameRate>("rate");
    QTest::addColumn<bool>("isSeconds");
    QTest::addColumn<int>("points");
    for (const int points : {9, 24})
        for (const bool isSeconds : {false, true})
            for (const int length : {48, 1'000'000})
                for (const animation::FrameRate rate : {animation::FrameRate{24, 1}, {30000, 1001}, {7, 5}})
                    QTest::addRow("%d frames at %d/%d, %s, %d pt", length, rate.frames, rate.seconds,
                                  isSeconds ? "seconds" : "frames", points)
                        << length << rate << isSeconds << points;
}

// What is painted is in the rooms of the labels, these are all filled, and no two of them meet.
void RulerTest::verifyLabels() {
    const view::RulerPlace place = tracks().rulerPlace();
    const std::vector<view::RulerLabel> labels = view::rulerLabels(place, tracks().font());
    for (std::size_t i = 1; i < labels.size(); ++i)
        QVERIFY2(labels[i - 1].room.right() < labels[i].room.left(), qPrintable(labels[i].text));
    const QImage image = ruler();
    const double share = image.devicePixelRatio();
    const QRgb empty = tracks().palette().color(QPalette::Window).rgb();
    const int bottom = int((place.area.bottom() - 5) * share); // above the ticks
    const auto isFree = [&](int x) {
        for (int y = 0; y < bottom; ++y)
            if (image.pixel(x, y) != empty) return false;
        return true;
    };
    const QRectF flag = tracks().playheadFlag();
    for (int x = int((place.area.left() + 2) * share); x < image.width(); ++x) {
        const double at = x / share;
        const bool isCovered = at > flag.left() - 2 && at < flag.right() + 2;
        const bool isInRoom = std::ranges::any_of(labels, [&](const view::RulerLabel& label) {
            return at > label.room.left() - 2 && at < label.room.right() + 2;
        });
        if (!isCovered && !isInRoom) QVERIFY2(isFree(x), qPrintable(QString::number(at)));
    }
    for (const view::RulerLabel& label : labels) {
        if (!place.area.contains(label.room) || label.room.intersects(flag)) continue;
        bool isPainted = false;
        for (int x = int(label.room.left() * share); x < int(label.room.right() * share); ++x)
            isPainted = isPainted || !isFree(x);
        QVERIFY2(isPainted, qPrintable(label.text));
    }
}

void RulerTest::labelsNeverMeet() {
    QFETCH(int, length);
    QFETCH(animation::FrameRate, rate);
    QFETCH(bool, isSeconds);
    QFETCH(int, points);
    QFont font = m_panel->font();
    font.setPointSize(points);
    tracks().setFont(font);
    timeline().setTiming(QStringLiteral("Timing"), {rate, length, animation::Loop::Off});
    showSeconds(isSeconds);
    timeline().setFrame(length / 2);
    tracks().fitLength();
    for (const int turned : {-20'000, 240, 500, 900, 1300, 1700, 2100, 20'000, -300, -700}) { // to both ends
        zoom(turned);
        tracks().reveal();
        verifyLabels();
        if (QTest::currentTestFailed()) return;
    }
    showSeconds(false);
}

void RulerTest::ticksAreBetweenLabels() {
    zoom(240);
    timeline().setFrame(0);
    const view::RulerPlace place = tracks().rulerPlace();
    const auto labels = view::rulerLabels(place, tracks().font());
    QVERIFY(labels.size() > 2);
    const QImage image = ruler();
    const auto colourAt = [&](double frame) {
        const double x = place.start + frame * place.scale;
        const double share = image.devicePixelRatio();
        return qGray(image.pixel(int(x * share), int((place.area.bottom() - 1) * share)));
    };
    const int first = labels[1].frame, second = labels[2].frame;
    QVERIFY(second - first > 1 && place.scale > 10);
    const int empty = colourAt(first + 0.5);
    for (int frame = first; frame <= second; ++frame) {
        QVERIFY2(colourAt(frame) != empty, qPrintable(QString::number(frame)));
        QCOMPARE(colourAt(frame + 0.5), empty);
    }
}

// All keys are seen at once, even those of rows that are scrolled away.
void RulerTest::keysHaveTicks() {
    tracks().setFixedHeight(60);
    timeline().setFrame(30);
    const QImage before = ruler();
    timeline().setRow(timeline().rowCount() - 2); // the appearance
    timeline().keys().set();
    timeline().setRow(0);
    tracks().reveal();
    timeline().select({});
    const QImage after = ruler();
    const double share = after.devicePixelRatio();
    QSet<int> changed; // columns
    for (int x = 0; x < after.width(); ++x)
        for (int y = 0; y < after.height(); ++y)
            if (after.pixel(x, y) != before.pixel(x, y)) changed << int(x / share);
    for (const int frame : {0, 30}) {
        const int at = tracks().rulerPosition(frame).x();
        QVERIFY2(changed.contains(at) || changed.contains(at - 1), qPrintable(QString::number(frame)));
        changed.removeIf([at](int x) { return std::abs(x - at) <= 2; });
    }
    QVERIFY(changed.isEmpty());
    m_document->undoStack()->undo();
    QCOMPARE(ruler(), before);
}

// What moves a map only leaves them alone: of many maps they would take longer than the picture.
void RulerTest::rowsAreReadWhereTheyChange() {
    const auto* rows = timeline().tracks().data();
    QSignalSpy changed(&timeline(), &view::Timeline::changed);
    document::Fractal moved = m_document->fractal();
    document::plane(moved)->system.maps[0].map.translation.x() += 0.25;
    m_document->edit(QStringLiteral("Move"), moved);
    QCOMPARE(changed.size(), 1); // of the names' colours, perhaps
    QCOMPARE(timeline().tracks().data(), rows);
    document::plane(moved)->system.maps.pop_back();
    m_document->edit(QStringLiteral("Delete"), moved);
    QVERIFY(timeline().tracks().data() != rows);
    QCOMPARE(timeline().rowCount(), 5);
    m_document->undoStack()->undo();
    QCOMPARE(timeline().rowCount(), 6);
    timeline().setRow(0);
    timeline().keys().set();
    QCOMPARE(timeline().tracks().front().keys.size(), std::size_t(1));
}

BARYCAGE_TEST(RulerTest, QApplication);
#include "ruler_test.moc"
