// SPDX-License-Identifier: MIT
#include "dialogs/paste_table_dialog.h"
#include "document/edit_gesture.h"
#include "document/fractal/fractal_geometry.h"
#include "panels/maps/map_shape_editor.h"
#include "panels/maps/maps_panel.h"
#include "support/choose.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/panels/maps_support.h"
#include "widgets/numbers/number_field.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QShortcut>
#include <QSignalSpy>
#include <QTableView>
#include <QTableWidget>
#include <QToolButton>

#include <cmath>
#include <numbers>

using namespace maps_support;
using view::MapsModel;
using view::MapsPanel;
using view::NumberField;

class MapsPanelTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_document = std::make_unique<document::Document>();
        m_document->setFile(document::fileOf(withTriangle(maple())));
        m_panel = std::make_unique<MapsPanel>(m_document.get());
        m_panel->resize(380, 600);
        m_panel->show();
        m_panel->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
    }

    void typingInACellIsLiveAndOneStep() {
        NumberField* editor = openEditor(1, MapsModel::A);
        QTest::keyClicks(editor, QStringLiteral("0.5"));
        QCOMPARE(coefficient(1, 0, 0), 0.5);
        QTest::keyClicks(editor, QStringLiteral("25"));
        QCOMPARE(coefficient(1, 0, 0), 0.525);
        QCOMPARE(m_document->undoStack()->count(), 0);
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(m_document->undoStack()->count(), 1);
        m_document->undoStack()->undo();
        QCOMPARE(coefficient(1, 0, 0), 0.61);
    }

    // The table stays as it is under the hand, whatever the numbers become.
    void columnsKeepTheirWidthsInADrag() {
        const QTableView* table = m_panel->table();
        std::vector<int> before;
        for (int column = 0; column < MapsModel::ColumnCount; ++column)
            before.push_back(table->columnWidth(column));
        document::EditGesture gesture = m_document->beginGesture(QStringLiteral("drag"));
        document::Fractal moved = m_document->fractal();
        document::system2(moved)->maps[0].map.linear(0, 1) = -0.1234;
        document::system2(moved)->maps[1].map.translation = {-1234.5678, -8.3333e-17};
        gesture.preview(moved);
        for (int column = 0; column < MapsModel::ColumnCount; ++column)
            QCOMPARE(table->columnWidth(column), before[column]);
        document::system2(moved)->maps[1].map.translation = {1, 1};
        gesture.preview(moved);
        for (int column = 0; column < MapsModel::ColumnCount; ++column)
            QCOMPARE(table->columnWidth(column), before[column]);
        gesture.commit();
    }

    // The figures become narrower instead.
    void noDigitIsLostInADrag() {
        document::EditGesture gesture = m_document->beginGesture(QStringLiteral("drag"));
        document::Fractal moved = m_document->fractal();
        const auto pictureOf = [&](double value) {
            document::system2(moved)->maps[1].map.linear(0, 1) = value;
            gesture.preview(moved);
            QTableView* table = m_panel->table();
            return table->viewport()
                ->grab(table->visualRect(table->model()->index(1, MapsModel::B)))
                .toImage();
        };
        QVERIFY(pictureOf(-0.1231) != pictureOf(-0.1242));
        QVERIFY(pictureOf(-0.04) != pictureOf(0));
        QVERIFY(pictureOf(-8.33e-17) != pictureOf(-8.34e-17));
        gesture.cancel();
    }

    // a to f and p, with the marks, as the panel is in a window of 1440 pixels; and whatever the numbers are.
    void theCodeFitsThePanel() {
        m_panel->resize(430, 600);
        const QTableView* table = m_panel->table();
        for (int i = 0; i < 2; ++i) {
            for (int column = 0; column <= MapsModel::Weight; ++column) {
                if (column == MapsModel::Name) continue; // no map has one
                const int right = table->columnViewportPosition(column) + table->columnWidth(column);
                QVERIFY2(right <= table->viewport()->width(), qPrintable(QString::number(column)));
                QVERIFY(!table->isColumnHidden(column));
            }
            QVERIFY(table->verticalHeader()->isVisible()); // which has the mark
            document::Fractal fractal = m_document->fractal();
            for (auto& map : document::system2(fractal)->maps) {
                map.map.linear << -0.123456, -0.654321, -0.98765, -0.45678;
                map.map.translation = {-0.33333, -7.66666};
            }
            m_document->edit(QStringLiteral("longer numbers"), fractal);
        }
        const QString shown = m_panel->model()->index(0, MapsModel::A).data().toString();
        QVERIFY2(shown.startsWith(QStringLiteral("-0.12")), qPrintable(shown));
    }

    // As a moment of an animation has them: with three digits, a small number is long.
    void longNumbersAreDrawnNarrower() {
        m_panel->resize(390, 600);
        m_document->setFile(
            document::fileOf(withTriangle(fractalOf({{-0.0333, 0.0189, -0.231, -0.65, -0.0864, 0.262, 0.25},
                                                     {0.61, -0.00225, 0.00444, 0.31, 0.0693, 3.49, 0.25}}))));
        QTableView* table = m_panel->table();
        for (int column = 0; column <= MapsModel::Weight; ++column) {
            const int right = table->columnViewportPosition(column) + table->columnWidth(column);
            QVERIFY2(table->isColumnHidden(column) || column == MapsModel::Name ||
                         right <= table->viewport()->width(),
                     qPrintable(QString::number(column)));
        }
        QCOMPARE(m_panel->model()->index(1, MapsModel::B).data().toString(), QStringLiteral("-0.00225"));
        const auto picture = [&] {
            return table->viewport()
                ->grab(table->visualRect(table->model()->index(1, MapsModel::B)))
                .toImage();
        };
        const QImage before = picture();
        document::Fractal changed = m_document->fractal();
        document::system2(changed)->maps[1].map.linear(0, 1) = -0.00226; // the last digit is in sight
        m_document->edit(QStringLiteral("change"), changed);
        QVERIFY(picture() != before);
    }

    // As wide as it takes in fractions of a pixel.
    void kindsAreNotCutOff() {
        QTableView* table = m_panel->table();
        for (double size = 6; size < 16; size += 0.25) {
            QFont font = table->font();
            font.setPointSizeF(size);
            table->setFont(font);
            m_panel->showColumns(MapsPanel::Columns::Facts, true);
            const QString kind = m_panel->model()->index(0, MapsModel::Kind).data().toString();
            const int room = table->columnWidth(MapsModel::Kind) - 8;
            QCOMPARE(QFontMetrics(font).elidedText(kind, Qt::ElideRight, room), kind);
        }
    }

    void anEditorDoesNotHideTheNumberBefore() {
        const NumberField* editor = openEditor(1, MapsModel::B);
        QTableView* table = m_panel->table();
        const QRect cell = table->visualRect(table->model()->index(1, MapsModel::B));
        QVERIFY(editor->width() > cell.width());
        QCOMPARE(editor->x(), cell.x());
        table->scrollTo(table->model()->index(1, MapsModel::Weight));
        const NumberField* last = openEditor(1, MapsModel::Weight);
        QVERIFY(last->geometry().right() < table->viewport()->width());
    }

    void aTypedKeyStartsTheEdit() {
        m_panel->table()->setCurrentIndex(m_panel->model()->index(2, MapsModel::E));
        m_panel->table()->setFocus();
        QTest::keyClicks(m_panel->table(), QStringLiteral("3"));
        QCOMPARE(systemOf(*m_document).maps[2].map.translation.x(), 3.0);
    }

    void aConstantIsANumber() {
        m_panel->table()->setCurrentIndex(m_panel->model()->index(2, MapsModel::E));
        m_panel->table()->setFocus();
        QTest::keyClicks(m_panel->table(), QStringLiteral("p"));
        QTest::keyClicks(currentEditor(), QStringLiteral("i"));
        QTest::keyClick(currentEditor(), Qt::Key_Return);
        QTRY_COMPARE(m_document->undoStack()->count(), 1);
        QCOMPARE(systemOf(*m_document).maps[2].map.translation.x(), std::numbers::pi);
    }

    void theWindowDoesNotTakeTheDigits() {
        int stolen = 0;
        QShortcut shortcut(QKeySequence(Qt::Key_1), m_panel.get(), [&] { ++stolen; });
        QShortcut copy(QKeySequence::Copy, m_panel.get(), [&] { ++stolen; });
        m_panel->table()->setCurrentIndex(m_panel->model()->index(2, MapsModel::F));
        m_panel->table()->setFocus();
        QGuiApplication::clipboard()->clear();
        QTest::keyClick(m_panel->table(), Qt::Key_C, Qt::ControlModifier);
        QVERIFY(QGuiApplication::clipboard()->text().startsWith(QStringLiteral("0.65\t0.29")));
        QTest::keyClick(m_panel->table(), Qt::Key_1);
        QCOMPARE(systemOf(*m_document).maps[2].map.translation.y(), 1.0);
        QCOMPARE(stolen, 0);
    }

    void escapeRestores() {
        const document::Fractal before = m_document->fractal();
        NumberField* editor = openEditor(0, MapsModel::D);
        QTest::keyClicks(editor, QStringLiteral("0.1"));
        QVERIFY(m_document->fractal() != before);
        QTest::keyClick(editor, Qt::Key_Escape);
        QTRY_VERIFY(m_document->fractal() == before);
        QCOMPARE(m_document->undoStack()->count(), 0);
    }

    void aBadNumberIsNeverCommitted() {
        const document::Fractal before = m_document->fractal();
        QSignalSpy messages(m_panel.get(), &MapsPanel::message);
        NumberField* editor = openEditor(0, MapsModel::B);
        QTest::keyClicks(editor, QStringLiteral("1/0"));
        QTest::keyClick(editor, Qt::Key_Return);
        QCoreApplication::processEvents();
        QVERIFY(editor->isVisible()); // refused where it is typed
        QVERIFY(editor->problem().contains(QStringLiteral("1/0")));
        m_panel->table()->setFocus(); // leaving it
        QTRY_VERIFY(m_document->fractal() == before);
        QCOMPARE(m_document->undoStack()->count(), 0);
        QCOMPARE(messages.size(), 1);
    }

    // Whichever way the cell is left, 1.234 is not what was meant.
    void anUnreadableNumberLeavesTheOneBefore() {
        const document::Fractal before = m_document->fractal();
        for (const char* typed : {"1.234,5", "3*", "2 apples"}) {
            QSignalSpy messages(m_panel.get(), &MapsPanel::message);
            QTest::keyClicks(openEditor(0, MapsModel::B), QLatin1String(typed));
            m_panel->table()->setFocus();
            QTRY_VERIFY(m_document->fractal() == before);
            QCOMPARE(m_document->undoStack()->count(), 0);
            QCOMPARE(messages.size(), 1);
            QVERIFY(messages[0][0].toString().contains(QLatin1String(typed)));
        }
    }

    void aNegativeWeightIsTakenAndSaid() {
        QSignalSpy messages(m_panel.get(), &MapsPanel::message);
        QTest::keyClicks(openEditor(1, MapsModel::Weight), QStringLiteral("-0.5"));
        QTest::keyClick(currentEditor(), Qt::Key_Return);
        QTRY_COMPARE(m_document->undoStack()->count(), 1);
        QCOMPARE(systemOf(*m_document).maps[1].weight, -0.5);
        QCOMPARE(messages.size(), 1);
        QVERIFY(messages[0][0].toString().contains(QStringLiteral("negative")));
    }

    // With the entry: undo and redo lead back to what was typed, and the file has plain numbers.
    void whatWasTypedIsKept() {
        const QModelIndex cell = m_panel->model()->index(0, MapsModel::B);
        NumberField* editor = openEditor(0, MapsModel::B);
        QTest::keyClicks(editor, QStringLiteral("sqrt(3)/6"));
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(m_document->undoStack()->count(), 1);
        QCOMPARE(coefficient(0, 0, 1), std::sqrt(3.0) / 6);
        QCOMPARE(m_panel->model()->typedText(cell), QStringLiteral("sqrt(3)/6"));
        m_document->undoStack()->undo();
        QVERIFY(m_panel->model()->typedText(cell).isEmpty());
        m_document->undoStack()->redo();
        QCOMPARE(m_panel->model()->typedText(cell), QStringLiteral("sqrt(3)/6"));
        QCOMPARE(openEditor(0, MapsModel::B)->text(), QStringLiteral("sqrt(3)/6"));
        QVERIFY(cell.data().toString().startsWith(QStringLiteral("0.2")));
    }

    void tabGoesOnWithOneStepEach() {
        NumberField* editor = openEditor(0, MapsModel::A);
        QTest::keyClicks(editor, QStringLiteral("0.5"));
        QTest::keyClick(editor, Qt::Key_Tab);
        QTRY_VERIFY(currentEditor() && currentEditor() != editor);
        QTest::keyClicks(currentEditor(), QStringLiteral("0.25"));
        QTest::keyClick(currentEditor(), Qt::Key_Return);
        QTRY_COMPARE(m_document->undoStack()->count(), 2);
        QCOMPARE(coefficient(0, 0, 0), 0.5);
        QCOMPARE(coefficient(0, 0, 1), 0.25);
    }

    void tabLeavesTheTable() {
        for (const auto& [key, modifiers] :
             {std::pair(Qt::Key_Tab, Qt::NoModifier), std::pair(Qt::Key_Backtab, Qt::ShiftModifier)}) {
            m_panel->table()->setFocus();
            m_panel->table()->setCurrentIndex(m_panel->model()->index(1, MapsModel::A));
            QTest::keyClick(m_panel->table(), key, modifiers);
            QVERIFY(m_panel->focusWidget() && m_panel->focusWidget() != m_panel->table());
            QCOMPARE(m_panel->table()->currentIndex().column(), int(MapsModel::A));
        }
    }

    void deletedMapsAreSelectedWhenTheyComeBack() {
        m_panel->selectMaps({m_panel->model()->idAt(0), m_panel->model()->idAt(2)});
        const std::vector<ifs::MapId> deleted = m_panel->selectedMaps();
        QCOMPARE(deleted.size(), std::size_t(2));
        QTest::keyClick(m_panel->table(), Qt::Key_Delete);
        QVERIFY(m_panel->selectedMaps() != deleted);
        m_document->undoStack()->undo();
        QCOMPARE(m_panel->selectedMaps(), deleted);
    }

    void duplicateDeleteAndReorderKeepTheSelection() {
        const ifs::MapId second = m_panel->model()->idAt(1);
        m_panel->selectMaps({second});
        QTest::keyClick(m_panel->table(), Qt::Key_Down, Qt::AltModifier);
        QCOMPARE(m_panel->model()->idAt(2), second);
        QCOMPARE(m_panel->selectedMaps(), std::vector{second});
        QTest::keyClick(m_panel->table(), Qt::Key_Up, Qt::AltModifier);
        QCOMPARE(m_panel->model()->idAt(1), second);
        QTest::keyClick(m_panel->table(), Qt::Key_Insert);
        QCOMPARE(m_panel->model()->rowCount(), 5);
        QCOMPARE(m_panel->selectedMaps(), std::vector{m_panel->model()->idAt(2)});
        QTest::keyClick(m_panel->table(), Qt::Key_Delete);
        QCOMPARE(m_panel->model()->rowCount(), 4);
        QCOMPARE(m_document->undoStack()->count(), 4);
    }

    void rowsAreDraggedByTheirNumber() {
        const ifs::MapId first = m_panel->model()->idAt(0);
        m_panel->table()->verticalHeader()->moveSection(0, 2);
        QTRY_COMPARE(m_panel->model()->idAt(2), first);
        for (int row = 0; row < 4; ++row)
            QCOMPARE(m_panel->table()->verticalHeader()->visualIndex(row), row);
        QCOMPARE(m_document->undoStack()->count(), 1);
    }

    void pastesRowsAndRefusesRubbishWithASentence() {
        QSignalSpy messages(m_panel.get(), &MapsPanel::message);
        m_panel->selectMaps({m_panel->model()->idAt(3)});
        QGuiApplication::clipboard()->setText(
            QStringLiteral("a b c d e f p\n0.1\t0.2\t0.3\t0.4\t0.5\t0.6\t0.7\n1 2 3 4 5 6 0.5\n"));
        m_panel->pasteMaps();
        QCOMPARE(m_panel->model()->rowCount(), 5);
        QCOMPARE(coefficient(3, 1, 1), 0.4);
        QVERIFY(qAbs(*systemOf(*m_document).maps[4].weight / *systemOf(*m_document).maps[3].weight -
                     5.0 / 7) < 1e-12);
        QCOMPARE(m_document->undoStack()->count(), 1);
        QGuiApplication::clipboard()->setText(QStringLiteral("a b c d e f\n0.1 0.2 0.3 0.4 0.5 0.6\n"));
        m_panel->appendPasted();
        QTRY_VERIFY(messages.back().front().toString().contains(QStringLiteral("1 map")));
        m_document->undoStack()->undo();
        QCOMPARE(m_panel->model()->rowCount(), 5);
        QGuiApplication::clipboard()->setText(QStringLiteral("0.1 0.2 rubbish 0.4 0.5 0.6\n"));
        m_panel->appendPasted();
        QCOMPARE(m_panel->model()->rowCount(), 5);
        QVERIFY2(messages.back().front().toString().startsWith(QStringLiteral("Nothing was pasted")),
                 qPrintable(messages.back().front().toString()));
        QGuiApplication::clipboard()->setText(
            QStringLiteral("a b c d e f p\n.5 0 0 .5 0 0 1\n.5 0 0 .5 1 0 86\n.5 0 0 .5 0 1 100\n"));
        m_panel->appendPasted();
        QVERIFY2(messages.back().front().toString().contains(QStringLiteral("“cumulative”")),
                 qPrintable(messages.back().front().toString()));
        QGuiApplication::clipboard()->setText(QStringLiteral(
            "a = [.5,.5]\nb = [0,0]\nc = [0,0]\nd = [.5,.5]\ne = [0,1]\nf = [0,0]\np = [.2,.3,.5]\n"));
        m_panel->appendPasted();
        QVERIFY2(messages.back().front().toString().contains(QStringLiteral("“p” has 3 numbers")),
                 qPrintable(messages.back().front().toString()));
    }

    // Each equation in a row: only in that order does every map contract, and the user may say otherwise.
    void columnsThatSayNothingAreAskedFor() {
        const document::Fractal before = m_document->fractal();
        m_panel->selectMaps({m_panel->model()->idAt(0)});
        QGuiApplication::clipboard()->setText(
            QStringLiteral("0.5 0.1 3 0.2 0.4 5 0.25\n0.3 0 2 0 0.3 1 0.75\n"));
        m_panel->pasteMaps();
        auto* dialog = m_panel->findChild<view::PasteTableDialog*>();
        QVERIFY(dialog);
        auto* columns = dialog->findChild<QComboBox*>();
        QCOMPARE(columns->currentData().toString(), QStringLiteral("a b e c d f p"));
        QCOMPARE(coefficient(0, 1, 0), 0.2); // on the canvas already
        QCOMPARE(systemOf(*m_document).maps[0].map.translation.x(), 3.0);
        QCOMPARE(m_document->undoStack()->count(), 0);
        support::choose(columns, QStringLiteral("a b c d e f p"));
        QCOMPARE(coefficient(0, 1, 0), 3.0);
        QVERIFY(dialog->findChild<QTableWidget*>()->item(0, 2)->text() == QStringLiteral("3"));
        QVERIFY(!dialog->findChild<QTableWidget*>()->tabKeyNavigation());
        dialog->reject();
        QVERIFY(m_document->fractal() == before);

        QSignalSpy messages(m_panel.get(), &MapsPanel::message);
        m_panel->pasteMaps();
        for (auto* open : m_panel->findChildren<view::PasteTableDialog*>())
            if (open->isVisible()) open->accept();
        QCOMPARE(m_document->undoStack()->count(), 1);
        QCOMPARE(m_panel->model()->rowCount(), 5);
        QCOMPARE(systemOf(*m_document).maps[1].map.translation.y(), 1.0);
        QCOMPARE(m_panel->selectedMaps().size(), 2);
        QCOMPARE(messages.size(), 1);
    }

    // Weights that rise to 1 from row to row are cumulative; any other order can be typed, and missing
    // columns are named.
    void everyOrderOfColumnsCanBeSaid() {
        QGuiApplication::clipboard()->setText(
            QStringLiteral("0.5 0.1 0.2 0.4 3 5 0.25\n0.3 0 0 0.3 2 1 1\n"));
        m_panel->appendPasted();
        auto* dialog = m_panel->findChild<view::PasteTableDialog*>();
        QVERIFY(dialog);
        auto* columns = dialog->findChild<QComboBox*>();
        auto* typed = dialog->findChild<QLineEdit*>();
        QCOMPARE(columns->currentData().toString(), QStringLiteral("a b c d e f cumulative"));
        QCOMPARE(systemOf(*m_document).maps.back().weight, 0.75 / 2); // all sum to 1 again
        QVERIFY(!typed->isVisibleTo(dialog));

        support::choose(columns, QString());
        QVERIFY(typed->isVisibleTo(dialog));
        QCOMPARE(typed->text(), QStringLiteral("a b c d e f cumulative"));
        const auto* accept = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        const auto said = [dialog](const QString& sentence) {
            for (const auto* label : dialog->findChildren<QLabel*>())
                if (label->text() == sentence) return true;
            return false;
        };
        typed->selectAll();
        QTest::keyClicks(typed, QStringLiteral("d c b a f"));
        QVERIFY(said(QStringLiteral("Missing: e.")));
        QVERIFY(!accept->isEnabled());
        QCOMPARE(m_panel->model()->rowCount(), 4); // nothing to see yet
        QTest::keyClicks(typed, QStringLiteral(" e p"));
        QVERIFY(accept->isEnabled());
        QCOMPARE(m_panel->model()->rowCount(), 6);
        QCOMPARE(coefficient(4, 0, 0), 0.4);
        QCOMPARE(systemOf(*m_document).maps[4].map.translation.x(), 5.0);
        dialog->accept();
        QCOMPARE(m_document->undoStack()->count(), 1);
    }

    // A header that names no order is no dead end.
    void anUnknownHeaderIsAskedAbout() {
        QGuiApplication::clipboard()->setText(
            QStringLiteral("q1 q2 q3 q4 q5 q6\n.5 0 0 .5 1 2\n.5 0 0 .5 0 0\n"));
        m_panel->appendPasted();
        auto* dialog = m_panel->findChild<view::PasteTableDialog*>();
        QVERIFY(dialog);
        dialog->accept();
        QCOMPARE(m_panel->model()->rowCount(), 6);
    }

    void copiedRowsComeBackTheSame() {
        m_panel->selectMaps({m_panel->model()->idAt(0), m_panel->model()->idAt(2)});
        m_panel->copyMaps();
        m_panel->appendPasted();
        QCOMPARE(m_panel->model()->rowCount(), 6);
        for (const auto& [copy, original] : {std::pair{4U, 0U}, std::pair{5U, 2U}}) {
            QVERIFY(systemOf(*m_document).maps[copy].map == systemOf(*m_document).maps[original].map);
            QCOMPARE(systemOf(*m_document).maps[copy].weight, systemOf(*m_document).maps[original].weight);
        }
    }

    void bakeKeepsThePicture() {
        document::Fractal fractal = m_document->fractal();
        document::plane(fractal)->cage->current = {{0, 0}, {4, 1}, {-1, 5}};
        m_document->edit(QStringLiteral("place"), fractal);
        const auto shown = *document::effectiveSystem(m_document->fractal());
        m_panel->bake();
        QVERIFY(document::plane(m_document->fractal())->cage->rest ==
                document::plane(m_document->fractal())->cage->current);
        for (std::size_t i = 0; i < shown.maps.size(); ++i)
            QVERIFY(distance(systemOf(*m_document).maps[i].map, shown.maps[i].map) < 1e-12);

        document::plane(fractal)->cage->current = {{0, 0}, {1, 1}, {2, 2}};
        m_document->edit(QStringLiteral("flat"), fractal);
        QSignalSpy messages(m_panel.get(), &MapsPanel::message);
        m_panel->bake();
        QVERIFY(m_document->fractal() == fractal);
        QCOMPARE(messages.size(), 1);
    }

    // However many there are, and in every font.
    void theNumbersOfTheMapsHaveRoom() {
        QHeaderView* numbers = m_panel->table()->verticalHeader();
        const auto widthFor = [&](const QString& number) {
            return numbers->fontMetrics().horizontalAdvance(number) + 26;
        };
        QCOMPARE(numbers->sizeHint().width(), widthFor(QStringLiteral("4")));
        m_document->setFile(document::fileOf(fractalOf(std::vector<Row>(12, {0.1, 0, 0, 0.1, 0, 0, 1}))));
        QCOMPARE(numbers->sizeHint().width(), widthFor(QStringLiteral("12")));
        QFont large = numbers->font();
        large.setPointSizeF(2 * large.pointSizeF());
        const int height = numbers->sectionSizeHint(0);
        numbers->setFont(large);
        QVERIFY(numbers->sectionSizeHint(0) > height);
    }

    // Of several, the current one, which is named; of none, nothing.
    void theDetailsAreOfTheCurrentMapOfTheSelection() {
        const auto* shape = m_panel->findChild<view::MapShapeEditor*>();
        const NumberField* shift = shape->field(view::MapShapeEditor::TranslationX);
        const auto facts = [this] {
            for (const auto* label : m_panel->findChildren<QLabel*>())
                if (label->accessibleName() == QStringLiteral("Properties of the map")) return label->text();
            return QString();
        };
        m_panel->selectAllMaps();
        m_panel->table()->selectionModel()->setCurrentIndex(m_panel->model()->index(2, MapsModel::A),
                                                            QItemSelectionModel::NoUpdate);
        QCOMPARE(shift->value(), systemOf(*m_document).maps[2].map.translation.x());
        QVERIFY2(facts().startsWith(QStringLiteral("Map 3 only, of 4 selected    det ")),
                 qPrintable(facts()));
        m_panel->table()->clearSelection();
        QVERIFY(!shape->isEnabled() && shift->text().isEmpty());
        QCOMPARE(facts(), QStringLiteral("Select a map to see and edit it here."));
        m_panel->selectMaps({m_panel->model()->idAt(1)});
        QVERIFY(shape->isEnabled() && !shift->text().isEmpty());
        QVERIFY2(facts().startsWith(QStringLiteral("det ")), qPrintable(facts()));
    }

    void theShapeEditorIsTheSameMapInOtherWords() {
        auto* shape = m_panel->findChild<view::MapShapeEditor*>();
        m_panel->table()->setCurrentIndex(m_panel->model()->index(2, MapsModel::A));
        // Map 3 of the maple as published: -24.775140569 degrees, 0.715891053164, 0.557347376024,
        // 0.086829268293.
        using Part = view::MapShapeEditor::Part;
        QVERIFY(qAbs(shape->field(Part::Rotation)->value() + 24.775140569) < 1e-8);
        QVERIFY(qAbs(shape->field(Part::ScaleX)->value() - 0.715891053164) < 1e-11);
        QVERIFY(qAbs(shape->field(Part::ScaleY)->value() - 0.557347376024) < 1e-11);
        QVERIFY(qAbs(shape->field(Part::Shear)->value() - 0.086829268293) < 1e-11);

        NumberField* rotation = shape->field(Part::Rotation);
        type(rotation, QStringLiteral("30"));
        QCOMPARE(m_document->undoStack()->count(), 0); // live
        QVERIFY(qAbs(coefficient(2, 1, 0) - 0.715891053164 / 2) < 1e-11);
        QTest::keyClick(rotation, Qt::Key_Return);
        QCOMPARE(m_document->undoStack()->count(), 1);
        QCOMPARE(rotation->value(), 30.0); // as typed, not 29.999999999999996

        type(shape->field(Part::TranslationX), QStringLiteral("2"));
        const auto before = systemOf(*m_document).maps[2].map.linear;
        QTest::keyClick(shape->field(Part::TranslationX), Qt::Key_Return);
        QVERIFY(systemOf(*m_document).maps[2].map.linear == before);
        QCOMPARE(systemOf(*m_document).maps[2].map.translation.x(), 2.0);
        m_document->undoStack()->undo();
        m_document->undoStack()->undo();
        QVERIFY(qAbs(rotation->value() + 24.775140569) < 1e-8);
    }

    void saysWhatAnEntryWithoutMapsIs() {
        document::FractalFile file = document::fileOf(document::Fractal{});
        file.entries[0].problems = {{document::Problem::Severity::Error, QStringLiteral("x"), 7, 3,
                                     QStringLiteral("A number is missing.")}};
        m_document->setFile(file);
        QVERIFY(shownText().contains(QStringLiteral("Line 7, column 3: A number is missing.")));
        m_document->setFile(document::fileOf(fractalOf({})));
        QVERIFY(shownText().contains(QStringLiteral("No maps")));
        m_panel->addMap();
        QCOMPARE(m_panel->model()->rowCount(), 1);
        QVERIFY(m_panel->table()->isVisible());
    }

private:
    NumberField* openEditor(int row, int column) {
        const QModelIndex cell = m_panel->model()->index(row, column);
        m_panel->table()->setFocus();
        m_panel->table()->setCurrentIndex(cell);
        m_panel->table()->edit(cell);
        NumberField* editor = currentEditor();
        editor->setFocus();
        editor->selectAll();
        return editor;
    }
    NumberField* currentEditor() const {
        for (auto* field : m_panel->table()->viewport()->findChildren<NumberField*>())
            if (field->isVisible()) return field;
        return nullptr;
    }
    static void type(NumberField* field, const QString& text) {
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
    }
    double coefficient(std::size_t map, int row, int column) const {
        return systemOf(*m_document).maps[map].map.linear(row, column);
    }
    QString shownText() const {
        QString text;
        for (auto* label : m_panel->findChildren<QLabel*>())
            if (label->isVisible()) text += label->text();
        return text;
    }

    std::unique_ptr<document::Document> m_document;
    std::unique_ptr<MapsPanel> m_panel;
};

BARYCAGE_TEST(MapsPanelTest, QApplication);
#include "maps_panel_test.moc"
