// SPDX-License-Identifier: MIT
#include "support/named_test.h"
#include "support/source_files.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <vector>

// No file, function or class outgrows what a reader can keep in mind. The sources are formatted: a block
// closes at the indentation of the line that opens it, and what is inside is indented further.
class SizeLimitsTest : public QObject {
    Q_OBJECT

private slots:
    void filesAreShort();
    void functionsAreShort();
    void classesAreNarrow();
    void longFunctionsAreFound_data();
    void longFunctionsAreFound();
    void wideClassesAreFound();
    void parameterListsAreShort();
    void longParameterListsAreFound_data();
    void longParameterListsAreFound();
};

namespace {

constexpr qsizetype maxFileLines = 600, maxFunctionLines = 60, maxPublicFunctions = 30, maxParameters = 6;

// Functions that are tables of data.
const QStringList tables{
    QStringLiteral("model/attractor/colour/palette.cpp: const std::vector<Palette>& gradients()"),
    QStringLiteral("tests/io/fractint/fractint_edit_test.cpp: void FractintEditTest::edits_data()"),
    QStringLiteral("tests/io/fractint/fractint_reader_test.cpp: void FractintReaderTest::rules_data()"),
    QStringLiteral("tests/io/fractint/fractint_writer_test.cpp: "
                   "void FractintWriterTest::editsTouchOnlyWhatChanged_data()"),
    QStringLiteral("tests/io/fractint/metadata_comments_test.cpp: "
                   "void MetadataCommentsTest::understood_data()"),
    QStringLiteral("tests/io/table/table_reader_test.cpp: void tables_data()"),
    QStringLiteral("tests/notation/scanner_test.cpp: void ScannerTest::blocks_data()"),
};

QStringList allSources() {
    return support::sourceFiles(
        {QStringLiteral("app"), QStringLiteral("model"), QStringLiteral("view"), QStringLiteral("tests")},
        {QStringLiteral("*.h"), QStringLiteral("*.cpp")});
}

QStringList linesOf(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return {};
    QStringList lines = QString::fromUtf8(file.readAll()).split(u'\n');
    if (lines.back().isEmpty()) lines.removeLast();
    return lines;
}

QString nameOf(const QString& path) {
    return QDir(support::sourcePath(QString())).relativeFilePath(path);
}

qsizetype indentationOf(const QString& line) {
    return std::find_if(line.begin(), line.end(), [](QChar c) { return c != u' '; }) - line.begin();
}

QString codeOf(const QString& line) {
    static const QRegularExpression comment(QStringLiteral("(^|\\s)//.*$"));
    return QString(line).remove(comment).trimmed();
}

// Where the statement begins whose last line that is.
qsizetype statementStart(const QStringList& lines, qsizetype last) {
    static const QRegularExpression end(QStringLiteral("^#|^$|[;{}:]$"));
    qsizetype first = last;
    while (first > 0 && indentationOf(lines[first]) > 0 && !end.match(codeOf(lines[first - 1])).hasMatch())
        --first;
    return first;
}

struct Block {
    QString head; // "void f(int x)"
    qsizetype first = 0, opened = 0, last = 0;
    qsizetype lines() const { return last - first + 1; }
};

// All blocks that are the body of a function, or of a branch or a lambda in one.
std::vector<Block> functionsIn(const QStringList& lines) {
    static const QRegularExpression other(
        QStringLiteral("^[^(]*$|^(template <.*> )?(namespace|class|struct|enum|union|extern)\\b|= *$"));
    std::vector<Block> open, functions;
    for (qsizetype i = 0; i < lines.size(); ++i) {
        const QString text = codeOf(lines[i]);
        const qsizetype indentation = indentationOf(lines[i]);
        while (text.startsWith(u'}') && !open.empty()) {
            Block block = open.back();
            const qsizetype outer = indentationOf(lines[block.first]);
            const bool closes = indentation == outer || indentation == indentationOf(lines[block.opened]);
            if (!closes && indentation > outer) break;
            open.pop_back();
            block.last = i;
            if (!closes) continue;
            if (!other.match(block.head).hasMatch()) functions.push_back(block);
            break;
        }
        if (!text.endsWith(u'{')) continue;
        const qsizetype first = statementStart(lines, i);
        QString head = lines.mid(first, i - first).join(u' ') + u' ' + text;
        head.chop(1);
        open.push_back({head.simplified(), first, i});
    }
    return functions;
}

QStringList longFunctionsIn(const QStringList& lines) {
    QStringList heads;
    for (const Block& function : functionsIn(lines))
        if (function.lines() > maxFunctionLines) heads << function.head;
    return heads;
}

// In the first parentheses of the head of a function that close again; those of a call do not, where a lambda
// is its last argument. Commas in angle and other brackets do not count.
qsizetype parametersIn(const QString& head) {
    qsizetype depth = 0, angles = 0, commas = 0;
    for (qsizetype i = head.indexOf(u'('); i >= 0 && i < head.size(); ++i) {
        const QChar c = head[i];
        if (c == u'(' || c == u'[' || c == u'{') ++depth;
        if (c == u')' || c == u']' || c == u'}') --depth;
        if (c == u'<' && head[i - 1].isLetterOrNumber()) ++angles;
        if (c == u'>' && angles > 0) --angles;
        if (c == u',' && depth == 1 && angles == 0) ++commas;
        if (depth == 0) return commas + 1;
    }
    return 0;
}

// "Name: count" of each class that has more public functions than a reader can keep in mind.
QStringList wideClassesIn(const QStringList& lines) {
    static const QRegularExpression head(
        QStringLiteral("^(?:template <.*> )?(class|struct) (\\w+)[^;]*\\{$"));
    static const QRegularExpression label(QStringLiteral("^\\w+( slots)?:$"));
    static const QRegularExpression function(QStringLiteral(
        "^(?!using|friend|enum|static_assert|Q_|//|#|return|\\})[^=;{]*(\\w|operator\\W+)\\("));
    struct Class {
        QString name;
        qsizetype indentation = 0;
        bool isPublic = false;
        int functions = 0;
    };
    std::vector<Class> open;
    QStringList wide;
    for (const QString& line : lines) {
        const QString text = line.trimmed();
        const qsizetype indentation = indentationOf(line);
        Class* inside = open.empty() ? nullptr : &open.back();
        if (const auto match = head.match(text); match.hasMatch()) {
            open.push_back({match.captured(2), indentation, match.captured(1) == QLatin1String("struct")});
        } else if (inside && indentation == inside->indentation && text.startsWith(u'}')) {
            if (inside->functions > maxPublicFunctions)
                wide << QStringLiteral("%1: %2").arg(inside->name).arg(inside->functions);
            open.pop_back();
        } else if (inside && indentation == inside->indentation && label.match(text).hasMatch()) {
            inside->isPublic = text.startsWith(QLatin1String("public"));
        } else if (inside && inside->isPublic && indentation == inside->indentation + 4) {
            inside->functions += function.match(text).hasMatch() ? 1 : 0;
        }
    }
    return wide;
}

// A function with that head and so many lines altogether.
QStringList functionOf(qsizetype lines, const QString& head, const QString& indentation = {}) {
    QStringList text = head.split(u'\n');
    text.back() += QStringLiteral(" {");
    while (text.size() < lines - 1)
        text << indentation + QStringLiteral("    if (x) { y(); }");
    text << indentation + u'}';
    return text;
}

} // namespace

