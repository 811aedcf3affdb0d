// SPDX-License-Identifier: MIT
#include "widgets/numbers/number_box.h"

#include "support/named_test.h"
#include "widgets/tooltips.h"

#include <QAccessible>
#include <QApplication>
#include <QFocusEvent>
#include <QLineEdit>
#include <QLocale>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>
#include <QWheelEvent>
#include <QWidget>

using view::NumberBox;
using view::WholeNumberBox;

class NumberBoxTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::German)); } // must not matter

    void expressionsAreTyped();
    void whatWasTypedStaysWhileTheValueIsIts();
    void theNumberIsStatedBesideTheExpression();
    void whatIsUnfinishedChangesNothing();
    void whatIsNoNumberLeavesTheOneBefore();
    void whatHasNoValueBringsBackTheOneBefore();
    void whatIsTooLargeIsTheLargest();
    void theWheelNeedsTheFocus();
    void valuesAreRoundedToTheDecimals();
    void unitsStay();
    void degreesAreReadOnce();
    void aCommaIsADecimalPoint();
    void wholeNumbersAreComputed();
    void digitsStandInGroups();
    void otherNumbersAreNotWhole();
    void decimalsAreRoundedNotJoined();

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
    QCOMPARE(box.text(), QStringLiteral("3/4")); // as it was typed
    type(box, QStringLiteral("sqrt(3)/6"));
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(box.value(), 0.289);
}

void NumberBoxTest::whatWasTypedStaysWhileTheValueIsIts() {
    NumberBox box;
    box.setRange(0, 10);
    box.setDecimals(3);
    box.setKeyboardTracking(false);
    type(box, QStringLiteral("cos(36°)"));
    QFocusEvent left(QEvent::FocusOut, Qt::TabFocusReason);
    QApplication::sendEvent(&box, &left);
    QCOMPARE(box.value(), 0.809);
    QCOMPARE(box.text(), QStringLiteral("cos(36°)"));
    box.setValue(0.809); // the document says the same
    QCOMPARE(box.text(), QStringLiteral("cos(36°)"));
    box.setValue(0.81);
    QCOMPARE(box.text(), QStringLiteral("0.810"));

    type(box, QStringLiteral("7/2"));
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(box.text(), QStringLiteral("7/2"));
    QTest::keyClick(&box, Qt::Key_Up);
    QCOMPARE(box.text(), QStringLiteral("4.500"));
    type(box, QStringLiteral("3.5")); // a plain number with that value
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(box.text(), QStringLiteral("3.500"));
}

void NumberBoxTest::theNumberIsStatedBesideTheExpression() {
    NumberBox box;
    box.setRange(0, 10);
    box.setAccessibleName(QStringLiteral("Width"));
    box.setToolTip(QStringLiteral("How wide it is"));
    QVERIFY(!view::composedTip(box).contains(u'='));
    type(box, QStringLiteral("1/2"));
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(view::composedTip(box), QStringLiteral("<p><b>Width</b><br>1/2 = 0.5<br>How wide it is.</p>"));
    QAccessibleInterface* seen = QAccessible::queryAccessibleInterface(&box);
    QVERIFY(seen && seen->valueInterface());
    QCOMPARE(seen->valueInterface()->currentValue().toDouble(), 0.5);
    box.setToolTip({});
    QCOMPARE(view::composedTip(box), QStringLiteral("1/2 = 0.5"));
    WholeNumberBox whole;
    whole.setRange(0, 10);
    type(whole, QStringLiteral("2*3"));
    QCOMPARE(view::composedTip(whole), QStringLiteral("2*3 = 6"));
    whole.setValue(7);
    QVERIFY(view::composedTip(whole).isEmpty());
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
    QCOMPARE(box.value(), 5.0);
}

