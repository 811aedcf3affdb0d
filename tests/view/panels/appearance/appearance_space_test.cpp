// SPDX-License-Identifier: MIT
#include "document/fractal/space_geometry.h"
#include "panels/appearance/appearance_panel.h"
#include "panels/appearance/controls/appearance_slider.h"
#include "panels/appearance/light_ball.h"
#include "panels/appearance/number_rows.h"
#include "panels/appearance/palettes/gradient_preview.h"
#include "panels/appearance/slice_rows.h"
#include "panels/appearance/space_rows.h"
#include "support/choose.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/panels/maps_support.h"
#include "widgets/numbers/number_field.h"

#include <QComboBox>
#include <QSlider>

#include <cmath>
#include <memory>

using namespace maps_support;
using attractor::LookInSpace;
using attractor::SolidColour;

// The Appearance panel with a system in space.
class AppearanceSpaceTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_document = std::make_unique<document::Document>();
        m_document->setFile(document::fileOf(fernInSpace()));
        m_panel = std::make_unique<view::AppearancePanel>(m_document.get());
        m_panel->resize(420, 800);
        m_panel->show();
        m_panel->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
    }
    void cleanup() { m_panel.reset(); }

    void everyLookShowsWhatItUses() {
        const view::SpaceRows* rows = m_panel->space();
        struct Shown {
            LookInSpace look;
            bool colour, light, fog, palette, tone;
        };
        for (const Shown& shown : {Shown{LookInSpace::Stone, true, true, true, false, false},
                                   Shown{LookInSpace::Ink, true, false, true, false, false},
                                   Shown{LookInSpace::Cloud, false, false, false, true, true},
                                   Shown{LookInSpace::XRay, false, false, false, true, true},
                                   Shown{LookInSpace::Depth, false, false, false, false, false},
                                   Shown{LookInSpace::Normals, false, false, false, false, false}}) {
            support::choose(rows->look(), shown.look);
            QCOMPARE(inSpace().look, shown.look);
            QCOMPARE(rows->colourBy()->isVisible(), shown.colour);
            QCOMPARE(rows->light()->isVisible(), shown.light);
            QCOMPARE(rows->fog()->isVisible(), shown.fog);
            QCOMPARE(m_panel->gradient()->isVisible(), shown.palette);
            for (const auto* slider : {m_panel->numbers()->slider(&attractor::Appearance::brightness),
                                       m_panel->numbers()->slider(&attractor::Appearance::contrast),
                                       m_panel->numbers()->slider(&attractor::Appearance::vibrancy)})
                QCOMPARE(slider->isVisible(), shown.tone);
            QVERIFY(!m_panel->numbers()->slider(&attractor::Appearance::shadow)->isVisible());
        }
        QCOMPARE(m_document->undoStack()->count(), 5); // stone was there
        m_document->undoStack()->setIndex(0);
        QCOMPARE(rows->look()->currentData().toInt(), int(LookInSpace::Stone));
    }

    void coloursOfASolidTakeThePalette() {
        const view::SpaceRows* rows = m_panel->space();
        support::choose(rows->colourBy(), SolidColour::Address);
        QCOMPARE(document::solidColour(m_document->fractal()), SolidColour::Address);
        QVERIFY(m_panel->gradient()->isVisible() && m_panel->gradient()->isEnabled());
        QVERIFY(document::spaceRequest(m_document->fractal(), {}).key == attractor::SolidKey::Address);
        support::choose(rows->colourBy(), SolidColour::Map);
        QVERIFY(!m_panel->gradient()->isVisible());
        QCOMPARE(document::solidAppearance(m_document->fractal()).mapColours.size(),
                 document::system3(m_document->fractal())->maps.size());
    }

    void theLightIsDraggedInOneStep() {
        view::LightBall* ball = m_panel->space()->light();
        const QPoint middle = ball->rect().center();
        QTest::mousePress(ball, Qt::LeftButton, {}, middle);
        QTest::mouseMove(ball, middle + QPoint(10, 0));
        QTest::mouseMove(ball, middle + QPoint(28, 0));
        QVERIFY(inSpace().lightAzimuth > 30); // live
        QCOMPARE(m_document->undoStack()->count(), 0);
        QTest::mouseRelease(ball, Qt::LeftButton, {}, middle + QPoint(28, 0));
        QCOMPARE(m_document->undoStack()->count(), 1);
        QVERIFY(std::abs(inSpace().lightElevation) < 3);
        m_document->undoStack()->undo();
        QVERIFY(inSpace() == attractor::SpaceAppearance{});
        QTest::mousePress(ball, Qt::LeftButton, {}, middle);
        QTest::keyClick(ball, Qt::Key_Escape);
        QVERIFY(inSpace() == attractor::SpaceAppearance{});
        QTest::mouseRelease(ball, Qt::LeftButton, {}, middle);
        QCOMPARE(m_document->undoStack()->count(), 1); // the one that was undone
    }

    void arrowKeysMoveTheLightInOneStep() {
        view::LightBall* ball = m_panel->space()->light();
        ball->setFocus();
        for (int k = 0; k < 3; ++k)
            QTest::keyClick(ball, Qt::Key_Right);
        QCOMPARE(inSpace().lightAzimuth, -25.0);
        QCOMPARE(m_document->undoStack()->count(), 0);
        QTRY_COMPARE(m_document->undoStack()->count(), 1);
        QVERIFY(ball->accessibleDescription().contains(QStringLiteral("-25")));
    }

    void aSliceIsChosenTurnedAndMoved() {
        const view::SliceRows* rows = m_panel->slice();
        QVERIFY(!rows->offset()->isVisible());
        support::choose(rows->kind(), view::SliceRows::Kind::Half);
        QVERIFY(inSpace().clip && std::isinf(inSpace().clip->lowest));
        QVERIFY(rows->offset()->isVisible() && !rows->thickness()->isVisible());
        QTRY_VERIFY(rows->offset()->height() >= rows->offset()->minimumSizeHint().height());
        QTRY_VERIFY(rows->offset()->y() > rows->direction()->y());
        support::choose(rows->kind(), view::SliceRows::Kind::Slice);
        QVERIFY(std::isfinite(inSpace().clip->lowest) && inSpace().clip->lowest < inSpace().clip->highest);
        QVERIFY(rows->thickness()->isVisible());
        support::choose(rows->direction(), view::SliceRows::Across::Diagonal);
        QCOMPARE(inSpace().clip->normal, ifs::Vector<3>(1, 1, 1));
        const int steps = m_document->undoStack()->count();
        QSlider* slider = rows->offset()->slider();
        const double before = inSpace().clip->highest;
        slider->setSliderDown(true);
        slider->setSliderPosition(slider->value() + 60);
        QVERIFY(inSpace().clip->highest > before);
        slider->setSliderDown(false);
        QCOMPARE(m_document->undoStack()->count(), steps + 1);
        support::choose(rows->kind(), view::SliceRows::Kind::Whole);
        QVERIFY(!inSpace().clip);
    }

    void resetForgetsEverything() {
        support::choose(m_panel->space()->look(), LookInSpace::Ink);
        support::choose(m_panel->slice()->kind(), view::SliceRows::Kind::Half);
        m_panel->resetToDefault();
        QVERIFY(inSpace() == attractor::SpaceAppearance{});
        QCOMPARE(m_document->undoStack()->count(), 3);
    }

    void thePlaneIsAsItWas() {
        m_document->setFile(document::fileOf(maple()));
        QVERIFY(!m_panel->space()->look()->isVisible());
        QVERIFY(!m_panel->slice()->kind()->isVisible());
        QVERIFY(m_panel->colourBy()->isVisible() &&
                m_panel->numbers()->slider(&attractor::Appearance::brightness)->isVisible());
        QVERIFY(m_panel->gradient()->isVisible());
    }

private:
    const attractor::SpaceAppearance& inSpace() const { return m_document->fractal().inSpace; }

    std::unique_ptr<document::Document> m_document;
    std::unique_ptr<view::AppearancePanel> m_panel;
};

BARYCAGE_TEST(AppearanceSpaceTest, QApplication);
#include "appearance_space_test.moc"
