// SPDX-License-Identifier: MIT
#include "io/collection_reader.h"

#include "document/text/text.h"
#include "document/text/unique_names.h"
#include "io/exchange/aifs_reader.h"
#include "io/exchange/entry_link.h"
#include "io/fractint/format_detection.h"
#include "io/fractint/fractint_reader.h"
#include "io/picture/png/png_system.h"
#include "io/picture/vector/svg_system.h"
#include "io/raster/raster_system.h"
#include "io/table/html_tables.h"
#include "io/table/listed_maps.h"
#include "io/table/table_reader.h"
#include "io/table/table_systems.h"
#include "io/text/cumulative_weights.h"
#include "io/text/encoding.h"
#include "io/text/export_weights.h"
#include "io/video/video_system.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace io {

namespace {

constexpr qsizetype maxRemarks = 10; // remarks on the weights of a table

document::Problem errorOf(const QString& sentence) {
    return {document::Problem::Severity::Error, {}, 0, 0, sentence};
}

document::FractalFile fileOf(const EmbeddedSystem& embedded) {
    if (!embedded.failure) return readFractint(embedded.text);
    document::FractalFile file;
    file.problems << errorOf(*embedded.failure);
    return file;
}

// The first map without weight, where others have one.
std::optional<std::size_t> someWeightMissing(const auto& rows) {
    const auto isMissing = [](const auto& row) { return !row.weight; };
    const auto first = std::ranges::find_if(rows, isMissing);
    if (first == rows.end() || std::ranges::all_of(rows, isMissing)) return std::nullopt;
    return std::size_t(first - rows.begin());
}

void warn(document::Entry& entry, int line, const QString& sentence) {
    entry.problems << document::Problem{document::Problem::Severity::Warning, entry.fractal->name, line,
                                        line > 0 ? 1 : 0, sentence};
}

// Weights that are read as such but rise like sums.
void warnOfSums(document::Entry& entry, const auto& rows, int line) {
    std::vector<std::optional<double>> weights;
    for (const auto& row : rows)
        weights.push_back(row.weight);
    if (const auto sentence = cumulativeRemark(weights)) warn(entry, line, *sentence);
}

// `lines`: of the text, of every row; 0 where it is not known.
void remarkOnWeights(document::Entry& entry, const auto& rows, const std::vector<int>& lines,
                     bool areDifferences) {
    if (const auto index = someWeightMissing(rows))
        warn(entry, lines[*index], missingWeightRemark(*index + 1));
    for (std::size_t i = 0; i < rows.size() && entry.problems.size() < maxRemarks; ++i)
        if (const auto sentence = rows[i].weight ? weightRemark(i + 1, *rows[i].weight) : std::nullopt)
            warn(entry, lines[i], *sentence);
    if (!areDifferences && !lines.empty()) warnOfSums(entry, rows, lines.front());
}

void remarkOnWeights(document::Entry& entry, const Table& table, const std::vector<int>& lines) {
    if (table.spaceRows.empty())
        remarkOnWeights(entry, table.rows, lines, table.isCumulative);
    else
        remarkOnWeights(entry, table.spaceRows, lines, table.isCumulative);
}

// Rows of six numbers that would fill rows of seven, with weights that sum to 1.
std::optional<QString> otherReading(const Table& table) {
    constexpr double tolerance = 0.02; // accepts weights with two digits
    const auto hasWeight = [](const auto& row) { return row.weight.has_value(); };
    if (table.isOrdered || table.rows.empty() || table.rows.size() % 7 != 0 ||
        std::ranges::any_of(table.rows, hasWeight))
        return std::nullopt;
    std::vector<double> numbers;
    for (const auto& row : table.rows) {
        const auto& [linear, translation] = row.map;
        numbers.insert(numbers.end(), {linear(0, 0), linear(0, 1), linear(1, 0), linear(1, 1), translation[0],
                                       translation[1]});
    }
    double sum = 0;
    for (std::size_t i = 6; i < numbers.size(); i += 7)
        sum += numbers[i] >= 0 ? numbers[i] : NAN;
    if (!(std::abs(sum - 1) <= tolerance)) return std::nullopt;
    return Text::tr("The numbers can be read as %1 maps of 6 numbers, line by line, or as %2 "
                    "maps of 7 numbers, whose weights then sum to 1. They are read line by "
                    "line; for the other reading, put 7 numbers on each line.")
        .arg(table.rows.size())
        .arg(numbers.size() / 7);
}

// A table that is not one to Fractint (rows of 7 numbers without commas are).
std::optional<Collection> collectionOfTable(const QByteArray& bytes, const QString& path,
                                            const std::optional<TableColumns>& columns) {
    if (foreignFormatRemark(bytes)) return std::nullopt;
    Collection result{QStringLiteral("table"), {}, false};
    document::FractalFile& file = result.file;
    if (bytes.size() > maxTable) {
        file.problems << errorOf(Text::tr("No iterated function system was found, and the file is too "
                                          "large for a table of numbers: the limit is 64 MB."));
        return result;
    }
    Table table = readTable(QString::fromUtf8(bytes), columns, TableMaps::PlaneOrSpace);
    if (!table.isTable) return std::nullopt;
    if (!hasErrors(table)) {
        document::Fractal fractal;
        const QString name = QFileInfo(path).completeBaseName();
        fractal.name = document::uniqueName({}, name.isEmpty() ? QStringLiteral("table") : name);
        if (table.spaceRows.empty())
            fractal.shape = document::Shape<2>{systemOf(table)};
        else
            fractal.shape = document::Shape<3>{spaceSystemOf(table)};
        file = document::fileOf(std::move(fractal));
        result.isOrderAssumed = !table.isOrdered;
    }
    file.problems = std::move(table.problems);
    if (const auto other = otherReading(table); other && !columns)
        file.problems << document::Problem{
            document::Problem::Severity::Warning, {}, table.lines.front(), 1, *other};
    for (document::Entry& entry : file.entries)
        remarkOnWeights(entry, table, table.lines);
    return result;
}

// Empty for lists, whose remark does not name them.
QString nameOf(Notation notation) {
    static const std::array names{QT_TRANSLATE_NOOP("Text", "YAML"),
                                  QT_TRANSLATE_NOOP("Text", "a text of GIMP’s IFS Fractal"),
                                  QT_TRANSLATE_NOOP("Text", "a LaTeX table"),
                                  QT_TRANSLATE_NOOP("Text", "an HTML table"),
                                  QT_TRANSLATE_NOOP("Text", "a Markdown table"),
                                  QT_TRANSLATE_NOOP("Text", "a wiki table"),
                                  QT_TRANSLATE_NOOP("Text", "matrices in LaTeX"),
                                  QT_TRANSLATE_NOOP("Text", "equations")};
    if (notation == Notation::Lists) return {};
    return QCoreApplication::translate("Text", names[std::size_t(notation) - 1]);
}

document::Problem recognised(Notation notation, qsizetype systems, qsizetype maps, bool isOrderAssumed) {
    QString sentence =
        notation == Notation::Lists
            ? Text::tr(
                  "This is not the format of a fractal program. Its lists of numbers are read as tables of "
                  "maps (systems: %1, maps: %2), in the order a b c d e f unless names give another order.")
            : Text::tr("This is read as %3 (systems: %1, maps: %2).");
    sentence = sentence.arg(systems).arg(maps);
    if (notation != Notation::Lists) sentence = sentence.arg(nameOf(notation));
    if (notation != Notation::Lists && isOrderAssumed)
        sentence += u' ' + Text::tr("Nothing names its columns: their order is "
                                    "taken to be a b c d e f.");
    return {document::Problem::Severity::Warning, {}, 0, 0, sentence};
}

// The line of the text for a row of the table.
int lineOf(const ListedMaps& listed, int row) {
    return row > 0 && std::size_t(row) <= listed.lines.size() ? listed.lines[std::size_t(row) - 1] : 0;
}

// The problems of a table that stands in another text: in which of its rows.
document::Problems located(document::Problems problems, const ListedMaps& listed) {
    for (document::Problem& problem : problems) {
        const auto row = std::size_t(problem.line);
        if (row > 0 && !nameOf(listed.notation).isEmpty())
            problem.message =
                Text::tr("In %1, row %2: %3").arg(nameOf(listed.notation)).arg(row).arg(problem.message);
        problem.line = lineOf(listed, problem.line);
        problem.column = problem.line > 0 ? 1 : 0;
    }
    return problems;
}

// A map that is not understood: its system is not read, for no map may be lost.
document::Problem notUnderstood(const ListedMaps& listed) {
    const UnreadMap& unread = *listed.unread;
    const QString kind =
        listed.notation == Notation::Lists ? Text::tr("lists of numbers") : nameOf(listed.notation);
    const QString what = unread.text.isEmpty()
                             ? Text::tr("This map is not understood, so none is read.")
                             : Text::tr("“%1” is not understood, so no map is read.").arg(unread.text);
    return {document::Problem::Severity::Error,
            {},
            unread.line,
            unread.line > 0 ? 1 : 0,
            Text::tr("In %1, row %2: %3").arg(kind).arg(unread.row).arg(what)};
}

// Systems that stand in lists of another language or in its tables, each through the reader of tables.
std::optional<Collection> collectionOfLists(const QByteArray& bytes, const QString& path,
                                            const std::optional<TableColumns>& columns) {
    constexpr qsizetype maxLists = 16 * 1024 * 1024;
    if (bytes.size() > maxLists || bytes.contains('\0')) return std::nullopt;
    Collection result{QStringLiteral("table"), {}, false};
    document::UniqueNames names;
    const QString fileName = QFileInfo(path).completeBaseName();
    qsizetype maps = 0;
    Notation notation = Notation::Lists;
    document::Problems problems;
    for (const ListedMaps& listed : listedMaps(QString::fromUtf8(bytes))) {
        if (listed.unread) {
            problems << notUnderstood(listed);
            continue;
        }
        const Table table = readTable(listed.table, columns, TableMaps::PlaneOrSpace);
        if (listed.notation != Notation::Lists) problems += located(table.problems, listed);
        if (hasErrors(table) || !table.isTable) continue;
        document::Fractal fractal;
        fractal.name = names.give(!listed.name.isEmpty() ? listed.name
                                  : fileName.isEmpty()   ? QStringLiteral("table")
                                                         : fileName);
        if (table.spaceRows.empty())
            fractal.shape = document::Shape<2>{systemOf(table)};
        else
            fractal.shape = document::Shape<3>{spaceSystemOf(table)};
        maps += qsizetype(table.rows.size() + table.spaceRows.size());
        notation = listed.notation;
        result.isOrderAssumed = result.isOrderAssumed || !table.isOrdered;
        document::FractalFile one = document::fileOf(std::move(fractal));
        one.entries.first().id = document::freshId(result.file);
        document::Entry& entry = one.entries.first();
        std::vector<int> lines;
        for (const int row : table.lines)
            lines.push_back(lineOf(listed, row));
        remarkOnWeights(entry, table, lines);
        if (const QString unused = unusedWeightsRemark(listed); !unused.isEmpty())
            warn(entry, lineOf(listed, int(listed.withoutWeight.value_or(0)) + 2), unused);
        result.file.entries << one.entries;
    }
    if (result.file.entries.isEmpty() && problems.isEmpty()) return std::nullopt;
    if (!result.file.entries.isEmpty())
        result.file.problems << recognised(notation, result.file.entries.size(), maps, result.isOrderAssumed);
    result.file.problems += problems;
    return result;
}

// Returns true if the file begins with an entry whose name looks like a tag, “<flame>a {”. Before a brace on
// the first line, markup has attributes, or begins a style sheet.
bool beginsWithEntry(const QByteArray& bytes) {
    constexpr qsizetype longest = 4096;
    QByteArray head = bytes.left(longest).trimmed();
    if (head.startsWith("\xef\xbb\xbf")) head = head.sliced(3).trimmed();
    if (!head.startsWith('<') || head.startsWith("<?") || head.startsWith("<!")) return false;
    const qsizetype brace = head.indexOf('{');
    const QByteArray before = head.left(brace);
    return brace > 0 && !before.contains('\n') && !before.contains('=') && !before.contains("<style");
}

// A flame behind other text, as in a letter.
bool holdsFlame(const QByteArray& bytes) {
    return bytes.contains("<flame") && bytes.contains("<xform") && !bytes.contains('\0');
}

bool isLikeNumber(const QByteArray& word) {
    return !word.isEmpty() && QByteArrayView("0123456789.-+").contains(word[0]);
}

// Text with braces of a program, a document or a page; no line has numbers as an entry does, not even damaged
// ones.
bool isOfAnotherKind(const QByteArray& bytes) {
    constexpr qsizetype sample = 64 * 1024;
    constexpr int fewest = 3;
    static const std::array marks{
        "\\begin{", "\\documentclass", "){", ") {", "();", "};", "</", "\n@", "[{", "[[", "=> {"};
    QByteArray head = bytes.left(sample).toLower();
    head.replace("(3d)", ""); // mark of an entry in space
    const auto isIn = [&](const char* mark) { return head.contains(mark); };
    if (head.contains('\0') || std::ranges::none_of(marks, isIn)) return false;
    for (const QByteArray& line : head.split('\n')) {
        int numbers = 0;
        const QByteArrayList words = line.simplified().split(' ');
        for (const QByteArray& word : words)
            numbers += isLikeNumber(word) ? 1 : 0;
        if (numbers >= fewest && (isLikeNumber(words.first()) || !line.contains('('))) return false;
    }
    return head.contains('{');
}

// Returns true if nothing that could be an entry was found.
bool isUnknown(const document::FractalFile& file, const QByteArray& bytes) {
    return file.entries.isEmpty() && !file.problems.isEmpty() && !bytes.trimmed().isEmpty() &&
           (foreignFormatRemark(bytes) || !bytes.contains('{'));
}

// Reads the file as UTF-8, in which a collection is also saved.
Collection collectionOfUtf16(QByteArray text, const QString& path, const ReadOptions& options) {
    static const QRegularExpression declaration(
        QStringLiteral("^(<\\?xml[^>]*?)\\s+encoding=[\"'][^\"']*[\"']"));
    constexpr qsizetype longest = 200;
    QString head = QString::fromUtf8(text.left(longest));
    if (declaration.match(head).hasMatch())
        text = head.replace(declaration, QStringLiteral("\\1")).toUtf8() + text.mid(longest);
    Collection collection = readCollection(text, path, options);
    if (collection.format == u"fractint")
        collection.file.problems.prepend({document::Problem::Severity::Warning,
                                          {},
                                          0,
                                          0,
                                          Text::tr("The text is encoded in UTF-16; it is saved as UTF-8.")});
    return collection;
}

} // namespace

