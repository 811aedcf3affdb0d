// SPDX-License-Identifier: MIT
#include "panels/timeline/track_view.h"
#include "support/named.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/panels/timeline/timeline_fixture.h"

#include <QAction>

// When the endless zoom is offered, and where its keys are.
class EndlessZoomTest : public TimelineFixture {
    Q_OBJECT

private slots:
    void whatCannotBeIsNotOffered();
    void theRowOfTheCameraIsShown();

private:
    QAction* zoom() const;
};

QAction* EndlessZoomTest::zoom() const {
    return support::action(*m_panel, "zoom-in");
}

// Of maps that are no similarities, none shows the whole again.
void EndlessZoomTest::whatCannotBeIsNotOffered() {
    document::Fractal skew;
    document::Shape<2> shape;
    ifs::append(shape.system, ifs::affineMap(.5, .2, 0, .3, 0, 0), 1);
    ifs::append(shape.system, ifs::affineMap(.3, 0, .2, .5, 1, 0), 1);
    skew.shape = std::move(shape);
    m_document->setFile(document::fileOf(skew));
    QVERIFY(zoom()->isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(!zoom()->isEnabled(), 60'000);
    QVERIFY2(zoom()->toolTip().startsWith(QStringLiteral("No map")), qPrintable(zoom()->toolTip()));
    QVERIFY(m_panel->motions().front()->isEnabled());
    m_document->setFile(document::fileOf(document::sierpinskiTriangle()));
    QVERIFY(zoom()->isEnabled());
    QVERIFY2(zoom()->toolTip().startsWith(QStringLiteral("The view moves")), qPrintable(zoom()->toolTip()));
}

// With its keys selected, so that Del takes them away.
void EndlessZoomTest::theRowOfTheCameraIsShown() {
    view::TrackView& tracks = *m_panel->trackView();
    view::Timeline& timeline = m_panel->timeline();
    tracks.setFixedHeight(90); // not all rows fit
    zoom()->trigger();
    timeline.playback().setPlaying(false);
    const int row = timeline.row();
    QCOMPARE(timeline.rowName(row), QStringLiteral("Camera"));
    QVERIFY(tracks.viewport()->rect().contains(tracks.keyPosition(row, 0)));
    QVERIFY(timeline.tracks()[std::size_t(row)].keys.size() > 1);
    QTest::keyClick(&tracks, Qt::Key_Delete);
    QVERIFY(timeline.tracks()[std::size_t(row)].keys.empty());
}

BARYCAGE_TEST(EndlessZoomTest, QApplication);
#include "endless_zoom_test.moc"