// 1.234 of 1.234,5 is a thousandth of what was meant.
void NumberBoxTest::whatIsNoNumberLeavesTheOneBefore() {
    for (const char* typed : {"1.234,5", "1,234.5", "1.2.3", "12 of them", "7*", "2,3,4"}) {
        for (const int key : {int(Qt::Key_Return), 0}) {
            NumberBox box;
            box.setRange(0, 2000);
            box.setDecimals(4);
            box.setValue(5);
            type(box, QLatin1String(typed));
            QVERIFY(QTest::qWaitForWindowExposed(&box));
            QFocusEvent left(QEvent::FocusOut, Qt::TabFocusReason);
            key != 0 ? QTest::keyClick(&box, Qt::Key(key)) : void(QApplication::sendEvent(&box, &left));
            QVERIFY2(box.value() == 5, typed);
            QCOMPARE(box.text(), QStringLiteral("5.0000"));
            QVERIFY2(!QToolTip::text().isEmpty(), typed);
            QToolTip::hideText();
            WholeNumberBox whole;
            whole.setRange(0, 2000);
            whole.setValue(7);
            type(whole, QLatin1String(typed));
            QVERIFY(QTest::qWaitForWindowExposed(&whole));
            key != 0 ? QTest::keyClick(&whole, Qt::Key(key)) : void(QApplication::sendEvent(&whole, &left));
            QVERIFY2(whole.value() == 7, typed);
        }
    }
    NumberBox box;
    box.setRange(0, 2000);
    box.setDecimals(4);
    box.setValue(5);
    type(box, QStringLiteral("1.234"));
    QCOMPARE(box.value(), 1.234);
    QTest::keyClicks(&box, QStringLiteral(","));
    QCOMPARE(box.value(), 5.0); // at once
}

// 1 of 1/0 is no value that anybody wanted.
void NumberBoxTest::whatHasNoValueBringsBackTheOneBefore() {
    NumberBox box;
    box.setRange(0, 10);
    box.setSuffix(QStringLiteral(" mm"));
    box.setValue(5);
    box.show();
    QVERIFY(QTest::qWaitForWindowExposed(&box));
    const QSignalSpy changed(&box, &QDoubleSpinBox::valueChanged);
    type(box, QStringLiteral("1/"));
    QCOMPARE(box.value(), 1.0);
    QTest::keyClick(&box, Qt::Key_0);
    QCOMPARE(box.value(), 5.0);
    QVERIFY2(box.text().startsWith(QStringLiteral("1/0")), qPrintable(box.text()));
    QTest::keyClicks(&box, QStringLiteral(".5"));
    QCOMPARE(box.value(), 2.0);
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(box.value(), 2.0);
    QList<double> values;
    for (const QVariantList& arguments : changed)
        if (values.isEmpty() || values.last() != arguments.first().toDouble())
            values << arguments.first().toDouble();
    QCOMPARE(values, (QList<double>{1, 5, 2}));
    type(box, QStringLiteral("3/0"));
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(box.value(), 2.0);
    WholeNumberBox whole;
    whole.setRange(0, 10);
    whole.setValue(7);
    type(whole, QStringLiteral("4/0"));
    QCOMPARE(whole.value(), 7);
}

void NumberBoxTest::whatIsTooLargeIsTheLargest() {
    WholeNumberBox box;
    box.setRange(1, 47);
    for (const auto& [typed, expected] : {std::pair{"48", 47}, {"1600", 47}, {"0", 1}, {"12", 12}}) {
        box.setValue(30);
        type(box, QLatin1String(typed));
        QTest::keyClick(&box, Qt::Key_Return);
        QCOMPARE(box.value(), expected);
        QCOMPARE(box.text(), QString::number(expected));
    }
}

