// SPDX-License-Identifier: MIT
#include "options/commands.h"
#include "options/tr.h"
#include "options/usage_error.h"
#include "process/arguments.h"
#include "process/heading.h"
#include "process/input.h"
#include "process/interrupt.h"
#include "process/messages.h"
#include "process/output.h"
#include "process/picture_suffixes.h"
#include "process/progress_bar.h"

#include "io/picture/contact_sheet.h"
#include "io/picture/picture_writers.h"

#include <QFileInfo>
#include <QPageSize>

#include <algorithm>
#include <memory>

namespace cli {

namespace {

struct GalleryArguments {
    std::vector<std::string> files;
    std::vector<std::string> entries;
    std::string output;
    QSize tile{240, 240};
    io::ContactSheet::Paper paper = io::ContactSheet::Paper::Dark;
    std::string title;
    int columns = 0; // 0: as many as fit
    std::optional<attractor::Palette> palette;
    std::optional<attractor::ColourBy> colour;
    std::optional<QPageSize> page;
    Verbosity verbosity;
};

io::ContactSheet sheetOf(const GalleryArguments& arguments) {
    io::ContactSheet sheet;
    sheet.title = QString::fromStdString(arguments.title);
    sheet.columns = arguments.columns;
    sheet.tile = arguments.tile;
    sheet.paper = arguments.paper;
    sheet.threads = io::threadsOfThisMachine();
    return sheet;
}

bool takesSheets(const io::PictureFileFacts& facts) {
    return facts.takes8Bits;
}

// nullopt: PDF.
std::optional<io::PictureFile> fileOf(const QString& output) {
    const QString suffix = QFileInfo(output).suffix();
    if (isStandardOutput(output)) return io::PictureFile::Png;
    if (suffix.compare(u"pdf", Qt::CaseInsensitive) == 0) return std::nullopt;
    const auto file = io::pictureFileOf(suffix);
    if (!file || !takesSheets(io::factsOf(*file)))
        throw UsageError{tr("The sheet can be written as %1, and “%2” is none of them.")
                             .arg(namedSuffixes(takesSheets, tr("or"), {"pdf"}), output)};
    return file;
}

// A name, or width and height in millimetres.
QPageSize pageArgument(const std::string&, const std::string& text) {
    const QString name = QString::fromStdString(text).toLower();
    if (name == u"a3") return QPageSize(QPageSize::A3);
    if (name == u"a4") return QPageSize(QPageSize::A4);
    if (name == u"a5") return QPageSize(QPageSize::A5);
    if (name == u"letter") return QPageSize(QPageSize::Letter);
    if (name == u"legal") return QPageSize(QPageSize::Legal);
    constexpr double minPageSide = 50, maxPageSide = 5000; // mm
    const QStringList sides = name.split(u'x');
    bool areNumbers[2] = {false, false};
    QSizeF size;
    if (sides.size() == 2) size = {sides[0].toDouble(&areNumbers[0]), sides[1].toDouble(&areNumbers[1])};
    if (!areNumbers[0] || !areNumbers[1] || !(std::min(size.width(), size.height()) >= minPageSide) ||
        !(std::max(size.width(), size.height()) <= maxPageSide))
        throw UsageError{
            tr("--page “%1” is not valid: it must be A3, A4, A5, letter, legal, or width and height "
               "from 50 to 5000 millimetres, such as 297x210.")
                .arg(QString::fromStdString(text))};
    return QPageSize(size, QPageSize::Millimeter, {}, QPageSize::ExactMatch);
}

// Settings shared by all tiles.
struct Style {
    std::optional<attractor::Palette> palette;
    std::optional<attractor::ColourBy> colourBy;
    bool isLight = false;
};

std::shared_ptr<const document::Fractal> styled(const std::shared_ptr<const document::Fractal>& fractal,
                                                const Style& style) {
    if (!style.palette && !style.colourBy && !style.isLight) return fractal;
    auto changed = std::make_shared<document::Fractal>(*fractal);
    attractor::Appearance& appearance = changed->appearance;
    if (style.palette) appearance.palette = *style.palette;
    if (style.colourBy) appearance.colourBy = *style.colourBy;
    if (style.isLight) putOn(appearance, {255, 255, 255, 255});
    return changed;
}

// An entry that cannot be read is left out, which is no failure of the sheet.
ExitStatus reportOmitted(const Selection& selection, const Input& input) {
    const ExitStatus status = reportAll(input.collection.file.problems, input.name);
    for (const document::Entry& entry : selection.entries)
        for (document::Problem problem : entry.problems) {
            problem.severity = document::Problem::Severity::Warning;
            report(problem, input.name);
        }
    return selection.complete ? status : std::max(status, ExitStatus::InputProblems);
}

// Reports problems of a file and shows its good entries all the same.
ExitStatus addFiles(const GalleryArguments& arguments, const Style& style, io::ContactSheet& sheet) {
    ExitStatus worst = ExitStatus::Done;
    for (const std::string& file : arguments.files) {
        const auto input = readInput(file);
        if (!input) {
            worst = ExitStatus::CannotReadOrWrite;
            continue;
        }
        const Selection selection = select(*input, arguments.entries);
        worst = std::max(worst, reportOmitted(selection, *input));
        io::ContactSheet::Section section;
        if (arguments.files.size() > 1) section.title = headingOf(input->name);
        for (const auto& entry : selection.entries)
            if (isLoaded(entry)) section.fractals << styled(entry.fractal, style);
        if (!section.fractals.isEmpty()) sheet.sections << section;
    }
    return worst;
}

ExitStatus gallery(const GalleryArguments& arguments) {
    const ProgressMode mode = applied(arguments.verbosity);
    io::ContactSheet sheet = sheetOf(arguments);
    const Style style{arguments.palette, arguments.colour, sheet.paper == io::ContactSheet::Paper::Light};
    const Interrupt interrupt;
    const QString output = fileNameOf(arguments.output);
    const auto file = fileOf(output);
    if (file && arguments.page) throw UsageError{tr("--page cannot be used here: only a .pdf has pages.")};
    const QPageSize page = arguments.page.value_or(QPageSize(QPageSize::A4));
    const ExitStatus read = addFiles(arguments, style, sheet);
    if (sheet.sections.isEmpty()) {
        reportError(output, tr("No file contains an entry that can be shown, so nothing was written."));
        return std::max(read, ExitStatus::InputProblems);
    }
    ProgressBar bar(mode);
    const auto progress = [&bar](double fraction) { bar.show(fraction); };
    if (file)
        if (const io::Failure reason = io::whyImpossible(sheet, *file)) throw UsageError{*reason};
    const auto write = [&](const QString& path) {
        return file ? io::exportSheet(sheet, *file, path, progress, interrupt.token())
                    : io::exportSheetPdf(sheet, page, path, progress, interrupt.token());
    };
    const io::ExportOutcome outcome = exportBy(write, output);
    bar.clear();
    if (outcome.stopped) {
        reportError(output, tr("Interrupted; nothing was written."));
        return interrupt.status();
    }
    if (outcome.failure) {
        reportError(output, *outcome.failure);
        return ExitStatus::CannotReadOrWrite;
    }
    return read;
}

} // namespace

Command galleryCommand() {
    auto arguments = std::make_shared<GalleryArguments>();
    Command command("gallery", "Draw all entries of collections on one sheet",
                    "gallery FILE... -o SHEET [OPTION]...");
    const OptionGroup files = command.group("Files");
    files.argument("FILE...", &arguments->files, "Collections; - for standard input").required();
    files
        .add("-o,--output", "SHEET", &arguments->output,
             "Sheet to write: " + namedSuffixes(takesSheets, tr("or"), {"pdf"}).toStdString() +
                 "; - for standard output (PNG)")
        .completedBy(Completion::Kind::Files, pictureSuffixes(takesSheets, {"pdf"}))
        .fileName()
        .required();
    addEntriesOption(command, arguments->entries);
    const OptionGroup colours = command.group("Colours");
    colours
        .add("--palette", "PALETTE", parsed(&arguments->palette, paletteArgument),
             "Palette: a name, as render lists them, or a file", "stored in each entry, else Maple")
        .completedBy(Completion::Kind::Palettes)
        .fileName();
    colours.add("--colour,--color", "BY",
                choice(&arguments->colour, std::span<const ifs::Named<attractor::ColourBy>>(coloursInPlane)),
                "Colour by density, map, address, blend or none", "stored in each entry, else density");
    const OptionGroup sheet = command.group("Sheet");
    sheet.add("--title", "TEXT", &arguments->title, "Title above the sheet").orEmpty();
    sheet.add("--columns", "N", parsed(&arguments->columns, integerFrom(1, 1000)),
              "Pictures per row, 1 to 1000", "enough to fill a screen, at most 1920 pixels");
    sheet
        .add("--page", "SIZE", parsed(&arguments->page, pageArgument),
             "Pages of a .pdf: A3, A4, A5, letter, legal, or WIDTHxHEIGHT in millimetres", "A4")
        .completedBy(Completion::Kind::Words, {"A3", "A4", "A5", "letter", "legal"});
    sheet.add("--tile", "WxH", parsed(&arguments->tile, sizeArgument),
              "Width and height of a picture in pixels", "240x240");
    sheet.add("--paper", "PAPER", choice(&arguments->paper),
              "Background of the sheet and its pictures: dark or light", "dark");
    addVerbosityOptions(command, arguments->verbosity);
    command.run = [arguments] { return gallery(*arguments); };
    return command;
}

} // namespace cli
