// SPDX-License-Identifier: MIT
#include "document/edits/maps/symmetry_edits.h"
#include "io/collection_reader.h"
#include "io/exchange/text_formats.h"
#include "io/fractint/entry_writer.h"
#include "io/fractint/fractint_reader.h"
#include "io/fractint/fractint_strict.h"
#include "io/fractint/fractint_writer.h"
#include "io/fractint/symmetry_comments.h"
#include "io/text/symmetry_text.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QTest>

using document::Fractal;
using enum ifs::SymmetryGroup;

namespace {

Fractal inPlane(const ifs::Symmetry<2>& symmetry) {
    document::System2 system;
    ifs::append(system, ifs::affineMap(.5, .1, -.1, .5, .3, 0), 0.75);
    ifs::append(system, ifs::affineMap(.2, 0, 0, .3, 1, 1), 0.25);
    system.symmetry = symmetry;
    return support::fractalOf(system, QStringLiteral("star"));
}

Fractal symmetricInSpace(const ifs::Symmetry<3>& symmetry) {
    document::System3 system;
    ifs::append<3>(system, {ifs::Matrix<3>::Identity() / 3, {1, 0, 0}}, 1.0);
    system.symmetry = symmetry;
    return support::fractalOf(system, QStringLiteral("star"));
}

document::FractalFile read(const QByteArray& bytes) {
    return io::readFractint(bytes);
}

void verifyRoundTrip(const Fractal& fractal) {
    const QByteArray text = io::writeEntry(fractal);
    for (const QByteArray& line : text.split('\n'))
        QVERIFY2(line.size() < 70 || !line.contains("symmetry"), line.constData());
    const document::FractalFile file = read(text);
    QCOMPARE(file.entries.size(), 1);
    QVERIFY2(file.entries[0].problems.isEmpty(), text.constData());
    QVERIFY2(document::isSameSystem(*file.entries[0].fractal, fractal), text.constData());
}

} // namespace

class SymmetryCommentsTest : public QObject {
    Q_OBJECT

private slots:
    void everySymmetryComesBack() {
        verifyRoundTrip(inPlane({}));
        QVERIFY(!io::writeEntry(inPlane({})).contains("barycage"));
        verifyRoundTrip(inPlane({Rotation, 24, 0, {-1.2345678901234567e-100, 1e100 / 3}}));
        verifyRoundTrip(inPlane({Mirror, 1, 1.0 / 3}));
        ifs::Symmetry<2> sheared{Dihedral, 5, -12.5, {1, 2}};
        sheared.frame << 1.2345678901234567, -2.3456789012345678e-7, 3.4567890123456789e9, 1.0 / 3;
        verifyRoundTrip(inPlane(sheared));
        verifyRoundTrip(symmetricInSpace({Octahedral}));
        ifs::Symmetry<3> tilted{Icosahedral, 1, 0, {1.0 / 3, 2.0 / 3, 1e-9 / 7}};
        tilted.frame << 1.0 / 3, 1.0 / 7, 1.0 / 11, 0, 1.0 / 13, 1.0 / 17, 0, 0, 1.0 / 19;
        verifyRoundTrip(symmetricInSpace(tilted));
        verifyRoundTrip(symmetricInSpace({Dihedral, 7, 3}));
    }

    void readableInTheFile() {
        const QByteArray text = io::writeEntry(inPlane({Dihedral, 6, 15, {1, 2}}));
        QVERIFY2(text.contains("; barycage: symmetry d6:15\n"), text.constData());
        QVERIFY2(text.contains("; barycage: symmetry-centre 1 2\n"), text.constData());
    }

    // An edit of the symmetry alone changes its lines and no other byte.
    void anEditLeavesTheRowsAlone() {
        const QByteArray before = "star { ; twelve\n  .5 0 0 .50 .3 0 1 ; a\n}\n";
        document::FractalFile file = read(before);
        Fractal changed = document::withSymmetry(*file.entries[0].fractal, ifs::Symmetry<2>{Rotation, 12});
        file.entries[0].fractal = std::make_shared<const Fractal>(changed);
        const QByteArray after = io::writeFractint(file);
        QVERIFY2(after.contains("  .5 0 0 .50 .3 0 1 ; a\n"), after.constData());
        QVERIFY2(after.contains("; barycage: symmetry c12\n"), after.constData());
        document::FractalFile again = read(after);
        QVERIFY(document::isSameSystem(*again.entries[0].fractal, changed));
        again.entries[0].fractal = std::make_shared<const Fractal>(
            document::withSymmetry(*again.entries[0].fractal, ifs::Symmetry<2>{}));
        QVERIFY(!io::writeFractint(again).contains("symmetry"));
    }

