// SPDX-License-Identifier: MIT
#include "document/edits/timeline/orbit_edits.h"
#include "panels/timeline/motion_dialog.h"
#include "panels/timeline/orbit_rows.h"
#include "panels/timeline/track_view.h"
#include "support/choose.h"
#include "support/named_test.h"
#include "view/panels/timeline/timeline_fixture.h"
#include "view/space/space_window.h"
#include "widgets/numbers/number_field.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPointer>

// Where an orbit turns.
class OrbitMotionTest : public TimelineFixture {
    Q_OBJECT

private slots:
    void anOrbitIsChanged();
};

// In space its axis, with a tilt, and its pivot; in the plane the pivot.
void OrbitMotionTest::anOrbitIsChanged() {
    const auto field = [](QWidget* dialog, const char* name) -> QWidget* {
        for (QWidget* widget : dialog->findChildren<QWidget*>())
            if (widget->accessibleName() == QLatin1String(name)) return widget;
        return nullptr;
    };
    const auto opened = [this] {
        m_panel->timeline().playback().setPlaying(false);
        m_panel->timeline().setRow(m_panel->timeline().rowCount() - 1);
        QTest::keyClick(m_panel->trackView(), Qt::Key_Return);
        return m_panel->findChild<view::MotionDialog*>();
    };
    const auto place = [this] { return *document::orbitPlace(m_document->entryFractal(), 0); };
    m_panel->motions()[2]->trigger(); // Orbit
    QPointer dialog = opened();
    QVERIFY(dialog && !field(dialog, "Axis") && !field(dialog, "z of the pivot"));
    dialog->reject();
    QTRY_VERIFY(!dialog);
    m_document->setFile(document::fileOf(space_window::cubeOfEight()));
    m_panel->timeline().setVerticalSource([] { return ifs::Vector<3>(ifs::Vector<3>::UnitZ()); });
    m_panel->motions()[2]->trigger();
    const document::OrbitPlace start = place();
    QVERIFY(start.axis == ifs::Vector<3>::UnitZ());
    QVERIFY((start.centre - ifs::Vector<3>(0.5, 0.5, 0.5)).norm() < 1e-5);
    dialog = opened();
    QVERIFY(dialog);
    using Pivot = view::OrbitRows::Pivot;
    auto* axis = qobject_cast<QComboBox*>(field(dialog, "Axis"));
    auto* tilt = qobject_cast<QDoubleSpinBox*>(field(dialog, "Tilt"));
    auto* pivot = qobject_cast<QComboBox*>(field(dialog, "Pivot"));
    auto* x = qobject_cast<view::NumberField*>(field(dialog, "x of the pivot"));
    QVERIFY(axis && tilt && pivot && x);
    QCOMPARE(axis->currentText(), QStringLiteral("Z"));
    QCOMPARE(tilt->value(), 0.0);
    QCOMPARE(pivot->currentText(), QStringLiteral("Centre of the fractal"));
    QVERIFY(!x->isEnabled());
    support::choose(axis, 1);
    QVERIFY(place().axis == ifs::Vector<3>::UnitY()); // seen at once
    tilt->setValue(30);
    QVERIFY((place().axis - document::directionOf({1, 30, 0})).norm() < 1e-12);
    support::choose(pivot, Pivot::Target);
    QVERIFY(place().pivot == animation::OrbitPivot::Target);
    support::choose(pivot, Pivot::Point);
    QVERIFY(x->isEnabled());
    x->setFocus();
    x->selectAll();
    QTest::keyClicks(x, QStringLiteral("2"));
    QVERIFY(place().pivot == animation::OrbitPivot::Centre && place().centre.x() == 2);
    support::choose(pivot, Pivot::Centre);
    QVERIFY(place().centre == start.centre);
    dialog->accept();
    QTRY_VERIFY(!dialog);
    QCOMPARE(m_document->undoStack()->undoText(), QStringLiteral("Change the motion “Orbit”"));
    dialog = opened(); // as it is now
    QCOMPARE(qobject_cast<QDoubleSpinBox*>(field(dialog, "Tilt"))->value(), 30.0);
    dialog->reject();
}

BARYCAGE_TEST(OrbitMotionTest, QApplication);
#include "orbit_motion_test.moc"
