// SPDX-License-Identifier: MIT
#include "convert/convert_format.h"
#include "convert/pdf_pages.h"
#include "convert/solid_arguments.h"
#include "convert/symmetry_arguments.h"
#include "options/commands.h"
#include "options/parser.h"
#include "options/tr.h"
#include "options/usage_error.h"
#include "process/arguments.h"
#include "process/input.h"
#include "process/interrupt.h"
#include "process/messages.h"
#include "process/output.h"
#include "process/progress_bar.h"

#include "document/edits/cage/cage_edits.h"
#include "document/edits/dimension_edits.h"
#include "document/text/file_names.h"
#include "io/exchange/point_cloud.h"
#include "io/file/native_path.h"
#include "io/fractint/fractint_strict.h"
#include "io/fractint/fractint_writer.h"
#include "io/solid/openscad.h"

#include <QDir>
#include <QFileInfo>
#include <QSet>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <variant>

namespace cli {

namespace {

namespace fs = std::filesystem;

using io::TextFormat;
struct ConvertArguments {
    std::vector<std::string> files; // inputs, then the output
    std::vector<std::string> entries;
    std::string format;
    std::optional<io::TableColumns> columns, inColumns;
    std::optional<std::uint64_t> points, seed;
    SolidArguments solid;
    SymmetryArguments symmetry;
    bool bake = false;
    bool strict = false;
    bool yAsWritten = false;
    bool overwrite = false;
    Verbosity verbosity;
};

// The target of all inputs, checked before any of them is read.
struct Plan {
    ConvertFormat format = TextFormat::Fractint;
    io::ReadOptions reading;
    io::TextOptions writing;
    std::uint64_t points = 0;
    std::uint64_t seed = 1;
    io::SolidOptions solid;
    DimensionChange change;
    SymmetryArguments symmetry;
    QString output;
    bool intoFolder = false;
};

io::TableColumns columnsArgument(const std::string& option, const std::string& text) {
    const bool isRead = option == "--in-columns";
    const QString order = QString::fromStdString(text);
    if (const auto columns = isRead ? io::columnsToRead(order) : io::tableColumns(order)) return *columns;
    throw UsageError{tr("%1 “%2” is not an order of columns: it must name a b c d (or r s theta phi), e and "
                        "f, and optionally p, each once, such as \"a b e c d f p\".")
                         .arg(QString::fromStdString(option), QString::fromStdString(text))};
}

fs::path nativePath(const QString& path) {
    return io::nativeName(path).toStdString();
}

bool isFolder(const QString& path) {
    std::error_code error;
    return fs::is_directory(nativePath(path), error);
}

bool makeFolder(const QString& path) {
    std::error_code error;
    fs::create_directories(nativePath(path), error);
    return isFolder(path);
}

Plan planOf(const ConvertArguments& arguments) {
    Plan plan;
    plan.output = fileNameOf(arguments.files.back());
    const QFileInfo output(plan.output);
    const bool isPrinted = isStandardOutput(plan.output);
    if (plan.output.isEmpty()) throw UsageError{tr("The name of the output is empty.")};
    plan.intoFolder = !isPrinted && (isFolder(plan.output) || output.fileName().isEmpty());
    if (plan.intoFolder && arguments.format.empty())
        throw UsageError{tr("Give the format of the files in the folder with --to.")};
    if (isPrinted && arguments.format.empty())
        throw UsageError{tr("Give the format for standard output with --to.")};
    plan.format =
        formatOf(arguments.format.empty() ? output.suffix() : QString::fromStdString(arguments.format),
                 arguments.points.has_value(), asksForVoxels(arguments.solid));
    refuseIf(arguments.strict && !isFractint(plan.format), "--strict", tr("it applies only to .ifs."));
    refuseIf(arguments.columns && !isTable(plan.format), "--columns",
             tr("it applies only to tables that are written (.csv and .tsv); for a table that is read, use "
                "--in-columns."));
    refuseIf(arguments.points && !std::holds_alternative<io::PointFormat>(plan.format), "--points",
             tr("points can be written only as .csv or .ply."));
    refuseIf(arguments.seed && !arguments.points, "--seed", tr("it applies only with --points."));
    const bool isMesh = std::holds_alternative<io::MeshFormat>(plan.format);
    plan.solid = solidOptions(arguments.solid, isMesh, std::holds_alternative<ScadFormat>(plan.format));
    plan.change = dimensionChange(arguments.solid);
    plan.symmetry = arguments.symmetry;
    if (arguments.yAsWritten) plan.reading.axis = plan.writing.axis = io::FlameAxis::AsWritten;
    if (arguments.inColumns) plan.reading.columns = *arguments.inColumns;
    if (arguments.columns) plan.writing.columns = *arguments.columns;
    if (arguments.points) plan.points = *arguments.points;
    if (arguments.seed) plan.seed = *arguments.seed;
    if (arguments.files.size() > 2 && !plan.intoFolder)
        throw UsageError{tr("Several files can be converted only into a folder, and “%1” is not one. (To "
                            "create a folder, end its name with /.)")
                             .arg(plan.output)};
    return plan;
}

// Content to write of a file. Every entry that is left out is reported.
struct Content {
    document::FractalFile file; // contains only entries that can be written
    qsizetype asked = 0;        // number of entries, including those left out
    ExitStatus status = ExitStatus::Done;
};

bool hasActiveMap(const document::Fractal& fractal) {
    const auto* space = document::system3(fractal);
    return space ? !ifs::activeMaps(*space).maps.empty()
                 : !ifs::activeMaps(*document::system2(fractal)).maps.empty();
}

// Why the entry cannot be written in this form; the code takes up the cage where that is asked.
std::optional<QString> obstacle(document::Entry& entry, const Input& input, const ConvertArguments& arguments,
                                const Plan& plan) {
    const QString loss = plan.change.isWanted() ? document::dimensionLoss(*entry.fractal) : QString();
    if (auto reason = changeDimension(entry, plan.change)) return reason;
    if (!loss.isEmpty()) reportWarning(input.name, loss);
    if (const auto warning = liftWarning(*entry.fractal, plan.change)) reportWarning(input.name, *warning);
    if (auto reason = changeSymmetry(entry, plan.symmetry)) return reason;
    const std::shared_ptr<const document::Fractal> before = entry.fractal;
    const document::Fractal& fractal = *before;
    if (const QString reason = dimensionObstacle(plan.format, fractal); !reason.isEmpty()) return reason;
    if (arguments.columns && !document::system2(fractal))
        return tr("“%1” was omitted: --columns applies only to systems in the plane.").arg(fractal.name);
    if (arguments.bake && !document::isAtRest(fractal)) {
        if (const auto* cage = document::cage2(fractal); cage && ifs::bends(*cage))
            return tr("“%1” was omitted: its cage bends the picture, which no code can reproduce.")
                .arg(fractal.name);
        auto baked = document::baked(fractal);
        if (!baked)
            return tr("“%1” was omitted: its cage is too flat to be baked into the code.").arg(fractal.name);
        entry.fractal = std::make_shared<const document::Fractal>(*std::move(baked));
    }
    Expansion expansion = expanded(entry, plan.symmetry);
    if (expansion.obstacle) return expansion.obstacle;
    if (expansion.warning) reportWarning(input.name, *expansion.warning);
    if (const auto* points = std::get_if<io::PointFormat>(&plan.format))
        return io::obstacle({*entry.fractal, plan.points, plan.seed, *points});
    if (plan.format == ConvertFormat(TextFormat::Aifs) && !hasActiveMap(fractal))
        return tr("“%1” was omitted: no map is active.").arg(fractal.name);
    return std::nullopt;
}

// Warns with the line of the entry, if it has one.
void warnOf(const QString& loss, const document::Entry& entry, const QString& fileName) {
    if (!entry.source) return reportWarning(fileName, loss);
    report({document::Problem::Severity::Warning, entry.fractal->name, entry.source->line, 1, loss},
           fileName);
}

Content contentOf(const Input& input, const ConvertArguments& arguments, const Plan& plan) {
    const Selection selection = select(input, arguments.entries);
    Content content{input.collection.file, selection.entries.size(),
                    reportAll(selection.problems, input.name)};
    if (!selection.complete) content.status = ExitStatus::InputProblems;
    if (!arguments.entries.empty()) content.file.tail.clear();
    content.file.entries.clear();
    for (document::Entry entry : selection.entries) {
        if (!isLoaded(entry)) continue;
        if (const auto reason = obstacle(entry, input, arguments, plan)) {
            reportError(input.name, *reason);
            content.status = ExitStatus::InputProblems;
        } else {
            const auto* text = std::get_if<TextFormat>(&plan.format);
            document::Fractal written = *entry.fractal;
            if (auto* shape = document::plane(written);
                shape && arguments.bake && document::isAtRest(written))
                shape->cage.reset(); // no longer needed
            if (auto* shape = document::space(written);
                shape && arguments.bake && document::isAtRest(written))
                shape->cage.reset();
            if (const auto loss = text ? io::lossOf(*text, written) : std::nullopt)
                warnOf(*loss, entry, input.name);
            content.file.entries << entry;
        }
    }
    return content;
}

// An entry of a parameter file as it is in a collection: without the prefix of its name, and with only the
// comments right above it.
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
    lines.removeLast(); // text before the name on its line
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

// Number of entries written, and the status, which tells if some were not.
struct Written {
    qsizetype entries = 0;
    ExitStatus status = ExitStatus::Done;
};

class Converter {
public:
    Converter(const ConvertArguments& arguments, const Plan& plan, const Interrupt& interrupt)
        : m_arguments(arguments), m_plan(plan), m_interrupt(interrupt), m_stop(interrupt.token()) {}

