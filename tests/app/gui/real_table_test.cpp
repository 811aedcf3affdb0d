// SPDX-License-Identifier: MIT
#include "dialogs/paste_table_dialog.h"
#include "io/file/save_file.h"
#include "panels/maps/map_shape_editor.h"
#include "panels/maps/maps_panel.h"
#include "support/window_on_x.h"
#include "widgets/numbers/number_field.h"

#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QMenu>
#include <QTableView>
#include <QToolButton>

using view::MapsModel;

// The maps in their table, with a real pointer and real keys.
class RealTableTest : public support::WindowOnX {
    Q_OBJECT

private slots:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void aCoefficientIsTyped();
    void aDigitBeginsToTypeAndEscapeTakesItBack();
    void aLetterBeginsAnExpression();
    void aMapIsTurnedByNumbers();
    void ctrlZInAFieldUndoesTheDocumentOnce();
    void ctrlZInTheMiddleOfTypingTakesTheTypingBack();
    void aMapIsFramedWhileThePointerIsAtItsRow();
    void aMapIsSwitchedOff();
    void mapsAreReorderedByTheirNumbers();
    void weightsFollowARule();
    void rowsAreCopiedAndPasted();
    void theColumnsOfPastedRowsAreChosen();

private:
    view::MapsPanel& panel() const { return *window().findChild<view::MapsPanel*>(); }
    QTableView& table() const { return *panel().table(); }
    QModelIndex cell(int row, int column) const { return panel().model()->index(row, column); }
    QPoint placeOf(int row, int column) const {
        table().scrollTo(cell(row, column));
        return table().viewport()->mapToGlobal(table().visualRect(cell(row, column)).center());
    }
};

// What was not typed keeps every byte in the file.
void RealTableTest::aCoefficientIsTyped() {
    const QString path = copyOfCollection(QStringLiteral("paper"));
    window().openPath(path);
    const QByteArray before = io::loadFile(path).bytes;
    hand().doubleClickAt(placeOf(1, MapsModel::D));
    QTRY_VERIFY(table().findChild<view::NumberField*>());
    hand().type(QStringLiteral("0.45"));
    QTRY_COMPARE(code().maps[1].map.linear(1, 1), 0.45); // live, before it is taken
    QCOMPARE(steps(), 0);
    hand().key("Return");
    QTRY_COMPARE(steps(), 1);
    hand().key("Control+s");
    QTRY_VERIFY(!window().isWindowModified());
    QVERIFY(before.contains("\n  0.61 0 0 0.31 0.07 3.5 "));
    QCOMPARE(io::loadFile(path).bytes,
             QByteArray(before).replace("\n  0.61 0 0 0.31 0.07 3.5 ", "\n  0.61 0 0 0.45 0.07 3.5 "));
}

void RealTableTest::aDigitBeginsToTypeAndEscapeTakesItBack() {
    const document::Fractal before = fractal();
    hand().clickAt(placeOf(2, MapsModel::E));
    hand().type(QStringLiteral("1.5"));
    QTRY_COMPARE(code().maps[2].map.translation.x(), 1.5);
    hand().key("Escape");
    QTRY_VERIFY(fractal() == before);
    hand().type(QStringLiteral("2.5"));
    hand().key("Tab"); // accepts it and moves to the next number
    QTRY_COMPARE(steps(), 1);
    hand().type(QStringLiteral("-1"));
    hand().key("Return");
    QTRY_COMPARE(steps(), 2);
    QCOMPARE(code().maps[2].map.translation, ifs::Vector<2>(2.5, -1));
}

// S takes a snapshot elsewhere, and C chooses a tool.
void RealTableTest::aLetterBeginsAnExpression() {
    hand().clickAt(placeOf(1, MapsModel::D));
    hand().type(QStringLiteral("sqrt(0.25)"));
    hand().key("Return");
    QTRY_COMPARE(code().maps[1].map.linear(1, 1), 0.5);
    hand().clickAt(placeOf(1, MapsModel::A));
    hand().type(QStringLiteral("cos(0)/2"));
    hand().key("Return");
    QTRY_COMPARE(steps(), 2); // its value is there before it is accepted
    QCOMPARE(code().maps[1].map.linear(0, 0), 0.5);
    QVERIFY(!window().findChild<QDockWidget*>(QStringLiteral("snapshots"))->isVisible());
}

