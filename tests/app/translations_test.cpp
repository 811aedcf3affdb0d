// SPDX-License-Identifier: MIT
#include "attractor/colour/palette.h"
#include "attractor/colour/palette_library.h"
#include "io/collection_source.h"
#include "support/languages.h"
#include "support/named_test.h"
#include "support/paths.h"

#include <QCoreApplication>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLibraryInfo>
#include <QMap>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>
#include <QTranslator>
#include <QXmlStreamReader>

namespace {

// The languages that promise to lack nothing. The others are reported.
const QStringList complete{QStringLiteral("de"), QStringLiteral("en"), QStringLiteral("es"),
                           QStringLiteral("fr"), QStringLiteral("mk")};

struct Message {
    QString context;
    QString source;
    QString comment;
    QStringList translations; // one, or as many as the language has numbers
    bool counts = false;
    bool finished = false;

    QString key() const { return context + u'|' + source + u'|' + comment; }
};

QList<Message> messagesOf(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return {};
    QXmlStreamReader xml(&file);
    QList<Message> messages;
    QString context;
    while (xml.readNextStartElement() || !xml.atEnd()) {
        if (!xml.isStartElement()) continue;
        if (xml.name() == u"name")
            context = xml.readElementText();
        else if (xml.name() == u"message")
            messages.append(
                {context, {}, {}, {}, xml.attributes().value(QLatin1String("numerus")) == u"yes", true});
        else if (xml.name() == u"source")
            messages.last().source = xml.readElementText();
        else if (xml.name() == u"comment")
            messages.last().comment = xml.readElementText();
        else if (xml.name() == u"numerusform")
            messages.last().translations << xml.readElementText();
        else if (xml.name() == u"translation") {
            messages.last().finished = !xml.attributes().hasAttribute(QLatin1String("type"));
            if (!messages.last().counts) messages.last().translations << xml.readElementText();
        }
    }
    return messages;
}

QStringList found(const QString& pattern, const QString& text) {
    QStringList parts;
    for (auto it = QRegularExpression(pattern).globalMatch(text); it.hasNext();)
        parts << it.next().captured();
    parts.sort();
    return parts;
}

bool isShortcut(const QString& text) {
    static const QRegularExpression keys(
        QStringLiteral("^((Ctrl|Shift|Alt)\\+)*([A-Z0-9,/]|F\\d+|Ins|Del|Up|Down)$"));
    return keys.match(text).hasMatch();
}

QSet<QString> textsOfTheCollection() {
    QSet<QString> texts;
    QFile index(support::sourcePath(QStringLiteral("ifs_library/index.json")));
    if (!index.open(QIODevice::ReadOnly)) return {};
    const QJsonArray themes =
        QJsonDocument::fromJson(index.readAll()).object().value(QLatin1String("themes")).toArray();
    for (const QJsonValue& theme : themes)
        for (const char* text : {"title", "description"})
            texts << QStringLiteral("Collection|") + theme.toObject().value(QLatin1String(text)).toString() +
                         u'|';
    for (const QString& path : io::bundledCollection())
        for (const document::Entry& entry : io::readTheme(path).entries)
            texts << QStringLiteral("CollectionNames|") + entry.fractal->headerComment.trimmed() + u'|';
    return texts;
}

// What must be the same in every language; empty when it is.
QString complaint(const Message& message, const QString& translation) {
    // One of something may do without its number.
    const QString places = message.counts ? QStringLiteral("%L?[1-9]") : QStringLiteral("%L?[1-9]|%n");
    const std::pair<const char*, QString> kept[] = {
        {"placeholders", places},
        {"tags", QStringLiteral("</?\\w+>")},
        {"file patterns", QStringLiteral("\\*(\\.\\w+)?(?=[ )])")},
        {"separators of filters", QStringLiteral(";;")},
        {"blanks at the ends", QStringLiteral("^\\s+|\\s+$")},
        {"an ellipsis", QStringLiteral("…$")},
        {"a colon", QStringLiteral(":$")},
    };
    for (const auto& [what, pattern] : kept)
        if (found(pattern, message.source) != found(pattern, translation)) return QString::fromLatin1(what);
    const QString mnemonic = QStringLiteral("(?<!&)&(?=[^\\s&])");
    if (found(mnemonic, message.source).size() != found(mnemonic, translation).size())
        return QStringLiteral("the letter of the menu (&)");
    if (isShortcut(message.source) && translation != message.source) return QStringLiteral("a shortcut");
    return {};
}

} // namespace

