// SPDX-License-Identifier: MIT
#include "arguments.h"
#include "commands.h"
#include "input.h"
#include "interrupt.h"
#include "messages.h"
#include "output.h"
#include "progress_bar.h"
#include "usage_error.h"

#include "io/fractint_writer.h"
#include "io/pdf_writer.h"
#include "io/point_cloud.h"
#include "io/text_formats.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QSet>

#include <algorithm>
#include <memory>
#include <variant>

namespace cli {

namespace {

using io::TextFormat;
struct PdfFormat {
    friend bool operator==(const PdfFormat&, const PdfFormat&) = default;
};
using Format = std::variant<TextFormat, io::PointFormat, PdfFormat>;

struct Arguments {
    std::vector<std::string> files; // the inputs, then the output
    std::vector<std::string> entries;
    std::string format;
    std::optional<std::string> columns, inColumns, points, seed;
    bool bake = false;
    bool strict = false;
    bool yAsWritten = false;
    std::string progress = "auto";
};

QString tr(const char* text) {
    return QCoreApplication::translate("cli", text);
}

// What every input is converted to, checked before any of them is read.
struct Plan {
    Format format = TextFormat::Fractint;
    io::ReadOptions reading;
    io::TextOptions writing;
    std::uint64_t points = 0;
    std::uint64_t seed = 1;
    QString output;
    bool intoFolder = false;
};

bool isFractint(const Format& format) {
    return format == Format(TextFormat::Fractint);
}

bool isTable(const Format& format) {
    const auto* text = std::get_if<TextFormat>(&format);
    return text && io::holdsOneSystem(*text);
}

bool holdsOneEntry(const Format& format) {
    return isTable(format) || std::holds_alternative<io::PointFormat>(format);
}

QString suffixOf(const Format& format) {
    if (const auto* text = std::get_if<TextFormat>(&format)) return io::suffixOf(*text);
    if (std::holds_alternative<PdfFormat>(format)) return QStringLiteral("pdf");
    return std::get<io::PointFormat>(format) == io::PointFormat::Ply ? QStringLiteral("ply")
                                                                     : QStringLiteral("csv");
}

Format formatOf(const Arguments& arguments, const QFileInfo& output) {
    const QString name =
        arguments.format.empty() ? output.suffix() : QString::fromStdString(arguments.format);
    if (arguments.points && name.compare(u"csv", Qt::CaseInsensitive) == 0) return io::PointFormat::Csv;
    if (name.compare(u"ply", Qt::CaseInsensitive) == 0) {
        if (!arguments.points) throw UsageError{tr("A .ply file holds points: say how many with --points.")};
        return io::PointFormat::Ply;
    }
    if (name.compare(u"pdf", Qt::CaseInsensitive) == 0) return PdfFormat{};
    if (const auto format = io::textFormat(name)) return *format;
    throw UsageError{
        tr("Files are written as fractint (.ifs), flame, aifs, csv, tsv, ply and pdf, and not as “%1”.")
            .arg(name)};
}

io::TableColumns columnsArgument(const char* option, const std::string& text) {
    if (const auto columns = io::tableColumns(QString::fromStdString(text))) return *columns;
    throw UsageError{
        tr("%1 “%2” is not an order of columns: it names a b c d (or r s theta phi), e and f, and perhaps p, "
           "each once, like \"a b e c d f p\".")
            .arg(QLatin1String(option), QString::fromStdString(text))};
}

void refuseIf(bool given, const char* option, const QString& reason) {
    if (given) throw UsageError{tr("%1 is not possible here: %2").arg(QLatin1String(option), reason)};
}

Plan planOf(const Arguments& arguments) {
    Plan plan;
    plan.output = QString::fromStdString(arguments.files.back());
    const QFileInfo output(plan.output);
    const bool isPrinted = isStandardOutput(plan.output);
    if (plan.output.isEmpty()) throw UsageError{tr("The name of the output is empty.")};
    plan.intoFolder = !isPrinted && (output.isDir() || output.fileName().isEmpty());
    if (plan.intoFolder && arguments.format.empty())
        throw UsageError{tr("Say with --to what the files in the folder shall be.")};
    if (isPrinted && arguments.format.empty())
        throw UsageError{tr("Say with --to what is written to standard output.")};
    plan.format = formatOf(arguments, output);
    refuseIf(arguments.strict && !isFractint(plan.format), "--strict", tr("it belongs to .ifs."));
    refuseIf(arguments.columns && !isTable(plan.format), "--columns",
             tr("it belongs to tables (.csv and .tsv); the order in a table that is read is --in-columns."));
    refuseIf(arguments.points && !std::holds_alternative<io::PointFormat>(plan.format), "--points",
             tr("points are written as .csv or .ply."));
    refuseIf(arguments.seed && !arguments.points, "--seed", tr("it belongs to --points."));
    if (arguments.yAsWritten) plan.reading.axis = plan.writing.axis = io::FlameAxis::AsWritten;
    if (arguments.inColumns) plan.reading.columns = columnsArgument("--in-columns", *arguments.inColumns);
    if (arguments.columns) plan.writing.columns = columnsArgument("--columns", *arguments.columns);
    if (arguments.points) plan.points = wholeArgument("--points", *arguments.points);
    if (arguments.points && (plan.points < 1 || plan.points > io::PointCloud::mostPoints))
        throw UsageError{tr("--points takes a number from 1 to %1.").arg(io::PointCloud::mostPoints)};
    if (arguments.seed) plan.seed = wholeArgument("--seed", *arguments.seed);
    if (arguments.files.size() > 2 && !plan.intoFolder)
        throw UsageError{tr("Several files are converted into a folder, and “%1” is none. (A name that ends "
                            "in / makes one.)")
                             .arg(plan.output)};
    return plan;
}

// What is written of a file. Every entry that is not is said.
struct Content {
    document::FractalFile file; // with the entries that can be written
    qsizetype asked = 0;        // entries, with those that are left out
    ExitStatus status = ExitStatus::Done;
};

bool isUnderMovedCage(const document::Fractal& fractal) {
    return document::system2(fractal) && fractal.cage && fractal.cage->rest != fractal.cage->current;
}

bool hasActiveMap(const document::Fractal& fractal) {
    const auto* space = std::get_if<document::System3>(&fractal.system);
    return space ? !ifs::activeMaps(*space).maps.empty()
                 : !ifs::activeMaps(*document::system2(fractal)).maps.empty();
}

// Why the entry cannot be written in this form; the code takes up the cage where that is asked.
std::optional<QString> obstacle(document::Entry& entry, const Arguments& arguments, const Plan& plan) {
    const document::Fractal& fractal = *entry.fractal;
    const auto* text = std::get_if<TextFormat>(&plan.format);
    if (text ? !io::holds(*text, fractal) : !document::system2(fractal))
        return tr("“%1” is left out: the format holds plane systems only.").arg(fractal.name);
    if (arguments.columns && !document::system2(fractal))
        return tr("“%1” is left out: --columns names the columns of plane systems.").arg(fractal.name);
    if (arguments.bake && isUnderMovedCage(fractal)) {
        if (ifs::bends(*fractal.cage))
            return tr("“%1” is left out: its cage bends the picture, which no code can do.")
                .arg(fractal.name);
        auto baked = document::withCageBaked(fractal);
        if (!baked)
            return tr("“%1” is left out: its cage is too flat to be baked into the code.").arg(fractal.name);
        entry.fractal = std::make_shared<const document::Fractal>(*std::move(baked));
    }
    if (const auto* points = std::get_if<io::PointFormat>(&plan.format))
        return io::obstacle({*entry.fractal, plan.points, plan.seed, *points});
    if (plan.format == Format(TextFormat::Aifs) && !hasActiveMap(fractal))
        return tr("“%1” is left out: no map takes part.").arg(fractal.name);
    return std::nullopt;
}

Content contentOf(const Input& input, const Arguments& arguments, const Plan& plan) {
    const Selection selection = select(input, arguments.entries);
    Content content{input.collection.file, selection.entries.size(),
                    reportAll(selection.problems, input.name)};
    if (!selection.complete) content.status = ExitStatus::InputProblems;
    if (!arguments.entries.empty()) content.file.tail.clear();
    content.file.entries.clear();
    for (document::Entry entry : selection.entries) {
        if (!isLoaded(entry)) continue;
        if (const auto reason = obstacle(entry, arguments, plan)) {
            reportError(input.name, *reason);
            content.status = ExitStatus::InputProblems;
        } else {
            content.file.entries << entry;
        }
    }
    return content;
}

// An entry of a parameter file as it is in a collection: without the prefix of its name, and of what stands
// before it with the comments right above.
std::shared_ptr<const document::EntrySource> withoutParameters(const document::EntrySource& entry,
                                                               bool isFirst) {
    auto source = std::make_shared<document::EntrySource>(entry);
    if (constexpr QByteArrayView prefix = "ifs:";
        source->text.first(std::min(prefix.size(), source->text.size()))
            .compare(prefix, Qt::CaseInsensitive) == 0)
        source->text = source->text.sliced(prefix.size());
    while (source->text.startsWith(' ') || source->text.startsWith('\t'))
        source->text.remove(0, 1);
    QByteArrayList lines = entry.before.split(entry.lineEnd.back());
    lines.removeLast(); // what stands before the name on its line
    source->before = isFirst ? QByteArray() : entry.lineEnd;
    qsizetype first = lines.size();
    while (first > 0 && lines[first - 1].trimmed().startsWith(';'))
        --first;
    for (const QByteArray& line : lines.sliced(first))
        source->before += line + entry.lineEnd.back();
    return source;
}

using Fractals = QList<std::shared_ptr<const document::Fractal>>;

Fractals systemsOf(const document::FractalFile& file) {
    Fractals systems;
    for (const auto& entry : file.entries)
        systems << entry.fractal;
    return systems;
}

// How many entries were written, where some were not.
struct Written {
    qsizetype entries = 0;
    ExitStatus status = ExitStatus::Done;
};

class Converter {
public:
    Converter(const Arguments& arguments, const Plan& plan, std::stop_token stop)
        : m_arguments(arguments), m_plan(plan), m_stop(std::move(stop)) {}