void SizeLimitsTest::filesAreShort() {
    const QStringList files = allSources();
    QVERIFY2(files.size() > 500, "there are few sources: the test looks at the wrong place");
    for (const QString& path : files) {
        const qsizetype lines = linesOf(path).size();
        QVERIFY2(lines > 0, qPrintable(path));
        QVERIFY2(lines <= maxFileLines,
                 qPrintable(QStringLiteral("%1: %2 lines").arg(nameOf(path)).arg(lines)));
    }
}

void SizeLimitsTest::functionsAreShort() {
    qsizetype seen = 0;
    QStringList found;
    for (const QString& path : allSources()) {
        const QStringList lines = linesOf(path);
        seen += qsizetype(functionsIn(lines).size());
        for (const QString& head : longFunctionsIn(lines))
            found << nameOf(path) + QStringLiteral(": ") + head;
    }
    QVERIFY2(seen > 5000, "there are few functions: the test does not see them");
    found.sort();
    for (const QString& function : std::as_const(found))
        QVERIFY2(tables.contains(function), qPrintable(function));
    QCOMPARE(found, tables); // what is a table no longer is taken off the list
}

void SizeLimitsTest::classesAreNarrow() {
    for (const QString& path : allSources()) {
        if (!path.endsWith(QLatin1String(".h"))) continue;
        const QStringList wide = wideClassesIn(linesOf(path));
        QVERIFY2(wide.isEmpty(), qPrintable(nameOf(path) + QStringLiteral(": ") + wide.join(u' ')));
    }
}

