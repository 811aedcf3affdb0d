// SPDX-License-Identifier: MIT
#include "widgets/number_box.h"

#include <QLocale>
#include <QSignalSpy>
#include <QTest>

using view::NumberBox;
using view::WholeNumberBox;

class NumberBoxTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::German)); } // must not matter

    void expressionsAreTyped();
    void whatIsUnfinishedChangesNothing();
    void valuesAreRoundedToTheDecimals();
    void unitsStay();
    void aCommaIsADecimalPoint();
    void wholeNumbersAreComputed();
    void otherNumbersAreNotWhole();
    void tooLargeNumbersAreRefused();

private:
    static void type(QAbstractSpinBox& box, const QString& text) {
        box.show();
        box.selectAll();
        QTest::keyClicks(&box, text);
    }
};

void NumberBoxTest::expressionsAreTyped() {
    NumberBox box;
    box.setRange(0, 1);
    box.setDecimals(3);
    const QSignalSpy changed(&box, &QDoubleSpinBox::valueChanged);
    type(box, QStringLiteral("3/4")); // 3 is out of range, and need not be in it
    QCOMPARE(box.text(), QStringLiteral("3/4"));
    QCOMPARE(box.value(), 0.75);
    QCOMPARE(changed.size(), 1);
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(box.text(), QStringLiteral("0.750"));
    type(box, QStringLiteral("sqrt(3)/6"));
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(box.value(), 0.289);
}

void NumberBoxTest::whatIsUnfinishedChangesNothing() {
    NumberBox box;
    box.setRange(1, 10);
    box.setValue(5);
    type(box, QStringLiteral("sqrt("));
    QCOMPARE(box.value(), 5.0);
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(box.value(), 5.0);
    QCOMPARE(box.text(), QStringLiteral("5.00"));
    type(box, QStringLiteral("4*8")); // 4 is a number, 32 is too large
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(box.value(), 4.0);
}

void NumberBoxTest::valuesAreRoundedToTheDecimals() {
    NumberBox box;
    box.setRange(0, 100);
    box.setDecimals(1);
    box.setKeyboardTracking(false);
    const QSignalSpy changed(&box, &QDoubleSpinBox::valueChanged);
    type(box, QStringLiteral("100/3"));
    QCOMPARE(changed.size(), 0);
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(box.value(), 33.3);
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(changed.size(), 1); // the text says the same
}

void NumberBoxTest::unitsStay() {
    NumberBox box;
    box.setRange(0, 360);
    box.setSuffix(QStringLiteral(" mm"));
    type(box, QStringLiteral("25.4/2"));
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(box.value(), 12.7);
    QCOMPARE(box.text(), QStringLiteral("12.70 mm"));
}

void NumberBoxTest::aCommaIsADecimalPoint() {
    NumberBox box;
    box.setRange(0, 100);
    type(box, QStringLiteral("1,5"));
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(box.value(), 1.5);
    type(box, QStringLiteral("max(2,7)"));
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(box.value(), 7.0);
}

void NumberBoxTest::wholeNumbersAreComputed() {
    WholeNumberBox box;
    box.setRange(1, 4000);
    type(box, QStringLiteral("1920*2"));
    QCOMPARE(box.value(), 3840);
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(box.text(), QStringLiteral("3840"));
}

void NumberBoxTest::otherNumbersAreNotWhole() {
    WholeNumberBox box;
    box.setRange(1, 4000);
    type(box, QStringLiteral("7/2"));
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(box.value(), 7); // the last whole number
    QCOMPARE(box.text(), QStringLiteral("7"));
}

void NumberBoxTest::tooLargeNumbersAreRefused() {
    WholeNumberBox box;
    box.setRange(1, 400);
    type(box, QStringLiteral("500"));
    QCOMPARE(box.text(), QStringLiteral("50"));
}

QTEST_MAIN(NumberBoxTest)
#include "number_box_test.moc"
