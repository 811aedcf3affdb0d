// SPDX-License-Identifier: MIT
#include "attractor/request/camera.h"
#include "canvas/items/analysis_item.h"
#include "canvas/scene/canvas_scene.h"
#include "document/fractal/fractal_geometry.h"
#include "panels/analysis/analysis_panel.h"
#include "panels/appearance/appearance_panel.h"
#include "panels/appearance/controls/appearance_slider.h"
#include "panels/appearance/number_rows.h"
#include "panels/cage/cage_panel.h"
#include "panels/history/history_panel.h"
#include "support/window_on_x.h"
#include "widgets/numbers/number_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QListView>
#include <QSlider>

using ifs::Vector;

// The panels beside the table of maps, with a real pointer and real keys.
class RealPanelsTest : public support::WindowOnX {
    Q_OBJECT

private slots:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void aVertexIsTyped();
    void theLookIsChanged();
    void factsAreOutlined();
    void theHistoryIsWalked();
};

void RealPanelsTest::aVertexIsTyped() {
    showPanel(QStringLiteral("Cage"));
    const auto* panel = window().findChild<view::CagePanel*>();
    auto* field = panel->field(view::CagePanel::Vertices::Current, 1, 0);
    const double y = vertices()[1].y();
    click(field);
    hand().key("Control+a");
    hand().type(QStringLiteral("-2.75"));
    QTRY_COMPARE(vertices()[1].x(), -2.75); // live, before it is taken
    QCOMPARE(steps(), 0);
    hand().key("Return");
    QTRY_COMPARE(steps(), 1);
    QCOMPARE(vertices()[1], Vector<2>(-2.75, y));
}

void RealPanelsTest::factsAreOutlined() {
    const auto outlined = [this]() -> QRectF {
        for (const QGraphicsItem* item : canvas().canvas().items())
            if (const auto* outlines = dynamic_cast<const view::AnalysisItem*>(item))
                return outlines->boundingRect();
        return {};
    };
    showPanel(QStringLiteral("Analysis"));
    auto* panel = window().findChild<view::AnalysisPanel*>();
    QTRY_VERIFY(!panel->facts().isEmpty());
    auto* box = panel->outlineBox(document::Outline::Box);
    panel->ensureWidgetVisible(box);
    support::handleEvents();
    hand().clickAt(box->mapToGlobal(QPoint(8, box->height() / 2)));
    QTRY_VERIFY(box->isChecked());
    const document::Box around = *document::displayedBox(fractal());
    const double width = (around.max - around.min).x() * pixelsPerUnit();
    QTRY_VERIFY(std::abs(outlined().width() - 18 - width) < 2); // with room for its line
    photograph(QStringLiteral("outlined.png"));
    hand().clickAt(box->mapToGlobal(QPoint(8, box->height() / 2)));
    QTRY_VERIFY(outlined().width() < 12);
}

void RealPanelsTest::theLookIsChanged() {
    showPanel(QStringLiteral("Appearance"));
    const auto* panel = window().findChild<view::AppearancePanel*>();
    const attractor::Appearance before = fractal().appearance;
    pick(panel->colourBy(), attractor::ColourBy::Map);
    QTRY_COMPARE(steps(), 1);
    QCOMPARE(fractal().appearance.colourBy, attractor::ColourBy::Map);

    const QImage picture = canvas().picture();
    const QSlider* slider = panel->numbers()->slider(&attractor::Appearance::brightness)->slider();
    const double share =
        double(slider->value() - slider->minimum()) / (slider->maximum() - slider->minimum());
    const QPoint knob =
        slider->mapToGlobal(QPoint(qRound(8 + share * (slider->width() - 16)), slider->height() / 2));
    hand().drag(knob, {knob + QPoint(10, 0), knob + QPoint(40, 0)});
    QTRY_COMPARE(steps(), 2); // one, however far
    QVERIFY(fractal().appearance.brightness > before.brightness);
    QTRY_VERIFY(canvas().picture() != picture);
    hand().key("Control+z");
    QTRY_COMPARE(fractal().appearance.brightness, before.brightness);
}

void RealPanelsTest::theHistoryIsWalked() {
    const document::Fractal opened = fractal();
    for (const QPoint by : {QPoint(-30, 20), QPoint(10, -40), QPoint(-20, -20)})
        dragBy(vertex(1), by);
    QTRY_COMPARE(steps(), 3);
    const document::Fractal last = fractal();
    showPanel(QStringLiteral("History"));
    auto* list = window().findChild<view::HistoryPanel*>()->findChild<QListView*>();
    clickOn(list, list->model()->index(0, 0));
    QTRY_VERIFY(fractal() == opened);
    clickOn(list, list->model()->index(3, 0));
    QTRY_VERIFY(fractal() == last);
    QCOMPARE(steps(), 3);
}

BARYCAGE_TEST_ON_X(RealPanelsTest);

#include "real_panels_test.moc"