    ExitStatus run(const std::string& file, const io::Progress& progress) {
        const auto input = readInput(file, m_plan.reading);
        if (!input) return ExitStatus::CannotReadOrWrite;
        const QString base = baseOf(*input);
        if (m_plan.intoFolder && !QDir().mkpath(m_plan.output)) {
            reportError(m_plan.output, tr("The folder cannot be made."));
            return ExitStatus::CannotReadOrWrite;
        }
        const bool untouched = m_arguments.entries.empty() && !m_arguments.bake && !m_arguments.strict &&
                               !m_arguments.inColumns && !m_arguments.yAsWritten;
        if (untouched && isFractint(m_plan.format) && isCollectionFile(*input))
            return writeOutput(outputFor(base, input->name), input->bytes);
        const Content content = contentOf(*input, m_arguments, m_plan);
        if (content.file.entries.isEmpty()) return nothingLeft(input->name);
        const Written written = save(content.file, base, input->name, progress);
        const ExitStatus status = std::max(content.status, written.status);
        if (written.entries == content.asked || written.entries == 0) return status;
        if (status > ExitStatus::InputProblems) return status;
        const auto say = status == ExitStatus::Done ? reportWarning : reportError;
        say(input->name, tr("Entries written: %1; left out: %2.")
                             .arg(written.entries)
                             .arg(content.asked - written.entries));
        return status;
    }

private:
    // By its name, or where that says nothing by what is in it: what no other reader knows goes to that of
    // collections, and need be none. Out of a parameter file only the systems are wanted, not the parameters
    // around them.
    static bool isCollectionFile(const Input& input) {
        const QString suffix = QFileInfo(input.name).suffix().toLower();
        if (suffix == u"ifs" || suffix == u"par") return suffix == u"ifs";
        const document::FractalFile& file = input.collection.file;
        return input.collection.format == u"fractint" && !file.entries.isEmpty() &&
               std::ranges::none_of(file.problems, [](const document::Problem& problem) {
                   return problem.severity == document::Problem::Severity::Error;
               });
    }

