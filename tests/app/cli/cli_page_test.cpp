// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

// Web pages that barycage-cli writes; tests/web/page_test.mjs opens them in a browser.
class CliPageTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void aPageIsWritten();
    void theFirstReadableEntryIsShown();
    void optionsReachThePage();
    void aGalleryHasAllEntriesThatCanBeShown();
    void aLessonHasItsStepsAndWhatTheyShow();
    void wrongUsage_data();
    void wrongUsage();
    void whatCannotBeWritten();
};

void CliPageTest::aPageIsWritten() {
    const Result result = run("page systems.ifs --entry maple -o maple.html");
    QCOMPARE(result.status, 0);
    QCOMPARE(result.err, QByteArray());
    const QByteArray page = read("maple.html");
    QVERIFY(page.startsWith("<!doctype html>"));
    QVERIFY(page.endsWith("</html>\n"));
    QVERIFY(page.contains("<title>maple</title>"));
    QCOMPARE(run("page systems.ifs --entry maple -o -").out, page);
    QCOMPARE(run("page - --entry maple -o -", read("systems.ifs")).out, page);
}

void CliPageTest::theFirstReadableEntryIsShown() {
    const Result result = run("page broken.ifs -o page.html");
    QCOMPARE(result.status, run("render broken.ifs --size 10x10 -o page.png").status);
    QVERIFY(read("page.html").contains("\"dimension\": 2"));
}

void CliPageTest::optionsReachThePage() {
    QCOMPARE(run("page systems.ifs --show table --allow code --caption \"x < y\" --lang de --size 640x480 "
                 "--points 3M "
                 "-o page.html")
                 .status,
             0);
    const QByteArray page = read("page.html");
    QVERIFY(page.contains("data-show=\"table\""));
    QVERIFY(page.contains("\"allow\": [\"code\"]"));
    QVERIFY(page.contains("<p class=\"caption\" id=\"caption\">x &lt; y</p>"));
    QVERIFY(page.contains("<html lang=\"de\">"));
    QVERIFY(page.contains("--figure-width: 640px"));
    QVERIFY(page.contains("\"points\": 3e+06"));
    QCOMPARE(run("page systems.ifs --allow none -o page.html").status, 0);
    QVERIFY(read("page.html").contains("\"allow\": []"));
    QCOMPARE(run("page systems.ifs --allow cage,maps -o page.html").status, 0);
    QVERIFY(read("page.html").contains("\"allow\": [\"cage\", \"maps\"]"));
    QCOMPARE(run("page systems.ifs -o page.html").status, 0);
    QVERIFY(read("page.html").contains("\"allow\": [\"cage\", \"maps\", \"code\"]"));
}

void CliPageTest::aGalleryHasAllEntriesThatCanBeShown() {
    const Result result = run("page systems.ifs --all --caption \"x < y\" -o gallery.html");
    QCOMPARE(result.status, 0);
    const QByteArray page = read("gallery.html");
    QVERIFY(page.contains("<title>Systems</title>"));
    QVERIFY(page.contains("\"title\": \"Systems\""));
    QVERIFY(page.contains("\"caption\": \"x \\u003c y\""));
    const QByteArray names = run("info systems.ifs --names").out;
    for (const QByteArray& name : names.trimmed().split('\n'))
        QVERIFY2(page.contains("\"name\": \"" + name + '"'), name);
    QCOMPARE(page.count("\"dimension\": "), names.count('\n'));
    QCOMPARE(page.count("id=\"engine\""), 1);
    // What cannot be read is left out, and said.
    const Result broken = run("page broken.ifs --all -o broken.html");
    QVERIFY2(broken.err.contains("warning"), broken.err);
    QVERIFY(read("broken.html").contains("\"dimension\": 2"));
    write("none.ifs", "none {\n 1 2 3\n}\n");
    const Result none = run("page none.ifs --all -o none.html");
    QCOMPARE(none.status, 1);
    QVERIFY2(none.err.contains("no entry that can be drawn"), none.err);
    QVERIFY(!QFile::exists(path("none.html")));
}