// So that a panel can be scrolled.
void NumberBoxTest::theWheelNeedsTheFocus() {
    QWidget window;
    auto* box = new NumberBox(&window);
    auto* whole = new WholeNumberBox(&window);
    whole->move(0, 60);
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    const auto turn = [](QWidget* over) {
        QWheelEvent event(QPointF(5, 5), over->mapToGlobal(QPointF(5, 5)), {}, {0, 120}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        event.setAccepted(true);
        QApplication::sendEvent(over, &event);
        return event.isAccepted();
    };
    for (QAbstractSpinBox* each :
         {static_cast<QAbstractSpinBox*>(box), static_cast<QAbstractSpinBox*>(whole)}) {
        window.setFocus();
        const QString before = each->text();
        QVERIFY(!turn(each));
        QCOMPARE(each->text(), before);
        QVERIFY(!each->hasFocus());
        each->setFocus();
        QVERIFY(turn(each));
        QVERIFY(each->text() != before);
    }
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
    QCOMPARE(box.text(), QStringLiteral("25.4/2 mm"));
}

void NumberBoxTest::degreesAreReadOnce() {
    NumberBox box;
    WholeNumberBox whole;
    box.setRange(-360, 360);
    whole.setRange(-360, 360);
    for (QAbstractSpinBox* each : QList<QAbstractSpinBox*>{&box, &whole}) {
        const auto value = [&] { return each == &box ? box.value() : double(whole.value()); };
        each == &box ? box.setSuffix(QStringLiteral("°")) : whole.setSuffix(QStringLiteral("°"));
        for (const char* typed : {"90", "90°", "pi/2", "90°/1", "acos(0)", "45° + pi/4", "45 + pi/4"}) {
            for (const bool isBesideItsUnit : {false, true}) {
                each->show();
                each->selectAll();
                if (!isBesideItsUnit) each->findChild<QLineEdit*>()->selectAll(); // with the suffix
                for (const QChar c : QString::fromUtf8(typed))
                    QTest::sendKeyEvent(QTest::Click, each, Qt::Key_unknown, QString(c), Qt::NoModifier);
                QTest::keyClick(each, Qt::Key_Return);
                QVERIFY2(value() == 90, typed);
                QVERIFY(each->text().startsWith(QStringLiteral("90")) && each->text().endsWith(u'°'));
                box.setValue(1);
                whole.setValue(1);
            }
        }
    }
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
    QCOMPARE(box.text(), QStringLiteral("1920*2"));
    QTest::keyClick(&box, Qt::Key_Up);
    QCOMPARE(box.text(), QStringLiteral("3841"));
}

void NumberBoxTest::digitsStandInGroups() {
    WholeNumberBox box;
    box.setLocale(QLocale::c());
    box.setRange(1, 9'000'000);
    box.setGroupSeparatorShown(true);
    box.setValue(1'234'567);
    QCOMPARE(box.text(), QStringLiteral("1\u202f234\u202f567"));
    box.setValue(9'999);
    QCOMPARE(box.text(), QStringLiteral("9999"));
    type(box, QStringLiteral("123456"));
    QCOMPARE(box.value(), 123'456);
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(box.text(), QStringLiteral("123\u202f456"));
    QTest::keyClick(&box, Qt::Key_End);
    QTest::keyClicks(&box, QStringLiteral("7")); // beside the groups
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(box.value(), 1'234'567);
    QCOMPARE(box.text(), QStringLiteral("1\u202f234\u202f567"));
}

void NumberBoxTest::otherNumbersAreNotWhole() {
    WholeNumberBox box;
    box.setRange(1, 4000);
    type(box, QStringLiteral("7/2"));
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(box.value(), 1); // as it was
    QCOMPARE(box.text(), QStringLiteral("1"));
}

// 10.5 is not 105.
void NumberBoxTest::decimalsAreRoundedNotJoined() {
    for (const auto language : {QLocale::C, QLocale::German}) {
        WholeNumberBox box;
        box.setLocale(language);
        box.setRange(0, 4000);
        box.setKeyboardTracking(false);
        for (const auto& [typed, expected] :
             {std::pair{"10.5", 11}, {"10,4", 10}, {"1600.25", 1600}, {"7.", 7}, {"2.50", 3}}) {
            box.setValue(30);
            type(box, QLatin1String(typed));
            QCOMPARE(box.text(), QLatin1String(typed));
            QTest::keyClick(&box, Qt::Key_Return);
            QCOMPARE(box.value(), expected);
            QCOMPARE(box.text(), QString::number(expected));
        }
    }
}

BARYCAGE_TEST(NumberBoxTest, QApplication);
#include "number_box_test.moc"
