// SPDX-License-Identifier: MIT
#include "notation/rows/numbers.h"
#include "support/named_test.h"

#include <QTest>

#include <cmath>

using namespace notation;

class NumbersTest : public QObject {
    Q_OBJECT

private slots:
    void tokens_data();
    void tokens();
    void decimalCommas_data();
    void decimalCommas();
    void shapes_data();
    void shapes();
};

void NumbersTest::tokens_data() {
    QTest::addColumn<QByteArray>("token");
    QTest::addColumn<int>("kind");
    QTest::addColumn<double>("value");
    using Kind = Number::Kind;
    const auto row = [](const char* token, Kind kind, double value = 0) {
        QTest::newRow(token) << QByteArray(token) << int(kind) << value;
    };
    row("0.5", Kind::Good, .5);
    row("+.5", Kind::Good, .5);
    row("-5.", Kind::Good, -5);
    row("5e-1", Kind::Good, .5);
    row(".5E0", Kind::Good, .5);
    row("1e-400", Kind::Good, 0);
    row("3.4028234663852886e38", Kind::Good, 3.4028234663852886e38); // the largest float
    row("1e39", Kind::Huge, 1e39);
    row("1e999", Kind::Huge);
    row("1/3", Kind::Trailing, 1);
    row("5D-1", Kind::Trailing, 5);
    row("0.5}", Kind::Trailing, .5);
    row("0,5", Kind::Trailing, 0);
    row("1.2.3", Kind::Trailing, 1.2);
    row("1e", Kind::Trailing, 1);
    row("inf", Kind::NotFinite);
    row("-nan", Kind::NotFinite);
    row("+Infinity", Kind::NotFinite);
    row("0x10", Kind::NotANumber);
    row("0X1p3", Kind::NotANumber);
    row("", Kind::NotANumber);
    row("+", Kind::NotANumber);
    row(".", Kind::NotANumber);
    row("+-1", Kind::NotANumber);
    row("--1", Kind::NotANumber);
    row("a", Kind::NotANumber);
    row("\xe2\x88\x92"
        "1",
        Kind::NotANumber); // the minus sign of typesetters
}

void NumbersTest::tokens() {
    QFETCH(QByteArray, token);
    QFETCH(int, kind);
    QFETCH(double, value);
    const Number number = readNumber(token.toStdString());
    QCOMPARE(int(number.kind), kind);
    QCOMPARE(number.value, value);
    const double good = valueOf(token.toStdString(), false);
    QVERIFY(number.kind == Number::Kind::Good ? good == value : std::isnan(good));
}

void NumbersTest::decimalCommas_data() {
    QTest::addColumn<QByteArray>("token");
    QTest::addColumn<double>("value"); // nan: no number
    const auto row = [](const char* token, double value = std::nan("")) {
        QTest::newRow(token) << QByteArray(token) << value;
    };
    row("0,5", .5);
    row(",5", .5);
    row("-1,25e1", -12.5);
    row("0.5", .5); // a point still is one
    row("1,");
    row("1,5,5");
    row("1,5.5");
    row("1,e5");
    row("1,-5");
    row(",");
}

void NumbersTest::decimalCommas() {
    QFETCH(QByteArray, token);
    QFETCH(double, value);
    const double found = valueOf(token.toStdString(), true);
    QVERIFY(std::isnan(value) ? std::isnan(found) : found == value);
    if (token.contains(',')) QVERIFY(std::isnan(valueOf(token.toStdString(), false)));
}

void NumbersTest::shapes_data() {
    QTest::addColumn<QList<int>>("perLine");
    QTest::addColumn<bool>("isMarked3D");
    QTest::addColumn<int>("rowLength");
    QTest::addColumn<QByteArray>("remark"); // "mark", "lines" or nothing
    const auto row = [](const char* name, const QList<int>& perLine, bool isMarked3D, int rowLength,
                        const char* remark = "") {
        QTest::newRow(name) << perLine << isMarked3D << rowLength << QByteArray(remark);
    };
    row("nothing", {}, false, 0);
    row("nothing, marked", {}, true, 0);
    row("sevens", {7, 7, 7}, false, 7);
    row("two maps on a line", {14, 7}, false, 7);
    row("a map over two lines", {4, 3}, false, 7);
    row("one number short", {7, 6}, false, 0);
    row("sixes", {6, 6}, false, 6);
    row("twice six on a line", {12, 6}, false, 6);
    row("seven sixes, read as six sevens", {6, 6, 6, 6, 6, 6, 6}, false, 7, "lines");
    row("seven thirteens, read as thirteen sevens", {13, 13, 13, 13, 13, 13, 13}, false, 7, "lines");
    row("thirteens", {13, 13}, true, 13);
    row("a spatial map over lines", {3, 3, 3, 3, 1}, true, 13);
    row("thirteens without the mark", {13, 26}, false, 13, "mark");
    row("twelves", {12, 12}, true, 12);
    row("twelves without the mark", {12, 12}, false, 12, "mark");
    row("twelve thirteens are thirteen twelves", {12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12}, true,
        13);
    row("sevens, marked", {7, 7}, true, 0);
    row("sixes, marked", {6, 6}, true, 0);
    row("six numbers over two lines", {3, 3}, false, 0); // then lines say nothing
    row("five", {5}, false, 0);
}

void NumbersTest::shapes() {
    QFETCH(QList<int>, perLine);
    QFETCH(bool, isMarked3D);
    QFETCH(int, rowLength);
    QFETCH(QByteArray, remark);
    const RowShape shape = rowShape({perLine.begin(), perLine.end()}, isMarked3D);
    QCOMPARE(shape.rowLength, rowLength);
    QCOMPARE(shape.isMarkMissing, remark == "mark");
    QCOMPARE(shape.isLineLengthOdd, remark == "lines");
}

BARYCAGE_TEST(NumbersTest);
#include "numbers_test.moc"
