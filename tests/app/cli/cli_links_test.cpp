// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"

#include <QImage>
#include <QJsonArray>
#include <QTest>

#include <cmath>

using namespace Qt::StringLiterals;

// Linked maps on the command line.
class CliLinksTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void init();
    void infoShowsThem();
    void infoShowsWhatTakesNoPart();
    void drawsThem();
    void convertsThem();
    void expandsNothingElse();
    void expandsWhatIsPlain();
    void refusesWhatIsNot();
    void expandsSymmetryAndLinks();
    void saysThatTransformationsAreLost();
};

void CliLinksTest::init() {
    write("golden.ifs", "golden {\n; barycage: version 1\n; barycage: links 2 1 0\n"
                        " .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n}\n");
    write("ends.ifs", "ends {\n; barycage: version 1\n; barycage: links 1 1 1 0\n; barycage: links 2 0 0 0\n"
                      "; barycage: links 3 1 0 0\n"
                      " .5 0 0 .5 0 0 1\n .5 0 0 .5 .5 0 1\n .5 0 0 .5 0 .5 1\n}\n");
}

void CliLinksTest::infoShowsThem() {
    const auto result = run("info --json golden.ifs");
    QCOMPARE(result.status, 0);
    const QJsonObject entry = result.entry();
    QCOMPARE(entry["links"_L1].toArray().at(1).toArray(), (QJsonArray{1, 0}));
    QCOMPARE(entry["link_states"_L1].toArray(), (QJsonArray{u"takes_part"_s, u"takes_part"_s}));
    // 2 is always followed by 1, and 1 by either: π = (2/3, 1/3)
    compare(entry["visits"_L1].toArray().at(0).toDouble(), 2 / 3.0, 1e-15);
    compare(entry["similarity_dimension"_L1].toDouble(), 0.694241913630617, 1e-14);
    compare(entry["bounding_box"_L1].toObject()["max"_L1].toArray().at(0).toDouble(), 2 / 3.0, 1e-13);
    // A₁ = w₁(A₁ ∪ A₂) and A₂ = w₂(A₁): [0, 1/3] and [1/2, 2/3]
    const auto side = [&](int part, const char* end) {
        return entry["parts"_L1].toArray().at(part).toObject()[QLatin1String(end)].toArray().at(0).toDouble(
            9);
    };
    compare(side(0, "min"), 0, 1e-9);
    compare(side(0, "max"), 1 / 3.0, 1e-9);
    compare(side(1, "min"), 0.5, 1e-9);
    compare(side(1, "max"), 2 / 3.0, 1e-9);
    for (const char* key : {"separation", "connectedness", "joint_spectral_radius"})
        QVERIFY(entry[QLatin1String(key)].isNull());
    const QByteArray text = run("info golden.ifs").out;
    QVERIFY(text.contains("links from map 2") && text.contains("part of map 2"));
    const QJsonObject plain = run("info --json systems.ifs").entry();
    QVERIFY(plain["links"_L1].isNull() && plain["parts"_L1].isNull());
}

void CliLinksTest::infoShowsWhatTakesNoPart() {
    const QJsonObject entry = run("info --json ends.ifs").entry();
    QCOMPARE(entry["link_states"_L1].toArray(), (QJsonArray{u"takes_part"_s, u"ends"_s, u"unreached"_s}));
    QCOMPARE(entry["maps"_L1].toArray().at(1).toObject()["weight"_L1].toDouble(), 0.0);
    QCOMPARE(entry["maps"_L1].toArray().at(1).toObject()["weight_in_file"_L1].toDouble(), 1.0);
    const QByteArray text = run("info ends.ifs").out;
    QVERIFY(text.contains("the chaos game ends") && text.contains("no map leads to it"));
}

void CliLinksTest::drawsThem() {
    for (const char* algorithm :
         {"density --points 50000", "chaos-game --points 50000", "deterministic --iterations 5"}) {
        const auto result = run(QByteArray("render golden.ifs -o out.png --size 300x40 --view "
                                           "0.5,0,0.14 --background black --algorithm ") +
                                algorithm);
        QCOMPARE(result.status, 0);
        const QImage image(path("out.png"));
        const auto brightest = [&](double from, double to) {
            int most = 0;
            for (int x = int(from * 286 + 7); x < int(to * 286 + 7); ++x)
                for (int y = 0; y < image.height(); ++y)
                    most = std::max(most, qGray(image.pixel(x, y)));
            return most;
        };
        QVERIFY2(brightest(0, 0.1) > 20, algorithm);
        QVERIFY2(brightest(0.72, 1) < 10, algorithm); // 11… is forbidden
    }
    const auto svg = run("render golden.ifs -o out.svg");
    QCOMPARE(svg.status, 1);
    QVERIFY(svg.err.contains("linked"));
}

void CliLinksTest::convertsThem() {
    QCOMPARE(run("convert golden.ifs golden.flame").status, 0);
    QVERIFY(read("golden.flame").contains("chaos=\"1 0\""));
    QCOMPARE(run("convert golden.flame back.ifs").status, 0);
    QVERIFY(read("back.ifs").contains("; barycage: links 2 1 0"));
    const auto table = run("convert golden.ifs golden.csv");
    QVERIFY(table.err.contains("links"));
    // Even where the maps that take part are as good as unlinked.
    QVERIFY(run("convert ends.ifs ends.csv").err.contains("the links of its maps"));
    const auto strict = run("convert --strict golden.ifs strict.ifs");
    QVERIFY(strict.err.contains("links") && !read("strict.ifs").contains("links"));
}

