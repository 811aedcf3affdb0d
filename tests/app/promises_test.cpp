// SPDX-License-Identifier: MIT
#include "support/named_test.h"
#include "support/source_files.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

// What docs/security.md promises of the program as a whole, and that each test it names is there.
class PromisesTest : public QObject {
    Q_OBJECT

private slots:
    void onlyThesePlacesReachOtherPrograms_data();
    void onlyThesePlacesReachOtherPrograms();
    void theTestsOfThePageAreThere();
};

namespace {

QString textOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

} // namespace

void PromisesTest::onlyThesePlacesReachOtherPrograms_data() {
    QTest::addColumn<QString>("call");
    QTest::addColumn<QStringList>("places"); // the beginnings of paths
    const auto row = [](const char* name, const char* call, const QStringList& places) {
        QTest::newRow(name) << QString::fromLatin1(call) << places;
    };
    row("processes", R"(\bQProcess\s*[:(>&*]|\bQProcess\s+\w|\bpopen\s*\(|\bexec[lv]p?e?\s*\(|\bposix_spawn)",
        {QStringLiteral("app/gui/main.cpp"), QStringLiteral("view/dialogs/export/cluster_queue")});
    row("shells and forks", R"((?:\bstd::|[^\w:]::)system\s*\(|\bsystem\s*\(\s*"|[^\w]fork\s*\(\s*\))", {});
    row("the desktop", R"(\bQDesktopServices::|setOpenExternalLinks)",
        {QStringLiteral("view/desktop/show_in_folder.cpp"), QStringLiteral("view/dialogs/guide.cpp")});
    row("the network", R"(\bQNetwork|\bQTcp|\bQUdp|\bQLocalSocket|\bQSsl|[^\w]socket\s*\(|Qt6::Network)", {});
    row("the session bus", R"(\bQDBus|Qt6::DBus)",
        {QStringLiteral("app/gui/portal/"), QStringLiteral("app/gui/CMakeLists.txt")});
    row("temporary files", R"(\bQTemporary(File|Dir)\b|\btmpfile\s*\(|\bmkstemp|\bQDir::temp|TempLocation)",
        {QStringLiteral("model/io/file/standard_output.cpp")}); // one without a name
    row("libraries", R"(\bQPluginLoader|\bQLibrary\b|\bdlopen\s*\()",
        {QStringLiteral("model/io/video/libav/library.cpp")});
}

void PromisesTest::onlyThesePlacesReachOtherPrograms() {
    QFETCH(const QString, call);
    QFETCH(const QStringList, places);
    const QRegularExpression pattern(call);
    QVERIFY(pattern.isValid());
    const QDir root(support::sourcePath({}));
    QSet<QString> met;
    const QStringList folders{QStringLiteral("app"), QStringLiteral("model"), QStringLiteral("view")};
    const QStringList sources = support::sourceFiles(
        folders, {QStringLiteral("*.h"), QStringLiteral("*.cpp"), QStringLiteral("CMakeLists.txt")});
    QVERIFY(sources.size() > 500);
    for (const QString& path : sources) {
        if (!textOf(path).contains(pattern)) continue;
        const QString name = root.relativeFilePath(path);
        QString known;
        for (const QString& place : places)
            if (name.startsWith(place)) known = place;
        QVERIFY2(!known.isEmpty(), qPrintable(name));
        met << known;
    }
    QCOMPARE(met.size(), places.size()); // else the pattern finds nothing
}

void PromisesTest::theTestsOfThePageAreThere() {
    const QString page = textOf(support::sourcePath(QStringLiteral("docs/security.md")));
    static const QRegularExpression name(QStringLiteral("`([a-z0-9_]+_test)(?:::(\\w+))?`"));
    int count = 0;
    for (auto found = name.globalMatch(page); found.hasNext(); ++count) {
        const auto match = found.next();
        const QStringList files =
            support::sourceFiles({QStringLiteral("tests")}, {match.captured(1) + QStringLiteral(".cpp"),
                                                             match.captured(1) + QStringLiteral(".py"),
                                                             match.captured(1) + QStringLiteral(".sh")});
        QVERIFY2(files.size() == 1, qPrintable(match.captured()));
        const QString function = QStringLiteral("void %1()").arg(match.captured(2));
        QVERIFY2(match.captured(2).isEmpty() || textOf(files.front()).contains(function),
                 qPrintable(match.captured()));
    }
    QVERIFY(count > 40);
}

BARYCAGE_TEST(PromisesTest);
#include "promises_test.moc"
