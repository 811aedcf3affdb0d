// SPDX-License-Identifier: MIT
#include "desktop/clipboard.h"
#include "document/edits/maps/map_locks.h"
#include "panels/maps/map_shape_editor.h"
#include "panels/maps/map_thumbnails.h"
#include "panels/maps/maps_panel.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "support/processor_timer.h"
#include "view/panels/maps_support.h"
#include "widgets/numbers/number_field.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QImage>
#include <QLineEdit>
#include <QMimeData>
#include <QSignalSpy>
#include <QTableView>
#include <QToolButton>

using namespace maps_support;
using view::MapsModel;
using view::MapsPanel;

// Maps as layers: names, eyes, locks, solo, pictures, cut and paste.
class MapsLayersTest : public QObject {
    Q_OBJECT

    QTableView& table() { return *m_panel->table(); }
    QModelIndex cell(int row, int column) { return m_panel->model()->index(row, column); }
    void click(int row, int column, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mouseClick(table().viewport(), Qt::LeftButton, modifiers,
                          table().visualRect(cell(row, column)).center());
    }
    QString nameOf(std::size_t row) {
        return m_document->fractal().mapLabels.of(systemOf(*m_document).maps[row].id).name;
    }
    bool isLocked(std::size_t row) { return document::isLocked(m_document->fractal(), row); }
    QToolButton* button(const QString& name) {
        for (auto* each : m_panel->findChildren<QToolButton*>())
            if (each->accessibleName() == name) return each;
        return nullptr;
    }
    int steps() { return m_document->undoStack()->count(); }
    void open(const document::Fractal& fractal) { m_document->setFile(document::fileOf(fractal)); }

private slots:
    void init() {
        m_document = std::make_unique<document::Document>();
        open(withTriangle(maple()));
        m_panel = std::make_unique<MapsPanel>(m_document.get());
        m_panel->resize(430, 600);
        m_panel->show();
        m_panel->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
        m_said = std::make_unique<QSignalSpy>(m_panel.get(), &MapsPanel::message);
    }

    void aNameIsTypedInTheTable() {
        QVERIFY(table().isColumnHidden(MapsModel::Name));
        m_panel->selectMaps({m_panel->model()->idAt(1)});
        m_panel->renameMap();
        QVERIFY(!table().isColumnHidden(MapsModel::Name));
        auto* editor = table().findChild<QLineEdit*>();
        QVERIFY(editor);
        QTest::keyClicks(editor, QStringLiteral("stem"));
        QCOMPARE(nameOf(1), QStringLiteral("stem")); // live
        QCOMPARE(editor->text(), QStringLiteral("stem"));
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(steps(), 1);
        QCOMPARE(cell(1, MapsModel::Name).data().toString(), QStringLiteral("stem"));
        QVERIFY(m_panel->model()
                    ->headerData(1, Qt::Vertical, Qt::ToolTipRole)
                    .toString()
                    .contains(QStringLiteral("stem")));
        m_document->undoStack()->undo();
        QVERIFY(m_document->fractal().mapLabels.isEmpty());
    }

    // Each is on or off by itself: a button to press, not a tab of several.
    void columnsHaveSwitches() {
        int off = 0;
        for (auto* toggle : m_panel->findChildren<QToolButton*>(QStringLiteral("columns"))) {
            QVERIFY2(!toggle->toolTip().isEmpty(), qPrintable(toggle->text()));
            if (toggle->isChecked()) continue;
            ++off;
            const QImage seen = toggle->grab().toImage();
            const QColor ground = m_panel->palette().color(QPalette::Window);
            bool isFramed = false;
            for (int x = 0; x < seen.width() / 8; ++x) // left of the text
                isFramed = isFramed || seen.pixelColor(x, seen.height() / 2) != ground;
            QVERIFY2(isFramed, qPrintable(toggle->text()));
        }
        QCOMPARE(off, 3);
    }

    void escapeLeavesTheName() {
        document::renameMap(*m_document, 0, QStringLiteral("leaf"));
        m_panel->selectMaps({m_panel->model()->idAt(0)});
        m_panel->renameMap();
        auto* editor = table().findChild<QLineEdit*>();
        QCOMPARE(editor->text(), QStringLiteral("leaf"));
        QTest::keyClicks(editor, QStringLiteral("x"));
        QTest::keyClick(editor, Qt::Key_Escape);
        QTRY_COMPARE(nameOf(0), QStringLiteral("leaf"));
        QCOMPARE(steps(), 1);
    }

