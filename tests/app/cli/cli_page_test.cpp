// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"

#include <QTest>

// Web pages that barycage-cli writes; tests/web/page_test.mjs opens them in a browser.
class CliPageTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void aPageIsWritten();
    void theFirstReadableEntryIsShown();
    void optionsReachThePage();
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
    QVERIFY(page.contains("<p class=\"caption\">x &lt; y</p>"));
    QVERIFY(page.contains("<html lang=\"de\">"));
    QVERIFY(page.contains("--figure-width: 640px"));
    QVERIFY(page.contains("\"points\": 3e+06"));
    QCOMPARE(run("page systems.ifs --allow none -o page.html").status, 0);
    QVERIFY(read("page.html").contains("\"allow\": []"));
}

void CliPageTest::wrongUsage_data() {
    QTest::addColumn<QByteArray>("options");
    QTest::addColumn<QByteArray>("sentence");
    QTest::newRow("allow") << QByteArray("--allow maps") << QByteArray("--allow “maps” is not valid");
    QTest::newRow("show") << QByteArray("--show everything") << QByteArray("--show");
    QTest::newRow("language") << QByteArray("--lang it") << QByteArray("--lang");
    QTest::newRow("points") << QByteArray("--points 12") << QByteArray("--points");
    QTest::newRow("entries") << QByteArray("--entry all") << QByteArray("A page shows one entry");
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