// The catalogues of texts, and what the languages have of them.
class TranslationsTest : public QObject {
    Q_OBJECT

private slots:
    void placesOfNumbersAreKept_data() { languages(); }
    void placesOfNumbersAreKept();
    void nothingIsMissing_data() { languages(); }
    void nothingIsMissing();
    void everyTextOfTheProgramIsInTheCatalogues();
    void namesOfDataAreInTheCatalogues();
    void entriesHaveNamesInEveryLanguage();
    void qtSpeaksTheOtherLanguages_data();
    void qtSpeaksTheOtherLanguages();
    void oneIsSingular();
    void pluralsAndTheGuideAreSaid();
    void spellingIsBritish();

private:
    static QStringList textsFoundNowhere(const QSet<QString>& keys);
    static void languages() {
        QTest::addColumn<QString>("language");
        for (const char* language : {"de", "en", "es", "fr", "mk"})
            QTest::newRow(language) << QString::fromLatin1(language);
    }
    static QString catalogue(const QString& language) {
        return support::sourcePath(QStringLiteral("resources/translations/barycage_%1.ts").arg(language));
    }
};

void TranslationsTest::placesOfNumbersAreKept() {
    QFETCH(QString, language);
    const QList<Message> messages = messagesOf(catalogue(language));
    QVERIFY(messages.size() > 5);
    QStringList complaints;
    for (const Message& message : messages)
        for (const QString& translation : message.translations)
            if (const QString what = complaint(message, translation);
                !translation.isEmpty() && !what.isEmpty())
                complaints << QStringLiteral("%1: “%2” and “%3” differ in %4")
                                  .arg(message.context, message.source, translation, what);
    QVERIFY2(complaints.isEmpty(), qPrintable(complaints.join(u'\n')));
}

void TranslationsTest::nothingIsMissing() {
    QFETCH(QString, language);
    QStringList missing;
    for (const Message& message : messagesOf(catalogue(language)))
        if (!message.finished || message.translations.contains(QString())) missing << message.key();
    if (complete.contains(language))
        QVERIFY2(missing.isEmpty(), qPrintable(missing.join(u'\n')));
    else if (!missing.isEmpty())
        qInfo("%s: %lld texts are not translated yet", qPrintable(language), qlonglong(missing.size()));
}

// The texts between quotes that are marked to be translated, in the sources, without those that lupdate found
// under any context.
QStringList TranslationsTest::textsFoundNowhere(const QSet<QString>& keys) {
    QSet<QString> known;
    for (const QString& key : keys)
        known.insert(key.section(u'|', 1, -2));
    static const QRegularExpression marked(QStringLiteral(
        "\\b(?:tr\\(|(?:QT_TRANSLATE_NOOP|QT_TRANSLATE_N_NOOP|translate)\\(\\s*\"[\\w:]+\",)\\s*"
        "((?:\"(?:[^\"\\\\]|\\\\.)*\"\\s*)+)"));
    static const QRegularExpression joint(QStringLiteral("\"\\s*\""));
    QStringList overlooked;
    for (const char* folder : {"app/gui", "model", "view"})
        for (QDirIterator files(support::sourcePath(QLatin1String(folder)), {QStringLiteral("*.cpp")},
                                QDir::Files, QDirIterator::Subdirectories);
             files.hasNext();) {
            QFile file(files.next());
            if (!file.open(QIODevice::ReadOnly)) return {file.fileName()};
            const QString source = QString::fromUtf8(file.readAll());
            for (auto it = marked.globalMatch(source); it.hasNext();) {
                QString text = it.next().captured(1).trimmed().remove(joint);
                text = text.mid(1, text.size() - 2);
                for (const auto& [written, meant] : {std::pair{"\\n", "\n"}, {"\\t", "\t"}, {"\\\"", "\""}})
                    text.replace(QLatin1String(written), QLatin1String(meant));
                if (!known.contains(text)) overlooked << file.fileName() + QStringLiteral(": ") + text;
            }
        }
    return overlooked;
}

