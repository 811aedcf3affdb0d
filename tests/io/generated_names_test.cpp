// SPDX-License-Identifier: MIT
#include "document/fractal/fractal.h"
#include "io/animation/cluster_job.h"
#include "io/exchange/text_formats.h"
#include "io/export_job.h"
#include "io/file/native_path.h"
#include "io/fractint/fractint_reader.h"
#include "io/page/page_export.h"
#include "io/solid/openscad.h"
#include "support/faults.h"
#include "support/named_test.h"
#include "support/paths.h"
#include "support/thorough.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QProcess>
#include <QProcessEnvironment>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include <random>

// What is generated from an entry with a hostile name is run, or read by a parser of its language: it does
// and says what it does with a tame name.
class GeneratedNamesTest : public QObject {
    Q_OBJECT

private slots:
    void latexHasNoOtherCommands();
    void openScadHasNoOtherCode();
    void xmlHasNoOtherParts();
    void tablesHaveNoOtherRows();
    void pagesHaveNoOtherTags();
    void scriptsRunNothingElse();
};

namespace {

// Made of what ends or begins something in one of the languages.
QStringList hostileNames(int count) {
    const QString parts[]{QStringLiteral("$(touch pwned)"),
                          QStringLiteral("`touch pwned`"),
                          QStringLiteral("; touch pwned;"),
                          QStringLiteral("'"),
                          QStringLiteral("\""),
                          QStringLiteral("\\"),
                          QStringLiteral("\n"),
                          QStringLiteral("\r"),
                          QStringLiteral("\u2028"),
                          QStringLiteral("\u0085"),
                          QStringLiteral("\f"),
                          QStringLiteral("*/"),
                          QStringLiteral("/*"),
                          QStringLiteral("//"),
                          QStringLiteral("}"),
                          QStringLiteral("{"),
                          QStringLiteral("%"),
                          QStringLiteral("#"),
                          QStringLiteral("&"),
                          QStringLiteral("_"),
                          QStringLiteral("^"),
                          QStringLiteral("~"),
                          QStringLiteral("$"),
                          QStringLiteral("\\input{/etc/passwd}"),
                          QStringLiteral("\\end{document}"),
                          QStringLiteral("\\write18{touch pwned}"),
                          QStringLiteral("^^5cinput"),
                          QStringLiteral("-->"),
                          QStringLiteral("<!--"),
                          QStringLiteral("]]>"),
                          QStringLiteral("<script>"),
                          QStringLiteral("</script>"),
                          QStringLiteral("</title>"),
                          QStringLiteral("<svg onload=a>"),
                          QStringLiteral("&#10;"),
                          QStringLiteral("cube(9);"),
                          QStringLiteral("=cmd|' /C calc'!A0"),
                          QStringLiteral("\u202e"),
                          QStringLiteral("-n"),
                          QStringLiteral("../"),
                          QStringLiteral(" "),
                          QStringLiteral("name"),
                          QStringLiteral("\U0001f33f"),
                          QStringLiteral(","),
                          QStringLiteral("\t")};
    std::mt19937 random(7);
    QStringList names;
    for (const QString& part : parts)
        names << part + QStringLiteral("name");
    while (names.size() < count) {
        QString name;
        for (int i = 0; i < 5; ++i)
            name += parts[random() % std::size(parts)];
        names << name;
    }
    return names.first(count);
}

constexpr int allParts = 45;
int namesToTry() {
    return support::isThorough() ? 2000 : 150;
}

std::shared_ptr<const document::Fractal> plane(const QString& name) {
    auto fractal = std::make_shared<document::Fractal>(document::sierpinskiTriangle());
    fractal->name = name;
    return fractal;
}

document::Fractal entryFrom(const QByteArray& text, const QString& name) {
    document::Fractal fractal = *io::readFractint(text).entries.first().fractal;
    fractal.name = name;
    return fractal;
}

document::Fractal solid(const QString& name) {
    return entryFrom("a (3D) {\n .5 0 0 0 .5 0 0 0 .5 0 0 0 .5\n .5 0 0 0 .5 0 0 0 .5 1 0 1 .5\n}\n", name);
}

// The control sequences of the text, and the braces, mathematics and comments that are open at its end.
struct Tex {
    QSet<QString> commands;
    int depth = 0;
    int dollars = 0;
    int comments = 0;
    int lines = 0;
};
Tex tokens(const QString& text) {
    Tex found;
    for (qsizetype at = 0; at < text.size(); ++at) {
        const QChar c = text[at];
        if (c == u'\\') {
            qsizetype end = at + 1;
            while (end < text.size() && text[end].unicode() < 128 && text[end].isLetter())
                ++end;
            end = std::max(end, std::min(at + 2, text.size()));
            found.commands << text.sliced(at + 1, end - at - 1);
            at = end - 1;
        } else if (c == u'%') {
            ++found.comments;
            at = text.indexOf(u'\n', at);
            if (at < 0) break;
            ++found.lines;
        } else {
            found.depth += c == u'{' ? 1 : c == u'}' ? -1 : 0;
            found.dollars += c == u'$' ? 1 : 0;
            found.lines += c == u'\n' ? 1 : 0;
            if (text.sliced(at).startsWith(u"^^")) found.commands << QStringLiteral("^^");
        }
    }
    return found;
}

// Without comments and with nothing between quotation marks; a name ends neither.
QString codeOf(const QString& text) {
    QString code;
    for (qsizetype at = 0; at < text.size(); ++at) {
        if (text.sliced(at).startsWith(u"//")) {
            at = text.indexOf(QRegularExpression(QStringLiteral("[\n\r]")), at);
            if (at < 0) break;
        } else if (text.sliced(at).startsWith(u"/*")) {
            at = text.indexOf(QStringLiteral("*/"), at) + 1;
            continue;
        } else if (text[at] == u'"') {
            for (++at; at < text.size() && text[at] != u'"'; ++at)
                at += text[at] == u'\\' ? 1 : 0;
        }
        code += text[at];
    }
    return code;
}

// The elements with the names of their attributes; what is wrong with the text, if something is.
QStringList elementsOf(const QByteArray& text) {
    QStringList elements;
    QXmlStreamReader xml(text);
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isStartElement()) {
            QString element = xml.name().toString();
            const QXmlStreamAttributes attributes = xml.attributes();
            for (const QXmlStreamAttribute& attribute : attributes)
                element += u' ' + attribute.name().toString();
            elements << element;
        } else if (xml.isDTD() || xml.isProcessingInstruction() || xml.isEntityReference()) {
            elements << QStringLiteral("!") + xml.tokenString();
        }
    }
    if (xml.hasError()) elements << xml.errorString();
    return elements;
}

