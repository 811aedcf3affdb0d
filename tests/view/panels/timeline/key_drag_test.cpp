// SPDX-License-Identifier: MIT
#include "panels/timeline/track_view.h"
#include "support/named_test.h"
#include "view/panels/timeline/timeline_fixture.h"

#include <QMouseEvent>

using document::KeyAt;

// Which keys go along when one is dragged with the pointer.
class KeyDragTest : public TimelineFixture {
    Q_OBJECT

private slots:
    void keysThatWereNotSelectedMoveAlone_data();
    void keysThatWereNotSelectedMoveAlone();
    void selectedKeysMoveTogether();
    void clicksAddToTheSelection();

private:
    view::Timeline& timeline() { return m_panel->timeline(); }
    view::TrackView& tracks() { return *m_panel->trackView(); }
    std::vector<int> framesOf(int row);
    void click(int frame, Qt::KeyboardModifiers modifiers = {});
    void drag(int from, int to, Qt::KeyboardModifiers modifiers);
};

std::vector<int> KeyDragTest::framesOf(int row) {
    std::vector<int> frames;
    for (const auto& key : timeline().tracks()[std::size_t(row)].keys)
        frames.push_back(key.frame);
    return frames;
}

void KeyDragTest::click(int frame, Qt::KeyboardModifiers modifiers) {
    QTest::mouseClick(tracks().viewport(), Qt::LeftButton, modifiers, tracks().keyPosition(0, frame));
}

void KeyDragTest::drag(int from, int to, Qt::KeyboardModifiers modifiers) {
    QWidget* viewport = tracks().viewport();
    const QPoint start = tracks().keyPosition(0, from), end = tracks().keyPosition(0, to);
    const auto send = [&](QEvent::Type type, const QPoint& at, Qt::MouseButton button) {
        QMouseEvent event(type, at, viewport->mapToGlobal(at), button,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, modifiers);
        QApplication::sendEvent(viewport, &event);
    };
    send(QEvent::MouseButtonPress, start, Qt::LeftButton);
    send(QEvent::MouseMove, (start + end) / 2, Qt::NoButton);
    send(QEvent::MouseMove, end, Qt::NoButton);
    send(QEvent::MouseButtonRelease, end, Qt::LeftButton);
}

void KeyDragTest::keysThatWereNotSelectedMoveAlone_data() {
    QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
    QTest::addColumn<std::vector<int>>("frames");
    QTest::newRow("moved") << Qt::KeyboardModifiers() << std::vector<int>{0, 32};
    QTest::newRow("copied") << Qt::KeyboardModifiers(Qt::ControlModifier) << std::vector<int>{0, 16, 32};
    QTest::newRow("Shift") << Qt::KeyboardModifiers(Qt::ShiftModifier) << std::vector<int>{0, 32};
}

// Copying both would put the key at 0 in the place of the one at 16.
void KeyDragTest::keysThatWereNotSelectedMoveAlone() {
    QFETCH(Qt::KeyboardModifiers, modifiers);
    QFETCH(std::vector<int>, frames);
    timeline().setRow(0);
    timeline().setFrame(16);
    timeline().keys().set();
    timeline().setFrame(0);
    click(0);
    timeline().keys().setEase({animation::Ease::Kind::Hold}); // tells the two apart
    QCOMPARE(timeline().selected().size(), std::size_t(1));
    drag(16, 32, modifiers);
    QCOMPARE(framesOf(0), frames);
    QVERIFY(timeline().tracks()[0].keys[0].ease.kind == animation::Ease::Kind::Hold);
    QVERIFY(timeline().tracks()[0].keys[1].ease.kind != animation::Ease::Kind::Hold);
    const KeyAt dropped{timeline().tracks()[0].track, 32};
    QCOMPARE(timeline().selected(), std::vector<KeyAt>{dropped});
}

void KeyDragTest::selectedKeysMoveTogether() {
    timeline().setRow(0);
    for (const int frame : {8, 16}) {
        timeline().setFrame(frame);
        timeline().keys().set();
    }
    click(8);
    click(16, Qt::ControlModifier);
    QCOMPARE(timeline().selected().size(), std::size_t(2));
    drag(16, 26, Qt::ControlModifier);
    QCOMPARE(framesOf(0), (std::vector<int>{0, 8, 16, 18, 26}));
}

void KeyDragTest::clicksAddToTheSelection() {
    timeline().setRow(0);
    timeline().setFrame(16);
    timeline().keys().set();
    click(0);
    click(16, Qt::ShiftModifier);
    QCOMPARE(timeline().selected().size(), std::size_t(2));
    click(16, Qt::ControlModifier);
    QCOMPARE(timeline().selected().size(), std::size_t(1));
}

BARYCAGE_TEST(KeyDragTest, QApplication);
#include "key_drag_test.moc"