    // Names become shorter first, then numbers have fewer decimals, but three digits; only then the table
    // scrolls.
    void namesGiveWayToNumbers() {
        document::Fractal named =
            fractalOf({{-0.12347, -0.65432, -0.98765, -0.45678, -0.33333, -0.66666, 0.54321},
                       {0.1, 0, 0, 0.1, 0, 0, 0.45679}});
        named.mapLabels.set(document::system2(named)->maps[0].id,
                            {QStringLiteral("the longest of all the leaves on the left"), false});
        open(named);
        constexpr int shortest = 48;
        bool isCut = false, isWhole = false;
        int before = 0;
        for (int width = 200; width <= 900; width += 20) {
            m_panel->resize(width, 600);
            QCoreApplication::processEvents();
            const int name = table().columnWidth(MapsModel::Name);
            QVERIFY2(name >= shortest && name >= before, qPrintable(QString::number(name)));
            before = name;
            const QString shown = cell(0, MapsModel::A).data().toString();
            QVERIFY2(shown.startsWith(QStringLiteral("-0.1")), qPrintable(shown));
            const int right =
                table().columnViewportPosition(MapsModel::Weight) + table().columnWidth(MapsModel::Weight);
            const bool fits = right <= table().viewport()->width();
            if (!fits) QVERIFY(name == shortest && shown == QStringLiteral("-0.123"));
            if (name > shortest) QVERIFY(fits && shown == QStringLiteral("-0.1235"));
            isCut = isCut || !fits;
            isWhole = isWhole || name > shortest;
        }
        QVERIFY(isCut && isWhole);
    }

    // However much is shown beside them.
    void threeDigitsAreAlwaysSeen() {
        document::Fractal named = withTriangle(maple());
        named.mapLabels.set(document::system2(named)->maps[2].id, {QStringLiteral("left leaf"), false});
        document::system2(named)->maps[1].map.linear(0, 1) = 0.0042317;
        open(named);
        for (const auto group : {MapsPanel::Columns::Names, MapsPanel::Columns::Code,
                                 MapsPanel::Columns::Facts, MapsPanel::Columns::Effective})
            m_panel->showColumns(group, true);
        QCOMPARE(cell(0, MapsModel::A).data().toString(), QStringLiteral("-0.04"));
        QCOMPARE(cell(1, MapsModel::B).data().toString(), QStringLiteral("0.00423"));
        const auto& model = *m_panel->model();
        for (int row = 0; row < model.rowCount(); ++row)
            for (int column = 0; column < model.columnCount(); ++column) {
                if (!model.isNumber(column)) continue;
                const double exact = cell(row, column).data(Qt::EditRole).toDouble();
                const QString shown = cell(row, column).data().toString();
                QVERIFY2(std::abs(shown.toDouble() - exact) <= 0.005 * std::abs(exact), qPrintable(shown));
                const QAbstractItemView& view = table(); // where the hint is public
                QVERIFY(table().columnWidth(column) >= view.sizeHintForIndex(cell(row, column)).width());
            }
    }

    // Where there are names; and all of the code still fits.
    void namesShowThemselves() {
        document::Fractal named = withTriangle(maple());
        named.mapLabels.set(document::system2(named)->maps[2].id, {QStringLiteral("left leaf"), false});
        open(named);
        QVERIFY(!table().isColumnHidden(MapsModel::Name));
        const int right =
            table().columnViewportPosition(MapsModel::Weight) + table().columnWidth(MapsModel::Weight);
        QVERIFY2(right <= table().viewport()->width(), qPrintable(QString::number(right)));
        open(maple());
        QVERIFY(table().isColumnHidden(MapsModel::Name));
    }

    void theEyeSwitches() {
        click(1, MapsModel::Enabled);
        QVERIFY(!systemOf(*m_document).maps[1].enabled);
        QTest::mouseDClick(table().viewport(), Qt::LeftButton, {},
                           table().visualRect(cell(1, MapsModel::Enabled)).center());
        table().setCurrentIndex(cell(2, MapsModel::Enabled));
        QTest::keyClick(&table(), Qt::Key_Space);
        QVERIFY(!systemOf(*m_document).maps[2].enabled);
    }