QByteArray bytesIn(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void writeProgram(const QString& path, const QByteArray& text) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
    QVERIFY(file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
}

} // namespace

void GeneratedNamesTest::latexHasNoOtherCommands() {
    const auto latex = [](const QString& name) {
        return QString::fromUtf8(io::textOf({plane(name)}, io::TextFormat::Latex));
    };
    const Tex tame = tokens(latex(QStringLiteral("name")));
    QVERIFY(tame.commands.size() > 5 && tame.depth == 0);
    // Those that stand for a sign.
    const QStringList signs{QStringLiteral("\\"),
                            QStringLiteral("{"),
                            QStringLiteral("}"),
                            QStringLiteral("$"),
                            QStringLiteral("&"),
                            QStringLiteral("#"),
                            QStringLiteral("_"),
                            QStringLiteral("%"),
                            QStringLiteral("textbackslash"),
                            QStringLiteral("textasciitilde"),
                            QStringLiteral("textasciicircum"),
                            QStringLiteral("textless"),
                            QStringLiteral("textgreater"),
                            QStringLiteral("textbar"),
                            QStringLiteral("textquotedbl"),
                            QStringLiteral("textquotesingle"),
                            QStringLiteral("textasciigrave"),
                            QStringLiteral("^"),
                            QStringLiteral("~")};
    for (const QString& name : hostileNames(namesToTry())) {
        const Tex found = tokens(latex(name));
        const QByteArray said = name.toUtf8().toPercentEncoding() + ": " + latex(name).left(400).toUtf8();
        for (const QString& command : found.commands)
            QVERIFY2(tame.commands.contains(command) || signs.contains(command),
                     ("\\" + command.toUtf8() + " in " + said).constData());
        QVERIFY2(found.depth == 0 && found.dollars == tame.dollars, said.constData());
        QVERIFY2(found.comments == tame.comments && found.lines == tame.lines, said.constData());
    }
}

