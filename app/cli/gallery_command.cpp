// SPDX-License-Identifier: MIT
#include "arguments.h"
#include "commands.h"
#include "input.h"
#include "interrupt.h"
#include "messages.h"
#include "output.h"
#include "progress_bar.h"
#include "usage_error.h"

#include "io/contact_sheet.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileInfo>

#include <memory>

namespace cli {

namespace {

struct Arguments {
    std::vector<std::string> files;
    std::string output;
    std::string tile = "240x240";
    std::string paper = "dark";
    std::string title;
    std::optional<int> columns;
    std::string progress = "auto";
};

QString tr(const char* text) {
    return QCoreApplication::translate("cli", text);
}

// "sierpinski.ifs" → "Sierpinski"
QString headingOf(const QString& fileName) {
    QString title = QFileInfo(fileName).completeBaseName();
    title.replace(u'_', u' ').replace(u'-', u' ');
    if (!title.isEmpty()) title[0] = title[0].toUpper();
    return title;
}

io::ContactSheet sheetOf(const Arguments& arguments) {
    const QString output = QString::fromStdString(arguments.output);
    if (!isStandardOutput(output) && QFileInfo(output).suffix().compare(u"png", Qt::CaseInsensitive) != 0)
        throw UsageError{tr("The sheet is written as .png, and “%1” is not.").arg(output)};
    io::ContactSheet sheet;
    sheet.title = QString::fromStdString(arguments.title);
    sheet.columns = arguments.columns.value_or(0);
    sheet.tile = sizeArgument("--tile", arguments.tile);
    sheet.paper = arguments.paper == "light" ? io::ContactSheet::Paper::Light : io::ContactSheet::Paper::Dark;
    sheet.threads = io::threadsOfThisMachine();
    return sheet;
}

// What is wrong with a file is said, and its good entries are shown all the same.
ExitStatus addFiles(const Arguments& arguments, io::ContactSheet& sheet) {
    ExitStatus worst = ExitStatus::Done;
    for (const std::string& file : arguments.files) {
        const auto input = readInput(file);
        if (!input) {
            worst = ExitStatus::CannotReadOrWrite;
            continue;
        }
        worst = std::max(worst, reportAll(select(*input, {}).problems, input->name));
        io::ContactSheet::Section section;
        if (arguments.files.size() > 1) section.title = headingOf(input->name);
        for (const auto& entry : input->collection.file.entries)
            if (isLoaded(entry)) section.fractals << entry.fractal;
        if (!section.fractals.isEmpty()) sheet.sections << section;
    }
    return worst;
}

ExitStatus gallery(const Arguments& arguments) {
    const ProgressMode mode = progressMode(arguments.progress);
    io::ContactSheet sheet = sheetOf(arguments);
    const Interrupt interrupt;
    const QString output = QString::fromStdString(arguments.output);
    const ExitStatus read = addFiles(arguments, sheet);
    if (sheet.sections.isEmpty()) {
        reportError(output, tr("No file holds an entry that could be shown, so nothing was written."));
        return std::max(read, ExitStatus::InputProblems);
    }
    ProgressBar bar(mode);
    const io::DrawnSheet drawn = io::drawSheet(
        sheet, [&bar](double fraction) { bar.show(fraction); }, interrupt.token());
    bar.clear();
    if (drawn.failure) throw UsageError{*drawn.failure};
    if (drawn.image.isNull()) {
        reportError(output, tr("Interrupted; nothing was written."));
        return ExitStatus::Interrupted;
    }
    QBuffer png;
    drawn.image.save(&png, "PNG");
    return std::max(read, writeOutput(output, png.data()));
}

} // namespace

void addGalleryCommand(CLI::App& program, Run& run) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command = program.add_subcommand("gallery", "Draw all entries of collections on one sheet");
    command->add_option("FILES", arguments->files, "Collections; - for standard input")->required();
    command->add_option("-o,--output", arguments->output, "Sheet to write: .png; - for standard output")
        ->required();
    command->add_option("--columns", arguments->columns, "Pictures side by side (as wide as a screen)")
        ->check(CLI::Range(1, 1000));
    command->add_option("--tile", arguments->tile, "Width and height of a picture in pixels (240x240)");
    command->add_option("--paper", arguments->paper, "dark or light (dark)")
        ->check(CLI::IsMember({"dark", "light"}));
    command->add_option("--title", arguments->title, "A title over the sheet");
    command->add_option("--progress", arguments->progress, "always, never or auto");
    command->callback([arguments, &run] { run = [arguments] { return gallery(*arguments); }; });
}

} // namespace cli
