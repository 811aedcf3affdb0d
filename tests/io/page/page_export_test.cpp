// SPDX-License-Identifier: MIT
#include "io/page/page_export.h"

#include "attractor/colour/palette.h"
#include "document/edits/cage/cage_edits.h"
#include "document/moments/animated_fractal.h"
#include "io/collection_reader.h"
#include "io/page/page_script.h"
#include "notation/page/page_text.h"
#include "support/named_test.h"
#include "support/paths.h"

#include <QCryptographicHash>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QSet>

#include <algorithm>

// What is written into a web page. How it behaves in a browser is for tests/web/page_test.mjs.
class PageExportTest : public QObject {
    Q_OBJECT

private slots:
    void everyEntryOfTheCollectionHasAPage_data();
    void everyEntryOfTheCollectionHasAPage();
    void hostileTextsStayTexts();
    void onlyWhatIsNamedMayRun();
    void stillPicturesOfDustAreSmall();
    void optionsAreWritten();
    void everyLanguageHasEveryText();
    void scriptsAreInOnePiece();
    void aScriptForArticlesHoldsTheEngineOnce();
    void entriesThatCannotBeShown();
};

namespace {

document::Fractal entryOf(const QByteArray& text) {
    return *io::readCollection(text).file.entries.front().fractal;
}

QByteArray gasket(const QByteArray& name, const QByteArray& comments = {}) {
    return name + " {\n" + comments + " .5 0 0 .5 0 0\n .5 0 0 .5 .5 0\n .5 0 0 .5 0 .5\n}\n";
}

// The text of the element with this beginning.
QByteArray inside(const QByteArray& page, const QByteArray& begin, const QByteArray& end) {
    const qsizetype at = page.indexOf(begin);
    if (at < 0) return {};
    const qsizetype from = at + begin.size();
    return page.sliced(from, page.indexOf(end, from) - from);
}

QJsonObject contentOf(const QByteArray& page) {
    return QJsonDocument::fromJson(
               inside(page, R"(<script type="application/json" id="content">)", "</script>"))
        .object();
}

qsizetype count(const QByteArray& page, const char* what) {
    return page.count(what);
}

} // namespace

void PageExportTest::everyEntryOfTheCollectionHasAPage_data() {
    QTest::addColumn<QString>("file");
    for (const char* name :
         {"paper.ifs", "linked.ifs", "space_sponges.ifs", "motion.ifs", "transformations.ifs"})
        QTest::newRow(name) << support::sourcePath(QStringLiteral("ifs_library/") + QLatin1String(name));
}

void PageExportTest::everyEntryOfTheCollectionHasAPage() {
    QFETCH(QString, file);
    QFile collection(file);
    QVERIFY(collection.open(QIODevice::ReadOnly));
    for (const document::Entry& entry : io::readCollection(collection.readAll()).file.entries.first(2)) {
        QCOMPARE(io::pageObstacle(*entry.fractal), QString());
        io::PageExport what;
        what.fractal = *entry.fractal;
        const QByteArray page = io::pageOf(what);
        const bool moves = document::animationFacts(*entry.fractal).has_value();
        const qsizetype limit = document::space(*entry.fractal) ? 600'000 : moves ? 500'000 : 450'000;
        QVERIFY2(page.size() <= limit, QByteArray::number(page.size()));
        static const QRegularExpression field(QStringLiteral("\\{\\{[a-z-]+\\}\\}"));
        QVERIFY(!field.match(QString::fromUtf8(page)).hasMatch()); // all are filled in
        const QJsonObject shown = contentOf(page)[u"entry"].toObject();
        const int dimension = document::dimension(*entry.fractal);
        QCOMPARE(shown[u"name"].toString(), entry.fractal->name);
        QCOMPARE(shown[u"dimension"].toInt(), dimension);
        QVERIFY(!shown[u"maps"].toArray().isEmpty());
        for (const QJsonValue map : shown[u"maps"].toArray())
            QCOMPARE(map.toArray().size(), dimension * (dimension + 1) + 1);
        QCOMPARE(shown.contains(u"view"), dimension == 3);
        // The lines of the entry are those that a collection has.
        QByteArray text = shown[u"text"][u"begin"].toString().toUtf8() + '\n';
        for (const char* part : {"lines", "rows"})
            for (const QJsonValue line : shown[u"text"][QLatin1String(part)].toArray())
                text += line.toString().toUtf8() + '\n';
        const document::Fractal read = entryOf(text + "}\n");
        QVERIFY(document::isSameSystem(read, *entry.fractal));
        QVERIFY(read.appearance == entry.fractal->appearance);
    }
}

