// SPDX-License-Identifier: MIT
#include "io/text/expression.h"
#include "support/named_test.h"

#include <QTest>

#include <array>
#include <clocale>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <random>

class ExpressionTest : public QObject {
    Q_OBJECT

private slots:
    void values_data();
    void values();
    void degrees_data();
    void degrees();
    void whatIsNone_data();
    void whatIsNone();
    void hostileTextsEnd();
    void theLocaleDoesNotMatter();
    void exactValues_data();
    void exactValues();
    void whatIsNotExact_data();
    void whatIsNotExact();
    void exactValuesAreNearTheOthers();
};

void ExpressionTest::values_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("value");
    const auto row = [](const char* text, double value) {
        QTest::addRow("%s", text) << QString::fromUtf8(text) << value;
    };
    row("0.25", 0.25);
    row(" -1e-3 ", -1e-3);
    row("1/2", 0.5);
    row("-1/3", -1.0 / 3);
    row("sqrt(3)/6", std::sqrt(3.0) / 6);
    row("√(3)/6", std::sqrt(3.0) / 6);
    row("√3/6", std::sqrt(3.0) / 6);
    row("-2√0.25", -1);
    row("cos(36°)", std::cos(std::numbers::pi / 5));
    row("cos(60°)", 0.5);
    row("cos(90°)", 0);
    row("sin(-30°)", -0.5);
    row("sin(180°)", 0);
    row("sin(pi/2)", 1);
    row("tan(45°)", 1);
    row("pi", std::numbers::pi);
    row("−2π", -2 * std::numbers::pi);
    row("1/phi", 1 / std::numbers::phi);
    row("2*e", 2 * std::numbers::e);
    row("3^2", 9);
    row("-2^2", -4);
    row("2^-1", 0.5);
    row("½", 0.5);
    row("3·4", 12);
    row("1 - 2 - 3", -4);
    row("2/3/4", 2.0 / 3 / 4);
    row("min(1, 2) + max(3, 4)", 5);
    row("COS(0)", 1);
    row("1e3/4", 250);
    row("90°", std::numbers::pi / 2); // elsewhere than in degrees
    row("45°/2 + 1", std::numbers::pi / 8 + 1);
    row("2^3^2", 512);
    row("2*-3 + 10 - 4/2", 2);
    row("acos(0.8)*180/pi", std::acos(0.8) * 180 / std::numbers::pi);
}

void ExpressionTest::values() {
    QFETCH(QString, text);
    QFETCH(double, value);
    const auto result = io::evaluate(text);
    QVERIFY(result);
    QVERIFY2(std::abs(*result - value) <= 2e-16 * std::abs(value),
             qPrintable(QString::number(*result, 'g', 17)));
}

void ExpressionTest::degrees_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("degrees");
    QTest::addColumn<bool>("isAngle"); // and no plain number
    const auto row = [](const char* text, double degrees, bool isAngle) {
        QTest::addRow("%s", text) << QString::fromUtf8(text) << degrees << isAngle;
    };
    const double sharp = std::acos(0.8) * 180 / std::numbers::pi; // 36.87°
    row("90", 90, false);
    row("-22.5", -22.5, false);
    row("360/7", 360.0 / 7, false);
    row("sqrt(2)*45", std::sqrt(2.0) * 45, false);
    row("1/phi", 1 / std::numbers::phi, false);
    row("cos(60°)", 0.5, false);
    row("cos(pi/3)", 0.5, false);
    row("90*cos(60°)", 45, false);
    row("cos(1)", std::cos(1), false); // as everywhere
    row("180/pi", 180 / std::numbers::pi, false);
    row("60°/30°", 2, false);
    row("90°", 90, true);
    row("-90°", -90, true);
    row("45°/2", 22.5, true);
    row("45º", 45, true);
    row("45˚", 45, true);
    row("2*45°", 90, true);
    row("1e-20°", 1e-20, true);
    row("180°/pi", 180 / std::numbers::pi, true);
    row("cos(60°)*90°", 45, true);
    row("pi", 180, true);
    row("π/2", 90, true);
    row("-pi/6", -30, true);
    row("2π", 360, true);
    row("2*pi/7", 360.0 / 7, true);
    row("acos(0.8)", sharp, true);
    row("asin(0.5)", 30, true);
    row("-atan(1)", -45, true);
    row("2*atan(1)", 90, true);
    row("atan2(1, -1)", 135, true);
    row("acos(cos(60°))", 60, true);
    row("abs(-pi/2)", 90, true);
    row("max(60°, pi/2)", 90, true);
    row("min(60, pi/2)", 60, true);
    row("acos(0.8)*180/pi", sharp, false); // converted already
    row("acos(0.8)*180°/pi", sharp, true);
    row("pi/2 + pi/4", 135, true);
    row("90° + pi/4", 135, true);
    row("90 + pi/4", 135, true);
    row("90° + 45", 135, true);
    row("180 - acos(0.8)", 180 - sharp, true);
    row("(90° + pi/4)/3", 45, true);
    row("(pi/2)°", 90, true);
}

