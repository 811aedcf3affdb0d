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

// The completions of three shells and the manual page name the options that --help names: all of them, and no
// others.
class CliOptionsTest : public QObject {
    Q_OBJECT

private slots:
    void completionsAndManualKnowEveryOption_data() { subcommands(); }
    void completionsAndManualKnowEveryOption();
    void nothingElseIsOffered();
    void everySubcommandIsOffered();
    void helpAndVersionAreOffered();
    void manualsSayWhatEveryoneAsks();
    void theEditorSaysItsVersionWithoutADisplay();
    void theEditorDrawsWithoutADisplay();

private:
    static QProcessEnvironment withoutDisplay();
    static void subcommands() {
        QTest::addColumn<QString>("subcommand");
        for (const QString& name : commands())
            QTest::newRow(qPrintable(name)) << name;
    }
    static QString help(const QStringList& arguments);
    static QStringList commands();
    static QSet<QString> optionsOf(const QString& subcommand);
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

const QString longOption = QStringLiteral("--([a-z][a-z-]*)");

// From the line that begins with `from` to the next that begins like it.
QString part(const QString& text, const QString& from, const QString& until) {
    const qsizetype begin = text.indexOf(from);
    if (begin < 0) return {};
    const qsizetype end = text.indexOf(until, begin + from.size());
    return text.mid(begin, end < 0 ? -1 : end - begin);
}

} // namespace

QString CliOptionsTest::help(const QStringList& arguments) {
    QProcess process;
    process.start(support::buildPath(QStringLiteral("barycage-cli")),
                  arguments + QStringList{QStringLiteral("--help")});
    process.waitForFinished(60'000);
    return QString::fromUtf8(process.readAllStandardOutput());
}

QStringList CliOptionsTest::commands() {
    const QString text = help({});
    QStringList names = found(part(text, QStringLiteral("\nCommands:"), QStringLiteral("\n\n")),
                              QStringLiteral("^  ([a-z]+)  "))
                            .values();
    names.sort();
    return names;
}

QSet<QString> CliOptionsTest::optionsOf(const QString& subcommand) {
    QSet<QString> options = found(help({subcommand}), longOption);
    options.remove(QStringLiteral("help")); // said once for all
    return options;
}

QString CliOptionsTest::read(const char* path) {
    QFile file(support::sourcePath(QStringLiteral("resources/")) + QLatin1String(path));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

void CliOptionsTest::completionsAndManualKnowEveryOption() {
    QFETCH(QString, subcommand);
    const QSet<QString> options = optionsOf(subcommand);
    QVERIFY(options.size() >= 3);
    const QString bash = part(read("completions/barycage-cli.bash"),
                              subcommand + QStringLiteral(") options="), QStringLiteral(";;"));
    QCOMPARE(found(bash, longOption) - QSet<QString>{QStringLiteral("help")}, options);

    const QString manual =
        read("linux/barycage-cli.1.in").replace(QStringLiteral("\\-"), QStringLiteral("-"));
    const QString section = part(manual, QStringLiteral(".SS ") + subcommand, QStringLiteral("\n.SS "))
                                .section(QStringLiteral("\n.PP\n"), 0, 0);
    QCOMPARE(found(section, QStringLiteral("^\\.BI? --([a-z][a-z-]*)")), options);
    for (const QString& option : options)
        QVERIFY2(section.count(QRegularExpression(QStringLiteral("^\\.BI? --%1( |$)").arg(option),
                                                  QRegularExpression::MultilineOption)) == 1,
                 qPrintable(option));

    const QString zsh = read("completions/_barycage-cli");
    const QString fish = read("completions/barycage-cli.fish");
    for (const QString& option : options) {
        QVERIFY2(zsh.contains(QStringLiteral("--") + option + u'[') ||
                     zsh.contains(QStringLiteral("--") + option + u'}'),
                 qPrintable(option));
        QVERIFY2(found(fish, QStringLiteral("-l ([a-z-]+)")).contains(option) ||
                     part(fish, QStringLiteral("for option in"), QStringLiteral("\n"))
                         .split(u' ')
                         .contains(option),
                 qPrintable(option));
    }
}

void CliOptionsTest::nothingElseIsOffered() {
    QSet<QString> all{QStringLiteral("help"), QStringLiteral("version"), QStringLiteral("option")};
    for (const QString& command : commands())
        all += optionsOf(command);
    for (const char* file : {"completions/barycage-cli.bash", "completions/_barycage-cli"})
        for (const QString& option : found(read(file), QStringLiteral("(?<![-\\w])--([a-z][a-z-]+)")))
            QVERIFY2(all.contains(option), qPrintable(option));
    for (const QString& option :
         found(read("completions/barycage-cli.fish"), QStringLiteral("^complete .* -l ([a-z][a-z-]+)")))
        QVERIFY2(all.contains(option), qPrintable(option));
}

void CliOptionsTest::everySubcommandIsOffered() {
    const QStringList names = commands();
    QVERIFY(names.size() >= 4);
    for (const QString& name : names) {
        QVERIFY2(read("completions/barycage-cli.bash")
                     .contains(QRegularExpression(QStringLiteral("_barycage_cli_offer [a-z ]*\\b") + name)),
                 qPrintable(name));
        QVERIFY2(read("completions/_barycage-cli").contains(u'\'' + name + u'['), qPrintable(name));
        QVERIFY2(read("completions/barycage-cli.fish")
                     .contains(QStringLiteral("-f -a ") + name + QStringLiteral(" -d")),
                 qPrintable(name));
        QVERIFY2(read("linux/barycage-cli.1.in").contains(QStringLiteral(".B barycage-cli ") + name),
                 qPrintable(name));
    }
}

// Before a command both, behind one its help.
void CliOptionsTest::helpAndVersionAreOffered() {
    const QString bash = read("completions/barycage-cli.bash");
    const QString zsh = read("completions/_barycage-cli");
    const QString fish = read("completions/barycage-cli.fish");
    const QString first = part(zsh, QStringLiteral("CURRENT == 2"), QStringLiteral("return"));
    for (const char* option : {"help", "version"}) {
        const QString name = QString::fromLatin1(option);
        QVERIFY(bash.contains(QRegularExpression(QStringLiteral("_barycage_cli_offer info .*--") + name)));
        QVERIFY(first.contains(QStringLiteral("--") + name + u'['));
        QVERIFY(found(fish, QStringLiteral("-l ([a-z-]+)")).contains(name));
    }
    for (const QString& command : commands()) {
        QVERIFY(part(bash, u' ' + command + QStringLiteral(") options="), QStringLiteral(";;"))
                    .contains(QStringLiteral("--help")));
        QVERIFY2(part(zsh, u' ' + command + QStringLiteral(")\n"), QStringLiteral(";;"))
                     .contains(QStringLiteral("--help[")),
                 qPrintable(command));
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

BARYCAGE_TEST(CliOptionsTest, QCoreApplication);
#include "cli_options_test.moc"
