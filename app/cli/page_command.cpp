// SPDX-License-Identifier: MIT
#include "options/commands.h"
#include "options/tr.h"
#include "options/usage_error.h"
#include "page_lesson.h"
#include "process/arguments.h"
#include "process/heading.h"
#include "process/input.h"
#include "process/messages.h"
#include "process/output.h"
#include "process/progress_bar.h"

#include "io/page/page_export.h"

#include <QSize>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cli {

namespace {

struct PageArguments {
    std::string file, entry, lesson, output;
    bool all = false;
    std::string caption, language;
    io::PageParts parts = io::PageParts::All;
    std::vector<std::string> allowed{"cage", "maps", "code"};
    std::optional<QSize> size;
    std::uint64_t points = io::PageExport().points;
    Verbosity verbosity;
};

std::vector<std::string> allowArgument(const std::string&, const std::string& text) {
    constexpr const char* known[] = {"cage", "maps", "code", "none"};
    std::vector<std::string> words;
    for (const QString& word : QString::fromStdString(text).split(u',')) {
        words.push_back(word.trimmed().toStdString());
        if (std::ranges::find(known, words.back()) == std::end(known))
            throw UsageError{tr("--allow “%1” is not valid: it must be cage, maps, code, some of them "
                                "between commas, or none.")
                                 .arg(QString::fromStdString(text))};
    }
    return words;
}

std::string languageArgument(const std::string& option, const std::string& text) {
    const std::vector<std::string> languages(io::pageLanguages.begin(), io::pageLanguages.end());
    return languages[choiceArgument(option, text, languages)];
}

io::PageExport pageWith(const PageArguments& arguments, const document::Fractal& fractal) {
    const auto allows = [&](const char* what) {
        return std::ranges::find(arguments.allowed, what) != arguments.allowed.end();
    };
    io::PageExport page;
    page.fractal = fractal;
    page.parts = arguments.parts;
    page.allowsCage = allows("cage");
    page.allowsMaps = allows("maps");
    page.allowsCode = allows("code");
    page.caption = QString::fromStdString(arguments.caption);
    page.language = QString::fromStdString(arguments.language);
    page.size = arguments.size;
    page.points = arguments.points;
    return page;
}

// A page, or a script where the name of the output says so.
ExitStatus writeAsNamed(const PageArguments& arguments, const io::PageExport& page) {
    const QString output = fileNameOf(arguments.output);
    const bool isScript = output.endsWith(QLatin1String(".js"), Qt::CaseInsensitive);
    return writeOutput(output, isScript ? io::scriptOf(page) : io::pageOf(page));
}

// Leaves out entries that cannot be shown, which is no failure of the gallery.
ExitStatus writeGallery(const PageArguments& arguments, const Input& input) {
    constexpr qsizetype most = 2000;
    const auto warn = [&](const QString& name, const QString& sentence) {
        report({document::Problem::Severity::Warning, name, 0, 0, sentence}, input.name);
    };
    QList<std::shared_ptr<const document::Fractal>> shown;
    for (const document::Entry& entry : input.collection.file.entries) {
        for (const document::Problem& problem : entry.problems)
            warn(entry.fractal->name, problem.message);
        if (!isLoaded(entry)) continue;
        const QString obstacle = io::pageObstacle(*entry.fractal);
        if (obstacle.isEmpty())
            shown << entry.fractal;
        else
            warn(entry.fractal->name, obstacle);
    }
    const ExitStatus read = reportAll(input.collection.file.problems, input.name);
    if (shown.isEmpty() || shown.size() > most) {
        reportError(input.name,
                    shown.isEmpty()
                        ? tr("The file contains no entry that can be drawn.")
                        : tr("The file has %1 entries that can be shown; a web page can have at most %2.")
                              .arg(shown.size())
                              .arg(most));
        return std::max(read, ExitStatus::InputProblems);
    }
    io::PageExport page = pageWith(arguments, *shown.front());
    page.entries = shown;
    page.title = input.name == u"-" ? tr("Fractals") : headingOf(input.name);
    return std::max(read, writeAsNamed(arguments, page));
}

ExitStatus writeLesson(const PageArguments& arguments, const Input& input) {
    io::PageExport page = pageWith(arguments, {});
    const ExitStatus read = addLesson(page, arguments.lesson, input);
    if (page.steps.isEmpty()) return read;
    return std::max(read, writeAsNamed(arguments, page));
}

ExitStatus writePage(const PageArguments& arguments) {
    applied(arguments.verbosity);
    const auto input = readInput(arguments.file);
    if (!input) return ExitStatus::CannotReadOrWrite;
    if (arguments.all) return writeGallery(arguments, *input);
    if (!arguments.lesson.empty()) return writeLesson(arguments, *input);
    std::vector<std::string> names;
    if (!arguments.entry.empty()) names.push_back(arguments.entry);
    const ToDraw found = entriesToDraw(*input, names);
    if (found.entries.size() > 1)
        throw UsageError{tr("A page shows one entry: give its name or #NUMBER with --entry, or --all.")};
    if (found.entries.empty()) return std::max(found.status, ExitStatus::InputProblems);
    const document::Fractal& fractal = *found.entries.front()->fractal;
    if (const QString obstacle = io::pageObstacle(fractal); !obstacle.isEmpty()) {
        reportError(input->name, obstacle);
        return ExitStatus::InputProblems;
    }
    return std::max(found.status, writeAsNamed(arguments, pageWith(arguments, fractal)));
}

} // namespace

