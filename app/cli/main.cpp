// SPDX-License-Identifier: MIT
#include "commands.h"
#include "messages.h"
#include "output.h"
#include "usage_error.h"

#include <QGuiApplication>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <memory>
#include <new>
#include <sstream>
#include <string_view>
#include <system_error>

namespace {

using cli::ExitStatus;

// Help and version are answered on standard output; anything else that CLI11 throws is wrong usage.
ExitStatus parse(CLI::App& program, int argc, char** argv) {
    try {
        program.parse(argc, argv);
        return ExitStatus::Done;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == int(CLI::ExitCodes::Success)) {
            std::ostringstream answer;
            program.exit(error, answer, std::cerr);
            return cli::writeOutput(QStringLiteral("-"), QByteArray::fromStdString(answer.str()));
        }
        const auto called = program.get_subcommands();
        if (called.empty() && argc > 1 && argv[1][0] != '-') {
            cli::reportUsage(
                {},
                QCoreApplication::translate(
                    "cli", "There is no command “%1”; the commands are info, render, convert and gallery.")
                    .arg(QString::fromLocal8Bit(argv[1])));
            return ExitStatus::WrongUsage;
        }
        cli::reportUsage(called.empty() ? QString() : QString::fromStdString(called.front()->get_name()),
                         QString::fromUtf8(error.what()));
        return ExitStatus::WrongUsage;
    }
}

// The parser takes "" for an option that is not there. Only a title may be no text.
void refuseEmptyValues(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
        const auto& values = option->results();
        const bool isEmpty = option->nonpositional() && std::ranges::find(values, "") != values.end();
        if (isEmpty && option->get_single_name() != "title")
            throw cli::UsageError{QCoreApplication::translate("cli", "What is given for --%1 is empty.")
                                      .arg(QString::fromStdString(option->get_single_name()))};
    }
}

ExitStatus runCommand(const CLI::App& program, const cli::Run& run) {
    try {
        refuseEmptyValues(*program.get_subcommands().front());
        return run();
    } catch (const cli::InputError& error) {
        cli::reportError(error.fileName, error.sentence);
        return error.status;
    } catch (const cli::UsageError& error) {
        cli::reportUsage(QString::fromStdString(program.get_subcommands().front()->get_name()),
                         error.sentence);
        return ExitStatus::WrongUsage;
    } catch (const std::bad_alloc&) {
        cli::reportError(QStringLiteral("barycage-cli"),
                         QCoreApplication::translate("cli", "There is not enough memory for this."));
        return ExitStatus::CannotReadOrWrite;
    } catch (const std::system_error& error) {
        cli::reportError(QStringLiteral("barycage-cli"), QString::fromLocal8Bit(error.what()));
        return ExitStatus::CannotReadOrWrite;
    }
}

} // namespace

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN); // a limit on the size of files is an error of writing, not the end
    // Letters on a sheet need a QGuiApplication; it gets no display all the same.
    std::unique_ptr<QCoreApplication> application;
    if (argc > 1 && std::string_view(argv[1]) == "gallery") {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        qputenv("QT_LOGGING_RULES", "default.warning=false"); // what is wrong with the desktop is no concern
        application = std::make_unique<QGuiApplication>(argc, argv);
    } else {
        application = std::make_unique<QCoreApplication>(argc, argv);
    }
    for (int i = 1; i < argc; ++i)
        if (!QByteArrayView(argv[i]).isValidUtf8()) { // under another name nothing is found again
            cli::reportUsage({},
                             QCoreApplication::translate(
                                 "cli", "“%1” is not UTF-8. Please rename the file, or lead to it by a link.")
                                 .arg(QString::fromUtf8(argv[i])));
            return int(ExitStatus::WrongUsage);
        }
    CLI::App program("Iterated function systems from the command line", "barycage-cli");
    program.set_version_flag("--version", "barycage-cli " BARYCAGE_VERSION);
    program.require_subcommand(1);
    cli::Run run;
    cli::addInfoCommand(program, run);
    cli::addRenderCommand(program, run);
    cli::addConvertCommand(program, run);
    cli::addGalleryCommand(program, run);
    const ExitStatus parsed = parse(program, argc, argv);
    return int(run && parsed == ExitStatus::Done ? runCommand(program, run) : parsed);
}
