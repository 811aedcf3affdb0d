// SPDX-License-Identifier: MIT
#include "commands.h"
#include "input.h"
#include "messages.h"
#include "usage_error.h"

#include "io/flame.h"
#include "io/fractint_writer.h"
#include "io/save_file.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <memory>

namespace cli {

namespace {

struct Arguments {
    std::string input;
    std::string output;
    std::vector<std::string> entries;
    std::string format;
    bool bake = false;
    bool strict = false;
};

enum class Format { Fractint, Flame };

QString tr(const char* text) {
    return QCoreApplication::translate("cli", text);
}

Format formatOf(const Arguments& arguments) {
    const QString name = arguments.format.empty()
                             ? QFileInfo(QString::fromStdString(arguments.output)).suffix().toLower()
                             : QString::fromStdString(arguments.format).toLower();
    if (name == u"ifs" || name == u"fractint") return Format::Fractint;
    if (name == u"flame") return Format::Flame;
    throw UsageError{
        tr("This version converts to fractint (.ifs) and flame (.flame), and not to “%1”.").arg(name)};
}

// The entry under its cage becomes the code; false when the cage is too flat, which is then reported.
bool bakeEntry(document::Entry& entry, const QString& fileName) {
    const document::System2* system = document::system2(*entry.fractal);
    if (!system || !entry.fractal->cage || entry.fractal->cage->rest == entry.fractal->cage->current)
        return true;
    const auto baked = ifs::bake(*system, *entry.fractal->cage);
    if (!baked) {
        reportError(fileName,
                    tr("The cage of “%1” is too flat to be baked into the code.").arg(entry.fractal->name));
        return false;
    }
    document::Fractal fractal = *entry.fractal;
    fractal.system = baked->system;
    fractal.cage = baked->cage;
    entry.fractal = std::make_shared<const document::Fractal>(std::move(fractal));
    return true;
}

// What goes into the output; nullopt after a problem that has been reported.
std::optional<document::FractalFile> fileToWrite(const Input& input, const Arguments& arguments) {
    document::FractalFile file = input.collection.file;
    if (!arguments.entries.empty()) {
        const Selection selection = select(input, arguments.entries);
        if (!selection.complete) return std::nullopt;
        file.entries = selection.entries;
        file.tail.clear();
    }
    bool good = true;
    for (auto& entry : file.entries)
        if (arguments.bake) good = bakeEntry(entry, input.name) && good;
    return good ? std::optional(std::move(file)) : std::nullopt;
}

// Problems that keep entries from being converted. A copy byte for byte minds none.
bool reportProblems(const Input& input, const document::FractalFile& file) {
    bool good = !file.entries.isEmpty();
    for (const auto& problem : input.collection.file.problems)
        report(problem, input.name);
    for (const auto& entry : file.entries) {
        for (const auto& problem : entry.problems)
            report(problem, input.name);
        good = good && isLoaded(entry);
    }
    return good;
}

QByteArray flameOf(const document::FractalFile& file, const QString& fileName) {
    QList<std::shared_ptr<const document::Fractal>> plane;
    for (const auto& entry : file.entries) {
        if (document::system2(*entry.fractal))
            plane << entry.fractal;
        else
            reportWarning(fileName,
                          tr("“%1” is left out: a flame holds plane systems only.").arg(entry.fractal->name));
    }
    return plane.isEmpty() ? QByteArray() : io::writeFlame(plane);
}

QByteArray strictOf(const document::FractalFile& file, const QString& fileName) {
    const io::StrictText text = io::writeStrict(file);
    for (const auto& problem : text.problems)
        report(problem, fileName);
    return text.bytes;
}

// nullopt when no entry can be written in this form, which has then been reported.
std::optional<QByteArray> bytesOf(const document::FractalFile& file, Format format, bool strict,
                                  const QString& fileName) {
    const bool flame = format == Format::Flame;
    if (!flame && !strict) return io::writeFractint(file);
    const QByteArray bytes = flame ? flameOf(file, fileName) : strictOf(file, fileName);
    if (!bytes.isEmpty()) return bytes;
    reportError(fileName, tr("No entry is left that could be written, so nothing was."));
    return std::nullopt;
}

ExitStatus save(const Arguments& arguments, const QByteArray& bytes) {
    const QString output = QString::fromStdString(arguments.output);
    const auto failure = io::saveFile(output, bytes);
    if (!failure) return ExitStatus::Done;
    reportError(output, *failure);
    return ExitStatus::CannotReadOrWrite;
}

ExitStatus convert(const Arguments& arguments) {
    const Format format = formatOf(arguments);
    if (format == Format::Flame && arguments.strict)
        throw UsageError{tr("--strict is not possible here: it belongs to .ifs.")};
    const auto input = readInput(arguments.input);
    if (!input) return ExitStatus::CannotReadOrWrite;
    const bool untouched = arguments.entries.empty() && !arguments.bake && !arguments.strict;
    if (untouched && format == Format::Fractint && input->collection.format == u"fractint")
        return save(arguments, input->bytes);
    const auto file = fileToWrite(*input, arguments);
    if (!file || !reportProblems(*input, *file)) return ExitStatus::InputProblems;
    const auto bytes = bytesOf(*file, format, arguments.strict, input->name);
    return bytes ? save(arguments, *bytes) : ExitStatus::InputProblems;
}

} // namespace

void addConvertCommand(CLI::App& program, Run& run) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command = program.add_subcommand("convert", "Write entries in another form");
    command->add_option("IN", arguments->input, "File to read; - for standard input")->required();
    command->add_option("OUT", arguments->output, "File to write")->required();
    command->add_option("--entry", arguments->entries, "Only the entry of this name (may be repeated)")
        ->expected(1)
        ->take_all();
    command->add_flag("--bake", arguments->bake, "Make what the cage shows the code");
    command->add_flag("--strict", arguments->strict, "Write .ifs that every reader takes");
    command->add_option("--to", arguments->format, "fractint or flame, where the name of OUT does not tell");
    command->callback([arguments, &run] { run = [arguments] { return convert(*arguments); }; });
}

} // namespace cli