    static ExitStatus nothingLeft(const QString& fileName) {
        reportError(fileName, tr("No entry is left that could be written, so nothing was."));
        return ExitStatus::InputProblems;
    }

    // The output, in a folder without its suffix.
    QString baseOf(const Input& input) const {
        if (!m_plan.intoFolder) return m_plan.output;
        const QString name =
            input.name == u"-" ? QStringLiteral("standard-input") : QFileInfo(input.name).completeBaseName();
        return QDir(m_plan.output).filePath(name);
    }

    // A file in the folder that this run has not written yet.
    QString outputFor(const QString& base, const QString& inputName) {
        if (!m_plan.intoFolder) return m_plan.output;
        const QString suffix = u'.' + suffixOf(m_plan.format);
        const QString wanted = base + suffix;
        QString output = wanted;
        for (int number = 2; m_taken.contains(output.toLower()); ++number)
            output = base + u'-' + QString::number(number) + suffix;
        m_taken.insert(output.toLower());
        if (output != wanted)
            reportWarning(inputName, tr("It is written to “%1”, for “%2” is taken.").arg(output, wanted));
        return output;
    }

    Written save(const document::FractalFile& file, const QString& base, const QString& inputName,
                 const io::Progress& progress) {
        if (isFractint(m_plan.format)) return saveCollection(file, outputFor(base, inputName), inputName);
        const Fractals systems = systemsOf(file);
        if (std::holds_alternative<PdfFormat>(m_plan.format))
            return savePages(systems, outputFor(base, inputName), inputName);
        if (holdsOneEntry(m_plan.format)) return saveEach(systems, base, inputName, progress);
        return {systems.size(),
                writeOutput(outputFor(base, inputName),
                            io::textOf(systems, std::get<TextFormat>(m_plan.format), m_plan.writing))};
    }