    bool isInterrupted() const { return m_isInterrupted; } // true if not everything was written
    int filesWritten() const { return m_filesWritten; }

    ExitStatus run(const std::string& file, const io::Progress& progress) {
        const auto input = readInput(file, m_plan.reading);
        if (!input) return ExitStatus::CannotReadOrWrite;
        const QString base = baseOf(*input);
        if (m_plan.intoFolder && !makeFolder(m_plan.output)) {
            reportError(m_plan.output, tr("The folder cannot be created."));
            return ExitStatus::CannotReadOrWrite;
        }
        const bool untouched = m_arguments.entries.empty() && !m_arguments.bake && !m_arguments.strict &&
                               !m_plan.change.isWanted() && !m_plan.symmetry.isWanted() &&
                               !m_arguments.inColumns && !m_arguments.yAsWritten;
        m_input = input->name;
        m_holdsLess = m_isRefused = false;
        if (untouched && isFractint(m_plan.format) && isCollectionFile(*input))
            return write(outputFor(base, input->name), input->bytes);
        const Content content = contentOf(*input, m_arguments, m_plan);
        if (content.file.entries.isEmpty()) return nothingLeft(input->name);
        const bool keepsAll = isFractint(m_plan.format) && input->collection.format == u"fractint";
        m_holdsLess = !keepsAll || content.file.entries.size() < input->collection.file.entries.size();
        const Written written = save(content.file, base, input->name, progress);
        const ExitStatus status = std::max(content.status, written.status);
        if (m_isRefused || written.entries == content.asked || written.entries == 0) return status;
        if (status > ExitStatus::InputProblems) return status;
        const auto say = status == ExitStatus::Done ? reportWarning : reportError;
        say(input->name, tr("Entries written: %1; omitted: %2.")
                             .arg(written.entries)
                             .arg(content.asked - written.entries));
        return status;
    }

private:
    // Returns true for a collection, recognised by its name or by its content. Content that no other reader
    // recognises goes to the reader of collections, too. From a parameter file, only the systems are wanted,
    // not the parameters around them.
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
        reportError(fileName, tr("No entry could be written, so nothing was written."));
        return ExitStatus::InputProblems;
    }