namespace {

// What a page shows as it was typed: a flame, an entry or a table.
std::optional<Collection> collectionInPage(const QByteArray& bytes, const QString& path,
                                           const ReadOptions& options) {
    constexpr qsizetype longest = 16 * 1024 * 1024;
    if (bytes.size() > longest || !bytes.contains("</") || bytes.contains('\0')) return std::nullopt;
    const QByteArray text = preformattedText(QString::fromUtf8(bytes)).toUtf8();
    if (text.isEmpty() || text.size() >= bytes.size()) return std::nullopt;
    Collection inner = readCollection(text, path, options);
    const bool isRead = std::ranges::any_of(inner.file.entries, [](const document::Entry& entry) {
        return document::dimension(*entry.fractal) != 0;
    });
    return isRead ? std::optional(std::move(inner)) : std::nullopt;
}

} // namespace

QStringList collectionFormats() {
    return QStringLiteral(
               "fractint flame aifs table jpeg webp tiff exr png svg mp4 webm mkv gif link unknown")
        .split(u' ');
}

Collection readCollection(const QByteArray& bytes, const QString& path, const ReadOptions& options) {
    if (looksLikePng(bytes)) return {QStringLiteral("png"), fileOf(readPngSystem(bytes)), false};
    if (const QString format = looksLikeVideo(bytes); !format.isEmpty())
        return {format, fileOf(readVideoSystem(bytes)), false};
    if (const QString format = rasterFormat(bytes); !format.isEmpty())
        return {format, fileOf(readRasterSystem(bytes)), false};
    if (auto text = fromUtf16(bytes)) return collectionOfUtf16(*std::move(text), path, options);
    if (looksLikeLink(bytes)) return {QStringLiteral("link"), fileOf(readLink(bytes)), false};
    const bool isMarkup = !beginsWithEntry(bytes);
    if (isMarkup && looksLikeSvg(bytes)) return {QStringLiteral("svg"), fileOf(readSvgSystem(bytes)), false};
    if (isMarkup && looksLikeFlame(bytes))
        return {QStringLiteral("flame"), readFlame(bytes, options.axis), false};
    if (looksLikeAifs(bytes)) return {QStringLiteral("aifs"), readAifs(bytes), false};
    constexpr qsizetype sample = 4000; // bytes, enough for five lines of a matrix
    const bool isTable = options.columns || isTableToFractintUnknown(QString::fromUtf8(bytes.left(sample)));
    document::FractalFile file;
    if (!isTable) file = readFractint(bytes, QFileInfo(path).completeBaseName());
    const auto isLoaded = [](const document::Entry& entry) {
        return document::dimension(*entry.fractal) != 0;
    };
    if (std::ranges::none_of(file.entries, isLoaded)) {
        if (holdsFlame(bytes)) return {QStringLiteral("flame"), readFlame(bytes, options.axis), false};
        auto table = collectionOfTable(bytes, path, options.columns);
        if (!table || table->file.entries.isEmpty())
            if (auto lists = collectionOfLists(bytes, path, options.columns)) return *std::move(lists);
        if (table && (file.entries.isEmpty() || !table->file.entries.isEmpty())) return *std::move(table);
        if (auto inner = collectionInPage(bytes, path, options)) return *std::move(inner);
    }
    if (isTable) file = readFractint(bytes, QFileInfo(path).completeBaseName());
    if (file.entries.size() == 1 && !bytes.contains('{')) // bare rows, possibly of another program
        if (const auto* system = document::system2(*file.entries.first().fractal))
            warnOfSums(file.entries.first(), system->maps, 0);
    if (std::ranges::none_of(file.entries, isLoaded) && isOfAnotherKind(bytes)) {
        file = {};
        file.problems << errorOf(Text::tr(
            "This is a program, a page or another document, not a Fractint collection, and none of its "
            "numbers are affine maps."));
        return {QStringLiteral("unknown"), std::move(file), false};
    }
    const bool isFractint = !isUnknown(file, bytes);
    return {isFractint ? QStringLiteral("fractint") : QStringLiteral("unknown"), std::move(file), false};
}

} // namespace io