// As lupdate finds them in the sources and the index of the collection as they are now.
void TranslationsTest::everyTextOfTheProgramIsInTheCatalogues() {
    QTemporaryDir folder;
    const QString fresh = folder.filePath(QStringLiteral("fresh.ts"));
    const QString collection = folder.filePath(QStringLiteral("collection.cpp"));
    QCOMPARE(QProcess::execute(
                 QStringLiteral(BARYCAGE_CMAKE),
                 {QStringLiteral("-DINDEX=") + support::sourcePath(QStringLiteral("ifs_library/index.json")),
                  QStringLiteral("-DOUTPUT=") + collection, QStringLiteral("-P"),
                  support::sourcePath(QStringLiteral("resources/translations/collection_texts.cmake"))}),
             0);
    QProcess lupdate;
    lupdate.setProcessChannelMode(QProcess::MergedChannels);
    lupdate.start(QStringLiteral(BARYCAGE_LUPDATE),
                  {QStringLiteral("-locations"), QStringLiteral("none"), QStringLiteral("-I"),
                   support::sourcePath(QStringLiteral("view")), QStringLiteral("-I"),
                   support::sourcePath(QStringLiteral("model")), QStringLiteral("-I"),
                   support::sourcePath(QStringLiteral("app/gui")),
                   support::sourcePath(QStringLiteral("app/gui")),
                   support::sourcePath(QStringLiteral("model")), support::sourcePath(QStringLiteral("view")),
                   collection, QStringLiteral("-ts"), fresh});
    QVERIFY(lupdate.waitForFinished(120'000));
    const QString said = QString::fromUtf8(lupdate.readAll());
    QCOMPARE(lupdate.exitCode(), 0);
    // A text whose context lupdate does not know is never found by the program.
    QVERIFY2(!said.contains(QStringLiteral("lacks Q_OBJECT")) &&
                 !said.contains(QStringLiteral("without context")),
             qPrintable(said));
    QSet<QString> texts;
    QSet<QString> counting;
    for (const Message& message : messagesOf(fresh)) {
        texts.insert(message.key());
        if (message.counts) counting.insert(message.key());
    }
    QVERIFY(texts.size() > 800);
    QVERIFY(textsOfTheCollection().size() > 250);
    QVERIFY(texts.contains(textsOfTheCollection()));
    const QStringList overlooked = textsFoundNowhere(texts);
    QVERIFY2(overlooked.isEmpty(),
             qPrintable(QStringLiteral("lupdate does not collect:\n") + overlooked.join(u'\n')));
    for (const char* language : {"de", "en", "es", "fr", "mk"}) {
        const QString name = QString::fromLatin1(language);
        QSet<QString> lacking = name == QLatin1String("en") ? counting : texts;
        for (const Message& message : messagesOf(catalogue(name)))
            lacking.remove(message.key());
        const QStringList list = lacking.values();
        if (complete.contains(name))
            QVERIFY2(list.isEmpty(),
                     qPrintable(name + QStringLiteral(" (see ./dev translate):\n") + list.join(u'\n')));
        else if (!list.isEmpty())
            qInfo("%s: %lld texts are not in the catalogue; ./dev translate puts them there", language,
                  qlonglong(list.size()));
    }
}

// Texts that no tr() holds: the titles of the collection and the names of palettes.
void TranslationsTest::namesOfDataAreInTheCatalogues() {
    QSet<QString> names = textsOfTheCollection();
    for (const attractor::Palette& palette : attractor::builtInPalettes())
        names << QStringLiteral("Palette|") + QString::fromStdString(palette.name) + u'|';
    for (const attractor::LibraryPalette& entry : attractor::paletteLibrary())
        for (const std::string_view part : {entry.pattern, entry.hue})
            names << QStringLiteral("Palette|") + QString::fromStdString(std::string(part)) + u'|';
    QVERIFY(names.size() > 30);
    for (const Message& message : messagesOf(catalogue(QStringLiteral("de"))))
        names.remove(message.key());
    QVERIFY2(names.isEmpty(), qPrintable(QStringList(names.values()).join(u'\n')));
}

// Names that begin with a name of their own, as “Terdragon”, may be the same; most are not.
void TranslationsTest::entriesHaveNamesInEveryLanguage() {
    QStringList titles;
    for (const QString& path : io::bundledCollection())
        for (const document::Entry& entry : io::readTheme(path).entries)
            titles << entry.fractal->headerComment.trimmed();
    titles.removeDuplicates();
    QVERIFY(titles.size() > 200);
    for (const char* language : {"de", "es", "fr", "mk"}) {
        const support::Spoken spoken(QString::fromLatin1(language));
        QVERIFY(spoken.isInstalled());
        QSet<QString> translated;
        qsizetype same = 0;
        for (const QString& title : titles) {
            const QString name = io::bundledTitle(title);
            QVERIFY2(name.contains(u':') == title.contains(u':'), qPrintable(name)); // where it is shortened
            translated << name;
            if (name == title) ++same;
        }
        QVERIFY2(same < 10, language);
        QCOMPARE(translated.size(), titles.size()); // as many names as in English
    }
    QCOMPARE(io::bundledTitle(QStringLiteral("Koch curve")), QStringLiteral("Koch curve"));
}

void TranslationsTest::qtSpeaksTheOtherLanguages_data() {
    QTest::addColumn<QString>("catalogue");
    const QString installed = QLibraryInfo::path(QLibraryInfo::TranslationsPath);
    for (const char* language : {"de", "es", "fr"})
        QTest::newRow(language) << installed + QStringLiteral("/qtbase_%1.qm").arg(QLatin1String(language));
    QTest::newRow("mk") << QStringLiteral(":/translations/qtbase_mk.qm");
}

void TranslationsTest::qtSpeaksTheOtherLanguages() {
    QFETCH(const QString, catalogue);
    QTranslator toolkit;
    QVERIFY2(toolkit.load(catalogue), qPrintable(catalogue));
    for (const char* button : {"Cancel", "Close", "Discard", "Save", "Restore Defaults"})
        QVERIFY2(!toolkit.translate("QPlatformTheme", button).isEmpty(), button);
}

void TranslationsTest::oneIsSingular() {
    QTranslator english;
    QVERIFY(english.load(QStringLiteral(":/translations/barycage_en.qm")));
    QCOMPARE(english.translate("MainWindow", "%n entries", nullptr, 1), QStringLiteral("%n entry"));
    QCOMPARE(english.translate("MainWindow", "%n entries", nullptr, 2), QStringLiteral("%n entries"));
    QCOMPARE(english.translate("MainWindow", "%n entries", nullptr, 0), QStringLiteral("%n entries"));
}

// Nothing was pasted as “1 maps”; and there is one guide, which other languages call English.
void TranslationsTest::pluralsAndTheGuideAreSaid() {
    QTranslator english;
    QVERIFY(english.load(QStringLiteral(":/translations/barycage_en.qm")));
    QCOMPARE(english.translate("Text", "%n maps added.", nullptr, 1), QStringLiteral("%n map added."));
    for (const char* language : {"de", "es", "fr", "mk"}) {
        QTranslator other;
        QVERIFY(other.load(QStringLiteral(":/translations/barycage_%1.qm").arg(QLatin1String(language))));
        QVERIFY2(other.translate("MainWindow", "&User Guide").contains(u'('), language);
    }
}

// As in the manual: colour, centre, grey, neighbour, analyse, fibre.
void TranslationsTest::spellingIsBritish() {
    const QRegularExpression american(
        QStringLiteral("\\b(\\w*(color|behavior|neighbor|favorite|honor|labor)\\w*|(re)?center(s|ed|ing)?|"
                       "gr[a]y(s|ed|scale)?|analyz\\w+|fibers?|catalogs?|modeling|labeled|canceled|"
                       "(?!(re)?siz|priz|seiz)\\w+iz(e|es|ed|ing|ation))\\b"),
        QRegularExpression::CaseInsensitiveOption);
    QVERIFY(american.match(QStringLiteral("Choose a Color")).hasMatch());
    QVERIFY(american.match(QStringLiteral("normalized")).hasMatch());
    QVERIFY(!american.match(QStringLiteral("Resize the colour by size")).hasMatch());
    QStringList found;
    const QList<Message> messages = messagesOf(catalogue(QStringLiteral("de")));
    QVERIFY(messages.size() > 1000);
    for (const Message& message : messages)
        if (american.match(QString(message.source).remove(u'&')).hasMatch()) found << message.source;
    QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
}

BARYCAGE_TEST(TranslationsTest, QCoreApplication);
#include "translations_test.moc"