void ExpressionTest::degrees() {
    QFETCH(QString, text);
    QFETCH(double, degrees);
    QFETCH(bool, isAngle);
    const auto result = io::evaluate(text, io::NumberUnit::Degrees);
    QVERIFY(result);
    QVERIFY2(std::abs(*result - degrees) <= 3e-16 * std::abs(degrees),
             qPrintable(QString::number(*result, 'g', 17)));
    QCOMPARE(io::isAngle(text), isAngle);
}

void ExpressionTest::whatIsNone_data() {
    QTest::addColumn<QString>("text");
    for (const char* text :
         {"",      " ",         "1/",    "1/0",       "sqrt(-1)", "(1",    "1)",       "()",    "x",
          "x = 3", "a",         "e",     "1 2",       "1,2",      "2 3/4", "sin",      "sin()", "sin(1,2)",
          "1 < 2", "1 ? 2 : 3", "\"a\"", "system(1)", "1//2",     "*2",    "2**3",     "0x10",  "1e400",
          "1e",    "--",        "inf",   "nan",       "1;2",      "1\n2",  "tan(90°)", "ln(0)", "9^9^9"})
        QTest::addRow("%s", text) << QString::fromUtf8(text);
}

void ExpressionTest::whatIsNone() {
    QFETCH(QString, text);
    QVERIFY(!io::evaluate(text));
    QVERIFY(!io::evaluate(text, io::NumberUnit::Degrees));
    static const QStringList whole{QStringLiteral("1/0"), QStringLiteral("sqrt(-1)"), QStringLiteral("ln(0)"),
                                   QStringLiteral("tan(90°)"), QStringLiteral("9^9^9")};
    QCOMPARE(io::isWithoutValue(text), whole.contains(text)); // the others are no expressions
}

