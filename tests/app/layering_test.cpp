// SPDX-License-Identifier: MIT
#include "support/named_test.h"
#include "support/paths.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <map>
#include <set>

// The include directions of the architecture: each layer may know those below it and nothing else, and no two
// folders or rooms (a header with its source) know each other, directly or by way of others.
class LayeringTest : public QObject {
    Q_OBJECT

private slots:
    void includesPointDownwards_data();
    void includesPointDownwards();
    void foldersAndRoomsFormNoCircle();
    void circlesAreFound_data();
    void circlesAreFound();
    void foldersReadLikeTablesOfContents();
    void sourcesStandBesideTheirHeaders();
    void coreCompilesWithoutQt();
    void viewStartsNoThread();
    void picturesOfTheClipboardAreFiles();
    void nothingReturnsASubrange();
    void decompositionsAreCompiledInFewFiles();
    void anonymousNamesAreUniqueInTheirFolder();
    void listsAreChosenByValue();
    void panelsAreNotSearchedByName();
    void fixedWaitsAreFew();
    void choicesByRowAreFound_data();
    void choicesByRowAreFound();
};

namespace {

using Graph = std::map<QString, std::set<QString>>;

const QStringList topFolders{QStringLiteral("app"), QStringLiteral("model"), QStringLiteral("view")};
// What an #include "…" may be relative to, as in the CMakeLists.txt of the libraries.
const QStringList includeFolders{QStringLiteral("model/"), QStringLiteral("view/"),
                                 QStringLiteral("app/gui/"), QStringLiteral("app/cli/"),
                                 QStringLiteral("app/")};

QStringList sourceFiles(const QString& folder) {
    QStringList files;
    QDirIterator it(folder, {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
                    QDirIterator::Subdirectories);
    while (it.hasNext())
        files << it.next();
    return files;
}

QString contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

struct Include {
    QString header;
    bool isOurs = false; // "…" rather than <…>
};

QList<Include> includesOf(const QString& path) {
    static const QRegularExpression include(QStringLiteral("^\\s*#\\s*include\\s*([<\"])([^>\"]+)[>\"]"),
                                            QRegularExpression::MultilineOption);
    QList<Include> found;
    auto matches = include.globalMatch(contents(path));
    while (matches.hasNext()) {
        const auto match = matches.next();
        found.append({match.captured(2), match.captured(1) == QLatin1String("\"")});
    }
    return found;
}

// "model/ifs/system/branch" for its header and its source.
QString roomOf(const QString& file) {
    return file.left(file.lastIndexOf(u'.'));
}

QString folderOf(const QString& room) {
    return room.left(room.lastIndexOf(u'/'));
}

// Which rooms of the tree at `root` include which others.
Graph roomsOf(const QString& root) {
    std::set<QString> files;
    for (const QString& top : topFolders)
        for (const QString& path : sourceFiles(root + u'/' + top))
            files.insert(QDir(root).relativeFilePath(path));
    Graph rooms;
    for (const QString& file : files) {
        std::set<QString>& known = rooms[roomOf(file)];
        for (const Include& include : includesOf(root + u'/' + file))
            for (const QString& folder : includeFolders)
                if (include.isOurs && files.contains(folder + include.header))
                    known.insert(roomOf(folder + include.header));
        known.erase(roomOf(file));
    }
    return rooms;
}

Graph foldersOf(const Graph& rooms) {
    Graph folders;
    for (const auto& [room, known] : rooms)
        for (const QString& other : known)
            if (folderOf(other) != folderOf(room)) folders[folderOf(room)].insert(folderOf(other));
    return folders;
}

// Some circle, as the names along it, the first one again at the end; empty when there is none.
class CircleSearch {
public:
    explicit CircleSearch(const Graph& graph) : m_graph(graph) {}

    QStringList circle() {
        for (const auto& [node, known] : m_graph)
            if (visit(node)) return m_path;
        return {};
    }

private:
    bool visit(const QString& node) {
        if (const qsizetype begin = m_path.indexOf(node); begin >= 0) {
            m_path = m_path.mid(begin) << node;
            return true;
        }
        if (!m_done.insert(node).second) return false;
        m_path << node;
        if (const auto known = m_graph.find(node); known != m_graph.end())
            for (const QString& next : known->second)
                if (visit(next)) return true;
        m_path.removeLast();
        return false;
    }

    const Graph& m_graph;
    QStringList m_path;
    std::set<QString> m_done;
};

QString circleIn(const Graph& graph) {
    return CircleSearch(graph).circle().join(QStringLiteral(" → "));
}

} // namespace

void LayeringTest::includesPointDownwards_data() {
    QTest::addColumn<QString>("folder");
    QTest::addColumn<QStringList>("mayKnow");
    QTest::addColumn<QString>("mustNotInclude");

    const QString qt = QStringLiteral("^Q");
    const QString widgets = QStringLiteral("^(QtWidgets|QWidget|QDialog|QMainWindow|QGraphics|QApplication|"
                                           "QMenu|QLabel|QAbstractItemView|QPrint)");
    const QStringList ifs{QStringLiteral("ifs")};
    const QStringList attractor = ifs + QStringList{QStringLiteral("attractor")};
    const QStringList animation = attractor + QStringList{QStringLiteral("animation")};
    const QStringList collage = animation + QStringList{QStringLiteral("collage")};
    const QStringList notation = collage + QStringList{QStringLiteral("notation")};
    const QStringList document = notation + QStringList{QStringLiteral("document")};
    const QStringList io = document + QStringList{QStringLiteral("io")};
    const QStringList view = io + QStringList{QStringLiteral("transformation"), QStringLiteral("bars"),
                                              QStringLiteral("bridges"),        QStringLiteral("canvas"),
                                              QStringLiteral("compare"),        QStringLiteral("desktop"),
                                              QStringLiteral("dialogs"),        QStringLiteral("gestures"),
                                              QStringLiteral("panels"),         QStringLiteral("space"),
                                              QStringLiteral("widgets")};
    QTest::newRow("model/ifs") << "model/ifs" << ifs << qt;
    QTest::newRow("model/attractor") << "model/attractor" << attractor << qt;
    QTest::newRow("model/animation") << "model/animation" << animation << qt;
    QTest::newRow("model/collage") << "model/collage" << collage << qt;
    QTest::newRow("model/notation") << "model/notation" << notation << qt;
    QTest::newRow("model/document") << "model/document" << document << widgets;
    QTest::newRow("model/io") << "model/io" << io << widgets;
    QTest::newRow("app/web") << "app/web" << notation + QStringList{QStringLiteral("web")} << qt;
    QTest::newRow("app/python") << "app/python" << notation + QStringList{QStringLiteral("python")} << qt;
    QTest::newRow("view") << "view" << view << QStringLiteral("^$");
}

void LayeringTest::includesPointDownwards() {
    QFETCH(QString, folder);
    QFETCH(QStringList, mayKnow);
    QFETCH(QString, mustNotInclude);

    const QStringList files = sourceFiles(support::sourcePath(folder));
    QVERIFY2(!files.isEmpty(), "the folder has no sources: the test looks at the wrong place");
    const QRegularExpression forbidden(mustNotInclude);
    for (const QString& path : files)
        for (const Include& include : includesOf(path)) {
            if (include.header.endsWith(QLatin1String(".moc"))) continue;
            const QString layer = include.header.section(u'/', 0, 0);
            const bool isAllowed = include.isOurs ? mayKnow.contains(layer) && include.header.contains(u'/')
                                                  : !forbidden.match(include.header).hasMatch();
            QVERIFY2(isAllowed, qPrintable(path + QStringLiteral(" includes ") + include.header));
        }
}

void LayeringTest::foldersAndRoomsFormNoCircle() {
    const Graph rooms = roomsOf(support::sourcePath(QString()));
    QVERIFY2(rooms.size() > 100, "the tree has no sources: the test looks at the wrong place");
    QVERIFY(rooms.at(QStringLiteral("model/ifs/facts"))
                .contains(QStringLiteral("model/ifs/dimension/dimension")));
    QCOMPARE(circleIn(rooms), QString());
    QCOMPARE(circleIn(foldersOf(rooms)), QString());
}

void LayeringTest::circlesAreFound_data() {
    QTest::addColumn<QStringList>("includes"); // file, what it includes, file, what it includes …
    QTest::addColumn<QString>("ofRooms");
    QTest::addColumn<QString>("ofFolders");

    QTest::newRow("none") << QStringList{QStringLiteral("model/a/x.h"), QStringLiteral("b/y.h"),
                                         QStringLiteral("model/b/y.h"), QStringLiteral("b/z.h"),
                                         QStringLiteral("model/b/z.h"), QString()}
                          << QString() << QString();
    QTest::newRow("a header and the source of another")
        << QStringList{QStringLiteral("model/a/x.h"),   QStringLiteral("a/y.h"),
                       QStringLiteral("model/a/y.cpp"), QStringLiteral("a/x.h"),
                       QStringLiteral("model/a/y.h"),   QString()}
        << QStringLiteral("model/a/x → model/a/y → model/a/x") << QString();
    QTest::newRow("by way of a third") << QStringList{QStringLiteral("view/a/x.h"), QStringLiteral("b/y.h"),
                                                      QStringLiteral("view/b/y.h"), QStringLiteral("c/z.h"),
                                                      QStringLiteral("view/c/z.h"), QStringLiteral("a/x.h")}
                                       << QStringLiteral("view/a/x → view/b/y → view/c/z → view/a/x")
                                       << QStringLiteral("view/a → view/b → view/c → view/a");
    QTest::newRow("folders only") << QStringList{QStringLiteral("view/a/x.h"), QStringLiteral("b/y.h"),
                                                 QStringLiteral("view/b/y.h"), QString(),
                                                 QStringLiteral("view/b/z.h"), QStringLiteral("a/x.h")}
                                  << QString() << QStringLiteral("view/a → view/b → view/a");
}

void LayeringTest::circlesAreFound() {
    QFETCH(QStringList, includes);
    QFETCH(QString, ofRooms);
    QFETCH(QString, ofFolders);

    const QTemporaryDir tree;
    for (qsizetype i = 0; i < includes.size(); i += 2) {
        QVERIFY(QDir(tree.path()).mkpath(folderOf(includes[i])));
        QFile file(tree.filePath(includes[i]));
        QVERIFY(file.open(QIODevice::WriteOnly));
        if (!includes[i + 1].isEmpty())
            file.write("#include \"" + includes[i + 1].toUtf8() + "\"\n#include <vector>\n");
    }
    const Graph rooms = roomsOf(tree.path());
    QCOMPARE(circleIn(rooms), ofRooms);
    QCOMPARE(circleIn(foldersOf(rooms)), ofFolders);
}

void LayeringTest::foldersReadLikeTablesOfContents() {
    for (const char* folder :
         {"model/ifs", "model/attractor", "model/io", "view", "view/canvas", "view/panels"}) {
        const QDir here(support::sourcePath(QString::fromLatin1(folder)));
        QVERIFY(here.exists());
        const QStringList files = here.entryList(QDir::Files);
        QVERIFY2(files.size() <= 15, qPrintable(here.path() + QStringLiteral(": ") + files.join(u' ')));
    }
    std::map<QString, std::set<QString>> folders; // what each holds: a header with its source counts once
    for (const QString& top : topFolders)
        for (const QString& path : sourceFiles(support::sourcePath(top)))
            folders[folderOf(path)].insert(roomOf(path));
    QVERIFY2(folders.size() > 50, "few folders were found: the test looks at the wrong places");
    for (const auto& [folder, sources] : folders)
        QVERIFY2(sources.size() <= 20,
                 qPrintable(QStringLiteral("%1 holds %2 sources").arg(folder).arg(sources.size())));
}

void LayeringTest::sourcesStandBesideTheirHeaders() {
    for (const char* folder : {"model", "view"}) {
        const QStringList files = sourceFiles(support::sourcePath(QString::fromLatin1(folder)));
        for (const QString& path : files)
            QVERIFY2(path.endsWith(QLatin1String(".h")) || files.contains(roomOf(path) + QLatin1String(".h")),
                     qPrintable(path));
    }
}

void LayeringTest::coreCompilesWithoutQt() {
    QFile file(support::buildPath(QStringLiteral("compile_commands.json")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    int seen = 0;
    for (const QJsonValue& entry : QJsonDocument::fromJson(file.readAll()).array()) {
        const QString path = entry[QLatin1String("file")].toString();
        if (!path.contains(QLatin1String("/model/ifs/")) &&
            !path.contains(QLatin1String("/model/attractor/")) &&
            !path.contains(QLatin1String("/model/animation/")) &&
            !path.contains(QLatin1String("/model/collage/")) &&
            !path.contains(QLatin1String("/model/notation/")))
            continue;
        // Of the library itself, or of several of its sources together.
        if (!path.startsWith(support::sourcePath(QStringLiteral("model/"))) &&
            !path.startsWith(support::buildPath(QStringLiteral("model/"))))
            continue;
        ++seen;
        QVERIFY2(!entry[QLatin1String("command")].toString().contains(QLatin1String("QtCore")),
                 qPrintable(path));
    }
    QVERIFY(seen > 0);
}

void LayeringTest::viewStartsNoThread() {
    static const QRegularExpression thread(QStringLiteral(
        "\\b(std::j?thread|std::async|QThread(?!::currentThread)|QThreadPool|QtConcurrent)\\b"));
    const QStringList files = sourceFiles(support::sourcePath(QStringLiteral("view")));
    QVERIFY(!files.isEmpty());
    for (const QString& path : files)
        QVERIFY2(!thread.match(contents(path)).hasMatch(), qPrintable(path));
}

// QClipboard::image() and QMimeData::imageData() decode in the window's thread whatever another program
// offers. The one who may ask looks first whether the image is one of this program's own.
void LayeringTest::picturesOfTheClipboardAreFiles() {
    static const QRegularExpression decoding(
        QStringLiteral("\\bimageData\\(|lipboard(\\(\\))?\\s*->\\s*(image|pixmap)\\("));
    QStringList found;
    for (const char* folder : {"app", "view"})
        for (const QString& path : sourceFiles(support::sourcePath(QString::fromLatin1(folder))))
            if (decoding.match(contents(path)).hasMatch()) found << QFileInfo(path).fileName();
    QCOMPARE(found, QStringList{QStringLiteral("target_box.cpp")});
    const QString text = contents(support::sourcePath(QStringLiteral("view/panels/collage/target_box.cpp")));
    QCOMPARE(text.count(decoding), 1);
    const qsizetype first = text.indexOf(QStringLiteral("inherits(\"QInternalMimeData\")"));
    QVERIFY(first >= 0 && first < text.indexOf(decoding));
}

// Clang 14, with which the readers are fuzzed and the sources checked, cannot compile std::ranges::subrange
// and views of libstdc++ 12, nor the least of a braced list.
void LayeringTest::nothingReturnsASubrange() {
    static const QRegularExpression subrange(QStringLiteral(
        "std::views::|std::ranges::(subrange|equal_range|find_end|partition|remove|remove_if|rotate|search|"
        "search_n|stable_partition|unique)\\b|std::ranges::(min|max|minmax)\\(\\s*\\{"));
    for (const char* folder : {"app", "model", "view"}) {
        const QStringList files = sourceFiles(support::sourcePath(QString::fromLatin1(folder)));
        QVERIFY(!files.isEmpty());
        for (const QString& path : files) {
            const auto match = subrange.match(contents(path));
            QVERIFY2(!match.hasMatch(), qPrintable(path + QStringLiteral(": ") + match.captured()));
        }
    }
}

// Eigen's decompositions take seconds to compile in every file that uses them: model/ifs/linear does, behind
// functions for everybody.
void LayeringTest::decompositionsAreCompiledInFewFiles() {
    static const QRegularExpression heavy(QStringLiteral("^Eigen/(Dense|Eigen|Eigenvalues|SVD)$"));
    static const QRegularExpression used(QStringLiteral(
        "EigenSolver\\b|\\b(BDC|Jacobi)SVD\\b|\\b(jacobi|bdc)Svd\\b|\\b(Real|Complex)Schur\\b"));
    QStringList users;
    for (const char* folder : {"app", "model", "view"})
        for (const QString& path : sourceFiles(support::sourcePath(QString::fromLatin1(folder)))) {
            const QList<Include> includes = includesOf(path);
            const bool includesIt = std::ranges::any_of(
                includes, [](const Include& include) { return heavy.match(include.header).hasMatch(); });
            if (includesIt || used.match(contents(path)).hasMatch()) users << path;
        }
    QVERIFY2(!users.isEmpty(), "no file uses them: the test looks at the wrong place");
    QVERIFY2(users.size() <= 6, qPrintable(users.join(u' ')));
    for (const QString& path : std::as_const(users))
        QVERIFY2(path.contains(QLatin1String("/model/ifs/linear/")), qPrintable(path));
}

// What a file names at the left margin of its anonymous namespaces, with the line: types and values by their
// names, functions by their names and parameters, since they may be overloaded.
static std::map<QString, QString> anonymousNames(const QString& path) {
    static const QRegularExpression type(
        QStringLiteral("^(?:template <[^>]*> )?(?:struct|class|enum class|enum) (\\w+)(?! *;)"));
    static const QRegularExpression alias(QStringLiteral("^(?:template <[^>]*> )?using (\\w+) ="));
    static const QRegularExpression value(
        QStringLiteral("^(?:static |inline |constexpr |const )+[^(=]*?(\\w+)(?:\\[\\w*\\])?(?: =|\\{| \\{)"));
    static const QRegularExpression function(QStringLiteral("^[\\w\\[][^=]*?\\b(\\w+\\(.*)\\{$"));
    std::map<QString, QString> names;
    bool isInside = false;
    for (const QString& line : contents(path).split(u'\n')) {
        if (line.startsWith(QLatin1String("namespace {"))) isInside = true;
        if (line.startsWith(QLatin1String("} // namespace"))) isInside = false;
        if (!isInside) continue;
        for (const QRegularExpression* kind : {&type, &alias, &value, &function})
            if (const auto match = kind->match(line); match.hasMatch()) {
                names.emplace(match.captured(1), line);
                break;
            }
    }
    return names;
}

// The sources of a folder are compiled together, some at a time. The same alias may be in several.
void LayeringTest::anonymousNamesAreUniqueInTheirFolder() {
    std::map<std::pair<QString, QString>, std::pair<QString, QString>>
        firsts; // path and line, by folder and name
    for (const char* top : {"app", "model", "view", "tests"})
        for (const QString& path : sourceFiles(support::sourcePath(QString::fromLatin1(top)))) {
            if (!path.endsWith(QLatin1String(".cpp"))) continue;
            if (path.contains(QLatin1String("/tests/bench/")) ||
                path.contains(QLatin1String("/tests/support/")))
                continue; // programs and libraries of one or few sources
            for (const auto& [name, line] : anonymousNames(path)) {
                const auto [entry, isNew] = firsts.try_emplace({folderOf(path), name}, std::pair(path, line));
                const auto& [first, firstLine] = entry->second;
                const bool isSameAlias = line == firstLine && line.contains(QLatin1String("using "));
                QVERIFY2(isNew || isSameAlias, qPrintable(name + QStringLiteral(" is in ") + first +
                                                          QStringLiteral(" and in ") + path));
            }
        }
    QVERIFY2(firsts.size() > 1000, "few names were found: the test looks at the wrong places");
}

// A list of choices whose rows are numbers: widgets/choices.h gives each row the value that it stands for.
static QString choiceByRow(const QString& text) {
    static const QRegularExpression pattern(QStringLiteral(
        "setCurrentIndex\\(\\d|currentIndex\\(\\) *(==|!=|[<>]=?|[-+]) *-?\\d|"
        "\\[(int|std::size_t)?\\(?\\w+->currentIndex\\(\\)|"
        "\\b([A-Z][a-z]\\w*|at|static_cast<[^>]*>)\\((std::size_t\\()?\\w+->currentIndex\\(\\)(?!\\.)"));
    return pattern.match(text).captured();
}

void LayeringTest::listsAreChosenByValue() {
    const QStringList exempt{QStringLiteral("choices.h"),
                             QStringLiteral("preferences_dialog.cpp")}; // for what no row stands
    int seen = 0;
    for (const char* top : {"app/gui", "view", "tests/app", "tests/support", "tests/view"})
        for (const QString& path : sourceFiles(support::sourcePath(QString::fromLatin1(top)))) {
            if (exempt.contains(QFileInfo(path).fileName()) ||
                path.endsWith(QLatin1String("layering_test.cpp")))
                continue;
            ++seen;
            const QString text = contents(path);
            const QString found = choiceByRow(text);
            QVERIFY2(found.isEmpty(), qPrintable(path + QStringLiteral(": ") + found));
            const bool isTest =
                QByteArray(top).startsWith("tests/"); // may fill a list that stands for nothing
            QVERIFY2(isTest || !text.contains(QStringLiteral("->addItems(")), qPrintable(path));
        }
    QVERIFY(seen > 300);
}

// app/gui/docks/panels.h knows the panels of a window.
void LayeringTest::panelsAreNotSearchedByName() {
    static const QRegularExpression search(QStringLiteral("findChild<QDockWidget"));
    const QStringList files = sourceFiles(support::sourcePath(QStringLiteral("app/gui")));
    QVERIFY(files.size() > 100);
    for (const QString& path : files)
        QVERIFY2(!search.match(contents(path)).hasMatch(), qPrintable(path));
}

// Tests wait for conditions. Where nothing tells when something is over, a comment in the line or the three
// before says so.
void LayeringTest::fixedWaitsAreFew() {
    static const QRegularExpression wait(QStringLiteral("\\b(?:qWait|qSleep|[mu]?sleep|sleep_for)\\("));
    QStringList found;
    for (const QString& path : sourceFiles(support::sourcePath(QStringLiteral("tests")))) {
        if (path.contains(QLatin1String("/bench/"))) continue;
        const QStringList lines = contents(path).split(u'\n');
        for (qsizetype i = 0; i < lines.size(); ++i) {
            if (!wait.match(lines[i]).hasMatch()) continue;
            found << path + QStringLiteral(": ") + lines[i].trimmed();
            const qsizetype first = std::max<qsizetype>(0, i - 3);
            const QString around = lines.sliced(first, i - first + 1).join(u'\n');
            QVERIFY2(around.contains(QLatin1String("//")), qPrintable(found.last()));
        }
    }
    QVERIFY(!found.isEmpty());
    QVERIFY2(found.size() <= 15, qPrintable(found.join(u'\n')));
}

void LayeringTest::choicesByRowAreFound_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("isOne");
    const auto row = [](const char* text, bool isOne) {
        QTest::newRow(text) << QString::fromLatin1(text) << isOne;
    };
    row("box->setCurrentIndex(2);", true);
    row("box->setCurrentIndex(-1);", false); // none
    row("if (m_box->currentIndex() > 0) return;", true);
    row("return m_views[m_box->currentIndex() - 1];", true);
    row("return kinds[m_box->currentIndex()].file;", true);
    row("return names.at(m_box->currentIndex());", true);
    row("return Section(m_box->currentIndex()) == Section::View;", true);
    row("return static_cast<Format>(m_box->currentIndex());", true);
    row("support::choose(box, Format::Png);", false);
    row("m_list->setCurrentIndex(index);", false);
    row("const int row = m_table->currentIndex().row();", false);
    row("showEntry(m_list->currentIndex().row());", false);
    row("m_list->scrollTo(m_list->currentIndex());", false);
}

void LayeringTest::choicesByRowAreFound() {
    QFETCH(QString, text);
    QFETCH(bool, isOne);
    QCOMPARE(!choiceByRow(text).isEmpty(), isOne);
}

BARYCAGE_TEST(LayeringTest);
#include "layering_test.moc"