Command pageCommand() {
    auto arguments = std::make_shared<PageArguments>();
    Command command("page", "Write an entry, or a collection, as a web page in which cages can be dragged",
                    "page FILE -o PAGE.html [OPTION]...");
    const OptionGroup files = command.group("Files");
    files
        .argument("FILE", &arguments->file,
                  "Collection, or picture with an embedded system; - for standard input")
        .fileName()
        .required();
    files
        .add("-o,--output", "PAGE", &arguments->output,
             "Page to write: .html, or .js for a script that shows it in an article; - for standard output")
        .completedBy(Completion::Kind::Files, {"html", "js"})
        .fileName()
        .required();
    files
        .add("--entry", "NAME", &arguments->entry, "The entry that is shown: its name, or #NUMBER",
             "the first that can be read")
        .completedBy(Completion::Kind::Entries);
    files
        .flag("--all", &arguments->all,
              "A gallery of all entries: small pictures, to be searched by name, each of which leads to its "
              "figure")
        .excludes("--entry");
    files
        .add("--lesson", "LESSON", &arguments->lesson,
             "A lesson about the collection: the texts of its steps, with the entry, cage, colours and area "
             "of each")
        .completedBy(Completion::Kind::Files, {"lesson"})
        .fileName()
        .excludes("--entry")
        .excludes("--all");
    const OptionGroup page = command.group("Page");
    page.add("--show", "PARTS", choice(&arguments->parts),
             "Parts of the page: figure, table (and the maps) or all (and palettes and files to save)",
             "all");
    page.add("--allow", "EDITS", parsed(&arguments->allowed, allowArgument),
             "What the reader can edit: cage and maps by dragging, code by typing, some of them between "
             "commas, or none",
             "cage,maps,code")
        .completedBy(Completion::Kind::Words, {"cage", "maps", "code", "cage,maps", "cage,code", "none"});
    page.add("--caption", "TEXT", &arguments->caption, "Caption below the name").orEmpty();
    page.add("--lang", "LANGUAGE", parsed(&arguments->language, languageArgument),
             "Language of the page: en, de, es, fr or mk", "that of the browser")
        .completedBy(Completion::Kind::Words, {io::pageLanguages.begin(), io::pageLanguages.end()});
    page.add("--size", "WxH", parsed(&arguments->size, sizeArgument),
             "Width and height of the picture in pixels of the page", "as large as the window allows");
    page.add("--points", "N", parsed(&arguments->points, countFrom(10'000, 1'000'000'000)),
             "Points of the picture at rest; suffixes k, M, G", "20M");
    addVerbosityOptions(command, arguments->verbosity);
    command.run = [arguments] { return writePage(*arguments); };
    return command;
}

} // namespace cli
