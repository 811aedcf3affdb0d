// SPDX-License-Identifier: MIT
#include "document/maps/map_names.h"
#include "io/exchange/flame.h"
#include "io/exchange/text_formats.h"
#include "io/fractint/entry_writer.h"
#include "io/fractint/fractint_reader.h"
#include "io/fractint/fractint_strict.h"
#include "io/fractint/fractint_writer.h"
#include "io/fractint/metadata_comments.h"
#include "support/named_test.h"

#include <QTest>

#include <random>

using document::Fractal;
using document::MapLabel;

namespace {

Fractal fern(const QList<MapLabel>& labels) {
    document::System2 system;
    Fractal fractal;
    fractal.name = QStringLiteral("fern");
    for (const MapLabel& label : labels) {
        const ifs::MapId id = ifs::append(system, ifs::affineMap(.5, 0, 0, .5, double(system.maps.size()), 0),
                                          1.0 / double(labels.size()));
        fractal.mapLabels.set(id, label);
    }
    fractal.shape = document::Shape<2>{std::move(system)};
    return fractal;
}

Fractal labelled(const QList<MapLabel>& labels) {
    document::System3 system;
    Fractal fractal;
    fractal.name = QStringLiteral("fern");
    for (const MapLabel& label : labels) {
        const ifs::MapId id =
            ifs::append<3>(system, {ifs::Matrix<3>::Identity() / 2, {double(system.maps.size()), 0, 0}},
                           1.0 / double(labels.size()));
        fractal.mapLabels.set(id, label);
    }
    fractal.shape = document::Shape<3>{std::move(system)};
    return fractal;
}

Fractal readBack(const QByteArray& text) {
    const document::FractalFile file = io::readFractint(text);
    return file.entries.isEmpty() ? Fractal() : *file.entries.first().fractal;
}

MapLabel labelAt(const Fractal& fractal, std::size_t index) {
    if (const auto* system = document::system2(fractal)) return fractal.mapLabels.of(system->maps[index].id);
    return fractal.mapLabels.of(document::system3(fractal)->maps[index].id);
}

} // namespace

class LabelCommentsTest : public QObject {
    Q_OBJECT

private slots:
    void readableInTheFile() {
        const QByteArray text = io::writeEntry(
            fern({{QStringLiteral("stem"), false}, {{}, true}, {QStringLiteral("left leaf"), true}, {}}));
        QVERIFY2(text.contains("; barycage: map-name 1 stem\n"), text.constData());
        QVERIFY2(text.contains("; barycage: map-name 3 left leaf\n"), text.constData());
        QVERIFY2(text.contains("; barycage: locked 2 3\n"), text.constData());
        QVERIFY(!io::writeEntry(fern({{}, {}})).contains("barycage: map"));
    }

    void anyNameComesBack_data() {
        QTest::addColumn<QString>("name");
        QTest::newRow("braces") << QStringLiteral("} evil { ; x");
        QTest::newRow("percent") << QStringLiteral("100 % %41 %7D");
        QTest::newRow("letters") << QStringLiteral("лист ñ 葉 🌿🌿");
        QTest::newRow("backslash") << QStringLiteral("a \\");
        QTest::newRow("long") << QStringLiteral("a long name of several words ").repeated(4).left(115);
        QTest::newRow("long and wide") << QStringLiteral("葉").repeated(120);
        QTest::newRow("long and braced") << QStringLiteral("}").repeated(120);
        QTest::newRow("a number") << QStringLiteral("2");
    }

    void anyNameComesBack() {
        QFETCH(QString, name);
        for (const Fractal& fractal : {fern({{}, {name, true}}), labelled({{}, {name, true}})}) {
            const QByteArray text = io::writeEntry(fractal);
            for (const QByteArray& line : text.split('\n'))
                QVERIFY2(line.size() < 70, line.constData());
            const Fractal back = readBack(text);
            QCOMPARE(labelAt(back, 1).name, name);
            QVERIFY(labelAt(back, 1).isLocked && !labelAt(back, 0).isLocked);
            QCOMPARE(io::writeEntry(back), text);
        }
    }

    // Whatever a name is made of, the file can be read, and has what asStored() promises.
    void everyTextIsSafe() {
        std::mt19937 random(3);
        for (int round = 0; round < 400; ++round) {
            QString name;
            for (unsigned k = random() % 40; k > 0; --k) {
                static const char16_t odd[] = {u'\n', u'\r',  u' ',   u'{',   u'}',   u'%',   u';',
                                               u'\t', 0x85,   0x2028, 0x202e, 0x2066, 0xd83c, 0xdf3f,
                                               0,     0xfeff, 0xffff, 0x200d, 0xa0,   u'a',   0xe9};
                name += QChar(odd[random() % std::size(odd)]);
            }
            const Fractal fractal = fern({{name, round % 2 == 0}, {}});
            const document::FractalFile file = io::readFractint(io::writeEntry(fractal));
            QCOMPARE(file.entries.size(), 1);
            QVERIFY(file.entries.first().problems.isEmpty());
            const Fractal stored = io::asStored(fractal);
            QVERIFY(file.entries.first().fractal->mapLabels == stored.mapLabels);
            QVERIFY(io::asStored(stored) == stored);
            const QString kept = labelAt(stored, 0).name;
            QVERIFY(!kept.contains(u'\n') && !kept.contains(QChar(0x202e)) && kept == kept.trimmed());
        }
    }