void GeneratedNamesTest::openScadHasNoOtherCode() {
    const auto code = [](const QString& name) {
        return codeOf(QString::fromUtf8(io::openScad(solid(name)).text));
    };
    const QString tame = code(QStringLiteral("name"));
    QVERIFY(tame.contains(u"cube") || tame.contains(u"module"));
    for (const QString& name : hostileNames(namesToTry()))
        QVERIFY2(code(name) == tame, name.toUtf8().toPercentEncoding().constData());
}

void GeneratedNamesTest::xmlHasNoOtherParts() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.svg"));
    const auto svg = [&](const QString& name) {
        io::SvgExport what;
        what.fractal = *plane(name);
        what.camera.width = what.camera.height = 32;
        const io::ExportOutcome outcome = io::exportTo(what, path);
        return outcome.failure ? QStringList(*outcome.failure) : elementsOf(bytesIn(path));
    };
    const auto flame = [](const QString& name) {
        return elementsOf(io::textOf({plane(name)}, io::TextFormat::Flame));
    };
    const QStringList tameSvg = svg(QStringLiteral("name")), tameFlame = flame(QStringLiteral("name"));
    QVERIFY(tameSvg.size() > 3 && tameSvg.first().startsWith(u"svg"));
    QVERIFY(tameFlame.size() > 3);
    for (const QString& name : hostileNames(namesToTry())) {
        QCOMPARE(svg(name), tameSvg);
        QCOMPARE(flame(name), tameFlame);
    }
}

void GeneratedNamesTest::tablesHaveNoOtherRows() {
    for (const auto format : {io::TextFormat::Csv, io::TextFormat::Tsv, io::TextFormat::Aifs}) {
        const auto lines = [&](const QString& name) {
            return io::textOf({plane(name)}, format).split('\n').size();
        };
        const auto tame = lines(QStringLiteral("name"));
        for (const QString& name : hostileNames(namesToTry()))
            QVERIFY2(lines(name) == tame, name.toUtf8().toPercentEncoding().constData());
    }
}