    Written saveCollection(document::FractalFile file, const QString& output, const QString& name) const {
        if (name.endsWith(u".par", Qt::CaseInsensitive)) {
            file.head.clear();
            file.tail.clear();
            for (auto& entry : file.entries)
                if (entry.source) // none in a flame of that name
                    entry.source = withoutParameters(*entry.source, &entry == &file.entries.first());
        }
        if (!m_arguments.strict) return {file.entries.size(), writeOutput(output, io::writeFractint(file))};
        const io::StrictText text = io::writeStrict(file);
        const ExitStatus status = reportAll(text.problems, name);
        if (text.bytes.isEmpty()) return {0, nothingLeft(name)};
        return {text.entries, std::max(status, writeOutput(output, text.bytes))};
    }

    // One square page for every system that has an attractor.
    Written savePages(const Fractals& systems, const QString& output, const QString& inputName) const {
        constexpr int side = 700; // pixels, a good seven inches
        std::vector<io::PdfPage> pages;
        for (const auto& fractal : systems) {
            attractor::Camera camera;
            camera.width = camera.height = side;
            const auto box = document::displayedBox(*fractal);
            if (box) camera = attractor::fitted(camera, box->min, box->max);
            io::PdfPage page{*fractal, camera, {}};
            const auto failure = io::svgPlan(page.fractal, page.camera, page.format).failure;
            if (failure)
                reportWarning(inputName, tr("“%1” is left out: %2").arg(fractal->name, *failure));
            else
                pages.push_back(std::move(page));
        }
        if (pages.empty()) return {0, nothingLeft(inputName)};
        const io::PdfPicture picture = io::pdfPicture(pages, m_stop);
        if (m_stop.stop_requested()) return {0, ExitStatus::Interrupted};
        return {qsizetype(pages.size()), writeOutput(output, picture.bytes)};
    }

    // One file for every system.
    Written saveEach(const Fractals& systems, const QString& base, const QString& inputName,
                     const io::Progress& progress) {
        if (systems.size() == 1)
            return {1, saveOne(systems.first(), outputFor(base, inputName), inputName, progress)};
        if (!m_plan.intoFolder) {
            reportError(inputName, tr("The file has %1 systems, and %2 holds one: choose it with --entry, or "
                                      "name a folder to write one file for each.")
                                       .arg(systems.size())
                                       .arg(QFileInfo(base).fileName()));
            return {0, ExitStatus::InputProblems};
        }
        Written written;
        for (qsizetype i = 0; i < systems.size() && !m_stop.stop_requested(); ++i) {
            QString name = systems[i]->name;
            name.replace(u'/', u'_');
            const io::Progress part = [&](double fraction) {
                progress((double(i) + fraction) / double(systems.size()));
            };
            const QString output = outputFor(base + u'-' + name, inputName);
            written.status = std::max(written.status, saveOne(systems[i], output, inputName, part));
            ++written.entries;
        }
        return written;
    }