// What is not worked out for linked maps is refused with a sentence.
void CliLinksTest::expandsNothingElse() {
    for (const char* command : {"morph golden.ifs --from golden --to golden -o out.ifs",
                                "steal golden.ifs --entry golden --from golden --tear 0.01",
                                "render golden.ifs --overlay hull -o out.png"}) {
        const auto result = run(command);
        QVERIFY2(result.status != 0 && result.err.contains("linked"), result.err);
    }
}

// The golden mean shift is the attractor of w1 and w2 w1.
void CliLinksTest::expandsWhatIsPlain() {
    const auto result = run("convert --expand golden.ifs plain.ifs");
    QCOMPARE(result.status, 0);
    QVERIFY2(result.err.contains("other densities"), result.err);
    QVERIFY(!read("plain.ifs").contains("links"));
    const QJsonObject entry = run("info --json plain.ifs").entry();
    QVERIFY(entry["links"_L1].isNull());
    QCOMPARE(entry["maps"_L1].toArray().size(), 2);
    compare(entry["similarity_dimension"_L1].toDouble(), 0.694241913630617, 1e-14);
    compare(entry["bounding_box"_L1].toObject()["max"_L1].toArray().at(0).toDouble(), 2 / 3.0, 1e-13);
    QCOMPARE(run("render plain.ifs -o plain.svg").status, 0); // which linked maps cannot have
    // Maps that take no part are switched off.
    QCOMPARE(run("convert --expand ends.ifs --to csv -").status, 0);
    const auto off = run("convert --expand ends.ifs off.ifs");
    QCOMPARE(off.status, 0);
    QVERIFY(!off.err.contains("densities") && !read("off.ifs").contains("links"));
    const QJsonArray maps = run("info --json off.ifs").entry()["maps"_L1].toArray();
    QCOMPARE(maps.at(0).toObject()["weight"_L1].toDouble(), 1.0);
    QCOMPARE(maps.at(1).toObject()["weight"_L1].toDouble(), 0.0);
    QCOMPARE(maps.at(2).toObject()["weight"_L1].toDouble(), 0.0);
}

void CliLinksTest::refusesWhatIsNot() {
    write("line.ifs",
          "line {\n; barycage: links 1 0 1 0\n; barycage: links 2 0 0 1\n; barycage: links 3 1 0 1\n"
          " .3 0 0 .3 0 0 1\n .3 0 0 .3 .3 0 1\n .3 0 0 .3 .6 0 1\n}\n");
    for (const char* output : {"line.csv", "plain.ifs", "line.flame"}) {
        const auto result = run(QByteArray("convert --expand line.ifs ") + output);
        QCOMPARE(result.status, 1);
        QVERIFY2(result.err.contains("cannot be written as plain maps"), result.err);
    }
    write("void.ifs", "void {\n; barycage: links 1 0 1\n; barycage: links 2 0 0\n"
                      " .3 0 0 .3 0 0 1\n .3 0 0 .3 .3 0 1\n}\n");
    const auto result = run("convert --expand void.ifs plain.ifs");
    QCOMPARE(result.status, 1);
    QVERIFY2(result.err.contains("every sequence of maps ends"), result.err);
}

void CliLinksTest::expandsSymmetryAndLinks() {
    QCOMPARE(run("convert --symmetry c3 golden.ifs round.ifs").status, 0);
    QCOMPARE(run("convert --expand round.ifs plain.ifs").status, 0);
    const QJsonObject entry = run("info --json plain.ifs").entry();
    QVERIFY(entry["links"_L1].isNull() && entry["symmetry"_L1].isNull());
    // γw1, and γw2 γ'w1
    QCOMPARE(entry["maps"_L1].toArray().size(), 3 + 9);
    const auto width = [&](const char* file) {
        const QJsonObject box = run(QByteArray("info --json ") + file).entry()["bounding_box"_L1].toObject();
        return box["max"_L1].toArray().at(0).toDouble() - box["min"_L1].toArray().at(0).toDouble();
    };
    compare(width("plain.ifs"), width("round.ifs"), 1e-9);
}

void CliLinksTest::saysThatTransformationsAreLost() {
    write("pair.ifs", "f {\n; barycage: partner g\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n}\n"
                      "g {\n .3 0 0 .3 0 0 .5\n .3 0 0 .3 .7 0 .5\n}\n");
    for (const char* output : {"f.csv", "f.flame", "f.aifs"}) {
        const auto result = run(QByteArray("convert pair.ifs --entry f ") + output);
        QCOMPARE(result.status, 0);
        QVERIFY2(result.err.contains("fractal transformation"), output);
    }
    const auto strict = run("convert --strict pair.ifs strict.ifs");
    QVERIFY(strict.err.contains("fractal transformation"));
    QVERIFY(!read("strict.ifs").contains("partner"));
    QVERIFY(run("convert pair.ifs same.ifs").err.isEmpty());
}

BARYCAGE_TEST(CliLinksTest, QGuiApplication);
#include "cli_links_test.moc"
