// SPDX-License-Identifier: MIT
#include "panels/maps/map_blend_row.h"

#include "document/edits/maps/map_locks.h"
#include "panels/appearance/appearance_panel.h"
#include "panels/maps/maps_panel.h"
#include "support/choose.h"
#include "support/named_test.h"
#include "view/panels/maps_support.h"
#include "widgets/numbers/number_field.h"

#include <QComboBox>
#include <QTableView>
#include <QTest>
#include <QUndoStack>

using namespace maps_support;
using attractor::ColourBy;
using attractor::MapBlend;
using view::MapsModel;
using view::MapsPanel;

class MapBlendRowTest : public QObject {
    Q_OBJECT

    view::MapBlendRow& row() { return *m_panel->findChild<view::MapBlendRow*>(); }
    int steps() { return m_document->undoStack()->count(); }
    void select(int map) { m_panel->table()->setCurrentIndex(m_panel->model()->index(map, MapsModel::A)); }
    std::optional<MapBlend> stored(std::size_t map) {
        const document::Fractal& fractal = m_document->fractal();
        const MapBlend* blend = fractal.appearance.mapBlends.find(systemOf(*m_document).maps[map].id);
        return blend ? std::optional(*blend) : std::nullopt;
    }
    static void type(view::NumberField* field, const QString& text) {
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
    }
    void colourBy(ColourBy colourBy) {
        document::Fractal fractal = m_document->fractal();
        fractal.appearance.colourBy = colourBy;
        m_document->edit(QStringLiteral("colour"), fractal);
    }

private slots:
    void init() {
        m_document = std::make_unique<document::Document>();
        m_document->setFile(document::fileOf(withTriangle(maple())));
        m_panel = std::make_unique<MapsPanel>(m_document.get());
        m_panel->resize(430, 600);
        m_panel->show();
        m_panel->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
    }

    void isThereWhereMapsBlend() {
        QVERIFY(row().isHidden());
        const int narrow = m_panel->minimumSizeHint().width();
        colourBy(ColourBy::Blend);
        QVERIFY(row().isVisible());
        QVERIFY(m_panel->minimumSizeHint().width() <= narrow);
        m_document->undoStack()->undo();
        QVERIFY(row().isHidden());
        document::Fractal solid = fernInSpace();
        solid.appearance.colourBy = ColourBy::Blend;
        m_document->setFile(document::fileOf(solid));
        QVERIFY(row().isHidden());
        solid.inSpace.look = attractor::LookInSpace::Cloud;
        m_document->setFile(document::fileOf(solid));
        QVERIFY(row().isVisible());
    }

    void aNumberIsOneStep() {
        colourBy(ColourBy::Blend);
        const int before = steps();
        select(2);
        QVERIFY(std::abs(row().coordinate()->value() - 2.0 / 3) < 1e-15);
        QCOMPARE(row().speed()->value(), 0.5);
        type(row().speed(), QStringLiteral("0.9"));
        QCOMPARE(steps(), before); // live
        QVERIFY((stored(2) == MapBlend{2.0 / 3, 0.9}));
        QTest::keyClick(row().speed(), Qt::Key_Return);
        QCOMPARE(steps(), before + 1);
        QCOMPARE(m_document->undoStack()->undoText(), QStringLiteral("Map 3: Speed 0.9"));
        type(row().coordinate(), QStringLiteral("0.25"));
        QTest::keyClick(row().coordinate(), Qt::Key_Return);
        QCOMPARE(steps(), before + 2);
        QVERIFY((stored(2) == MapBlend{0.25, 0.9}));
        QVERIFY(!stored(1));
        m_document->undoStack()->undo();
        QVERIFY((stored(2) == MapBlend{2.0 / 3, 0.9}));
        m_document->undoStack()->undo();
        QVERIFY(!stored(2));
        QCOMPARE(row().speed()->value(), 0.5);
        m_document->undoStack()->redo();
        QCOMPARE(row().speed()->value(), 0.9);
    }

    void whatWasTypedStays() {
        colourBy(ColourBy::Blend);
        select(2);
        type(row().coordinate(), QStringLiteral("1/4"));
        QTest::keyClick(row().coordinate(), Qt::Key_Return);
        QVERIFY((stored(2) == MapBlend{0.25, 0.5}));
        select(1);
        QVERIFY(row().coordinate()->text() != QStringLiteral("1/4"));
        select(2);
        QCOMPARE(row().coordinate()->text(), QStringLiteral("1/4"));
    }

    void onlyFromZeroToOne() {
        colourBy(ColourBy::Blend);
        select(0);
        const int before = steps();
        type(row().coordinate(), QStringLiteral("1.5"));
        QVERIFY(!row().coordinate()->problem().isEmpty());
        QTest::keyClick(row().coordinate(), Qt::Key_Escape);
        type(row().coordinate(), QStringLiteral("0.5"));
        QTest::keyClick(row().coordinate(), Qt::Key_Escape);
        QCOMPARE(steps(), before);
        QVERIFY(!stored(0));
    }

    void aLockedMapIsNotEdited() {
        colourBy(ColourBy::Blend);
        select(1);
        QVERIFY(row().coordinate()->isEnabled());
        const ifs::MapId id = systemOf(*m_document).maps[1].id;
        document::lockMaps(*m_document, std::span(&id, 1), true);
        QVERIFY(!row().coordinate()->isEnabled());
    }

    void aMapThatIsGoneLeavesNothing() {
        colourBy(ColourBy::Blend);
        select(3);
        type(row().speed(), QStringLiteral("1"));
        QTest::keyClick(row().speed(), Qt::Key_Return);
        m_panel->deleteMaps();
        QVERIFY(m_document->fractal().appearance.mapBlends.empty());
        m_document->undoStack()->undo();
        QVERIFY((stored(3) == MapBlend{1, 1}));
    }

    void isChosenInTheAppearancePanel() {
        view::AppearancePanel panel(m_document.get());
        support::choose(panel.colourBy(), ColourBy::Blend);
        QVERIFY(m_document->fractal().appearance.colourBy == ColourBy::Blend);
        QCOMPARE(m_document->undoStack()->undoText(), QStringLiteral("Colour by: Blend of maps"));
        QVERIFY(row().isVisible());
    }

private:
    std::unique_ptr<document::Document> m_document;
    std::unique_ptr<MapsPanel> m_panel;
};

BARYCAGE_TEST(MapBlendRowTest, QApplication);
#include "map_blend_row_test.moc"
