// SPDX-License-Identifier: MIT
#include "support/named_test.h"
#include "widgets/numbers/number_field.h"

#include <QAction>
#include <QLocale>
#include <QSignalSpy>
#include <QStatusTipEvent>
#include <QStringList>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <random>

using view::NumberField;

namespace {

// What a main window would show in its status bar.
class Tips : public QObject {
public:
    QStringList said;

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::StatusTip) said << static_cast<QStatusTipEvent*>(event)->tip();
        return false;
    }
};

} // namespace

class NumberFieldTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::German)); } // must not matter

    void init() {
        m_window = std::make_unique<QWidget>();
        auto* layout = new QVBoxLayout(m_window.get());
        m_field = new NumberField;
        m_other = new NumberField;
        layout->addWidget(m_field);
        layout->addWidget(m_other);
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        m_other->setFocus();
    }

    void shortNumbersAreShort() {
        QCOMPARE(view::shortNumber(0.723195530540), QStringLiteral("0.7232"));
        QCOMPARE(view::shortNumber(-0.04), QStringLiteral("-0.04"));
        QCOMPARE(view::shortNumber(3), QStringLiteral("3"));
        QCOMPARE(view::shortNumber(-1e-18), QStringLiteral("-1e-18"));
        QCOMPARE(view::shortNumber(12345.678901), QStringLiteral("12345.7"));
        QCOMPARE(view::shortNumber(2.5e9), QStringLiteral("2.5e+09"));
        QCOMPARE(view::shortNumber(0.0042317), QStringLiteral("0.00423"));
        // Three digits are more than a few decimals, and nothing but 0 reads 0.
        QCOMPARE(view::roundedNumber(-0.04, 1), QStringLiteral("-0.04"));
        QCOMPARE(view::roundedNumber(0.65432, 0), QStringLiteral("0.654"));
        QCOMPARE(view::roundedNumber(-7.66666, 1), QStringLiteral("-7.67"));
        QCOMPARE(view::roundedNumber(76.6666, 1), QStringLiteral("76.7"));
        QCOMPARE(view::roundedNumber(7666.66, 0), QStringLiteral("7667"));
        QCOMPARE(view::roundedNumber(0.99996, 0), QStringLiteral("1"));
        QCOMPARE(view::roundedNumber(0, 0), QStringLiteral("0"));
    }

    // Neither sign is of a decimal anywhere.
    void largeNumbersAreGroupedWithoutCommaOrPoint() {
        QCOMPARE(view::groupedNumber(0), QStringLiteral("0"));
        QCOMPARE(view::groupedNumber(4096), QStringLiteral("4096"));
        QCOMPARE(view::groupedNumber(262'144), QStringLiteral("262\u202f144"));
        QCOMPARE(view::groupedNumber(1e6), QStringLiteral("1\u202f000\u202f000"));
        QCOMPARE(view::groupedNumber(-123'456), QStringLiteral("-123\u202f456"));
    }

    void fullNumbersComeBack() {
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> number(-10, 10);
        for (int i = 0; i < 1000; ++i) {
            const double value = number(random);
            m_field->editValue(value);
            QCOMPARE(m_field->text().toDouble(), value);
        }
    }

    // Tab leaves what cannot be read, and the balloon goes with the focus.
    void aRefusedNumberIsSaidInTheWindow() {
        Tips tips;
        m_window->installEventFilter(&tips);
        m_field->editValue(2);
        m_field->setAccessibleName(QStringLiteral("x of corner 1"));
        m_field->setFocus();
        QTest::keyClicks(m_field, QStringLiteral("hello"));
        QTest::keyClick(m_field, Qt::Key_Tab);
        QCOMPARE(m_field->value(), 2.0);
        QCOMPARE(tips.said.size(), 1);
        QVERIFY(tips.said.first().startsWith(QStringLiteral("x of corner 1:")));
        QVERIFY(tips.said.first().contains(QStringLiteral("hello")));
    }

    void everyKeystrokeThatIsANumberIsReported() {
        QSignalSpy edited(m_field, &NumberField::edited);
        QSignalSpy committed(m_field, &NumberField::committed);
        m_field->setFocus();
        m_field->selectAll();
        QTest::keyClicks(m_field, QStringLiteral("-.25"));
        QCOMPARE(edited.size(), 2); // "-" and "-." are none
        QCOMPARE(edited.front().front().toDouble(), -0.2);
        QCOMPARE(edited.back().front().toDouble(), -0.25);
        QTest::keyClick(m_field, Qt::Key_Return);
        QCOMPARE(committed.size(), 1);
    }

    void aBadNumberIsRefusedWithItsReason() {
        QSignalSpy edited(m_field, &NumberField::edited);
        QSignalSpy committed(m_field, &NumberField::committed);
        QSignalSpy cancelled(m_field, &NumberField::cancelled);
        m_field->setValue(2);
        m_field->setFocus();
        m_field->selectAll();
        QTest::keyClicks(m_field, QStringLiteral("0,5,"));
        QVERIFY(m_field->problem().contains(QStringLiteral("0,5,")));
        QCOMPARE(m_field->accessibleDescription(), m_field->problem());
        QTest::keyClick(m_field, Qt::Key_Return);
        QCOMPARE(committed.size(), 0);
        QCOMPARE(m_field->text(), QStringLiteral("0,5,")); // still there to be mended
        m_other->setFocus();
        QCOMPARE(committed.size(), 0);
        QCOMPARE(cancelled.size(), 1);
        QVERIFY(m_field->problem().isEmpty());
    }

    // 1.234 of 1.234,5 is a thousandth of what was meant.
    void twoDecimalSignsLeaveTheNumberBefore() {
        for (const char* typed : {"1.234,5", "1,234.5", "1.2.3"}) {
            QSignalSpy edited(m_field, &NumberField::edited);
            QSignalSpy cancelled(m_field, &NumberField::cancelled);
            m_field->setValue(2);
            m_field->setFocus();
            m_field->selectAll();
            QTest::keyClicks(m_field, QLatin1String(typed));
            QCOMPARE(edited.back().front().toDouble(), 2.0);
            QCOMPARE(m_field->value(), 2.0);
            QVERIFY(m_field->problem().contains(QLatin1String(typed)));
            m_other->setFocus();
            QCOMPARE(cancelled.size(), 1);
            QCOMPARE(m_field->value(), 2.0);
        }
        // Unfinished, as far as one can tell: it is taken back when the field is left.
        m_field->setFocus();
        m_field->selectAll();
        QTest::keyClicks(m_field, QStringLiteral("7*"));
        QCOMPARE(m_field->value(), 7.0);
        m_other->setFocus();
        QCOMPARE(m_field->value(), 2.0);
    }

    void aCommaMayStandForTheDecimalPoint() {
        QSignalSpy edited(m_field, &NumberField::edited);
        m_field->setValue(2);
        m_field->setFocus();
        m_field->selectAll();
        QTest::keyClicks(m_field, QStringLiteral("-0,25"));
        QCOMPARE(edited.back().front().toDouble(), -0.25);
        m_other->setFocus();
        QCOMPARE(m_field->text(), QStringLiteral("-0.25"));
        QCOMPARE(view::typedNumber(QStringLiteral("1,5e-3")), 1.5e-3);
        QVERIFY(!view::typedNumber(QStringLiteral("1,234.5"))); // groups of thousands are not guessed at
        QVERIFY(!view::typedNumber(QStringLiteral("1,234,5")));
    }

    // The value is exact, what was typed stays to be read, and while it is unfinished the last value is live.
    void expressionsAreTyped() {
        QSignalSpy edited(m_field, &NumberField::edited);
        m_field->setFocus();
        m_field->selectAll();
        QTest::keyClicks(m_field, QStringLiteral("1/4"));
        QCOMPARE(edited.size(), 2); // 1 and 1/4
        QCOMPARE(edited.back().front().toDouble(), 0.25);
        QTest::keyClicks(m_field, QStringLiteral("+"));
        QCOMPARE(m_field->value(), 0.25);
        QTest::keyClick(m_field, Qt::Key_Backspace);
        QTest::keyClick(m_field, Qt::Key_Return);
        QCOMPARE(m_field->text(), QStringLiteral("1/4"));
        m_other->setFocus();
        QCOMPARE(m_field->text(), QStringLiteral("1/4"));
        QCOMPARE(m_field->typedText(), QStringLiteral("1/4"));
        m_field->setValue(0.25); // as the model says it
        QCOMPARE(m_field->text(), QStringLiteral("1/4"));
        m_field->setValue(0.3); // undone
        QCOMPARE(m_field->text(), QStringLiteral("0.3"));
        QCOMPARE(view::typedNumber(QStringLiteral("cos(60°)")), 0.5);
        QCOMPARE(view::typedNumber(QStringLiteral("0,5")), 0.5);
    }

    // 1 of 1/0 is no value that anybody wanted; what is unfinished may still become one.
    void whatHasNoValueGivesBackTheNumberBefore() {
        QSignalSpy edited(m_field, &NumberField::edited);
        m_field->setValue(7);
        m_field->setFocus();
        m_field->selectAll();
        QTest::keyClicks(m_field, QStringLiteral("1/"));
        QCOMPARE(m_field->value(), 1.0);
        QTest::keyClicks(m_field, QStringLiteral("0"));
        QCOMPARE(m_field->value(), 7.0);
        QCOMPARE(edited.back().front().toDouble(), 7.0);
        QVERIFY(m_field->problem().contains(QStringLiteral("finite")));
        QCOMPARE(m_field->text(), QStringLiteral("1/0"));
        QTest::keyClicks(m_field, QStringLiteral(".5"));
        QCOMPARE(edited.back().front().toDouble(), 2.0);
        m_field->setRange({0.0, 10.0});
        QTest::keyClick(m_field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(m_field, QStringLiteral("3"));
        QCOMPARE(m_field->value(), 3.0);
        QTest::keyClicks(m_field, QStringLiteral("0"));
        QCOMPARE(edited.back().front().toDouble(), 7.0); // 30 is too much
        QTest::keyClicks(m_field, QStringLiteral("*sqrt("));
        QCOMPARE(m_field->value(), 7.0);
        QTest::keyClick(m_field, Qt::Key_Escape);
    }

    // Undo takes back what is being typed; after Enter it is the document's.
    void undoIsLeftToTheDocument() {
        QAction undo(m_window.get());
        undo.setShortcut(QKeySequence::Undo);
        m_window->addAction(&undo);
        QSignalSpy undone(&undo, &QAction::triggered);
        QSignalSpy edited(m_field, &NumberField::edited);
        m_field->setValue(7);
        m_field->setFocus();
        m_field->selectAll();
        QTest::keyClicks(m_field, QStringLiteral("45"));
        QTest::keySequence(m_field, QKeySequence(QKeySequence::Undo));
        QCOMPARE(undone.size(), 0);
        QVERIFY(m_field->text() != QStringLiteral("45"));
        QTest::keyClick(m_field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(m_field, QStringLiteral("45"));
        QTest::keyClick(m_field, Qt::Key_Return);
        const auto before = edited.size();
        QTest::keySequence(m_field, QKeySequence(QKeySequence::Undo));
        QCOMPARE(undone.size(), 1);
        QCOMPARE(edited.size(), before); // no second edit
        QCOMPARE(m_field->text(), QStringLiteral("45"));
        m_window->removeAction(&undo);
    }

    void reasonsNameTheMistake() {
        QVERIFY(view::numberProblem(QStringLiteral(" 1e-3 ")).isEmpty());
        QVERIFY(view::numberProblem(QStringLiteral("1/3")).isEmpty());
        QVERIFY(!view::numberProblem(QStringLiteral("1/")).isEmpty());
        QVERIFY(view::numberProblem(QStringLiteral("sqrt(-1)")).contains(QStringLiteral("no finite value")));
        QVERIFY(view::numberProblem(QString()).contains(QStringLiteral("missing")));
        QVERIFY(!view::numberProblem(QStringLiteral("inf")).isEmpty());
        for (const char* large : {"1e400", "-1e400", "+1,5e999", " 1e400 ", "1e300", "-3.5e38"})
            QVERIFY(view::numberProblem(QLatin1String(large)).contains(QStringLiteral("too large")));
        for (const char* none : {"1e400x", "+-1e400", "e400", "–1e400"})
            QVERIFY(
                view::numberProblem(QString::fromUtf8(none)).endsWith(QStringLiteral("is not a number.")));
        QVERIFY(view::numberProblem(QStringLiteral("1e-400")).isEmpty());
        const view::NumberRange positive{0.0, std::nullopt, view::NumberRange::Ends::Open};
        QVERIFY(
            view::numberProblem(QStringLiteral("0"), positive).contains(QStringLiteral("greater than 0")));
        QVERIFY(view::numberProblem(QStringLiteral("0.1"), positive).isEmpty());
    }

    void escapeTakesTheTypingBack() {
        QSignalSpy cancelled(m_field, &NumberField::cancelled);
        m_field->setFocus();
        QTest::keyClicks(m_field, QStringLiteral("7"));
        QTest::keyClick(m_field, Qt::Key_Escape);
        QCOMPARE(cancelled.size(), 1);
    }

    void arrowsStepWithoutTails() {
        m_field->setValue(0.1);
        m_field->setFocus();
        for (int i = 0; i < 20; ++i)
            QTest::keyClick(m_field, Qt::Key_Up);
        QCOMPARE(m_field->value(), 0.3);
        QTest::keyClick(m_field, Qt::Key_Down, Qt::ShiftModifier);
        QCOMPARE(m_field->value(), 0.2);
        QTest::keyClick(m_field, Qt::Key_Up, Qt::AltModifier);
        QCOMPARE(m_field->value(), 0.201);
    }

    void theWheelNeedsTheFocus() {
        m_field->setValue(1);
        roll(m_field);
        QCOMPARE(m_field->value(), 1.0);
        m_field->setFocus();
        roll(m_field);
        QCOMPARE(m_field->value(), 1.01);
    }

    void theModelDoesNotWriteUnderTheTypingHand() {
        m_field->setFocus();
        m_field->selectAll();
        QTest::keyClicks(m_field, QStringLiteral("0.5"));
        m_field->setValue(0.25);
        QCOMPARE(m_field->text(), QStringLiteral("0.5"));
        QTest::keyClick(m_field, Qt::Key_Return);
        m_field->setValue(0.25);
        QCOMPARE(m_field->text(), QStringLiteral("0.25"));
    }

private:
    static void roll(QWidget* widget) {
        const QPointF middle(widget->rect().center());
        QWheelEvent event(middle, widget->mapToGlobal(middle), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(widget, &event);
    }

    std::unique_ptr<QWidget> m_window;
    NumberField* m_field = nullptr;
    NumberField* m_other = nullptr;
};

BARYCAGE_TEST(NumberFieldTest, QApplication);
#include "maps_number_field_test.moc"