    // The output without its suffix, for files in a folder.
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
            reportWarning(inputName, tr("“%2” already exists; using “%1” instead.").arg(output, wanted));
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
                write(outputFor(base, inputName),
                      io::textOf(systems, std::get<TextFormat>(m_plan.format), m_plan.writing))};
    }

    Written saveCollection(document::FractalFile file, const QString& output, const QString& name) {
        if (name.endsWith(u".par", Qt::CaseInsensitive)) {
            file.head.clear();
            file.tail.clear();
            for (auto& entry : file.entries)
                if (entry.source) // null for a flame file with this suffix
                    entry.source = withoutParameters(*entry.source, &entry == &file.entries.first());
        }
        if (!m_arguments.strict) return {file.entries.size(), write(output, io::writeFractint(file))};
        const io::StrictText text = io::writeStrict(file);
        const ExitStatus status = reportAll(text.problems, name);
        if (text.bytes.isEmpty()) return {0, nothingLeft(name)};
        m_holdsLess = m_holdsLess || !text.problems.isEmpty() || text.entries < file.entries.size();
        return {text.entries, std::max(status, write(output, text.bytes))};
    }

    Written savePages(const Fractals& systems, const QString& output, const QString& inputName) {
        const PdfPages pages = pdfPages(systems, inputName, m_stop);
        if (m_stop.stop_requested()) return {0, interrupted()};
        if (pages.count == 0) return {0, nothingLeft(inputName)};
        return {pages.count, write(output, pages.bytes)};
    }

    // Saves a file for every system.
    Written saveEach(const Fractals& systems, const QString& base, const QString& inputName,
                     const io::Progress& progress) {
        if (systems.size() == 1)
            return {1, saveOne(systems.first(), outputFor(base, inputName), inputName, progress)};
        if (!m_plan.intoFolder) {
            reportError(inputName, tr("The file has %1 systems, but %2 can store only one: select it with "
                                      "--entry, or give a folder to write one file for each.")
                                       .arg(systems.size())
                                       .arg(QFileInfo(base).fileName()));
            return {0, ExitStatus::InputProblems};
        }
        Written written;
        for (qsizetype i = 0; i < systems.size(); ++i) {
            if (m_stop.stop_requested()) return {written.entries, interrupted()};
            const qsizetype rest = QFileInfo(base).fileName().toUtf8().size() + 16; // number and suffix
            const QString name = document::fileNamePart(
                systems[i]->name, std::max<qsizetype>(document::maxFileName - rest, 16));
            const io::Progress part = [&](double fraction) {
                progress((double(i) + fraction) / double(systems.size()));
            };
            const QString output = outputFor(base + u'-' + name, inputName);
            written.status = std::max(written.status, saveOne(systems[i], output, inputName, part));
            ++written.entries;
        }
        return written;
    }

    ExitStatus interrupted() {
        m_isInterrupted = true;
        return m_interrupt.status();
    }

    // Returns true if the output is an input file whose contents would be lost.
    bool wouldLose(const QString& output) const {
        if (m_arguments.overwrite) return false;
        if (isReplacedBy(output, fileBehind(m_input))) {
            if (m_holdsLess)
                reportError(output, tr("This is the input file, and the output would contain less than it "
                                       "does. Write to another file, or replace it with --overwrite."));
            return m_holdsLess;
        }
        const bool isOther =
            std::any_of(m_arguments.files.begin(), m_arguments.files.end() - 1, [&](const std::string& file) {
                return isReplacedBy(output, fileBehind(fileNameOf(file)));
            });
        if (isOther)
            reportError(output,
                        tr("This is one of the input files, and “%1” would replace it. Write to another "
                           "folder, or replace it with --overwrite.")
                            .arg(m_input));
        return isOther;
    }

    ExitStatus write(const QString& output, const QByteArray& bytes) {
        if (wouldLose(output)) {
            m_isRefused = true;
            return ExitStatus::InputProblems;
        }
        const ExitStatus status = writeOutput(output, bytes, MayReplace::Inputs); // nothing is lost
        if (status == ExitStatus::Done) ++m_filesWritten;
        return status;
    }

    ExitStatus saveOne(const std::shared_ptr<const document::Fractal>& fractal, const QString& output,
                       const QString& inputName, const io::Progress& progress) {
        if (const auto* text = std::get_if<TextFormat>(&m_plan.format))
            return write(output, io::textOf({fractal}, *text, m_plan.writing));
        if (std::holds_alternative<ScadFormat>(m_plan.format)) return writeScad(*fractal, output, inputName);
        if (wouldLose(output)) {
            m_isRefused = true;
            return ExitStatus::InputProblems;
        }
        std::optional<io::SolidFacts> facts;
        const auto outcome =
            exportOutput(exportOf(*fractal, facts), output, progress, m_stop, MayReplace::Inputs);
        if (outcome.stopped) return interrupted();
        if (outcome.failure) {
            reportError(output, *outcome.failure);
            const bool isRefused =
                std::holds_alternative<io::MeshFormat>(m_plan.format) && !facts && !outcome.isShortOfMemory;
            return isRefused ? ExitStatus::InputProblems : ExitStatus::CannotReadOrWrite;
        }
        ++m_filesWritten;
        const bool isReported = facts && !isStandardOutput(output);
        const ExitStatus reported =
            isReported ? sayReport(io::summaryOf(*facts, m_plan.solid), output) : ExitStatus::Done;
        if (outcome.note != attractor::RenderNote::None)
            reportWarning(
                inputName,
                tr("“%1” may not have an attractor; the points show where orbits go before they escape.")
                    .arg(fractal->name));
        return reported;
    }

    io::Export exportOf(const document::Fractal& fractal, std::optional<io::SolidFacts>& facts) const {
        if (const auto* mesh = std::get_if<io::MeshFormat>(&m_plan.format))
            return io::SolidExport{fractal, m_plan.solid, *mesh,
                                   [&facts](const io::SolidFacts& made) { facts = made; }};
        return io::PointCloud{fractal, m_plan.points, m_plan.seed, std::get<io::PointFormat>(m_plan.format)};
    }

    ExitStatus writeScad(const document::Fractal& fractal, const QString& output, const QString& inputName) {
        const io::OpenScad scad = io::openScad(fractal, m_plan.solid.voxel);
        if (scad.failure) {
            reportError(inputName, *scad.failure);
            return ExitStatus::InputProblems;
        }
        return write(output, scad.text);
    }

    const ConvertArguments& m_arguments;
    const Plan& m_plan;
    const Interrupt& m_interrupt;
    std::stop_token m_stop;
    QString m_input;          // input being converted
    bool m_holdsLess = false; // true if the output cannot hold everything
    bool m_isRefused = false;
    bool m_isInterrupted = false;
    int m_filesWritten = 0;
    QSet<QString> m_taken; // lower-case names of files in the folder
};