void ExpressionTest::hostileTextsEnd() {
    for (const char* part : {"(", "-", "1+", "sin(", "2^", ",", "pi", "(1)", "°", "e", "1/"})
        for (const int count : {50, 66, 200, 100'000})
            io::evaluate(QString::fromUtf8(part).repeated(count));
    QVERIFY(!io::evaluate(QStringLiteral("1+").repeated(200) + u'1')); // too long
    const QString nested = QStringLiteral("(").repeated(90) + u'1' + QStringLiteral(")").repeated(90);
    QCOMPARE(io::evaluate(nested).value_or(0), 1.0);
}

void ExpressionTest::theLocaleDoesNotMatter() {
    const char* german = std::setlocale(LC_ALL, "de_DE.UTF-8");
    QCOMPARE(io::evaluate(u"1.5/2").value_or(0), 0.75);
    QVERIFY(!io::evaluate(u"1,5/2"));
    if (german) std::setlocale(LC_ALL, "C");
}

void ExpressionTest::exactValues_data() {
    using ifs::Surd;
    QTest::addColumn<QString>("text");
    QTest::addColumn<ifs::Surd>("value");
    const auto row = [](const char* text, const Surd& value) {
        QTest::newRow(text) << QString::fromUtf8(text) << value;
    };
    const Surd half = Surd(1) / Surd(2);
    row("1/3", Surd(1) / Surd(3));
    row("-0.1*3", Surd(-3) / Surd(10));
    row("sqrt(3)/6", Surd::root(3) / Surd(6));
    row("√3/6", Surd::root(3) / Surd(6));
    row("2^-3", Surd(1) / Surd(8));
    row("3^(1/2)", Surd::root(3));
    row("phi^2", (Surd(3) + Surd::root(5)) * half);
    row("1/(1+√2)", Surd::root(2) - Surd(1));
    row("cos(60°)", half);
    row("sin(pi/3)", Surd::root(3) * half);
    row("cos(π/4)/2", Surd::root(2) / Surd(4));
    row("cos(36°)", (Surd(1) + Surd::root(5)) / Surd(4));
    row("sin(-18°)", (Surd(1) - Surd::root(5)) / Surd(4));
    row("cos(120°)", -half);
    row("tan(30°)", Surd::root(3) / Surd(3));
    row("abs(-1/3)", Surd(1) / Surd(3));
    row("pi/pi", Surd(1));
    row("½", half);
}

void ExpressionTest::exactValues() {
    QFETCH(QString, text);
    QFETCH(ifs::Surd, value);
    const auto exact = io::evaluateExactly(text);
    QVERIFY(exact);
    QVERIFY2(*exact == value, qPrintable(QString::number(exact->rounded(), 'g', 17)));
}

void ExpressionTest::whatIsNotExact_data() {
    QTest::addColumn<QString>("text");
    // Plain numbers stand for the doubles that are stored; the others are no roots of rationals.
    for (const char* text : {"0.5",
                             "1e-3",
                             "pi",
                             "2π",
                             "30°",
                             "cos(20°)",
                             "cos(1.0471975511965976)",
                             "e/2",
                             "asin(1/2)",
                             "ln(2)",
                             "sqrt(2)+sqrt(3)",
                             "sqrt(phi)",
                             "cbrt(8)",
                             "sin(30)",
                             "cos(60°°)",
                             "1/0",
                             "tan(90°)",
                             "nonsense",
                             "2^100",
                             "1°+pi/4"})
        QTest::newRow(text) << QString::fromUtf8(text);
}

void ExpressionTest::whatIsNotExact() {
    QFETCH(QString, text);
    QVERIFY(!io::evaluateExactly(text));
}

// Random expressions: the exact value is the other but for its rounding.
void ExpressionTest::exactValuesAreNearTheOthers() {
    std::mt19937 random(11);
    int found = 0;
    const std::function<QString(int)> expression = [&](int depth) -> QString {
        const int kind = int(random() % (depth > 3 ? 3 : 9));
        const QString number = QString::number(int(random() % 9) + 1);
        if (kind < 2) return number;
        if (kind == 2) return QStringLiteral("sqrt(%1)").arg(number);
        if (kind == 3) return QStringLiteral("cos(%1°)").arg(30 * int(random() % 13));
        const QString a = expression(depth + 1), b = expression(depth + 1);
        static const std::array signs{u'+', u'-', u'*', u'/', u'*'};
        return u'(' + a + signs[std::size_t(kind - 4)] + b + u')';
    };
    for (int run = 0; run < 3000; ++run) {
        const QString text = expression(0);
        const auto value = io::evaluate(text);
        const auto exact = io::evaluateExactly(text);
        if (!exact || !value) continue;
        ++found;
        QVERIFY2(std::abs(exact->rounded() - *value) <= 1e-9 * (1 + std::abs(*value)),
                 qPrintable(text + QStringLiteral(" = %1").arg(*value, 0, 'g', 17)));
    }
    QVERIFY(found > 500);
}

BARYCAGE_TEST(ExpressionTest);
#include "expression_test.moc"
