// SPDX-License-Identifier: MIT
#include "document/edits/maps/link_edits.h"
#include "document/edits/maps/maps_edits.h"
#include "ifs/links/linked_systems.h"
#include "io/exchange/flame.h"
#include "io/exchange/text_formats.h"
#include "io/fractint/fractint_reader.h"
#include "io/fractint/metadata_comments.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QTest>

using document::Fractal;

namespace {

std::shared_ptr<const Fractal> linked(const document::System2& system) {
    Fractal fractal = support::fractalOf(system, QStringLiteral("linked"));
    return std::make_shared<const Fractal>(fractal);
}

QByteArray textOf(const Fractal& fractal, io::TextFormat format) {
    return io::textOf({std::make_shared<const Fractal>(fractal)}, format);
}

QByteArray entry(const QByteArray& lines,
                 const QByteArray& rows = " .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n") {
    return "linked {\n; barycage: version 1\n" + lines + rows + "}\n";
}

document::System2 systemIn(const document::FractalFile& file) {
    return *document::system2(*file.entries.first().fractal);
}

} // namespace

// Links in files: .ifs and flames keep them, the others say that they do not.
class LinkedFilesTest : public QObject {
    Q_OBJECT

private slots:
    void ifsKeepsThem() {
        auto golden = linked_systems::goldenMean();
        ifs::setLink(golden, {ifs::MapId{1}, ifs::MapId{2}, 1.0 / 3});
        for (const auto& system : {golden, linked_systems::threeOnALine(), linked_systems::rauzy(),
                                   linked_systems::dragonBoundary()}) {
            const QByteArray bytes = textOf(*linked(system), io::TextFormat::Fractint);
            const auto file = io::readFractint(bytes);
            for (const auto& problem :
                 file.entries.first().problems) // of the weights, which sum to more than 1
                QVERIFY2(!problem.message.contains(QStringLiteral("link")), qPrintable(problem.message));
            QCOMPARE(systemIn(file).links, system.links);
            for (const QByteArray& line : bytes.split('\n'))
                QVERIFY(!line.startsWith("; barycage:") || line.size() < 70);
        }
        QVERIFY(textOf(*linked(golden), io::TextFormat::Fractint)
                    .contains("; barycage: links 1 1 0.3333333333333333\n"));
    }

    void theWeightsOfRowsStay() {
        auto system = linked_systems::threeOnALine();
        system.maps[0].weight = 7;
        ifs::setLinks(system, std::vector<double>{1, 1, 0, 0, 0, 0, 1, 0, 0}); // 2 ends, 3 is unreached
        const auto back = systemIn(io::readFractint(textOf(*linked(system), io::TextFormat::Fractint)));
        for (std::size_t i = 0; i < 3; ++i)
            QCOMPARE(back.maps[i].weight, system.maps[i].weight);
    }

    void flamesKeepThem() {
        const auto system = linked_systems::threeOnALine();
        const QByteArray bytes = io::writeFlame({linked(system)});
        QVERIFY(bytes.contains("chaos=\"0 1 0\"") && bytes.contains("chaos=\"1 0 1\""));
        QCOMPARE(systemIn(io::readFlame(bytes)).links, system.links);
        QVERIFY(!io::writeFlame({linked(document::System2{system.maps})}).contains("chaos"));
    }

    // A row may be shorter, and the order of rows and columns is that of flam3.
    void rowsOfFlames() {
        const auto file = io::readFlame(
            "<flame name=\"a\"><xform weight=\"1\" linear=\"1\" coefs=\".5 0 0 .5 0 0\"/>"
            "<xform weight=\"1\" linear=\"1\" coefs=\".5 0 0 .5 1 0\" chaos=\"0.25\"/></flame>");
        QCOMPARE(systemIn(file).links, (std::vector<ifs::Link>{{ifs::MapId{2}, ifs::MapId{1}, 0.25}}));
    }

    void flamesRefused_data() {
        QTest::addColumn<QByteArray>("chaos");
        QTest::newRow("negative") << QByteArray("1 -1");
        QTest::newRow("nan") << QByteArray("nan 1");
        QTest::newRow("words") << QByteArray("a b");
        QTest::newRow("too large") << QByteArray("1 1e999");
    }
    void flamesRefused() {
        QFETCH(QByteArray, chaos);
        const auto file = io::readFlame("<flame name=\"a\"><xform weight=\"1\" linear=\"1\" "
                                        "coefs=\".5 0 0 .5 0 0\" chaos=\"" +
                                        chaos + "\"/></flame>");
        QVERIFY(file.entries.isEmpty());
        QVERIFY(file.problems.first().message.contains(QStringLiteral("chaos")));
    }

