// SPDX-License-Identifier: MIT
#include "dialogs/export/export_size_editor.h"
#include "support/choose.h"
#include "support/named_test.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>

using namespace view;

class ExportSizeEditorTest : public QObject {
    Q_OBJECT

private slots:
    void sizeKeepsItsShape();
    void sizesAreChosenByName();
    void lengthsFollowTheResolution();
    void sheetsStandOrLie();

private:
    template <typename Widget> static Widget* named(QWidget& parent, const char* name) {
        for (auto* child : parent.findChildren<Widget*>())
            if (child->accessibleName() == QLatin1String(name)) return child;
        return nullptr;
    }
};

void ExportSizeEditorTest::sizeKeepsItsShape() {
    ExportSizeEditor editor({160, 120});
    QCOMPARE(editor.pixels(), QSize(160, 120));
    named<QDoubleSpinBox>(editor, "Width")->setValue(1600);
    QCOMPARE(editor.pixels(), QSize(1600, 1200));
    named<QDoubleSpinBox>(editor, "Height")->setValue(60);
    QCOMPARE(editor.pixels(), QSize(80, 60));
    named<QDoubleSpinBox>(editor, "Height")->setValue(99'999); // the other side would be beyond the limit
    QCOMPARE(editor.pixels(), QSize(100'000, 75'000));
    QCOMPARE(named<QDoubleSpinBox>(editor, "Height")->value(), 75'000.0);
    named<QDoubleSpinBox>(editor, "Width")->setValue(100'000);
    QCOMPARE(editor.pixels(), QSize(100'000, 75'000));
}

void ExportSizeEditorTest::sheetsStandOrLie() {
    ExportSizeEditor editor({160, 120});
    auto* turn = named<QToolButton>(editor, "Portrait or landscape");
    QVERIFY(turn);
    turn->click();
    QCOMPARE(editor.pixels(), QSize(120, 160));
    named<QDoubleSpinBox>(editor, "Width")->setValue(300); // in the proportions that it has now
    QCOMPARE(editor.pixels(), QSize(300, 400));
    auto* sizes = named<QComboBox>(editor, "Named size");
    support::choose(sizes, QSize(3508, 2480)); // A4
    turn->click();
    QCOMPARE(editor.pixels(), QSize(2480, 3508));
    QCOMPARE(view::chosenValue<QSize>(sizes), QSize(3508, 2480)); // a sheet that stands is still one
}

void ExportSizeEditorTest::sizesAreChosenByName() {
    ExportSizeEditor editor({160, 120});
    auto* sizes = named<QComboBox>(editor, "Named size");
    support::choose(sizes, QSize(3840, 2160));
    QCOMPARE(editor.pixels(), QSize(3840, 2160));
    named<QDoubleSpinBox>(editor, "Width")->setValue(1600); // the shape that was chosen is kept
    QCOMPARE(editor.pixels(), QSize(1600, 900));
    QCOMPARE(sizes->currentText(), QStringLiteral("Custom"));
    support::choose(sizes, QSize(3508, 2480));
    QCOMPARE(editor.pixels(), QSize(3508, 2480));
    QCOMPARE(named<QDoubleSpinBox>(editor, "Width")->value(), 297.0);
    QCOMPARE(named<QDoubleSpinBox>(editor, "Height")->value(), 210.0);
    QCOMPARE(editor.dotsPerInch(), 300.0);
    support::choose(sizes, QSize(320, 240));
    QCOMPARE(editor.pixels(), QSize(320, 240));
    QCOMPARE(view::chosenValue<QSize>(sizes), QSize(320, 240));
    const QWidget* turning = sizes->nextInFocusChain();
    QVERIFY(qobject_cast<const QToolButton*>(turning)); // portrait or landscape
    QCOMPARE(turning->nextInFocusChain(), named<QSpinBox>(editor, "Resolution in dots per inch"));
    ExportSizeEditor standing({120, 160});
    auto* sheets = named<QComboBox>(standing, "Named size");
    QCOMPARE(sheets->itemData(sheets->findText(QStringLiteral("A3 at 300 dpi"))).toSize(), QSize(3508, 4961));
    // The next time the screen may have another shape.
    support::choose(sizes, QSize(3508, 2480));
    standing.choose(editor.choice());
    QCOMPARE(standing.pixels(), QSize(3508, 2480));
    QCOMPARE(sheets->currentText(), QStringLiteral("A4 at 300 dpi"));
    standing.setPixels({1080, 1920});
    QCOMPARE(sheets->currentText(), QStringLiteral("Custom"));
}

void ExportSizeEditorTest::lengthsFollowTheResolution() {
    ExportSizeEditor editor({160, 120});
    support::choose(named<QComboBox>(editor, "Unit of length"), ExportSizeEditor::Unit::Inches);
    named<QSpinBox>(editor, "Resolution in dots per inch")->setValue(150);
    named<QDoubleSpinBox>(editor, "Width")->setValue(4);
    QCOMPARE(editor.pixels(), QSize(600, 450));
    support::choose(named<QComboBox>(editor, "Unit of length"), ExportSizeEditor::Unit::Millimetres);
    QCOMPARE(named<QDoubleSpinBox>(editor, "Width")->value(), 101.6);
    // Typed with either sign, whatever the language says.
    for (const char* typed : {"50.5", "50,5"}) {
        auto* width = named<QDoubleSpinBox>(editor, "Width");
        width->setFocus();
        width->selectAll();
        QTest::keyClicks(width, QLatin1String(typed));
        QTest::keyClick(width, Qt::Key_Return);
        QCOMPARE(width->value(), 50.5);
        width->setValue(20);
    }
}

BARYCAGE_TEST(ExportSizeEditorTest, QApplication);
#include "export_size_editor_test.moc"