// By Python's parser, as lenient as a browser.
void GeneratedNamesTest::pagesHaveNoOtherTags() {
    const QTemporaryDir folder;
    const QStringList names =
        QStringList(QStringLiteral("name")) + hostileNames(support::isThorough() ? namesToTry() : allParts);
    for (qsizetype i = 0; i < names.size(); ++i) {
        io::PageExport page;
        page.fractal = *plane(names[i]);
        page.caption = names[names.size() - 1 - i];
        QFile file(folder.filePath(QStringLiteral("%1.html").arg(i, 4, 10, QChar(u'0'))));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(io::pageOf(page));
    }
    writeProgram(folder.filePath(QStringLiteral("tags.py")), R"(
import glob, html.parser, json, sys
class Tags(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.tags, self.content, self.inside = [], '', False
    def handle_starttag(self, tag, attributes):
        self.inside = tag == 'script' and ('id', 'content') in attributes
        self.tags.append((tag, [name for name, value in attributes]))
    def handle_endtag(self, tag):
        self.inside = False
        self.tags.append('/' + tag)
    def handle_comment(self, text):
        self.tags.append('comment')
    def handle_data(self, text):
        if self.inside: self.content += text
first = None
for name in sorted(glob.glob(sys.argv[1] + '/*.html')):
    tags = Tags()
    tags.feed(open(name, encoding='utf-8', newline='').read())
    json.loads(tags.content)
    first = first or tags.tags
    if tags.tags != first:
        print(name, [a for a in tags.tags if a not in first])
print(len(first))
)");
    QProcess python;
    python.start(QStringLiteral("python3"), {folder.filePath(QStringLiteral("tags.py")), folder.path()});
    QVERIFY(python.waitForFinished(120'000));
    const QByteArray said = python.readAllStandardOutput() + python.readAllStandardError();
    QVERIFY2(said.trimmed().toInt() > 10, said.constData());
}

// The scripts that go with an animation, in a folder that is named after the entry; other programs stand for
// Slurm's and for the command line.
void GeneratedNamesTest::scriptsRunNothingElse() {
    const QTemporaryDir folder;
    const QDir work(folder.path());
    QVERIFY(work.mkpath(QStringLiteral("bin")) && work.mkpath(QStringLiteral("jobs")));
    writeProgram(work.filePath(QStringLiteral("bin/sbatch")),
                 "#!/bin/bash\necho 7\nfor a in \"$@\"; do [[ $a == --* ]] || { bash -n \"$a\" && "
                 "echo sbatch >> \"$LOG\"; break; }; done\n");
    writeProgram(work.filePath(QStringLiteral("bin/barycage-cli")), "#!/bin/bash\necho cli >> \"$LOG\"\n");
    QProcessEnvironment variables = QProcessEnvironment::systemEnvironment();
    variables.insert(QStringLiteral("PATH"),
                     work.filePath(QStringLiteral("bin")) + QStringLiteral(":/usr/bin:/bin"));
    variables.insert(QStringLiteral("LOG"), work.filePath(QStringLiteral("log")));
    io::ClusterJob job;
    const QByteArray moving =
        "a {\n ; barycage: version 1\n ; barycage: animation 3 24/1 off\n"
        " ; barycage: track map 1\n ; barycage: key 0 linear\n"
        " ; barycage: value .5 0 0 .5 0 0 .5\n ; barycage: key 3 linear\n"
        " ; barycage: value .4 0 0 .4 0 0 .5\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n";
    job.animation.size = {32, 24};
    job.animation.format = io::VideoFormat::Gif;
    job.animation.last = 3;
    for (const QString& name : hostileNames(support::isThorough() ? 300 : allParts)) {
        job.animation.entry = entryFrom(moving, name);
        const io::WrittenJob written = io::writeClusterJob(work.filePath(QStringLiteral("jobs")), job);
        QVERIFY2(!written.failure, qPrintable(written.failure.value_or(QString())));
        QFile::remove(work.filePath(QStringLiteral("log")));
        QProcess script;
        script.setProcessEnvironment(variables);
        script.setProcessChannelMode(QProcess::MergedChannels);
        script.setWorkingDirectory(folder.path());
        script.start(QStringLiteral("bash"), {written.folder + QStringLiteral("/submit.sh")});
        QVERIFY(script.waitForFinished(60'000));
        const QByteArray said = name.toUtf8().toPercentEncoding() + ": " + script.readAll();
        QVERIFY2(script.exitCode() == 0, said.constData());
        QVERIFY2(bytesIn(work.filePath(QStringLiteral("log"))).count("sbatch") == 2, said.constData());
        for (const QString& place : {folder.path(), written.folder})
            QVERIFY2(!QFile::exists(place + QStringLiteral("/pwned")), said.constData());
    }
}

BARYCAGE_TEST(GeneratedNamesTest, QCoreApplication);
#include "generated_names_test.moc"