void PageExportTest::hostileTextsStayTexts() {
    io::PageExport what;
    what.fractal = entryOf(gasket("x</script><script>alert(1)</script>", "; <!-- </script> {{script}}\n"));
    what.caption = QStringLiteral("</style><script>alert(2)</script> \"&amp;' {{content}}");
    const QByteArray page = io::pageOf(what);
    QVERIFY(!page.contains("<script>alert"));
    QVERIFY(!page.contains("<!--"));
    QCOMPARE(count(page, "<script"), 5);
    QCOMPARE(count(page, "</script"), 5);
    QCOMPARE(count(page, "<style"), 1);
    QCOMPARE(count(page, "</style"), 1);
    QVERIFY(page.contains("&lt;/style&gt;&lt;script&gt;alert(2)&lt;/script&gt; &quot;&amp;amp;"));
    QCOMPARE(contentOf(page)[u"entry"][u"name"].toString(), what.fractal.name);
}

// The policy names the hash of the script and of the style, and no other source.
void PageExportTest::onlyWhatIsNamedMayRun() {
    io::PageExport what;
    what.fractal = document::sierpinskiTriangle();
    what.size = QSize(640, 480);
    const QByteArray page = io::pageOf(what);
    const QByteArray policy = inside(page, R"(<meta http-equiv="Content-Security-Policy" content=")", "\"");
    QVERIFY(policy.startsWith("default-src 'none'; script-src 'sha256-"));
    for (const auto& [begin, end] : {std::pair("<style>", "</style>"), std::pair("<script>", "</script>")}) {
        const QByteArray text = inside(page, begin, end);
        QVERIFY(!text.isEmpty());
        const QByteArray hash = QCryptographicHash::hash(text, QCryptographicHash::Sha256).toBase64();
        QVERIFY2(policy.contains("'sha256-" + hash + "'"), begin);
    }
    QVERIFY(!policy.contains("unsafe-inline") && !policy.contains("'unsafe-eval'") &&
            !policy.contains("http"));
    QVERIFY(!page.contains(" style=\"") && !page.contains("onclick"));
    QVERIFY(!page.contains("innerHTML"));
}

