// SPDX-License-Identifier: MIT
#include "arguments.h"
#include "commands.h"
#include "input.h"
#include "interrupt.h"
#include "messages.h"
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

// One input file and what is to become of it.
struct Job {
    std::string input;
    QString output; // a file; for a folder, what the names in it begin with
    bool inFolder = false;
};

// What every input is converted to, checked before any of them is read.
struct Plan {
    Format format = TextFormat::Fractint;
    io::ReadOptions reading;
    io::TextOptions writing;
    std::uint64_t points = 0;
    std::uint64_t seed = 1;
    std::vector<Job> jobs;
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

std::vector<Job> jobsOf(const Arguments& arguments, const Format& format) {
    const QString output = QString::fromStdString(arguments.files.back());
    const bool inFolder = output.endsWith(u'/') || QFileInfo(output).isDir();
    if (arguments.files.size() > 2 && !inFolder)
        throw UsageError{tr("Several files are converted into a folder, and “%1” is none. (A name that ends "
                            "in / makes one.)")
                             .arg(output)};
    std::vector<Job> jobs;
    QSet<QString> taken;
    for (std::size_t i = 0; i + 1 < arguments.files.size(); ++i) {
        const QFileInfo input(QString::fromStdString(arguments.files[i]));
        Job job{arguments.files[i], output, inFolder};
        if (inFolder)
            job.output = QDir(output).filePath(input.fileName() == u"-" ? QStringLiteral("standard-input")
                                                                        : input.completeBaseName());
        if (taken.contains(job.output))
            throw UsageError{
                tr("Two of the files would be written to “%1”.").arg(job.output + u'.' + suffixOf(format))};
        taken.insert(job.output);
        jobs.push_back(job);
    }
    return jobs;
}

Plan planOf(const Arguments& arguments) {
    const QFileInfo output(QString::fromStdString(arguments.files.back()));
    if ((output.isDir() || output.fileName().isEmpty()) && arguments.format.empty())
        throw UsageError{tr("Say with --to what the files in the folder shall be.")};
    Plan plan;
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
    plan.jobs = jobsOf(arguments, plan.format);
    return plan;
}

// The entry under its cage becomes the code; false when the cage is too flat, which is then reported.
bool bakeEntry(document::Entry& entry, const QString& fileName) {
    if (!document::system2(*entry.fractal) || !entry.fractal->cage ||
        entry.fractal->cage->rest == entry.fractal->cage->current)
        return true;
    auto baked = document::withCageBaked(*entry.fractal);
    if (!baked) {
        reportError(fileName,
                    tr("The cage of “%1” is too flat to be baked into the code.").arg(entry.fractal->name));
        return false;
    }
    entry.fractal = std::make_shared<const document::Fractal>(*std::move(baked));
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

using Fractals = QList<std::shared_ptr<const document::Fractal>>;

// The plane systems; what is left out is said.
Fractals planeSystems(const document::FractalFile& file, const QString& fileName) {
    Fractals plane;
    for (const auto& entry : file.entries) {
        if (document::system2(*entry.fractal))
            plane << entry.fractal;
        else
            reportWarning(
                fileName,
                tr("“%1” is left out: the format holds plane systems only.").arg(entry.fractal->name));
    }
    return plane;
}

ExitStatus save(const QString& output, const QByteArray& bytes) {
    const auto failure = io::saveFile(output, bytes);
    if (!failure) return ExitStatus::Done;
    reportError(output, *failure);
    return ExitStatus::CannotReadOrWrite;
}

ExitStatus nothingLeft(const QString& fileName) {
    reportError(fileName, tr("No entry is left that could be written, so nothing was."));
    return ExitStatus::InputProblems;
}

class Converter {
public:
    Converter(const Arguments& arguments, const Plan& plan, std::stop_token stop)
        : m_arguments(arguments), m_plan(plan), m_stop(std::move(stop)) {}

    ExitStatus run(const Job& job, const io::Progress& progress) const {
        const auto input = readInput(job.input, m_plan.reading);
        if (!input) return ExitStatus::CannotReadOrWrite;
        if (job.inFolder && !QDir().mkpath(QFileInfo(job.output).path())) {
            reportError(QFileInfo(job.output).path(), tr("The folder cannot be made."));
            return ExitStatus::CannotReadOrWrite;
        }
        const QString output = job.inFolder ? job.output + u'.' + suffixOf(m_plan.format) : job.output;
        const bool untouched = m_arguments.entries.empty() && !m_arguments.bake && !m_arguments.strict;
        if (untouched && isFractint(m_plan.format) && input->collection.format == u"fractint" &&
            !isParameterFile(*input))
            return save(output, input->bytes);
        const auto file = fileToWrite(*input, m_arguments);
        if (!file || !reportProblems(*input, *file)) return ExitStatus::InputProblems;
        if (isFractint(m_plan.format)) return saveCollection(*file, input->name, output);
        const Fractals systems = planeSystems(*file, input->name);
        if (systems.isEmpty()) return nothingLeft(input->name);
        if (std::holds_alternative<PdfFormat>(m_plan.format)) return savePages(systems, input->name, output);
        if (holdsOneEntry(m_plan.format)) return saveEach(systems, job, input->name, output, progress);
        return save(output, io::textOf(systems, std::get<TextFormat>(m_plan.format), m_plan.writing));
    }

private:
    // Out of a parameter file only the systems are wanted, not the parameters around them.
    static bool isParameterFile(const Input& input) {
        return QFileInfo(input.name).suffix().compare(u"par", Qt::CaseInsensitive) == 0;
    }

    ExitStatus saveCollection(document::FractalFile file, const QString& name, const QString& output) const {
        if (name.endsWith(u".par", Qt::CaseInsensitive)) {
            file.head.clear();
            file.tail.clear();
            for (auto& entry : file.entries)
                entry.source.reset();
        }
        if (!m_arguments.strict) return save(output, io::writeFractint(file));
        const io::StrictText text = io::writeStrict(file);
        for (const auto& problem : text.problems)
            report(problem, name);
        return text.bytes.isEmpty() ? nothingLeft(name) : save(output, text.bytes);
    }

    // One square page for every system that has an attractor.
    ExitStatus savePages(const Fractals& systems, const QString& inputName, const QString& output) const {
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
        if (pages.empty()) return nothingLeft(inputName);
        const io::PdfPicture picture = io::pdfPicture(pages, m_stop);
        if (m_stop.stop_requested()) return ExitStatus::Interrupted;
        return save(output, picture.bytes);
    }

    // One file for every system.
    ExitStatus saveEach(const Fractals& systems, const Job& job, const QString& inputName,
                        const QString& output, const io::Progress& progress) const {
        if (systems.size() == 1) return saveOne(systems.first(), output, inputName, progress);
        if (!job.inFolder) {
            reportError(inputName, tr("The file has %1 systems, and %2 holds one: choose it with --entry, or "
                                      "name a folder to write one file for each.")
                                       .arg(systems.size())
                                       .arg(QFileInfo(output).fileName()));
            return ExitStatus::InputProblems;
        }
        ExitStatus worst = ExitStatus::Done;
        QSet<QString> taken;
        for (qsizetype i = 0; i < systems.size() && !m_stop.stop_requested(); ++i) {
            QString name = systems[i]->name;
            name.replace(u'/', u'_');
            while (taken.contains(name.toLower()))
                name += u'_';
            taken.insert(name.toLower());
            const io::Progress part = [&](double fraction) {
                progress((double(i) + fraction) / double(systems.size()));
            };
            const QString file = job.output + u'-' + name + u'.' + suffixOf(m_plan.format);
            worst = std::max(worst, saveOne(systems[i], file, inputName, part));
        }
        return worst;
    }

    ExitStatus saveOne(const std::shared_ptr<const document::Fractal>& fractal, const QString& output,
                       const QString& inputName, const io::Progress& progress) const {
        if (const auto* text = std::get_if<TextFormat>(&m_plan.format))
            return save(output, io::textOf({fractal}, *text, m_plan.writing));
        const auto format = std::get<io::PointFormat>(m_plan.format);
        const auto outcome =
            io::exportPoints({*fractal, m_plan.points, m_plan.seed, format}, output, progress, m_stop);
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
};

ExitStatus convert(const Arguments& arguments) {
    const ProgressMode mode = progressMode(arguments.progress);
    const Plan plan = planOf(arguments);
    const Interrupt interrupt;
    const Converter converter(arguments, plan, interrupt.token());
    ExitStatus worst = ExitStatus::Done;
    ProgressBar bar(mode);
    for (std::size_t i = 0; i < plan.jobs.size() && worst != ExitStatus::Interrupted; ++i) {
        const io::Progress progress = [&](double fraction) {
            bar.show((double(i) + fraction) / double(plan.jobs.size()));
        };
        worst = std::max(worst, converter.run(plan.jobs[i], progress));
        progress(1);
        if (interrupt.token().stop_requested()) worst = ExitStatus::Interrupted;
    }
    bar.clear();
    if (worst == ExitStatus::Interrupted)
        reportError(QString::fromStdString(arguments.files.back()),
                    tr("Interrupted; what is written so far is whole."));
    return worst;
}

} // namespace

void addConvertCommand(CLI::App& program, Run& run) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command = program.add_subcommand("convert", "Write entries in another form");
    command
        ->add_option("FILES", arguments->files,
                     "Files to read (- for standard input), then the file or folder to write")
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
