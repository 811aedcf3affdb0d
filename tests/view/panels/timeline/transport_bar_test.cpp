// SPDX-License-Identifier: MIT
#include "document/fractal_file.h"
#include "panels/timeline/ruler_scale.h"
#include "panels/timeline/track_view.h"
#include "panels/timeline/transport_bar.h"
#include "support/named_test.h"
#include "view/panels/timeline/timeline_fixture.h"

#include <QComboBox>
#include <QLineEdit>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>

#include <algorithm>
#include <vector>

using animation::FrameRate;
using view::RulerUnit;

// Rates as they are typed, and what the ruler makes of them.
class TransportBarTest : public TimelineFixture {
    Q_OBJECT

private slots:
    void ratesAreFractions();
    void whatIsNoRateIsRefused();
    void tabGoesAsTheFieldsAreSeen();
    void rowsOfAnotherEntryBeginAtTheTop();
    void rulersHaveRoundSteps_data();
    void rulersHaveRoundSteps();
    void theRulerSaysSeconds();

private:
    void type(const char* rate);
    FrameRate rate() const { return m_panel->timeline().timing().rate; }
    QComboBox* field() const { return m_panel->transport()->rate(); }
};

void TransportBarTest::type(const char* rate) {
    field()->lineEdit()->selectAll();
    QTest::keyClicks(field()->lineEdit(), QLatin1String(rate));
    QTest::keyClick(field()->lineEdit(), Qt::Key_Return);
}

void TransportBarTest::ratesAreFractions() {
    QCOMPARE(field()->currentText(), QStringLiteral("24"));
    type("29.97");
    QCOMPARE(rate(), (FrameRate{30000, 1001}));
    QCOMPARE(field()->currentText(), QStringLiteral("29.97"));
    QCOMPARE(m_document->undoStack()->count(), 1);
    type("30000/1001"); // the same
    QCOMPARE(m_document->undoStack()->count(), 1);
    QCOMPARE(field()->currentText(), QStringLiteral("29.97"));
    type("25/2");
    QCOMPARE(rate(), (FrameRate{25, 2}));
    QCOMPARE(field()->currentText(), QStringLiteral("12.5"));
    QCOMPARE(m_document->undoStack()->undoText(), QStringLiteral("Frames per second: 12.5"));
    type("7,5");
    QCOMPARE(rate(), (FrameRate{15, 2}));
    m_document->undoStack()->undo();
    m_document->undoStack()->undo();
    QCOMPARE(rate(), (FrameRate{30000, 1001}));
    QCOMPARE(field()->currentText(), QStringLiteral("29.97"));
    m_panel->transport()->length()->setValue(30); // leaves the rate alone
    QCOMPARE(rate(), (FrameRate{30000, 1001}));
}

void TransportBarTest::whatIsNoRateIsRefused() {
    QSignalSpy told(&m_panel->timeline(), &view::Timeline::message);
    type("fast");
    QCOMPARE(told.size(), 1);
    QVERIFY(told[0][0].toString().contains(QStringLiteral("“fast”")));
    type("0");
    QCOMPARE(told.size(), 2);
    QCOMPARE(rate(), (FrameRate{24, 1}));
    QCOMPARE(field()->currentText(), QStringLiteral("24"));
    QCOMPARE(m_document->undoStack()->count(), 0);
    type("24"); // valid, and no step
    QCOMPARE(told.size(), 3);
    QVERIFY(told[2][0].toString().isEmpty()); // the complaint is over
}

void TransportBarTest::tabGoesAsTheFieldsAreSeen() {
    const view::TransportBar* bar = m_panel->transport();
    std::vector<int> places; // along the way of Tab, from the field of the frame
    const QWidget* first = bar->frame();
    for (const QWidget* at = first->nextInFocusChain(); at != first; at = at->nextInFocusChain())
        if (at->parentWidget() == bar && at->isVisible() && at->focusPolicy() & Qt::TabFocus)
            places.push_back(at->x());
    QVERIFY(places.size() >= 4);
    const auto again = std::ranges::min_element(places); // the beginning of the bar
    std::rotate(places.begin(), again, places.end());
    QVERIFY(std::ranges::is_sorted(places));
}

void TransportBarTest::rowsOfAnotherEntryBeginAtTheTop() {
    m_panel->showTracks();
    m_panel->resize(m_panel->width(), m_panel->minimumSizeHint().height());
    QScrollBar* down = m_panel->trackView()->verticalScrollBar();
    QTRY_VERIFY(down->maximum() > 0);
    down->setValue(down->maximum());
    m_document->setFile(document::fileOf(document::sierpinskiTriangle()));
    m_panel->showTracks();
    QTRY_COMPARE(down->value(), 0);
}

void TransportBarTest::rulersHaveRoundSteps_data() {
    QTest::addColumn<double>("wanted");
    QTest::addColumn<int>("frames");
    QTest::addColumn<int>("seconds");
    QTest::addColumn<int>("inFrames");
    QTest::addColumn<int>("inSeconds");
    QTest::newRow("close") << 0.5 << 24 << 1 << 1 << 24;
    QTest::newRow("a few") << 3.0 << 24 << 1 << 5 << 24;
    QTest::newRow("more than a second") << 25.0 << 24 << 1 << 50 << 48;
    QTest::newRow("five seconds") << 100.0 << 24 << 1 << 100 << 120;
    QTest::newRow("television") << 90.0 << 30000 << 1001 << 100 << 150;
    QTest::newRow("slow") << 1.0 << 1 << 4 << 1 << 1;
}

void TransportBarTest::rulersHaveRoundSteps() {
    QFETCH(double, wanted);
    QFETCH(int, frames);
    QFETCH(int, seconds);
    QFETCH(int, inFrames);
    QFETCH(int, inSeconds);
    QCOMPARE(view::rulerStep(wanted, {frames, seconds}, RulerUnit::Frames), inFrames);
    QCOMPARE(view::rulerStep(wanted, {frames, seconds}, RulerUnit::Seconds), inSeconds);
}

void TransportBarTest::theRulerSaysSeconds() {
    QCOMPARE(view::rulerText(36, {24, 1}, RulerUnit::Frames), QStringLiteral("36"));
    QCOMPARE(view::rulerText(36, {24, 1}, RulerUnit::Seconds), QStringLiteral("1.5"));
    QCOMPARE(view::rulerText(3000, {30000, 1001}, RulerUnit::Seconds), QStringLiteral("100.1"));
    view::TrackView* tracks = m_panel->trackView();
    QToolButton* unit = nullptr;
    for (auto* button : tracks->findChildren<QToolButton*>())
        if (button->accessibleName() == QStringLiteral("Unit of the ruler")) unit = button;
    QVERIFY(unit);
    QVERIFY(!unit->isChecked());
    const auto ruler = [&] {
        const QPoint from = tracks->rulerPosition(6), to = tracks->rulerPosition(48);
        return tracks->viewport()->grab(QRect(from - QPoint(0, 8), QSize(to.x() - from.x(), 16))).toImage();
    };
    const QImage frames = ruler();
    QTest::mouseClick(unit, Qt::LeftButton);
    QCOMPARE(unit->text(), QStringLiteral("Seconds"));
    QVERIFY(ruler() != frames);
    const view::TrackView again(&m_panel->timeline()); // it is remembered
    QVERIFY(again.findChild<QToolButton*>()->isChecked());
    QTest::mouseClick(unit, Qt::LeftButton);
    QCOMPARE(ruler(), frames);
}

BARYCAGE_TEST(TransportBarTest, QApplication);
#include "transport_bar_test.moc"
