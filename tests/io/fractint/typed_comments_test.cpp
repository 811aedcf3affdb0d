// SPDX-License-Identifier: MIT
#include "ifs/facts.h"
#include "io/fractint/entry_writer.h"
#include "io/fractint/fractint_reader.h"
#include "io/fractint/fractint_writer.h"
#include "io/fractint/metadata_comments.h"
#include "io/fractint/typed_comments.h"
#include "io/table/table_reader.h"
#include "io/text/typed_coefficient.h"
#include "support/named_test.h"

#include <QTest>

#include <array>
#include <random>

using namespace Qt::StringLiterals;

using document::Fractal;

namespace {

Fractal readEntry(const QByteArray& text) {
    const document::FractalFile file = io::readFractint(text);
    return file.entries.isEmpty() ? Fractal() : *file.entries.first().fractal;
}

QByteArray entryOf(const QByteArray& lines) {
    return "digits {\n .3333333333333333 0 0 .3333333333333333 0 0 .5\n"
           " .3333333333333333 0 0 .3333333333333333 1 0 .5\n" +
           lines + "}\n";
}

// Empty where nothing is typed.
QString typedAt(const Fractal& fractal, std::size_t map, int which) {
    const auto of = [&](const auto& system) {
        const auto* typed = system.maps[map].typed.of(which, system.maps[map].map);
        return typed ? QString::fromStdString(typed->text) : QString();
    };
    const auto* plane = document::system2(fractal);
    return plane ? of(*plane) : of(*document::system3(fractal));
}

} // namespace

