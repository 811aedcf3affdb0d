// SPDX-License-Identifier: MIT
#include "commands.h"
#include "input.h"
#include "messages.h"
#include "progress_bar.h"
#include "usage_error.h"

#include "io/info_report.h"
#include "io/number.h"

#include <QCoreApplication>

#include <memory>

namespace cli {

namespace {

struct Arguments {
    std::string file;
    std::vector<std::string> entries;
    bool json = false;
    std::optional<std::string> hullTolerance;
    std::string progress = "auto";
};

std::optional<double> tolerance(const Arguments& arguments) {
    if (!arguments.hullTolerance) return std::nullopt;
    const QString text = QString::fromStdString(*arguments.hullTolerance);
    const auto value = io::parseNumber(text);
    if (!value || !(*value > 0))
        throw UsageError{
            QCoreApplication::translate("cli", "--hull-tolerance takes a positive length, and not “%1”.")
                .arg(text)};
    return value;
}

ExitStatus info(const Arguments& arguments) {
    progressMode(arguments.progress); // taken for the sake of scripts: nothing here is long
    const auto hullTolerance = tolerance(arguments);
    const auto input = readInput(arguments.file);
    if (!input) return ExitStatus::CannotReadOrWrite;
    const Selection selection = select(*input, arguments.entries);
    const ExitStatus problems = reportAll(selection.problems, input->name);
    const io::InfoSubject subject{input->name, input->collection.format, selection.entries,
                                  selection.problems, hullTolerance};
    if (!print(arguments.json ? io::infoJson(subject) : printable(io::infoText(subject)).toUtf8())) {
        reportError(input->name,
                    QCoreApplication::translate("cli", "The answer cannot be written to standard output."));
        return ExitStatus::CannotReadOrWrite;
    }
    return selection.complete && !selection.entries.isEmpty() ? problems : ExitStatus::InputProblems;
}

} // namespace

void addInfoCommand(CLI::App& program, Run& run) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command = program.add_subcommand("info", "Say what a file holds and what is known about it");
    command
        ->add_option("FILE", arguments->file,
                     "Collection, or picture with a system inside; - for standard input")
        ->required();
    command->add_option("--entry", arguments->entries, "Only the entry of this name (may be repeated)")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
    command->add_flag("--json", arguments->json, "One JSON object with every digit");
    command->add_option("--hull-tolerance", arguments->hullTolerance,
                        "Tolerance of the convex hull, in the system's units (1e-6 of the diagonal)");
    command->add_option("--progress", arguments->progress, "always, never or auto");
    command->callback([arguments, &run] { run = [arguments] { return info(*arguments); }; });
}

} // namespace cli