    ExitStatus saveOne(const std::shared_ptr<const document::Fractal>& fractal, const QString& output,
                       const QString& inputName, const io::Progress& progress) const {
        if (const auto* text = std::get_if<TextFormat>(&m_plan.format))
            return writeOutput(output, io::textOf({fractal}, *text, m_plan.writing));
        const auto format = std::get<io::PointFormat>(m_plan.format);
        const io::PointCloud cloud{*fractal, m_plan.points, m_plan.seed, format};
        const auto outcome = exportOutput(cloud, output, progress, m_stop);
        if (outcome.stopped) return ExitStatus::Interrupted;
        if (outcome.failure) {
            reportError(output, *outcome.failure);
            return ExitStatus::CannotReadOrWrite;
        }
        if (outcome.note != attractor::RenderNote::None)
            reportWarning(inputName,
                          tr("“%1” is not known to have an attractor; the points are where orbits go "
                             "before they escape.")
                              .arg(fractal->name));
        return ExitStatus::Done;
    }

    const Arguments& m_arguments;
    const Plan& m_plan;
    std::stop_token m_stop;
    QSet<QString> m_taken; // files in the folder, in small letters
};

ExitStatus convert(const Arguments& arguments) {
    const ProgressMode mode = progressMode(arguments.progress);
    const Plan plan = planOf(arguments);
    const Interrupt interrupt;
    Converter converter(arguments, plan, interrupt.token());
    ExitStatus worst = ExitStatus::Done;
    ProgressBar bar(mode);
    const std::size_t files = arguments.files.size() - 1;
    for (std::size_t i = 0; i < files && worst != ExitStatus::Interrupted; ++i) {
        const io::Progress progress = [&](double fraction) {
            bar.show((double(i) + fraction) / double(files));
        };
        worst = std::max(worst, converter.run(arguments.files[i], progress));
        progress(1);
        if (interrupt.token().stop_requested()) worst = ExitStatus::Interrupted;
    }
    bar.clear();
    if (worst == ExitStatus::Interrupted)
        reportError(plan.output, tr("Interrupted; what is written so far is whole."));
    return worst;
}

} // namespace

void addConvertCommand(CLI::App& program, Run& run) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command = program.add_subcommand("convert", "Write entries in another form");
    command
        ->add_option(
            "FILES", arguments->files,
            "Files to read (- for standard input), then the file (- for standard output) or folder to write")
        ->required()
        ->expected(2, 1'000'000);
    command->add_option("--entry", arguments->entries, "Only the entry of this name (may be repeated)")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
    command->add_flag("--bake", arguments->bake, "Make what the cage shows the code");
    command->add_flag("--strict", arguments->strict, "Write .ifs that every reader takes");
    command->add_option(
        "--to", arguments->format,
        "fractint, flame, aifs, csv, tsv, ply or pdf, where the name of the output does not tell");
    command->add_option("--columns", arguments->columns,
                        "Order of the columns of a table, like \"a b e c d f p\" (a b c d e f p)");
    command->add_option("--in-columns", arguments->inColumns,
                        "Order of the columns in the table that is read (what its header says)");
    command->add_option("--points", arguments->points, "Write so many points (.csv, .ply) and not the maps");
    command->add_option("--seed", arguments->seed, "Seed of the random numbers for --points (1)");
    command->add_flag("--y-as-written", arguments->yAsWritten,
                      "Leave the y of flames as it is: their pictures grow downwards");
    command->add_option("--progress", arguments->progress, "always, never or auto");
    command->callback([arguments, &run] { run = [arguments] { return convert(*arguments); }; });
}

} // namespace cli