ExitStatus convert(const ConvertArguments& arguments) {
    const ProgressMode mode = applied(arguments.verbosity);
    const Plan plan = planOf(arguments);
    const Interrupt interrupt;
    Converter converter(arguments, plan, interrupt);
    ExitStatus worst = ExitStatus::Done;
    ProgressBar bar(mode);
    const std::size_t files = arguments.files.size() - 1;
    bool isInterrupted = false;
    for (std::size_t i = 0; i < files && !isInterrupted; ++i) {
        const io::Progress progress = [&](double fraction) {
            bar.show((double(i) + fraction) / double(files));
        };
        worst = std::max(worst, converter.run(arguments.files[i], progress));
        progress(1);
        isInterrupted = converter.isInterrupted() || (interrupt.token().stop_requested() && i + 1 < files);
    }
    bar.clear();
    if (!isInterrupted) return worst;
    const int written = converter.filesWritten();
    reportError(plan.output, written == 0 ? tr("Interrupted; nothing was written.")
                                          : tr("Interrupted; files written before that: %1.").arg(written));
    return interrupt.status();
}

} // namespace

Command convertCommand() {
    auto arguments = std::make_shared<ConvertArguments>();
    Command command("convert", "Convert entries to another format", "convert FILE... OUT [OPTION]...");
    const OptionGroup files = command.group("Files");
    files
        .argument("FILE... OUT", &arguments->files,
                  "Files to read (- for standard input), then the file (- for standard output) or folder to "
                  "write")
        .required()
        .minimum(2);
    addEntriesOption(command, arguments->entries);
    const OptionGroup format = command.group("Format");
    format
        .add("--to", "FORMAT", &arguments->format, listed(convertFormats(), tr("or")).toStdString(),
             "as the output name determines")
        .completedBy(Completion::Kind::Words, convertFormats());
    files.flag("--overwrite", &arguments->overwrite,
               "Replace an input file even if the output contains less");
    format.flag("--bake", &arguments->bake, "Bake the cage into the code");
    format.flag("--strict", &arguments->strict, "Write .ifs files that every program can read");
    format
        .flag("--y-as-written", &arguments->yAsWritten,
              "Keep the y of flames as written; their pictures are then upside down")
        .moreOf("By default y is flipped, because it points down in flame files.");
    const OptionGroup tables = command.group("Tables");
    const std::vector<std::string> orders{"abcdefp", "abecdfp", "acbdefp", "pabcdef"};
    tables
        .add("--columns", "ORDER", parsed(&arguments->columns, columnsArgument),
             "Order of the columns of the table to write, such as \"a b e c d f p\"", "a b c d e f p")
        .moreOf("The columns are the letters a to f and p, or r, s, theta, phi, e, f and p.")
        .completedBy(Completion::Kind::Words, orders);
    tables
        .add("--in-columns", "ORDER", parsed(&arguments->inColumns, columnsArgument),
             "Order of the columns in the table to read", "as in its header")
        .moreOf("It is needed where the header does not name them.")
        .completedBy(Completion::Kind::Words, orders);
    const OptionGroup points = command.group("Points");
    points.add("--points", "N", parsed(&arguments->points, countFrom(1, io::PointCloud::maxPoints)),
               "Number of points to write (.csv, .ply) instead of the maps");
    points.add("--seed", "N", parsed(&arguments->seed, wholeArgument),
               "Seed of the random numbers for --points", "1");
    addSolidOptions(command, arguments->solid);
    addSymmetryOptions(command, arguments->symmetry);
    addVerbosityOptions(command, arguments->verbosity);
    command.run = [arguments] { return convert(*arguments); };
    return command;
}

} // namespace cli