class TypedCommentsTest : public QObject {
    Q_OBJECT

private slots:
    void writtenBesideTheDoubles() {
        const QByteArray text = entryOf("; barycage: exact 1 a 1/3\n; barycage: exact 2 d 1/3\n");
        const Fractal fractal = readEntry(text);
        QCOMPARE(typedAt(fractal, 0, 0), u"1/3"_s);
        QCOMPARE(typedAt(fractal, 1, 3), u"1/3"_s);
        QVERIFY(typedAt(fractal, 0, 3).isEmpty());
        const QByteArray written = io::writeEntry(fractal);
        QVERIFY2(written.contains("; barycage: exact 1 a 1/3\n"), written.constData());
        QVERIFY2(written.contains("; barycage: exact 2 d 1/3\n"), written.constData());
        QCOMPARE(written.count("exact"), 2);
        QVERIFY(readEntry(written) == io::asStored(fractal));
    }
    // Another program has changed the number.
    void aLineCountsWithItsNumber() {
        const Fractal fractal =
            readEntry(entryOf("; barycage: exact 1 a 1/3\n").replace("{\n .3333333333333333", "{\n .25"));
        QCOMPARE(document::system2(fractal)->maps[0].map.linear(0, 0), .25);
        QVERIFY(typedAt(fractal, 0, 0).isEmpty());
        QVERIFY(!io::writeEntry(fractal).contains("exact"));
    }
    // Lines that mean nothing change nothing, and those that are not understood stay.
    void whatIsNoLineSaysNothing_data() {
        QTest::addColumn<QByteArray>("line");
        for (const char* line :
             {"exact", "exact 1", "exact 1 a", "exact 0 a 1/3", "exact 3 a 1/3", "exact 1 g 1/3",
              "exact 1 aa 1/3", "exact a 1 1/3", "exact 1 a 1/2", "exact 1 a .3333333333333333",
              "exact 1 a 1/0", "exact 1 a x/3", "exact 99999999999999 a 1/3", "exact -1 a 1/3"})
            QTest::newRow(line) << QByteArray(line);
    }
    void whatIsNoLineSaysNothing() {
        QFETCH(const QByteArray, line);
        const Fractal fractal = readEntry(entryOf("; barycage: " + line + '\n'));
        QVERIFY(document::system2(fractal));
        for (std::size_t map = 0; map < 2; ++map)
            for (int which = 0; which < 6; ++which)
                QVERIFY(typedAt(fractal, map, which).isEmpty());
    }
    void rootsAndLettersOfSpace() {
        Fractal fractal;
        fractal.name = u"solid"_s;
        document::System3 system;
        ifs::append<3>(system, {ifs::Matrix<3>::Identity() / 2, {std::sqrt(3.0) / 6, 0, 1.0 / 7}}, 1.0);
        io::keepTyped(system.maps[0], 9, u"√3/6");
        io::keepTyped(system.maps[0], 11, u"  1 /  7 ");
        fractal.shape = document::Shape<3>{std::move(system)};
        const QByteArray text = io::writeEntry(fractal);
        QVERIFY2(text.contains("; barycage: exact 1 j √3/6\n"), text.constData());
        QVERIFY2(text.contains("; barycage: exact 1 l 1 / 7\n"), text.constData());
        QVERIFY(readEntry(text) == io::asStored(fractal));
        QCOMPARE(typedAt(readEntry(text), 0, 9), u"√3/6"_s);
    }
    // What is too long for a line is left out, and the entry is what asStored() says.
    void longExpressionsAreLeftOut() {
        Fractal fractal = readEntry(entryOf({}));
        auto& map = document::system2(fractal)->maps[0];
        io::keepTyped(map, 0, u"1/3"_s + u"+0"_s.repeated(30));
        QVERIFY(map.typed.of(0, map.map));
        QVERIFY(!io::writeEntry(fractal).contains("exact"));
        QVERIFY(readEntry(io::writeEntry(fractal)) == io::asStored(fractal));
    }
    // Else the entry would have more lines than can be read.
    void anEntryHasOnlySoManyLines() {
        Fractal fractal = readEntry(entryOf({}));
        auto& maps = document::system2(fractal)->maps;
        io::keepTyped(maps[0], 0, u"1/3");
        io::keepTyped(maps[0], 3, u"1/3");
        maps.resize(60'000, maps[0]);
        const QByteArray text = io::writeEntry(fractal);
        QCOMPARE(text.count("; barycage: exact "), qsizetype(io::maxTypedLines));
        QVERIFY(readEntry(text) == io::asStored(fractal));
    }
    void plainNumbersAreNotKept() {
        QVERIFY(!io::typedCoefficient(0, u"0.25"));
        QVERIFY(!io::typedCoefficient(0, u"1e-3"));
        QVERIFY(!io::typedCoefficient(0, u"nonsense"));
        QVERIFY(io::typedCoefficient(0, u"1/4")->value == ifs::Surd(1) / ifs::Surd(4));
        QVERIFY(!io::typedCoefficient(0, u"cos(20°)")->value.hasValue());
    }
    // The whole way: what the file says is proved.
    void factsOfAFileAreProved() {
        const QByteArray lines = "; barycage: exact 1 a 1/3\n; barycage: exact 1 d 1/3\n"
                                 "; barycage: exact 2 a 1/3\n; barycage: exact 2 d 1/3\n";
        const auto dimensionOf = [](const Fractal& fractal) {
            return ifs::factsOf(*document::system2(fractal)).invariants.openSet->dimension;
        };
        const auto overlapping = [&](const QByteArray& more) {
            return entryOf(" .3333333333333333 0 0 .3333333333333333 .3333333333333333 0 .5\n" + more);
        };
        const QByteArray third = "; barycage: exact 3 a 1/3\n; barycage: exact 3 d 1/3\n"
                                 "; barycage: exact 3 e 1/3\n";
        QCOMPARE(dimensionOf(readEntry(overlapping({})))->certainty, ifs::Certainty::ToRounding);
        QCOMPARE(dimensionOf(readEntry(overlapping(lines + third)))->certainty, ifs::Certainty::Exact);
    }
    void tablesKeepTheirFractions() {
        const io::Table table = io::readTable(u"a b c d e f p\n1/3 0 0 1/3 0 0 0.5\n"
                                              "½ 0 0 0.5 sqrt(3)/2 −1/7 1/2\n"_s);
        QCOMPARE(table.rows.size(), std::size_t(2));
        const auto text = [&](std::size_t row, int which) {
            const auto* typed = table.rows[row].typed.of(which, table.rows[row].map);
            return typed ? QString::fromStdString(typed->text) : QString();
        };
        QCOMPARE(text(0, 0), u"1/3"_s);
        QCOMPARE(text(1, 4), u"sqrt(3)/2"_s);
        QCOMPARE(text(1, 5), u"-1/7"_s);
        QVERIFY(text(1, 3).isEmpty());
    }
    // Of scales and angles no coefficient is the number that stands there; e and f are.
    void scalesAndAnglesMakeNoCoefficients() {
        const io::Table table = io::readTable(u"r s theta phi e f\n1/3 1/3 60 60 1/3 0\n"_s);
        QCOMPARE(table.rows.size(), std::size_t(1));
        for (int which = 0; which < 4; ++which)
            QVERIFY(!table.rows[0].typed.of(which, table.rows[0].map));
        QVERIFY(table.rows[0].typed.of(4, table.rows[0].map));
    }
    void randomEntriesReadBack() {
        std::mt19937 random(3);
        const std::array texts{u"1/3"_s,   u"2/7"_s,        u"sqrt(2)/3"_s, u"-√3/6"_s,
                               u"phi/4"_s, u"cos(60°)/3"_s, u"pi/9"_s,      u"(1+sqrt(5))/7"_s};
        for (int run = 0; run < 100; ++run) {
            document::System2 system;
            for (int i = 0; i < 3; ++i) {
                ifs::append(system, ifs::affineMap(.5, 0, 0, .25, i, 0), 1.0 / 3);
                for (int which = 0; which < 6; ++which) {
                    if (random() % 2 == 0) continue;
                    const QString& text = texts[random() % texts.size()];
                    auto& map = system.maps.back();
                    const double number = io::typedCoefficient(which, text)->number;
                    if (which < 4)
                        map.map.linear(which / 2, which % 2) = number;
                    else
                        map.map.translation[which - 4] = number;
                    io::keepTyped(map, which, text);
                    QVERIFY(map.typed.of(which, map.map));
                }
            }
            Fractal fractal;
            fractal.name = u"random"_s;
            fractal.shape = document::Shape<2>{std::move(system)};
            QVERIFY(readEntry(io::writeEntry(fractal)) == io::asStored(fractal));
        }
    }
};

BARYCAGE_TEST(TypedCommentsTest, QCoreApplication);
#include "typed_comments_test.moc"
