// SPDX-License-Identifier: MIT
#include "support/named_test.h"
#include "support/paths.h"

#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

// What follows from the table of options is written into the completions of three shells and the manual page.
class CliOptionsTest : public QObject {
    Q_OBJECT

private slots:
    void theTableIsWrittenInto_data();
    void theTableIsWrittenInto();
    void everyOptionIsInTheTables();
    void manualsSayWhatEveryoneAsks();
    void theEditorSaysItsVersionWithoutADisplay();
    void theEditorDrawsWithoutADisplay();

private:
    static QProcessEnvironment withoutDisplay();
    static QString answer(const QStringList& arguments);
    static QStringList commands();
    static QString read(const char* path);
};

namespace {

QSet<QString> found(const QString& text, const QString& pattern) {
    QSet<QString> words;
    const QRegularExpression expression(pattern, QRegularExpression::MultilineOption);
    for (auto it = expression.globalMatch(text); it.hasNext();)
        words << it.next().captured(1);
    return words;
}

// From the line that begins with `from` to the next that begins like it.
QString part(const QString& text, const QString& from, const QString& until) {
    const qsizetype begin = text.indexOf(from);
    if (begin < 0) return {};
    const qsizetype end = text.indexOf(until, begin + from.size());
    return text.mid(begin, end < 0 ? -1 : end - begin);
}

} // namespace

QString CliOptionsTest::answer(const QStringList& arguments) {
    QProcess process;
    process.start(support::buildPath(QStringLiteral("barycage-cli")), arguments);
    process.waitForFinished(60'000);
    return QString::fromUtf8(process.readAllStandardOutput());
}

QStringList CliOptionsTest::commands() {
    const QString text = answer({QStringLiteral("--help")});
    return found(part(text, QStringLiteral("\nCommands:"), QStringLiteral("\n\n")),
                 QStringLiteral("^  ([a-z]+)  "))
        .values();
}

QString CliOptionsTest::read(const char* path) {
    QFile file(support::sourcePath(QStringLiteral("resources/")) + QLatin1String(path));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

void CliOptionsTest::theTableIsWrittenInto_data() {
    QTest::addColumn<QString>("reader");
    QTest::addColumn<QString>("path");
    QTest::newRow("bash") << "bash"
                          << "completions/barycage-cli.bash";
    QTest::newRow("zsh") << "zsh"
                         << "completions/_barycage-cli";
    QTest::newRow("fish") << "fish"
                          << "completions/barycage-cli.fish";
    QTest::newRow("manual") << "manual"
                            << "linux/barycage-cli.1.in";
}

void CliOptionsTest::theTableIsWrittenInto() {
    QFETCH(QString, reader);
    QFETCH(QString, path);
    const QString file = read(qPrintable(path));
    const QString begin = QStringLiteral("--describe %1; ./dev describe renews it.\n").arg(reader);
    const QString written = part(file, begin, QStringLiteral("What is written ends here.")).mid(begin.size());
    const QString expected = answer({QStringLiteral("--describe"), reader});
    QVERIFY(expected.size() > 1000);
    QVERIFY2(written.section(u'\n', 0, -2) + u'\n' == expected,
             qPrintable(QStringLiteral("./dev describe renews %1").arg(path)));
}

// --help is written by other code.
void CliOptionsTest::everyOptionIsInTheTables() {
    for (const QString& command : commands()) {
        const QStringList help = answer({command, QStringLiteral("--help")}).split(u'\n');
        QSet<QString> options;
        for (const QString& line : help)
            options += found(line.left(26), QStringLiteral("(?:^  |, )(--[a-z-]+)"));
        QVERIFY(options.size() >= 3);
        for (const QString& option : options) {
            QVERIFY2(part(read("completions/barycage-cli.bash"), QStringLiteral("    %1)\n").arg(command),
                          QStringLiteral(";;"))
                         .contains(QRegularExpression(QStringLiteral("[( ]%1[ )]").arg(option))),
                     qPrintable(option));
            QVERIFY2(part(read("completions/_barycage-cli"), QStringLiteral("    %1)\n").arg(command),
                          QStringLiteral(";;"))
                         .contains(option + u'['),
                     qPrintable(option));
            QVERIFY2(read("completions/barycage-cli.fish")
                         .contains(QRegularExpression(
                             QStringLiteral("_from %1\".* -l %2 ").arg(command, option.mid(2)))),
                     qPrintable(option));
        }
    }
}

void CliOptionsTest::manualsSayWhatEveryoneAsks() {
    const QString statuses =
        part(read("linux/barycage-cli.1.in"), QStringLiteral(".SH EXIT STATUS"), QStringLiteral("\n.SH "));
    QCOMPARE(
        found(statuses, QStringLiteral("^\\.B ([0-9]+)$")),
        (QSet<QString>{QStringLiteral("0"), QStringLiteral("1"), QStringLiteral("2"), QStringLiteral("3"),
                       QStringLiteral("129"), QStringLiteral("130"), QStringLiteral("143")}));
    const QString editor = read("linux/barycage.1.in").replace(QStringLiteral("\\-"), QStringLiteral("-"));
    for (const char* word : {"--help", "--version", ".ifs", ".par", ".flame", ".csv", ".svg"})
        QVERIFY2(editor.contains(QLatin1String(word)), word);
}

QProcessEnvironment CliOptionsTest::withoutDisplay() {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        environment.remove(QString::fromLatin1(name));
    return environment;
}

void CliOptionsTest::theEditorSaysItsVersionWithoutADisplay() {
    const QString editor = support::buildPath(QStringLiteral("barycage"));
    if (!QFileInfo::exists(editor)) QSKIP("Built without the editor.");
    QProcess process;
    process.setProcessEnvironment(withoutDisplay());
    for (const char* question : {"--version", "--help"}) {
        process.start(editor, {QString::fromLatin1(question)});
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 0);
        QVERIFY(process.readAllStandardOutput().contains("arycage"));
    }
}

void CliOptionsTest::theEditorDrawsWithoutADisplay() {
    const QString editor = support::buildPath(QStringLiteral("barycage"));
    if (!QFileInfo::exists(editor)) QSKIP("Built without the editor.");
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("maple.png"));
    QProcess process;
    process.setProcessEnvironment(withoutDisplay());
    process.start(editor, {QStringLiteral("--picture"), path});
    QVERIFY(process.waitForFinished(120'000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QVERIFY2(process.exitCode() == 0, process.readAllStandardError().constData());
    const QImage picture(path);
    QCOMPARE(picture.size(), QSize(1600, 1200));
    QVERIFY(picture.pixel(800, 600) != picture.pixel(5, 5));
    process.start(editor, {QStringLiteral("--picture"), folder.filePath(QStringLiteral("no/maple.png"))});
    QVERIFY(process.waitForFinished(120'000));
    QCOMPARE(process.exitCode(), 1);
    QVERIFY(process.readAllStandardError().startsWith("barycage: "));
}

BARYCAGE_TEST(CliOptionsTest, QGuiApplication);
#include "cli_options_test.moc"