void RealTableTest::aMapIsTurnedByNumbers() {
    hand().clickAt(placeOf(1, MapsModel::A));
    auto* shape = window().findChild<view::MapShapeEditor*>();
    type(shape->field(view::MapShapeEditor::Rotation), QStringLiteral("90"));
    QTRY_COMPARE(steps(), 1);
    ifs::Matrix<2> turned;
    turned << 0, -0.31, 0.61, 0;
    QVERIFY((code().maps[1].map.linear - turned).norm() < 1e-12);
    QCOMPARE(code().maps[1].map.translation, ifs::Vector<2>(0.07, 3.5));
}

// The field of gamma likewise: every number field is the same.
void RealTableTest::ctrlZInAFieldUndoesTheDocumentOnce() {
    hand().clickAt(placeOf(1, MapsModel::A));
    const document::Fractal before = fractal();
    auto* shape = window().findChild<view::MapShapeEditor*>();
    auto* rotation = shape->field(view::MapShapeEditor::Rotation);
    click(rotation);
    hand().key("Control+a");
    hand().type(QStringLiteral("45"));
    hand().key("Return");
    QTRY_COMPARE(steps(), 1);
    const document::Fractal turned = fractal();
    hand().key("Control+z");
    QTRY_VERIFY(fractal() == before);
    QCOMPARE(code().maps[1].map.linear(0, 1), 0.0); // exactly
    QVERIFY(rotation->hasFocus());
    QCOMPARE(steps(), 1); // and it can be done again
    QCOMPARE(document().undoStack()->index(), 0);
    hand().key("Control+Shift+z");
    QTRY_VERIFY(fractal() == turned);
    hand().key("Up");
    hand().key("Up");
    QTRY_COMPARE(rotation->value(), 47.0);
    hand().key("Control+z"); // the steps of the arrow keys are one, and can be done again, too
    QTRY_VERIFY(fractal() == turned);
    QCOMPARE(document().undoStack()->index(), 1);
    hand().key("Control+z");
    QTRY_VERIFY(fractal() == before);

    showPanel(QStringLiteral("Appearance"));
    const double gamma = fractal().appearance.gamma;
    auto* field = named<view::NumberField>(window(), QStringLiteral("Gamma"));
    click(field);
    hand().key("Control+a");
    hand().type(QStringLiteral("2.5"));
    hand().key("Return");
    QTRY_COMPARE(fractal().appearance.gamma, 2.5);
    hand().key("Control+z");
    QTRY_COMPARE(fractal().appearance.gamma, gamma);
    QVERIFY(fractal() == before);
    QCOMPARE(steps(), 1);
    QCOMPARE(document().undoStack()->index(), 0);
}

void RealTableTest::ctrlZInTheMiddleOfTypingTakesTheTypingBack() {
    hand().clickAt(placeOf(1, MapsModel::A));
    const document::Fractal before = fractal();
    auto* shape = window().findChild<view::MapShapeEditor*>();
    click(shape->field(view::MapShapeEditor::Shear));
    hand().key("Control+a");
    hand().type(QStringLiteral("0.5"));
    QTRY_VERIFY(code().maps[1].map.linear(0, 1) != 0);
    for (int i = 0; i < 3; ++i)
        hand().key("Control+z");
    QTRY_VERIFY(fractal() == before);
    QCOMPARE(steps(), 0);
}

// The picture and its triangle are alone until then, whatever is selected.
void RealTableTest::aMapIsFramedWhileThePointerIsAtItsRow() {
    hand().clickAt(placeOf(1, MapsModel::A));
    QTRY_COMPARE(canvas().selectedMaps().size(), std::size_t{1});
    QTRY_COMPARE(canvas().canvas().frames().size(), std::size_t{1});
    QCOMPARE(canvas().canvas().frames()[0].index, 1);
    hand().moveTo(placeOf(2, MapsModel::B));
    QTRY_COMPARE(canvas().canvas().frames()[0].index, 2);
    hand().moveTo(onCanvas({20, 20}));
    QTRY_VERIFY(canvas().canvas().frames().empty());
    QCOMPARE(canvas().selectedMaps().size(), std::size_t{1});
}

void RealTableTest::aMapIsSwitchedOff() {
    hand().clickAt(placeOf(3, MapsModel::Enabled));
    QTRY_VERIFY(!code().maps[3].enabled);
    QCOMPARE(steps(), 1);
    hand().clickAt(placeOf(1, MapsModel::A)); // so that these are two clicks, not a double one
    hand().clickAt(placeOf(3, MapsModel::Enabled));
    QTRY_VERIFY(code().maps[3].enabled);
}