void SizeLimitsTest::longFunctionsAreFound_data() {
    QTest::addColumn<QString>("head");
    QTest::addColumn<QString>("indentation");

    QTest::newRow("function") << QStringLiteral("void f(int x)") << QString();
    QTest::newRow("two lines") << QStringLiteral("void Class::function(int x,\n                     int y)")
                               << QString();
    QTest::newRow("constructor") << QStringLiteral("Class::Class(int x)\n    : m_x(x),\n      m_y(x)")
                                 << QString();
    QTest::newRow("in a class") << QStringLiteral("    void f() const override") << QStringLiteral("    ");
    QTest::newRow("template") << QStringLiteral("template <int Dim> double f(const Map<Dim>& map)")
                              << QString();
    QTest::newRow("lambda") << QStringLiteral("    const auto act = [&](int x)") << QStringLiteral("    ");
}

void SizeLimitsTest::longFunctionsAreFound() {
    QFETCH(QString, head);
    QFETCH(QString, indentation);

    const QStringList before{QStringLiteral("namespace a {"), QString(), QStringLiteral("class Class {"),
                             QStringLiteral("public:")};
    const QStringList after{QStringLiteral("};"), QString(), QStringLiteral("} // namespace a")};
    const QStringList fits = functionOf(maxFunctionLines, head, indentation);
    QCOMPARE(longFunctionsIn(before + fits + after), QStringList());
    const QStringList tooLong = functionOf(maxFunctionLines + 1, head, indentation);
    QCOMPARE(longFunctionsIn(before + tooLong + after), QStringList{head.simplified()});
    QStringList table = functionOf(200, QStringLiteral("const Row rows[] ="));
    QCOMPARE(longFunctionsIn(table), QStringList());
}

void SizeLimitsTest::wideClassesAreFound() {
    QStringList narrow{QStringLiteral("class Narrow : public QObject {"), QStringLiteral("    Q_OBJECT"),
                       QString(), QStringLiteral("public:")};
    for (qsizetype i = 0; i < maxPublicFunctions; ++i)
        narrow << QStringLiteral("    int f%1(int x, // with a comment (in brackets)").arg(i)
               << QStringLiteral("            int y) const;");
    QStringList wide = narrow;
    wide << QStringLiteral("    bool operator()(int x) const { return f1(x, x); }");
    const QStringList rest{QStringLiteral("    int m_value = f();"), QStringLiteral("private:"),
                           QStringLiteral("    void g();"), QStringLiteral("};")};
    QCOMPARE(wideClassesIn(narrow + rest), QStringList());
    QCOMPARE(wideClassesIn(wide + rest),
             QStringList{QStringLiteral("Narrow: %1").arg(maxPublicFunctions + 1)});
}

void SizeLimitsTest::parameterListsAreShort() {
    static const QRegularExpression macro(QStringLiteral("^[A-Z_]+\\("));
    qsizetype longest = 0;
    for (const QString& path : allSources())
        for (const Block& function : functionsIn(linesOf(path))) {
            if (function.head.contains(macro)) continue;
            const qsizetype parameters = parametersIn(function.head);
            longest = std::max(longest, parameters);
            QVERIFY2(parameters <= maxParameters,
                     qPrintable(nameOf(path) + QStringLiteral(": ") + function.head));
        }
    QCOMPARE(longest, maxParameters); // the test sees them
}

void SizeLimitsTest::longParameterListsAreFound_data() {
    QTest::addColumn<QString>("head");
    QTest::addColumn<qsizetype>("parameters");

    QTest::newRow("seven") << QStringLiteral("void f(int a, int b, int c, int d, int e, int f, int g) const")
                           << qsizetype(7);
    QTest::newRow("types with commas")
        << QStringLiteral("void f(std::map<QString, std::pair<int, int>>& a, int b = g(1, 2))")
        << qsizetype(2);
    QTest::newRow("constructor") << QStringLiteral("C::C(int a, int b, int c) : m_a(a), m_b(b, c)")
                                 << qsizetype(3);
    QTest::newRow("lambda") << QStringLiteral("const auto f = [&, this](int a, int b)") << qsizetype(2);
    QTest::newRow("call") << QStringLiteral("call(a, b, c, d, e, f, g, [&](int x)") << qsizetype(0);
}

void SizeLimitsTest::longParameterListsAreFound() {
    QFETCH(QString, head);
    QTEST(parametersIn(head), "parameters");
}

BARYCAGE_TEST(SizeLimitsTest);
#include "size_limits_test.moc"
