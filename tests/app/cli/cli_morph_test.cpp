// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"

#include <QJsonArray>
#include <QTest>

// barycage-cli morph.
class CliMorphTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void init();
    void aMorphLeadsFromOneToTheOther();
    void theLengthIsThatGiven();
    void pinnedMapsBelongTogether();
    void movedBranchesStayBehind();
    void animationsStayBehind();
    void whatMakesNoSenseIsRefused_data();
    void whatMakesNoSenseIsRefused();
    void whatCannotBeMorphedIsSaid();
    void warningsAreSaidOnce();

private:
    QJsonArray maps(const QByteArray& input) const {
        return run("info --json " + input).entry()[QLatin1String("maps")].toArray();
    }
};

namespace {

// The maps of the second are listed the other way round.
const QByteArray near = "near {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 8 0 .5\n}\n";
const QByteArray far = "far {\n .5 0 0 .5 8 1 .5\n .5 0 0 .5 0 1 .5\n}\n";
const QByteArray solid = "solid (3D) {\n .5 0 0 0 .5 0 0 0 .5 0 0 0 .5\n .5 0 0 0 .5 0 0 0 .5 1 0 0 .5\n}\n";
const QByteArray grows = "grows {\n 2 0 0 2 0 0 .5\n 2 0 0 2 1 0 .5\n}\n"; // no attractor

} // namespace

void CliMorphTest::init() {
    QByteArray many = "many {\n";
    for (int i = 0; i < 257; ++i)
        many += " .1 0 0 .1 " + QByteArray::number(i) + " 0 1\n";
    write("ends.ifs", near + far + solid + grows + many + "}\n");
}

void CliMorphTest::aMorphLeadsFromOneToTheOther() {
    const Result result = run("morph ends.ifs --from near --to far -o morph.ifs");
    QCOMPARE(result.err, QByteArray());
    QCOMPARE(result.status, 0);
    QCOMPARE(maps("morph.ifs --frame 0"), maps("ends.ifs --entry near"));
    // Maps keep their places in the first, and each is paired with the nearest one of the second.
    const QJsonArray end = maps("morph.ifs --frame 120"), wanted = maps("ends.ifs --entry far");
    QCOMPARE(end.size(), 2);
    QCOMPARE(end[0], wanted[1]);
    QCOMPARE(end[1], wanted[0]);
    QVERIFY(maps("morph.ifs --frame 60") != end);
}

void CliMorphTest::theLengthIsThatGiven() {
    const auto frames = [&] {
        return run("info --json morph.ifs").entry()[QLatin1String("animation")][QLatin1String("frames")];
    };
    QCOMPARE(run("morph ends.ifs --from near --to far -o morph.ifs").status, 0);
    const int usual = frames().toInt();
    QCOMPARE(run("morph ends.ifs --from near --to far --length 30 -o morph.ifs").status, 0);
    QCOMPARE(usual - frames().toInt(), 90);
}

void CliMorphTest::pinnedMapsBelongTogether() {
    QCOMPARE(run("morph ends.ifs --from near --to far --pin 1:1 -o morph.ifs").status, 0);
    QCOMPARE(maps("morph.ifs --frame 120"), maps("ends.ifs --entry far"));
}

void CliMorphTest::whatMakesNoSenseIsRefused_data() {
    QTest::addColumn<QByteArray>("options");
    QTest::addColumn<QByteArray>("words");
    const QByteArray ends = "--from near --to far ";
    QTest::newRow("a pin from 0") << ends + "--pin 0:1" << QByteArray("0:1");
    QTest::newRow("no such map") << ends + "--pin 1:3" << QByteArray("1:3");
    QTest::newRow("half a pin") << ends + "--pin 1" << QByteArray("“1”");
    QTest::newRow("three parts") << ends + "--pin 1:2:3" << QByteArray("1:2:3");
    QTest::newRow("no length") << ends + "--length 0" << QByteArray("--length");
    QTest::newRow("no frames") << ends + "--length 1.5" << QByteArray("--length");
    QTest::newRow("no end") << QByteArray("--from near") << QByteArray("--to");
}

void CliMorphTest::whatMakesNoSenseIsRefused() {
    QFETCH(const QByteArray, options);
    QFETCH(const QByteArray, words);
    const Result result = run("morph ends.ifs -o refused.ifs " + options);
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.contains(words), result.err.constData());
    QVERIFY(read("refused.ifs").isEmpty());
}

void CliMorphTest::whatCannotBeMorphedIsSaid() {
    const auto said = [&](const QByteArray& ends) {
        const Result result = run("morph ends.ifs -o none.ifs " + ends);
        return result.status == 1 && read("none.ifs").isEmpty() ? result.err : QByteArray("no failure");
    };
    QVERIFY2(said("--from near --to solid").contains("space"), said("--from near --to solid").constData());
    QVERIFY2(said("--from many --to far").contains("“many” has more than 256 maps"),
             said("--from many --to far").constData());
    QVERIFY2(said("--from near --to many").contains("“many”"), said("--from near --to many").constData());
    QVERIFY2(said("--from grows --to near").contains("“grows”"), said("--from grows --to near").constData());
    QVERIFY2(said("--from near --to grows").contains("“grows”"), said("--from near --to grows").constData());
    QVERIFY(said("--from near --to nobody").contains("nobody"));
}

void CliMorphTest::movedBranchesStayBehind() {
    write("moved.ifs",
          "moved {\n; barycage: branch 1\n; barycage: by 1 0\n; barycage: by 0 1\n; barycage: by 2 0\n"
          " .5 0 0 .5 0 0 .5\n .5 0 0 .5 8 0 .5\n}\n" +
              far);
    const Result result = run("morph moved.ifs --from moved --to far -o morph.ifs");
    QVERIFY2(result.err.contains("moved branches"), result.err.constData());
    QVERIFY(read("morph.ifs").contains("track map"));
}

void CliMorphTest::animationsStayBehind() {
    write("moving.ifs",
          "moving {\n; barycage: animation 8 24/1 cycle\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 8 0 .5\n}\n" + far);
    const Result result = run("morph moving.ifs --from moving --to far -o morph.ifs");
    QCOMPARE(result.status, 0);
    QVERIFY2(result.err.contains("The animation of “moving” is not part of the morph."),
             result.err.constData());
}

void CliMorphTest::warningsAreSaidOnce() {
    // Of the file (a byte order mark), of an entry, and of its moved branches.
    write("odd.ifs", "\xef\xbb\xbf"
                     "odd {\n; barycage: branch 1\n; barycage: by 1 0\n; barycage: by 0 1\n"
                     "; barycage: by 2 0\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 8 0 .6\n}\n" +
                         far);
    for (const QByteArray to : {"far", "odd"}) {
        const QByteArray said = run("morph odd.ifs --from odd --to " + to + " -o morph.ifs").err;
        QByteArrayList lines = said.trimmed().split('\n');
        QCOMPARE(lines.size(), 3);
        QCOMPARE(lines.removeAll(lines.first()), 1);
        QVERIFY2(said.count("The weights sum to") == 1, said.constData());
        QVERIFY2(said.count("moved branches") == 1, said.constData());
    }
}

BARYCAGE_TEST(CliMorphTest, QGuiApplication);
#include "cli_morph_test.moc"