void RealTableTest::mapsAreReorderedByTheirNumbers() {
    const document::System2 before = code();
    const QHeaderView* numbers = table().verticalHeader();
    const auto number = [&](int row, double share) {
        return numbers->viewport()->mapToGlobal(
            QPoint(numbers->width() / 2,
                   numbers->sectionViewportPosition(row) + int(share * numbers->sectionSize(row))));
    };
    hand().drag(number(2, 0.5), {number(1, 0.5), number(0, 0.5), number(0, 0.2)});
    QTRY_COMPARE(steps(), 1);
    QVERIFY(code().maps[0] == before.maps[2]);
    QVERIFY(code().maps[1] == before.maps[0]);
    QVERIFY(code().maps[2] == before.maps[1]);
}

void RealTableTest::weightsFollowARule() {
    auto* button = named<QToolButton>(panel(), QStringLiteral("Weights"));
    const auto choose = [&](const QString& rule) {
        QTimer::singleShot(200, button, [&] { // the press does not end before the menu is closed
            watchdog().ignoreThisEvent();
            hand().release();
            chooseFrom(button->menu(), rule);
        });
        click(button);
    };
    choose(QStringLiteral("Equal"));
    QTRY_COMPARE(steps(), 1);
    for (const auto& map : code().maps)
        QCOMPARE(map.weight, code().maps[0].weight);
    choose(QStringLiteral("By |Determinant|"));
    QTRY_COMPARE(steps(), 2);
    QVERIFY(std::abs(*code().maps[2].weight / *code().maps[1].weight - (0.65 * 0.48 + 0.29 * 0.3) / 0.1891) <
            1e-6);
}

void RealTableTest::rowsAreCopiedAndPasted() {
    const document::System2 before = code();
    hand().clickAt(placeOf(1, MapsModel::A));
    hand().key("Control+c");
    QTRY_VERIFY(
        QGuiApplication::clipboard()->text().startsWith(QStringLiteral("0.61\t0\t0\t0.31\t0.07\t3.5\t")));
    hand().key("Control+v"); // as a new map
    QTRY_COMPARE(code().maps.size(), std::size_t{5});
    QVERIFY(code().maps[4].map == before.maps[1].map);

    QGuiApplication::clipboard()->setText(QStringLiteral("a,b,c,d,e,f\n1/2,0,0,1/2,0,1\n"));
    hand().clickAt(placeOf(0, MapsModel::A));
    hand().key("Control+Shift+v"); // in place of the selected row
    QTRY_COMPARE(steps(), 2);
    QCOMPARE(code().maps.size(), std::size_t{5});
    QCOMPARE(code().maps[0].map.linear, ifs::Matrix<2>(ifs::Matrix<2>::Identity() / 2));
    QCOMPARE(code().maps[0].map.translation, ifs::Vector<2>(0, 1));
}

void RealTableTest::theColumnsOfPastedRowsAreChosen() {
    QGuiApplication::clipboard()->setText(QStringLiteral("0.5 0.1 3 0.2 0.4 5 0.25\n0.3 0 2 0 0.3 1 0.75\n"));
    hand().clickAt(placeOf(0, MapsModel::A));
    hand().key("Control+Shift+v");
    QTRY_VERIFY(visible<view::PasteTableDialog>());
    QVERIFY(QTest::qWaitForWindowActive(visible<view::PasteTableDialog>()));
    QVERIFY(support::waitFor([] { return support::isInPlace(visible<view::PasteTableDialog>()); }));
    QTRY_COMPARE(code().maps[0].map.translation, ifs::Vector<2>(3, 5)); // seen at once: a b e c d f p
    QCOMPARE(steps(), 0);
    pick(visible<view::PasteTableDialog>()->findChild<QComboBox*>(), QStringLiteral("a b c d e f p"));
    QTRY_COMPARE(code().maps[0].map.linear(1, 0), 3.0); // a b c d e f p
    pick(visible<view::PasteTableDialog>()->findChild<QComboBox*>(), QStringLiteral("a c b d e f p"));
    const document::System2 shown = code();
    hand().key("Return");
    QTRY_VERIFY(!visible<view::PasteTableDialog>());
    QCOMPARE(steps(), 1);
    QVERIFY(code() == shown);
    QCOMPARE(code().maps.size(), std::size_t{5});
}

BARYCAGE_TEST_ON_X(RealTableTest);

#include "real_table_test.moc"