    void whatDoesNotFitIsKept_data() {
        QTest::addColumn<QByteArray>("lines");
        QTest::newRow("order") << QByteArray("symmetry c25");
        QTest::newRow("unknown") << QByteArray("symmetry p4m");
        QTest::newRow("thousands") << QByteArray("symmetry c5000");
        QTest::newRow("polyhedron in the plane") << QByteArray("symmetry octahedral");
        QTest::newRow("twice") << QByteArray("symmetry c3\n; barycage: symmetry c4");
        QTest::newRow("empty") << QByteArray("symmetry");
        QTest::newRow("centre in space") << QByteArray("symmetry c3\n; barycage: symmetry-centre 1 2 3");
        QTest::newRow("no number") << QByteArray("symmetry c3\n; barycage: symmetry-centre 1 x");
        QTest::newRow("flat frame") << QByteArray("symmetry c3\n; barycage: symmetry-frame 1 1 1 1");
        QTest::newRow("long frame") << QByteArray("symmetry c3\n; barycage: symmetry-frame" +
                                                  QByteArray(" 1").repeated(10));
        QTest::newRow("only a centre") << QByteArray("symmetry-centre 1 2");
        QTest::newRow("angle of a rotation") << QByteArray("symmetry c3:10");
    }

    void whatDoesNotFitIsKept() {
        QFETCH(QByteArray, lines);
        const QByteArray text =
            "star {\n; barycage: version 1\n; barycage: " + lines + "\n .5 0 0 .5 0 0 1\n}\n";
        document::FractalFile file = read(text);
        QVERIFY(!document::isSymmetric(*file.entries[0].fractal));
        QCOMPARE(file.entries[0].problems.size(), 1);
        QVERIFY(
            file.entries[0].problems[0].message.contains(QStringLiteral("repeats each map 2 to 24 times")));
        QCOMPARE(io::writeFractint(file), text);
        Fractal changed = *file.entries[0].fractal;
        document::system2(changed)->maps[0].map.translation.x() = 3;
        file.entries[0].fractal = std::make_shared<const Fractal>(changed);
        QVERIFY2(io::writeFractint(file).contains(lines), io::writeFractint(file).constData());
    }

    void tooManyMapsAreNotMultiplied() {
        QByteArray text = "crowd (3D) {\n; barycage: version 1\n; barycage: symmetry icosahedral\n";
        for (std::size_t i = 0; i <= ifs::maxSymmetricMaps / 60; ++i)
            text += " .5 0 0 0 .5 0 0 0 .5 0 0 0 1\n";
        const document::FractalFile file = read(text + "}\n");
        QVERIFY(!document::isSymmetric(*file.entries[0].fractal));
        QVERIFY(std::ranges::any_of(file.entries[0].problems, [](const document::Problem& problem) {
            return problem.message.contains(QStringLiteral("100000"));
        }));
    }

    void otherFormatsListTheMaps() {
        const auto fractal = std::make_shared<const Fractal>(inPlane({Rotation, 6}));
        const QByteArray table = io::textOf({fractal}, io::TextFormat::Csv);
        QCOMPARE(table.trimmed().count('\n'), 12); // and the header
        QCOMPARE(io::textOf({fractal}, io::TextFormat::Aifs).count("*["), 12);
        for (const io::TextFormat format : {io::TextFormat::Csv, io::TextFormat::Aifs})
            QVERIFY(io::lossOf(format, *fractal)->contains(QStringLiteral("symmetry")));
        QVERIFY(!io::lossOf(io::TextFormat::Fractint, *fractal));
        QVERIFY(!io::lossOf(io::TextFormat::Csv, inPlane({})));
        document::FractalFile file = read(io::writeEntry(*fractal));
        const io::StrictText strict = io::writeStrict(file);
        QVERIFY(!strict.bytes.contains("barycage"));
        QCOMPARE(document::system2(*read(strict.bytes).entries[0].fractal)->maps.size(), 12);
        QVERIFY(std::ranges::any_of(strict.problems, [](const document::Problem& problem) {
            return problem.message.contains(QStringLiteral("symmetry"));
        }));
    }

    void names() {
        QCOMPARE(io::symmetryNamed(u"C6")->order, 6);
        QCOMPARE(io::symmetryNamed(u"d4:15@1,-2")->centre, (std::vector<double>{1, -2}));
        QCOMPARE(*io::symmetryNamed(u"mirror:30")->angle, 30);
        QCOMPARE(int(io::symmetryNamed(u"icosahedral@0,0,1")->group), int(Icosahedral));
        QCOMPARE(int(io::symmetryNamed(u"none")->group), int(None));
        for (const char16_t* text :
             {u"", u"c", u"c1", u"c25", u"c-3", u"c007", u"d+4", u"c6:10", u"c6@1", u"c6@1,2,3,4", u"c6@x,y",
              u"mirror:", u"mirror:x", u"c6@", u"@1,2", u"mirror2"})
            QVERIFY2(!io::symmetryNamed(QStringView(text)), qPrintable(QString::fromUtf16(text)));
        QVERIFY(!io::symmetryIn<2>(*io::symmetryNamed(u"octahedral")));
        QVERIFY(!io::symmetryIn<2>(*io::symmetryNamed(u"c6@1,2,3")));
        QCOMPARE(io::symmetryIn<3>(*io::symmetryNamed(u"c6@1,2"))->centre, ifs::Vector<3>(1, 2, 0));
    }
};

BARYCAGE_TEST(SymmetryCommentsTest);
#include "symmetry_comments_test.moc"