void CliPageTest::aLessonHasItsStepsAndWhatTheyShow() {
    write("leaf.ifs", "gasket {\n .5 0 0 .5 0 0\n .5 0 0 .5 .5 0\n .5 0 0 .5 0 .5\n}\n"
                      "dust {\n .3 0 0 .3 0 0\n .3 0 0 .3 .7 .7\n .3 0 0 .3 0 .7\n}\n");
    write(
        "leaf.lesson",
        "lesson: Leaves < trees\nfile: other.ifs\n\n## First\nentry: dust\n\nLook </script> here.\n\n"
        "## Second\nentry: gasket\ntool: maps\nview: area 0.25 0.5 2 1\ncage: 0 0, 1 0.5, 0 1\n\nDrag it.\n\n"
        "## Third\n\nThe same entry, as it was.\n\n## Fourth\nentry: dust\nconstruction: steps 3\n\nSee.\n");
    const Result result = run("page leaf.ifs --lesson leaf.lesson -o lesson.html");
    QCOMPARE(result.status, 0);
    QVERIFY2(result.err.contains("in these steps: 4"), result.err);
    const QByteArray page = read("lesson.html");
    QVERIFY(page.contains("<title>Leaves &lt; trees</title>"));
    const qsizetype from = page.indexOf("id=\"content\">") + 13;
    const QJsonObject content =
        QJsonDocument::fromJson(page.sliced(from, page.indexOf("</script>", from) - from)).object();
    const QJsonArray steps = content[u"steps"].toArray(), entries = content[u"entries"].toArray();
    QCOMPARE(steps.size(), 4);
    QCOMPARE(steps[0][u"text"].toString(), QStringLiteral("Look </script> here."));
    QCOMPARE(steps[1][u"maps"].toBool(), true);
    QCOMPARE(steps[1][u"area"].toArray(), (QJsonArray{0.25, 0.5, 2, 1}));
    QVERIFY(!steps[0].toObject().contains(u"area"));
    // Dust, the gasket with its cage moved, and as it is: what is the same stands there once.
    QCOMPARE(entries.size(), 3);
    QCOMPARE(entries[steps[0][u"entry"].toInt()][u"name"].toString(), QStringLiteral("dust"));
    QCOMPARE(entries[steps[1][u"entry"].toInt()][u"cage"][u"current"].toArray(),
             (QJsonArray{QJsonArray{0, 0}, QJsonArray{1, 0.5}, QJsonArray{0, 1}}));
    QCOMPARE(entries[steps[2][u"entry"].toInt()][u"name"].toString(), QStringLiteral("gasket"));
    QVERIFY(!entries[steps[2][u"entry"].toInt()].toObject().contains(u"cage"));
    QCOMPARE(steps[3][u"entry"], steps[0][u"entry"]);
    // What cannot be shown is named.
    write("bad.lesson", "lesson: Bad\nfile: leaf.ifs\n\n## One\nentry: nobody\n\nText.\n");
    const Result bad = run("page leaf.ifs --lesson bad.lesson -o bad.html");
    QCOMPARE(bad.status, 1);
    QVERIFY2(bad.err.contains("Step 1: the collection has no entry “nobody”"), bad.err);
    QCOMPARE(run("page leaf.ifs --lesson leaf.ifs -o none.html").status, 1);
    QCOMPARE(run("page leaf.ifs --lesson nothing.lesson -o none.html").status, 3);
    QVERIFY(!QFile::exists(path("none.html")));
}

void CliPageTest::wrongUsage_data() {
    QTest::addColumn<QByteArray>("options");
    QTest::addColumn<QByteArray>("sentence");
    QTest::newRow("allow") << QByteArray("--allow maps,colours")
                           << QByteArray("--allow “maps,colours” is not valid");
    QTest::newRow("show") << QByteArray("--show everything") << QByteArray("--show");
    QTest::newRow("language") << QByteArray("--lang it") << QByteArray("--lang");
    QTest::newRow("points") << QByteArray("--points 12") << QByteArray("--points");
    QTest::newRow("entries") << QByteArray("--entry all") << QByteArray("A page shows one entry");
    QTest::newRow("lesson and one") << QByteArray("--lesson a.lesson --entry maple")
                                    << QByteArray("--lesson");
    QTest::newRow("lesson and all") << QByteArray("--lesson a.lesson --all") << QByteArray("--lesson");
    QTest::newRow("all and one") << QByteArray("--all --entry maple") << QByteArray("--all");
}

void CliPageTest::wrongUsage() {
    QFETCH(QByteArray, options);
    QFETCH(QByteArray, sentence);
    const Result result = run("page systems.ifs -o page2.html " + options);
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.contains(sentence), result.err);
    QVERIFY(!QFile::exists(path("page2.html")));
}

void CliPageTest::whatCannotBeWritten() {
    QCOMPARE(run("page systems.ifs --entry nobody -o page3.html").status, 1);
    QVERIFY(!QFile::exists(path("page3.html")));
    QCOMPARE(run("page nothing.ifs -o page3.html").status, 3);
    QCOMPARE(run("page systems.ifs -o nowhere/page3.html").status, 3);
    QByteArray rows;
    for (int i = 0; i < 2001; ++i)
        rows += " .5 0 0 .5 0 0 1\n";
    write("many.ifs", "many {\n" + rows + "}\n");
    const Result many = run("page many.ifs -o page3.html -q");
    QCOMPARE(many.status, 1);
    QVERIFY2(many.err.contains("2001 maps; a web page can have at most 2000"), many.err);
}

BARYCAGE_TEST(CliPageTest, QGuiApplication);
#include "cli_page_test.moc"
