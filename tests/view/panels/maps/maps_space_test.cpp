// SPDX-License-Identifier: MIT
#include "document/edits/cage/cage_edits.h"
#include "document/fractal/space_geometry.h"
#include "panels/maps/map_shape_editor.h"
#include "panels/maps/maps_panel.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/panels/maps_support.h"
#include "widgets/numbers/number_field.h"

#include <QAbstractItemModelTester>
#include <QAction>
#include <QColor>
#include <QLabel>
#include <QTableView>
#include <QToolButton>

#include <cmath>

using namespace maps_support;
using view::MapsModel;
using view::MapsPanel;
using view::NumberField;

// The Maps panel with a system in space.
class MapsSpaceTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_document = std::make_unique<document::Document>();
        m_document->setFile(document::fileOf(withTetrahedron(fernInSpace())));
        m_panel = std::make_unique<MapsPanel>(m_document.get());
        m_panel->resize(380, 700);
        m_panel->show();
        m_panel->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
    }
    void cleanup() { m_panel.reset(); } // before its document

    void showsTheRowsOfAFile() {
        const MapsModel& model = *m_panel->model();
        QVERIFY(m_panel->table()->isVisible());
        QCOMPARE(model.rowCount(), 4);
        const QStringList names =
            QStringLiteral("On,,,Name,a,b,c,d,e,f,g,h,i,j,k,l,p,det,‖A‖,Kind").split(u',');
        for (int column = 0; column < names.size(); ++column)
            QCOMPARE(model.headerData(column, Qt::Horizontal).toString(), names[column]);
        QCOMPARE(model.columnCount(), int(names.size()) + 12);
        QCOMPARE(model.headerData(model.columnCount() - 1, Qt::Horizontal).toString(), QStringLiteral("l′"));
        const auto& maps = solidOf(*m_document).maps;
        for (int row = 0; row < 4; ++row) {
            const auto& map = maps[std::size_t(row)].map;
            for (int k = 0; k < 9; ++k)
                QCOMPARE(value(row, MapsModel::A + k), map.linear(k / 3, k % 3));
            for (int k = 0; k < 3; ++k)
                QCOMPARE(value(row, MapsModel::A + 9 + k), map.translation[k]);
            QCOMPARE(value(row, model.columnOf(MapsModel::Weight)), 0.25);
            QCOMPARE(value(row, model.columnOf(MapsModel::Determinant)), ifs::determinant<3>(map.linear));
            QCOMPARE(value(row, model.columnOf(MapsModel::Contraction)), ifs::spectralNorm<3>(map.linear));
        }
        QCOMPARE(model.index(0, model.columnOf(MapsModel::Kind)).data().toString(),
                 QStringLiteral("singular"));
        QVERIFY(model.index(0, model.columnOf(MapsModel::Kind))
                    .data(Qt::ToolTipRole)
                    .toString()
                    .contains(QStringLiteral("space")));
    }

    void theModelKeepsItsRules() {
        const QAbstractItemModelTester tester(m_panel->model(),
                                              QAbstractItemModelTester::FailureReportingMode::Fatal);
        const MapsModel& model = *m_panel->model();
        for (int column = 0; column < model.columnCount(); ++column) {
            const auto flags = model.index(1, column).flags();
            const bool typed = column >= MapsModel::Name && column <= model.columnOf(MapsModel::Weight);
            QCOMPARE(flags.testFlag(Qt::ItemIsEditable), typed);
            QCOMPARE(flags.testFlag(Qt::ItemIsUserCheckable),
                     column == MapsModel::Enabled || column == MapsModel::Lock);
        }
        m_document->setFile(document::fileOf(maple())); // fewer columns
        QCOMPARE(model.columnCount(), int(MapsModel::ColumnCount));
        m_document->setFile(document::fileOf(fernInSpace()));
        QCOMPARE(model.columnCount(), 32);
    }

    void typingInACellIsLiveAndOneStep() {
        const document::Fractal before = m_document->fractal();
        for (int k = 0; k < 12; ++k) {
            NumberField* editor = openEditor(1, MapsModel::A + k);
            QTest::keyClicks(editor, QStringLiteral("0.1"));
            QCOMPARE(value(1, MapsModel::A + k), 0.1);
            QTest::keyClicks(editor, QStringLiteral("25"));
            QCOMPARE(value(1, MapsModel::A + k), 0.125);
            const auto& map = solidOf(*m_document).maps[1].map;
            QCOMPARE(k < 9 ? map.linear(k / 3, k % 3) : map.translation[k - 9], 0.125);
            QCOMPARE(m_document->undoStack()->count(), 0);
            QTest::keyClick(editor, Qt::Key_Return);
            QTRY_COMPARE(m_document->undoStack()->count(), 1);
            QVERIFY(m_document->undoStack()->text(0).contains(u"abcdefghijkl"[k]));
            m_document->undoStack()->undo();
            QVERIFY(m_document->fractal() == before);
            m_document->undoStack()->clear();
        }
    }

    void anExpressionStaysAsItWasTyped() {
        const QModelIndex cell = m_panel->model()->index(1, MapsModel::A + 10);
        NumberField* editor = openEditor(1, MapsModel::A + 10);
        QTest::keyClicks(editor, QStringLiteral("sqrt(3)/6"));
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(m_document->undoStack()->count(), 1);
        QCOMPARE(solidOf(*m_document).maps[1].map.translation.y(), std::sqrt(3.0) / 6);
        QCOMPARE(m_panel->model()->typedText(cell), QStringLiteral("sqrt(3)/6"));
        QVERIFY(cell.data(Qt::ToolTipRole).toString().startsWith(QStringLiteral("sqrt(3)/6 = 0.288675")));
        QCOMPARE(openEditor(1, MapsModel::A + 10)->text(), QStringLiteral("sqrt(3)/6"));
    }

    // Below the table, as in the plane.
    void thePropertiesOfTheMapAreShown() {
        document::Fractal half = m_document->fractal();
        document::system3(half)->maps[0].map = {ifs::Matrix<3>::Identity() / 2, {0, 1, 0}};
        m_document->edit(QStringLiteral("half"), half);
        QString text;
        for (const auto* label : m_panel->findChildren<QLabel*>())
            if (label->accessibleName() == QStringLiteral("Properties of the map")) text = label->text();
        QVERIFY2(text.startsWith(QStringLiteral("det 0.125")), qPrintable(text));
        QVERIFY2(text.contains(QStringLiteral("‖A‖ 0.5")), qPrintable(text));
        QVERIFY2(text.endsWith(QStringLiteral("similarity")), qPrintable(text));
    }

    void escapeCancelsAndTabGoesOn() {
        const document::Fractal before = m_document->fractal();
        QTest::keyClicks(openEditor(2, MapsModel::A + 11), QStringLiteral("7"));
        QCOMPARE(solidOf(*m_document).maps[2].map.translation.z(), 7.0);
        QTest::keyClick(currentEditor(), Qt::Key_Escape);
        QVERIFY(m_document->fractal() == before);
        QCOMPARE(m_document->undoStack()->count(), 0);

        QTest::keyClicks(openEditor(2, MapsModel::A + 11), QStringLiteral("7"));
        QTest::keyClick(currentEditor(), Qt::Key_Tab);
        QCOMPARE(m_document->undoStack()->count(), 1);
        QCOMPARE(m_panel->table()->currentIndex().column(), m_panel->model()->columnOf(MapsModel::Weight));
    }

    void weightSwitchAndColour() {
        MapsModel& model = *m_panel->model();
        QVERIFY(model.setData(model.index(1, model.columnOf(MapsModel::Weight)), 0.5));
        QCOMPARE(solidOf(*m_document).maps[1].weight, std::optional(0.5));
        QVERIFY(model.setData(model.index(0, MapsModel::Enabled), Qt::Unchecked, Qt::CheckStateRole));
        QVERIFY(!solidOf(*m_document).maps[0].enabled);
        QVERIFY(model.setData(model.index(3, MapsModel::Colour), QColor(10, 20, 30), Qt::DecorationRole));
        QCOMPARE(model.index(3, MapsModel::Colour).data(Qt::DecorationRole).value<QColor>(),
                 QColor(10, 20, 30));
        QCOMPARE(m_document->undoStack()->count(), 3);
        model.setData(model.index(1, MapsModel::A), 3.0);
        QVERIFY(!model.headerData(1, Qt::Vertical, MapsModel::WarningRole).toString().isEmpty());
    }

    void mapsAreAddedDuplicatedDeletedAndMoved() {
        const document::Fractal before = m_document->fractal();
        m_panel->addMap();
        QCOMPARE(solidOf(*m_document).maps.size(), std::size_t(5));
        QCOMPARE(m_panel->selectedMaps(), std::vector{solidOf(*m_document).maps[4].id});
        m_panel->duplicateMaps();
        QCOMPARE(solidOf(*m_document).maps.size(), std::size_t(6));
        m_panel->moveMapsUp();
        m_panel->moveMapsUp();
        QCOMPARE(m_panel->selectedMaps(), std::vector{solidOf(*m_document).maps[3].id});
        m_panel->moveMapsDown();
        QCOMPARE(m_panel->selectedMaps(), std::vector{solidOf(*m_document).maps[4].id});
        m_panel->deleteMaps();
        QCOMPARE(solidOf(*m_document).maps.size(), std::size_t(5));
        m_panel->applyWeights(document::WeightRule::Equal);
        QCOMPARE(solidOf(*m_document).maps[0].weight, std::optional(0.2));
        while (m_document->undoStack()->canUndo())
            m_document->undoStack()->undo();
        QVERIFY(m_document->fractal() == before);
    }

    // Numbers that take all their room do not run together.
    void numbersAreApart() {
        document::Fractal thirds = m_document->fractal();
        for (auto& map : document::system3(thirds)->maps) {
            map.map.linear.fill(-1.0 / 3);
            map.map.translation.fill(0);
        }
        m_document->edit(QStringLiteral("thirds"), thirds);
        const QTableView* table = m_panel->table();
        const QImage seen = m_panel->table()->viewport()->grab().toImage();
        const auto isEmpty = [&](int x, const QRect& cell) {
            for (int y = cell.top() + 2; y < cell.bottom() - 1; ++y)
                if (seen.pixel(x, y) != seen.pixel(x, cell.top() + 2)) return false;
            return true;
        };
        int looked = 0;
        for (int column = MapsModel::A; column < MapsModel::A + 12; ++column) {
            const QRect cell = table->visualRect(m_panel->model()->index(1, column));
            if (cell.right() >= seen.width()) break;
            for (const int x : {cell.left() + 1, cell.right() - 1, cell.right()})
                QVERIFY2(isEmpty(x, cell), qPrintable(QString::number(column)));
            ++looked;
        }
        QVERIFY(looked >= 8);
    }

    // The rows of the matrix and the shift are told apart by lines.
    void theRowsOfTheMatrixAreApart() {
        const QTableView* table = m_panel->table();
        const QImage seen = m_panel->table()->viewport()->grab().toImage();
        for (int k = 0; k < 9; ++k) {
            const QRect cell = table->visualRect(m_panel->model()->index(1, MapsModel::A + k));
            const bool isLine =
                seen.pixel(cell.topLeft() + QPoint(0, 2)) != seen.pixel(cell.topLeft() + QPoint(1, 2));
            QCOMPARE(isLine, k == 3 || k == 6);
        }
    }

    void theEffectiveCodeFollowsTheCage() {
        document::Fractal placed = m_document->fractal();
        document::space(placed)->cage->current = {{1, 0, 0}, {9, 0, 1}, {0, 7, 0}, {2, 0, 8}};
        const auto cage = *document::space(placed)->cage;
        const auto expected = *ifs::conjugate(ifs::displayMap(cage), solidOf(*m_document));
        m_document->edit(QStringLiteral("place"), placed);
        const int first = m_panel->model()->columnOf(MapsModel::EffectiveA);
        for (int row = 0; row < 4; ++row)
            for (int k = 0; k < 12; ++k) {
                const auto& map = expected.maps[std::size_t(row)].map;
                const double wanted = k < 9 ? map.linear(k / 3, k % 3) : map.translation[k - 9];
                QVERIFY(qAbs(value(row, first + k) - wanted) < 1e-12);
            }
        document::space(placed)->cage->current = {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {3, 3, 0}};
        m_document->edit(QStringLiteral("flat"), placed);
        QCOMPARE(m_panel->model()->index(0, first).data().toString(), QStringLiteral("–"));
    }

    void groupsOfColumnsAreShownAndHidden() {
        const MapsModel& model = *m_panel->model();
        const QTableView* table = m_panel->table();
        const auto shown = [&] {
            QString names;
            for (int column = MapsModel::A; column < model.columnCount(); ++column)
                if (!table->isColumnHidden(column))
                    names += model.headerData(column, Qt::Horizontal).toString();
            return names;
        };
        QCOMPARE(shown(), QStringLiteral("abcdefghijklp"));
        m_panel->showColumns(MapsPanel::Columns::Facts, true);
        QCOMPARE(shown(), QStringLiteral("abcdefghijklpdet‖A‖Kind"));
        m_panel->showColumns(MapsPanel::Columns::Facts, false);
        m_panel->showColumns(MapsPanel::Columns::Code, false);
        QCOMPARE(shown(), QStringLiteral("p"));
        m_panel->reveal(model.columnOf(MapsModel::EffectiveA));
        m_document->setFile(document::fileOf(maple()));
        QVERIFY(shown().endsWith(QStringLiteral("a′b′c′d′e′f′")));
        m_document->setFile(document::fileOf(fernInSpace()));
        QVERIFY(shown().endsWith(QStringLiteral("a′b′c′d′e′f′g′h′i′j′k′l′")));
    }

    void aTurnAboutAnAxisIsTyped() {
        using Editor = view::MapShapeEditor;
        auto* shape = m_panel->findChild<Editor*>();
        m_panel->selectMaps({solidOf(*m_document).maps[1].id});
        document::Fractal half = m_document->fractal();
        document::system3(half)->maps[1].map = {ifs::Matrix<3>::Identity() / 2, {0, 1, 0}};
        m_document->edit(QStringLiteral("half"), half);
        m_document->undoStack()->clear();
        QVERIFY(shape->field(Editor::AxisX)->isVisible());
        QVERIFY(!shape->field(Editor::ScaleX)->isVisible());
        QCOMPARE(shape->field(Editor::SpaceScaleZ)->value(), 0.5);
        type(shape->field(Editor::AxisX), QStringLiteral("0"));
        QTest::keyClick(shape->field(Editor::AxisX), Qt::Key_Return);
        type(shape->field(Editor::AxisZ), QStringLiteral("2"));
        QTest::keyClick(shape->field(Editor::AxisZ), Qt::Key_Return);
        QVERIFY(m_document->fractal() == half); // no angle yet
        type(shape->field(Editor::Angle), QStringLiteral("90"));
        QTest::keyClick(shape->field(Editor::Angle), Qt::Key_Return);
        ifs::Matrix<3> quarter;
        quarter << 0, -0.5, 0, 0.5, 0, 0, 0, 0, 0.5;
        QVERIFY((solidOf(*m_document).maps[1].map.linear - quarter).norm() < 1e-15);
        QCOMPARE(shape->field(Editor::Angle)->value(), 90.0); // as typed
        QCOMPARE(shape->field(Editor::AxisZ)->value(), 2.0);
        type(shape->field(Editor::SpaceScaleX), QStringLiteral("0.25"));
        type(shape->field(Editor::ShearXZ), QStringLiteral("1"));
        const auto& linear = solidOf(*m_document).maps[1].map.linear;
        QVERIFY((linear.col(0) - ifs::Vector<3>(0, 0.25, 0)).norm() < 1e-15);
        QVERIFY((linear.col(2) - ifs::Vector<3>(0, 0.25, 0.5)).norm() < 1e-15);
        const ifs::Matrix<3> sheared = linear;
        type(shape->field(Editor::SpaceTranslationZ), QStringLiteral("3"));
        QVERIFY(solidOf(*m_document).maps[1].map.linear == sheared);
        QCOMPARE(solidOf(*m_document).maps[1].map.translation.z(), 3.0);
        QTest::keyClick(shape->field(Editor::SpaceTranslationZ), Qt::Key_Escape);
        QCOMPARE(solidOf(*m_document).maps[1].map.translation.z(), 0.0);
        while (m_document->undoStack()->canUndo())
            m_document->undoStack()->undo();
        QVERIFY(m_document->fractal() == half);
        QCOMPARE(shape->field(Editor::Angle)->value(), 0.0);
    }

    void escapeBringsAnUnusedAxisBack() {
        using Editor = view::MapShapeEditor;
        auto* shape = m_panel->findChild<Editor*>();
        document::Fractal half = m_document->fractal();
        document::system3(half)->maps[0].map = {ifs::Matrix<3>::Identity() / 2, {0, 1, 0}};
        m_document->edit(QStringLiteral("half"), half);
        const double before = shape->field(Editor::AxisY)->value();
        type(shape->field(Editor::AxisY), QStringLiteral("5")); // changes no coefficient
        QTest::keyClick(shape->field(Editor::AxisY), Qt::Key_Escape);
        QCOMPARE(shape->field(Editor::AxisY)->value(), before);
        type(shape->field(Editor::Angle), QStringLiteral("90"));
        const auto& linear = solidOf(*m_document).maps[0].map.linear;
        QVERIFY((linear.col(0) - ifs::Vector<3>(0.5, 0, 0)).norm() < 1e-15); // still about x
    }

    void aPanelThatIsClosedWhileTypingEndsTheEdit() {
        auto* shape = m_panel->findChild<view::MapShapeEditor*>();
        type(shape->field(view::MapShapeEditor::SpaceTranslationX), QStringLiteral("3"));
        m_panel.reset();
        QCOMPARE(solidOf(*m_document).maps[0].map.translation.x(), 3.0);
        QCOMPARE(m_document->undoStack()->count(), 1);
    }

    void anEmptySystemTakesAMap() {
        document::Fractal empty;
        empty.shape = document::Shape<3>();
        m_document->setFile(document::fileOf(empty));
        QString text;
        for (auto* label : m_panel->findChildren<QLabel*>())
            if (label->isVisible()) text += label->text();
        QVERIFY2(text.contains(QStringLiteral("No maps: add one.")), qPrintable(text));
        m_panel->addMap();
        QCOMPARE(solidOf(*m_document).maps.size(), std::size_t(1));
        QVERIFY(m_panel->table()->isVisible());
    }

    // It holds rows of as many numbers as a map has.
    void theClipboardIsForSpaceToo() {
        m_panel->selectMaps({solidOf(*m_document).maps[0].id});
        for (const QAction* action : m_panel->table()->actions()) {
            QVERIFY(action->isVisible());
            if (action->objectName().startsWith(QStringLiteral("paste")))
                QVERIFY(action->statusTip().contains(QStringLiteral("13")));
            if (action->objectName() == QStringLiteral("bake")) {
                QVERIFY(!action->isEnabled()); // the cage is at rest
                QCOMPARE(action->toolTip(), document::bakeObstacle(m_document->fractal()));
            }
        }
        m_document->setFile(document::fileOf(maple()));
        for (const QAction* action : m_panel->table()->actions())
            if (action->objectName().startsWith(QStringLiteral("paste")))
                QVERIFY(action->statusTip().contains(QStringLiteral("7 numbers")));
    }

private:
    double value(int row, int column) const {
        return m_panel->model()->index(row, column).data(Qt::EditRole).toDouble();
    }
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

    std::unique_ptr<document::Document> m_document;
    std::unique_ptr<MapsPanel> m_panel;
};

BARYCAGE_TEST(MapsSpaceTest, QApplication);
#include "maps_space_test.moc"