    // What others may have written; what cannot be meant stays as it is.
    void readsLeniently() {
        const Fractal fractal = readBack("fern {\n"
                                         "; barycage: map-name   2   two   words\n"
                                         "; barycage: map-name 1 a%7g\n"
                                         "; barycage: map-name 1 b%zz%20c\n"
                                         "; barycage: map-name 9 nobody\n"
                                         "; barycage: map-name 0 nobody\n"
                                         "; barycage: map-name 2\n"
                                         "; barycage: locked 2 7 2\n"
                                         "; barycage: locked x\n"
                                         " .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n");
        QCOMPARE(labelAt(fractal, 0).name, QStringLiteral("a%7gb%zz c"));
        QCOMPARE(labelAt(fractal, 1).name, QStringLiteral("two words"));
        QVERIFY(labelAt(fractal, 1).isLocked && !labelAt(fractal, 0).isLocked);
    }

    void aNameAloneChangesItsLineAlone() {
        const QByteArray before = "fern { ; two\n  .5 0 0 .50 .3 0 1 ; a\n}\n";
        document::FractalFile file = io::readFractint(before);
        Fractal named = *file.entries[0].fractal;
        named.mapLabels.set(document::system2(named)->maps[0].id, {QStringLiteral("stem"), false});
        file.entries[0].fractal = std::make_shared<const Fractal>(named);
        const QByteArray after = io::writeFractint(file);
        QVERIFY2(after.contains("  .5 0 0 .50 .3 0 1 ; a\n"), after.constData());
        QVERIFY2(after.contains("; barycage: map-name 1 stem\n"), after.constData());
        document::FractalFile again = io::readFractint(after);
        QVERIFY(*again.entries[0].fractal == named);
    }

    // Labels are numbered as the maps are, however many have gone.
    void asStoredRenumbers() {
        Fractal fractal = fern({{QStringLiteral("a"), false}, {QStringLiteral("b"), true}, {}});
        auto& maps = document::system2(fractal)->maps;
        maps.erase(maps.begin());
        const Fractal stored = io::asStored(fractal);
        QCOMPARE(labelAt(stored, 0), (MapLabel{QStringLiteral("b"), true}));
        QVERIFY(readBack(io::writeEntry(fractal)).mapLabels == stored.mapLabels);
    }

    void flamesCarryNames() {
        const auto fractal = std::make_shared<const Fractal>(
            fern({{QStringLiteral("a <b> & \"c\""), true}, {}, {QStringLiteral("葉"), false}}));
        const QByteArray text = io::writeFlame({fractal});
        const document::FractalFile file = io::readFlame(text);
        QCOMPARE(file.entries.size(), 1);
        const Fractal& back = *file.entries.first().fractal;
        QCOMPARE(labelAt(back, 0), (MapLabel{QStringLiteral("a <b> & \"c\""), false}));
        QCOMPARE(labelAt(back, 1), MapLabel());
        QCOMPARE(labelAt(back, 2).name, QStringLiteral("葉"));
        const document::FractalFile foreign =
            io::readFlame("<flame name=\"f\"><xform weight=\"1\" linear=\"1\" name=\" left&#10;leaf \" "
                          "coefs=\".5 0 0 .5 0 0\"/></flame>");
        QCOMPARE(labelAt(*foreign.entries.first().fractal, 0).name, QStringLiteral("left leaf"));
    }

    void whatIsLostIsSaid() {
        const Fractal named = fern({{QStringLiteral("stem"), false}, {}});
        const Fractal locked = fern({{{}, true}, {}});
        QVERIFY(io::lossOf(io::TextFormat::Tsv, named)->contains(QStringLiteral("names")));
        QVERIFY(io::lossOf(io::TextFormat::Tsv, locked)->contains(QStringLiteral("locks")));
        QVERIFY(!io::lossOf(io::TextFormat::Flame, named));
        QVERIFY(io::lossOf(io::TextFormat::Flame, locked)->contains(QStringLiteral("locks")));
        QVERIFY(!io::lossOf(io::TextFormat::Fractint, locked));
        QVERIFY(!io::lossOf(io::TextFormat::Tsv, fern({{}, {}})));
    }
};

BARYCAGE_TEST(LabelCommentsTest, QCoreApplication);
#include "label_comments_test.moc"