    void aLockedMapIsNotEdited() {
        click(1, MapsModel::Lock);
        QVERIFY(isLocked(1));
        QCOMPARE(steps(), 1);
        const document::Fractal locked = m_document->fractal();
        for (const int column : {int(MapsModel::A), int(MapsModel::Weight)}) {
            QVERIFY(!(cell(1, column).flags() & Qt::ItemIsEditable));
            QVERIFY(!m_panel->model()->setData(cell(1, column), 0.5));
            m_panel->model()->preview(cell(1, column), 0.5);
        }
        m_said->clear();
        table().setCurrentIndex(cell(1, MapsModel::A));
        QTest::keyClicks(&table(), QStringLiteral("5"));
        QCOMPARE(m_said->size(), 1);
        const QPoint middle = table().visualRect(cell(1, MapsModel::B)).center();
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, middle); // as a hand does first
        QTest::mouseDClick(table().viewport(), Qt::LeftButton, {}, middle);
        QCOMPARE(m_said->size(), 2);
        QCOMPARE(m_said->front().front().toString(),
                 QStringLiteral("Map 2 is locked. Unlock it in the Maps panel first."));
        m_panel->deleteMaps();
        m_panel->cutMaps();
        QGuiApplication::clipboard()->setText(QStringLiteral(".1 0 0 .1 0 0 1"));
        m_panel->pasteMaps();
        QCOMPARE(m_said->size(), 5);
        QVERIFY(!m_panel->findChild<view::MapShapeEditor*>()->isEnabled());
        QVERIFY(m_document->fractal() == locked);
        // What is not its code stays open, and the others are.
        QVERIFY(m_panel->model()->setData(cell(1, MapsModel::Name), QStringLiteral("stem")));
        QVERIFY(m_panel->model()->setData(cell(0, MapsModel::A), 0.5));
        m_panel->selectMaps({m_panel->model()->idAt(0), m_panel->model()->idAt(1)});
        m_panel->toggleLock();
        QVERIFY(isLocked(0) && isLocked(1));
        m_panel->toggleLock();
        QVERIFY(!isLocked(0) && !isLocked(1));
    }

    // By Alt+click on an eye or the button; no step, and it ends with the entry.
    void soloIsNoEdit() {
        QSignalSpy solo(m_panel.get(), &MapsPanel::soloChanged);
        const ifs::MapId second = m_panel->model()->idAt(1);
        click(1, MapsModel::Enabled, Qt::AltModifier);
        QCOMPARE(solo.size(), 1);
        QCOMPARE(solo.last().front().value<ifs::MapId>(), second);
        QCOMPARE(m_panel->model()->solo(), second);
        QVERIFY(button(QStringLiteral("Solo"))->isChecked());
        QCOMPARE(steps(), 0);
        QVERIFY(systemOf(*m_document).maps[1].enabled);
        button(QStringLiteral("Solo"))->click();
        QCOMPARE(m_panel->model()->solo(), ifs::MapId::None);
        QVERIFY(!button(QStringLiteral("Solo"))->isChecked());
        click(1, MapsModel::Enabled, Qt::AltModifier);
        click(2, MapsModel::Enabled, Qt::AltModifier); // another one alone
        QCOMPARE(m_panel->model()->solo(), m_panel->model()->idAt(2));
        m_document->edit(QStringLiteral("delete"), withoutMaps(m_document->fractal(), {2}).fractal);
        QCOMPARE(m_panel->model()->solo(), ifs::MapId::None);
        m_document->undoStack()->undo();
        click(2, MapsModel::Enabled, Qt::AltModifier);
        open(maple());
        QCOMPARE(m_panel->model()->solo(), ifs::MapId::None);
        open({});
        m_panel->toggleSolo(); // an entry without maps
        QCOMPARE(m_panel->model()->solo(), ifs::MapId::None);
    }

    void weightsOfLockedMapsStay() {
        m_panel->selectAllMaps();
        m_panel->toggleLock();
        m_said->clear();
        m_panel->applyWeights(document::WeightRule::Determinant);
        QCOMPARE(m_said->size(), 1);
        QVERIFY(m_said->front().front().toString().startsWith(QStringLiteral("Maps 1, 2, 3, 4 are locked.")));
        QCOMPARE(steps(), 1); // the lock
    }

    void mapsGoThroughTheClipboardWithTheirNames() {
        document::renameMap(*m_document, 2, QStringLiteral("leaf"));
        const auto third = systemOf(*m_document).maps[2];
        m_panel->selectMaps({third.id});
        m_panel->cutMaps();
        QCOMPARE(systemOf(*m_document).maps.size(), std::size_t(3));
        QCOMPARE(m_document->undoStack()->undoText(), QStringLiteral("Cut a map"));
        QVERIFY(QGuiApplication::clipboard()->text().startsWith(QStringLiteral("0.65\t0.29")));
        table().setFocus();
        QTest::keyClick(&table(), Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(systemOf(*m_document).maps.size(), std::size_t(4));
        QVERIFY(systemOf(*m_document).maps[3].map == third.map);
        QCOMPARE(nameOf(3), QStringLiteral("leaf"));
        QTest::keyClick(&table(), Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(m_panel->selectedMaps().size(), std::size_t(4));
        QTest::keyClick(&table(), Qt::Key_X, Qt::ControlModifier);
        QVERIFY(systemOf(*m_document).maps.empty());
    }

    void mapsInSpaceGoThroughTheClipboard() {
        open(fernInSpace());
        document::renameMap(*m_document, 1, QStringLiteral("leaf"));
        const auto second = solidOf(*m_document).maps[1];
        m_panel->selectMaps({second.id});
        m_panel->copyMaps();
        const QString rows = QGuiApplication::clipboard()->text();
        QCOMPARE(rows.trimmed().split(u'\t').size(), 13);
        m_panel->appendPasted();
        QCOMPARE(solidOf(*m_document).maps.size(), std::size_t(5));
        QVERIFY(solidOf(*m_document).maps[4].map == second.map);
        QCOMPARE(m_document->fractal().mapLabels.of(solidOf(*m_document).maps[4].id).name,
                 QStringLiteral("leaf"));
        QGuiApplication::clipboard()->setText(rows); // as it comes from another program
        m_panel->selectMaps({solidOf(*m_document).maps[0].id});
        m_panel->pasteMaps();
        QCOMPARE(solidOf(*m_document).maps.size(), std::size_t(5));
        QVERIFY((solidOf(*m_document).maps[0].map.linear - second.map.linear).norm() < 1e-12);
        QGuiApplication::clipboard()->setText(QStringLiteral("rubbish"));
        m_panel->appendPasted();
        QVERIFY(m_said->last().front().toString().contains(QStringLiteral("12 or 13")));
        open(maple());
        QGuiApplication::clipboard()->setMimeData(view::mapsMimeData({{}, {second}, {QString()}}).release());
        m_panel->appendPasted();
        QCOMPARE(systemOf(*m_document).maps.size(), std::size_t(4));
        QVERIFY(m_said->last().front().toString().contains(QStringLiteral("in space")));
    }

    // Each row has the part of the attractor that its map makes; drawn behind the window's back.
    void picturesAppear() {
        auto* thumbnails = m_panel->findChild<view::MapThumbnails*>();
        QVERIFY(thumbnails);
        QTRY_VERIFY(!thumbnails->picture(3, m_panel->model()->idAt(3)).isNull());
        QTRY_VERIFY(!thumbnails->isBusy());
        const QImage before = thumbnails->picture(3, m_panel->model()->idAt(3));
        QVERIFY(thumbnails->picture(0, m_panel->model()->idAt(0)) != before);
        m_panel->model()->setData(cell(3, MapsModel::E), 0.9);
        QTRY_VERIFY(thumbnails->picture(3, m_panel->model()->idAt(3)) != before);
    }

    void tenThousandMapsStayFast() {
        std::vector<Row> rows;
        for (int k = 0; k < 10'000; ++k)
            rows.push_back({0.01, 0, 0, 0.01, double(k % 100) / 100, double(k / 100) / 100, 1});
        open(fractalOf(rows));
        const support::ProcessorTimer time;
        table().selectAll();
        m_panel->toggleLock();
        document::renameMap(*m_document, 5000, QStringLiteral("middle"));
        m_panel->deleteMaps(); // not these
        m_panel->toggleLock();
        m_panel->duplicateMaps();
        table().scrollToBottom();
        QCoreApplication::processEvents();
        QCOMPARE(systemOf(*m_document).maps.size(), std::size_t(20'000));
        qInfo("10^4 maps: %lld ms", static_cast<long long>(time.elapsed()));
        QVERIFY(time.elapsed() < 4000);
        auto* thumbnails = m_panel->findChild<view::MapThumbnails*>();
        QTRY_VERIFY_WITH_TIMEOUT(!thumbnails->picture(19'999, m_panel->model()->idAt(19'999)).isNull(),
                                 60'000);
    }

private:
    std::unique_ptr<document::Document> m_document;
    std::unique_ptr<MapsPanel> m_panel;
    std::unique_ptr<QSignalSpy> m_said;
};

BARYCAGE_TEST(MapsLayersTest, QApplication);
#include "maps_layers_test.moc"