    void hostileComments_data() {
        QTest::addColumn<QByteArray>("lines");
        QTest::newRow("negative") << QByteArray("; barycage: links 1 1 -1\n");
        QTest::newRow("nan") << QByteArray("; barycage: links 1 1 nan\n");
        QTest::newRow("no number") << QByteArray("; barycage: links 1 1 x\n");
        QTest::newRow("short") << QByteArray("; barycage: links 1 1\n");
        QTest::newRow("long") << QByteArray("; barycage: links 1 1 1\n; barycage: links 1 1\n");
        QTest::newRow("no such map") << QByteArray("; barycage: links 9 1 1\n");
    }
    void hostileComments() {
        QFETCH(QByteArray, lines);
        const auto file = io::readFractint(entry(lines));
        QVERIFY(systemIn(file).links.empty());
        QCOMPARE(file.entries.first().problems.size(), 1);
        QVERIFY(file.entries.first().problems.first().message.contains(QStringLiteral("links of map")));
    }

    void nothingTakesPart() {
        const auto file = io::readFractint(entry("; barycage: links 1 0 0\n; barycage: links 2 0 0\n"));
        QCOMPARE(ifs::countActive(systemIn(file)), std::size_t(0));
        QVERIFY(
            file.entries.first().problems.first().message.contains(QStringLiteral("sequence of maps ends")));
    }

    void spaceKeepsTheLines() {
        const QByteArray bytes = "solid (3D) {\n; barycage: version 1\n; barycage: links 1 0\n"
                                 " .5 0 0 0 .5 0 0 0 .5 0 0 0 1\n}\n";
        const auto file = io::readFractint(bytes);
        QVERIFY(document::system3(*file.entries.first().fractal)->links.empty());
        QVERIFY(file.entries.first().problems.first().message.contains(QStringLiteral("cannot be linked")));
    }

    void othersSayWhatTheyLose() {
        const auto fractal = linked(linked_systems::rauzy());
        for (const auto format : {io::TextFormat::Aifs, io::TextFormat::Csv, io::TextFormat::Tsv}) {
            const auto loss = io::lossOf(format, *fractal);
            QVERIFY(loss && loss->contains(QStringLiteral("links")));
            QVERIFY(loss->contains(QStringLiteral("different picture")));
        }
        QVERIFY(!io::lossOf(io::TextFormat::Fractint, *fractal));
        const auto flame = io::lossOf(io::TextFormat::Flame, *fractal);
        QVERIFY(!flame || !flame->contains(QStringLiteral("links")));
    }

    void edits() {
        const auto fractal = linked(linked_systems::threeOnALine());
        const auto systemOf = [](const Fractal& f) { return *document::system2(f); };
        const auto doubled = document::withDuplicates(*fractal, {2});
        QCOMPARE(ifs::linkMatrix(systemOf(doubled.fractal)),
                 (std::vector<double>{0, 1, 0, 0, 0, 0, 1, 1, 1, 0, 1, 1, 1, 0, 1, 1}));
        const auto moved = document::withMapsMoved(*fractal, {2}, 0);
        QCOMPARE(ifs::linkMatrix(systemOf(moved.fractal)), (std::vector<double>{1, 1, 0, 0, 0, 1, 1, 0, 0}));
        const auto fewer = document::withoutMaps(*fractal, {1});
        QCOMPARE(ifs::linkMatrix(systemOf(fewer.fractal)), (std::vector<double>{0, 0, 1, 1}));
        const auto more = document::withNewMap(fewer.fractal); // any map leads to it, and it to any
        QCOMPARE(ifs::linkMatrix(systemOf(more.fractal)), (std::vector<double>{0, 0, 1, 1, 1, 1, 1, 1, 1}));
        const auto linked = document::withLink(*fractal, 0, 0, 2);
        QCOMPARE(ifs::linkMatrix(systemOf(linked))[0], 2.0);
        QVERIFY(systemOf(document::withoutLinks(linked)).links.empty());
        QCOMPARE(io::asStored(moved.fractal), io::asStored(io::asStored(moved.fractal)));
        QCOMPARE(ifs::linkMatrix(systemOf(io::asStored(moved.fractal))),
                 ifs::linkMatrix(systemOf(moved.fractal)));
    }
};

BARYCAGE_TEST(LinkedFilesTest, QCoreApplication);
#include "linked_files_test.moc"
