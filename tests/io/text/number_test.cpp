// SPDX-License-Identifier: MIT
#include "io/text/number.h"
#include "support/named_test.h"

#include <QLocale>
#include <QTest>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

class NumberTest : public QObject {
    Q_OBJECT

private slots:
    void numbersAreParsed_data();
    void numbersAreParsed();
    void numbersNearTheEndsOfTheDoubles_data();
    void numbersNearTheEndsOfTheDoubles();
    void partsAreLeft();
    void numbersAreFormatted_data();
    void numbersAreFormatted();
    void everyDoubleComesBack();
    void theLocaleChangesNothing();
};

void NumberTest::numbersAreParsed_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("value"); // nan: refused
    const auto row = [](const char* text, double value = std::nan("")) {
        QTest::newRow(text) << QString::fromUtf8(text) << value;
    };
    row("0", 0);
    row("-0", -0.);
    row("7", 7);
    row("+7", 7);
    row("  \t-.5 \n", -.5);
    row("5.", 5);
    row(".25", .25);
    row("1e3", 1000);
    row("1E+3", 1000);
    row("1e-3", .001);
    row("00012.50", 12.5);
    row("");
    row("   ");
    row("+");
    row("-");
    row(".");
    row("e5");
    row("1/3");
    row("0,5");
    row("1 000");
    row("1e");
    row("1.2.3");
    row("+-1");
    row("-+1");
    row("--1");
    row("++1");
    row("\u22121"); // the minus sign of typesetters
    row("0x10");
    row("5D-1");
    row("inf");
    row("-inf");
    row("nan");
    row("+nan");
    row("1.5}");
    row("١"); // a digit, but not of the C locale
    row("1e999");
    row("-1e400");
}

void NumberTest::numbersAreParsed() {
    QFETCH(QString, text);
    QFETCH(double, value);
    const auto found = io::parseNumber(text);
    QCOMPARE(found.has_value(), !std::isnan(value));
    if (found) QVERIFY(*found == value && std::signbit(*found) == std::signbit(value));
}

// What is too small is 0, what is too large is out of range, however it is spelt.
void NumberTest::numbersNearTheEndsOfTheDoubles_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<double>("value"); // inf: out of range
    const auto row = [](const char* name, const QByteArray& text, double value) {
        QTest::newRow(name) << text << value;
    };
    const double out = std::numeric_limits<double>::infinity();
    row("least", "4.9406564584124654e-324", std::numeric_limits<double>::denorm_min());
    row("below it", "1e-400", 0);
    row("far below it", "-1e-99999999999999999999", 0);
    row("zeros behind the point", "0." + QByteArray(400, '0') + "1", 0);
    row("made up by the exponent", "0." + QByteArray(400, '0') + "1e401", 1);
    row("large", "1.7976931348623157e308", std::numeric_limits<double>::max());
    row("above it", "1e309", out);
    row("digits before the point", "1" + QByteArray(400, '0'), out);
    row("made down by the exponent", "1" + QByteArray(400, '0') + "e-400", 1);
    row("small by the exponent", "1" + QByteArray(400, '0') + "e-1000", 0);
    row("large by the exponent", "0." + QByteArray(400, '0') + "1e1000", out);
    row("nothing however large", "0e999999", 0);
}

void NumberTest::numbersNearTheEndsOfTheDoubles() {
    QFETCH(QByteArray, text);
    QFETCH(double, value);
    double found = -1;
    const auto result = io::fromChars(text.constData(), text.constData() + text.size(), found);
    QCOMPARE(result.ptr - text.constData(), text.size());
    if (std::isinf(value)) {
        QVERIFY(result.ec == std::errc::result_out_of_range);
        QVERIFY(!io::parseNumber(QString::fromLatin1(text)));
    } else {
        QVERIFY(result.ec == std::errc());
        QCOMPARE(found, value);
    }
}

void NumberTest::partsAreLeft() {
    const char* text = "1.5e2rest";
    double value = 0;
    const auto result = io::fromChars(text, text + std::strlen(text), value);
    QVERIFY(result.ec == std::errc());
    QCOMPARE(value, 150.);
    QCOMPARE(QByteArray(result.ptr), QByteArray("rest"));
    QVERIFY(io::fromChars(text + 5, text + 9, value).ec == std::errc::invalid_argument);
}

void NumberTest::numbersAreFormatted_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<QByteArray>("text");
    const auto row = [](double value, const char* text) { QTest::newRow(text) << value << QByteArray(text); };
    row(0, "0");
    row(.1, "0.1");
    row(-.5, "-0.5");
    row(1. / 3, "0.3333333333333333");
    row(100, "100");
    row(1e23, "1e+23");
    row(1e-7, "1e-07");
    row(std::numeric_limits<double>::max(), "1.7976931348623157e+308");
    row(std::numeric_limits<double>::denorm_min(), "5e-324");
}

void NumberTest::numbersAreFormatted() {
    QFETCH(double, value);
    QFETCH(QByteArray, text);
    QCOMPARE(io::formatNumber(value), text);
    if (value == 0) QCOMPARE(io::formatNumber(-value), text); // −0 says nothing new
}

void NumberTest::everyDoubleComesBack() {
    std::mt19937_64 random(7);
    for (int trial = 0; trial < 200'000; ++trial) {
        const std::uint64_t bits = random();
        double value = 0;
        std::memcpy(&value, &bits, sizeof value);
        if (!std::isfinite(value)) continue;
        const QByteArray text = io::formatNumber(value);
        const auto back = io::parseNumber(QString::fromLatin1(text));
        QVERIFY2(back == value, text.constData());
        // And is never longer than all 17 digits.
        if (trial % 100 == 0) QVERIFY(text.size() <= QByteArray::number(value, 'e', 16).size());
    }
}

void NumberTest::theLocaleChangesNothing() {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German));
    const QByteArray written = io::formatNumber(1234.5);
    const auto read = io::parseNumber(u"1234.5");
    const auto comma = io::parseNumber(u"1234,5");
    QLocale::setDefault(before);
    QCOMPARE(written, QByteArray("1234.5"));
    QVERIFY(read == 1234.5);
    QVERIFY(!comma);
}

BARYCAGE_TEST(NumberTest);
#include "number_test.moc"