// A gasket fills the picture with single points, which pack badly.
void PageExportTest::stillPicturesOfDustAreSmall() {
    io::PageExport what;
    what.fractal = entryOf(gasket("gasket"));
    const QByteArray page = io::pageOf(what);
    const QByteArray jpeg = QByteArray::fromBase64(inside(page, "src=\"data:image/jpeg;base64,", "\""));
    QVERIFY2(jpeg.size() <= 26'000, QByteArray::number(jpeg.size()));
    QCOMPARE(QImage::fromData(jpeg).size(), QSize(640, 480));
}

void PageExportTest::optionsAreWritten() {
    io::PageExport what;
    what.fractal =
        entryOf(gasket("gasket", "; barycage: rest 0 0\n; barycage: rest 2 0\n; barycage: rest 0 2\n"
                                 "; barycage: current 0 0\n; barycage: current 2 1\n; barycage: current 0 2\n"
                                 "; barycage: background #ffffff00\n"));
    what.parts = io::PageParts::Figure;
    what.allowsCode = false;
    what.language = QStringLiteral("mk");
    what.size = QSize(720, 540);
    what.points = 5'000'000;
    const QByteArray page = io::pageOf(what);
    const QJsonObject content = contentOf(page);
    QCOMPARE(content[u"show"].toString(), QStringLiteral("figure"));
    QCOMPARE(content[u"allow"].toArray(), (QJsonArray{QStringLiteral("cage"), QStringLiteral("maps")}));
    QCOMPARE(content[u"language"].toString(), QStringLiteral("mk"));
    QCOMPARE(content[u"points"].toInt(), 5'000'000);
    const QJsonArray current{QJsonArray{0, 0}, QJsonArray{2, 1}, QJsonArray{0, 2}};
    QCOMPARE(content[u"entry"][u"cage"][u"current"].toArray(), current);
    QVERIFY(page.contains("--figure-width: 720px; --figure-ratio: 720 / 540"));
    QVERIFY(page.contains("background: transparent"));
    QVERIFY(page.contains("<html lang=\"mk\">"));
    QVERIFY(page.contains("JavaScript."));
    QVERIFY(page.contains("src=\"data:image/jpeg;base64,"));
}

// A page speaks all languages, or its own alone. What one says, all say, with the same places to be filled.
void PageExportTest::everyLanguageHasEveryText() {
    io::PageExport what;
    what.fractal = document::sierpinskiTriangle();
    const auto textsOf = [&] {
        return QJsonDocument::fromJson(
                   inside(io::pageOf(what), R"(<script type="application/json" id="texts">)", "</script>"))
            .object();
    };
    const QJsonObject all = textsOf();
    QCOMPARE(all.size(), qsizetype(io::pageLanguages.size()));
    const QJsonObject english = all[u"en"].toObject();
    QVERIFY(english.size() > 30);
    static const QRegularExpression place(QStringLiteral("\\{\\d\\}"));
    const auto placesIn = [&](const QJsonValue& text) {
        QStringList places;
        auto matches = place.globalMatch(text.toString());
        while (matches.hasNext())
            places << matches.next().captured();
        places.sort();
        return places;
    };
    for (const char* name : io::pageLanguages) {
        const QString language = QLatin1String(name);
        const QJsonObject texts = all[language].toObject();
        QCOMPARE(texts.keys(), english.keys());
        QCOMPARE(texts[u"palettes"].toArray().size(), qsizetype(attractor::builtInPalettes().size()));
        for (const QString& key : english.keys()) {
            QVERIFY2(key == u"palettes" || !texts[key].toString().isEmpty(), qPrintable(language + key));
            QVERIFY2(placesIn(texts[key]) == placesIn(english[key]), qPrintable(language + key));
        }
        what.language = language;
        QCOMPARE(textsOf(), (QJsonObject{{language, texts}}));
    }
}

// Modules lose their imports, and no name is declared by two of them.
void PageExportTest::scriptsAreInOnePiece() {
    static const QRegularExpression declared(
        QStringLiteral("^(?:export )?(?:async )?(?:const|let|class|function) (\\w+)"),
        QRegularExpression::MultilineOption);
    for (const auto& modules : {notation::pageModules("gallery.js"), notation::pageModules("lesson.js"),
                                notation::workerModules()}) {
        const QByteArray script = io::joinedScript(modules);
        QVERIFY(!script.contains("\nimport ") && !script.contains("\nexport "));
        QVERIFY(!script.contains("/**\n") && !script.contains("SPDX"));
        QVERIFY(!script.contains("</") && !script.contains("<!--"));
        QSet<QString> names;
        for (const std::string& module : modules) {
            auto matches = declared.globalMatch(QString::fromUtf8(io::pagePart(module)));
            while (matches.hasNext()) {
                const QString name = matches.next().captured(1);
                QVERIFY2(!names.contains(name), qPrintable(name));
                names.insert(name);
            }
        }
        QVERIFY(names.size() > 5);
    }
}

void PageExportTest::aScriptForArticlesHoldsTheEngineOnce() {
    io::PageExport what;
    what.fractal = entryOf(gasket("gasket"));
    what.fractal.name = QStringLiteral("Ж </script> “é”");
    const QByteArray script = io::scriptOf(what);
    QVERIFY(std::ranges::all_of(script, [](char c) { return static_cast<unsigned char>(c) < 128; }));
    const QJsonObject figures = QJsonDocument::fromJson(inside(script, "\nembed(", ");\n})();")).object();
    QCOMPARE(figures[u"title"].toString(), what.fractal.name);
    QCOMPARE(figures[u"engine"].toString().toStdString(),
             notation::inBase85(io::pagePart("engine_plane.wasm.gz").toStdString()));
    QVERIFY(!figures[u"worker"].toString().isEmpty());
    const QByteArray page = figures[u"page"].toString().toUtf8();
    QCOMPARE(contentOf(page), contentOf(io::pageOf(what)));
    QVERIFY(inside(page, R"(id="engine">)", "</script>").isEmpty());
    QVERIFY(inside(page, R"(id="worker">)", "</script>").isEmpty());
    QVERIFY(page.contains("sha256-" + QCryptographicHash::hash(inside(page, "<script>", "</script>"),
                                                               QCryptographicHash::Sha256)
                                          .toBase64()));
}

void PageExportTest::entriesThatCannotBeShown() {
    QVERIFY(!io::pageObstacle(document::Fractal()).isEmpty());
    QByteArray rows;
    for (int i = 0; i < 2001; ++i)
        rows += " .5 0 0 .5 0 0 1\n";
    QVERIFY(io::pageObstacle(entryOf("many {\n" + rows + "}\n")).contains(QStringLiteral("2001")));
}

BARYCAGE_TEST(PageExportTest);
#include "page_export_test.moc"
