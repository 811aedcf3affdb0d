// SPDX-License-Identifier: MIT
#include "options/help.h"
#include "options/options.h"
#include "options/parser.h"
#include "options/usage_error.h"
#include "support/named_test.h"

#include <QTest>

#include <stdexcept>

using cli::Command;
using cli::OptionGroup;
using cli::Program;
using cli::UsageError;

namespace {

cli::ExitStatus nothing() {
    return cli::ExitStatus::Done;
}

// A command of a program of its own, with a place of each kind.
struct Table {
    bool flag = false;
    std::string text = "before";
    std::optional<std::string> absent;
    std::vector<std::string> list, files;

    Program program() {
        Command command("draw", "Draw something", "draw FILE... OUT [OPTION]...");
        const OptionGroup group = command.group("Things");
        group.argument("FILE...", &files, "Files");
        group.flag("-f,--flag", &flag, "A flag");
        group.add("--text", "TEXT", &text, "A text", "before").excludes("--absent");
        group.add("-a,--absent,--missing", "TEXT", &absent, "A text that may be absent");
        group.add("--list", "NAME", &list, "A list");
        command.run = nothing;
        return {"A program", {command}};
    }
};

QString complaintOf(const std::vector<std::string>& words) {
    Table table;
    const Program program = table.program();
    try {
        cli::parse(program, words);
    } catch (const UsageError& error) {
        return error.sentence;
    }
    return {};
}

} // namespace

class OptionTableTest : public QObject {
    Q_OBJECT

private slots:
    void valuesGoToTheirPlaces();
    void nothingIsStoredBeforeAllMakesSense();
    void argumentsFillOnePlaceAfterTheOther();
    void optionsExcludeEachOther();
    void helpHasTheHeadingsAndTheGeneralOptionsLast();
    void tablesThatContradictThemselvesAreRefused();
    void optionsAreFoundByAnyName();
};

void OptionTableTest::valuesGoToTheirPlaces() {
    Table table;
    const Program program = table.program();
    const cli::Call call = cli::parse(program, {"draw", "a", "-faone", "--list", "[x,y]", "b", "--list={}"});
    QVERIFY(call.command == program.find("draw"));
    QVERIFY(table.flag);
    QCOMPARE(table.text, std::string("before"));
    QCOMPARE(table.absent, std::optional<std::string>("one"));
    QCOMPARE(table.list, (std::vector<std::string>{"[x,y]", "{}"}));
    QCOMPARE(table.files, (std::vector<std::string>{"a", "b"}));
}

void OptionTableTest::nothingIsStoredBeforeAllMakesSense() {
    Table table;
    const Program program = table.program();
    QVERIFY_THROWS_EXCEPTION(UsageError, cli::parse(program, {"draw", "-f", "--list", "x", "--text"}));
    QVERIFY_THROWS_EXCEPTION(
        UsageError, cli::parse(program, {"draw", "-f", "--list", "x", "--absent", "y", "--text", "z"}));
    QVERIFY(!table.flag);
    QVERIFY(table.list.empty());
    QVERIFY(!table.absent);
}

void OptionTableTest::argumentsFillOnePlaceAfterTheOther() {
    std::string first;
    std::vector<std::string> rest;
    Command command("join", "Join files", "join FIRST REST...");
    const OptionGroup files = command.group("Files");
    files.argument("FIRST", &first, "The first").required();
    files.argument("REST... LAST", &rest, "The others").required().minimum(2);
    command.run = nothing;
    const Program program("A program", {command});
    cli::parse(program, {"join", "a", "b", "--", "-c"});
    QCOMPARE(first, std::string("a"));
    QCOMPARE(rest, (std::vector<std::string>{"b", "-c"}));
    try {
        cli::parse(program, {"join", "a", "b"});
        QFAIL("one of the files is missing");
    } catch (const UsageError& error) {
        QCOMPARE(error.sentence, QStringLiteral("LAST is missing. Usage: barycage-cli join FIRST REST..."));
    }
}

void OptionTableTest::optionsExcludeEachOther() {
    const auto expected = QStringLiteral("--text and --absent cannot be used together.");
    QCOMPARE(complaintOf({"draw", "--text", "x", "-a", "y"}), expected);
    QCOMPARE(complaintOf({"draw", "--missing", "y", "--text", "x"}), expected);
    QCOMPARE(complaintOf({"draw", "--missing", "y", "--flag"}), QString());
}

void OptionTableTest::helpHasTheHeadingsAndTheGeneralOptionsLast() {
    Table table;
    const Program program = table.program();
    const std::string help = cli::helpText(program, program.find("draw"));
    QCOMPARE(QString::fromStdString(help),
             QStringLiteral("Draw something\n\n"
                            "Usage: barycage-cli draw FILE... OUT [OPTION]...\n\n"
                            "Things:\n"
                            "  FILE...                 Files\n"
                            "  -f, --flag              A flag\n"
                            "  --text TEXT             A text [default: before]\n"
                            "  -a, --absent, --missing TEXT\n"
                            "                          A text that may be absent\n"
                            "  --list NAME             A list\n\n"
                            "Options:\n"
                            "  -h, --help              Print this help message and exit\n"));
}

void OptionTableTest::tablesThatContradictThemselvesAreRefused() {
    bool flag = false;
    Command command("draw", "Draw something", "draw");
    const OptionGroup group = command.group("Things");
    group.flag("-f,--flag", &flag, "A flag");
    QVERIFY_THROWS_EXCEPTION(std::logic_error, group.flag("-f", &flag, "Its short name again"));
    QVERIFY_THROWS_EXCEPTION(std::logic_error, group.flag("--other,--flag", &flag, "Its long name again"));
    QVERIFY_THROWS_EXCEPTION(std::logic_error, group.flag("--twice,--twice", &flag, "A name twice"));
    QVERIFY_THROWS_EXCEPTION(std::logic_error, group.flag("--help", &flag, "Every command has it"));
    QCOMPARE(command.options.size(), std::size_t(2));

    QVERIFY_THROWS_EXCEPTION(std::logic_error, Program("A program", {command, command}));
    command.option("-f").excludes("--absent");
    QVERIFY_THROWS_EXCEPTION(std::logic_error, Program("A program", {command}));
}

void OptionTableTest::optionsAreFoundByAnyName() {
    Table table;
    Command command = table.program().commands.front();
    QVERIFY(&command.option("--missing") == &command.option("-a"));
    QVERIFY(command.find("--missing") == command.find("-a"));
    QVERIFY(command.find("--help") != nullptr);
    QVERIFY(command.find("missing") == nullptr);
    QVERIFY_THROWS_EXCEPTION(std::logic_error, command.option("--mis"));
}

BARYCAGE_TEST(OptionTableTest);
#include "option_table_test.moc"
