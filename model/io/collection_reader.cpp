// SPDX-License-Identifier: MIT
#include "io/collection_reader.h"

#include "io/fractint_reader.h"
#include "io/png_system.h"
#include "io/svg_system.h"
#include "io/table_reader.h"
#include "io/unrelated_format.h"
#include "io/written_weights.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>

namespace io {

namespace {

constexpr qsizetype mostRemarks = 10; // on the weights of a table

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

// A table that is not one to Fractint (rows of 7 numbers without commas are).
std::optional<Collection> collectionOfTable(const QByteArray& bytes, const QString& path,
                                            const std::optional<TableColumns>& columns) {
    if (unrelatedFormat(bytes)) return std::nullopt;
    Collection result{QStringLiteral("table"), {}, false};
    document::FractalFile& file = result.file;
    if (bytes.size() > largestTable) {
        file.problems << errorOf(QCoreApplication::translate(
            "Text",
            "No iterated function system was found, and for a table of numbers the file is too large: the "
            "limit is 64 MB."));
        return result;
    }
    Table table = readTable(QString::fromUtf8(bytes), columns, TableMaps::PlaneOrSpace);
    if (!table.isTable) return std::nullopt;
    if (!hasErrors(table)) {
        document::Fractal fractal;
        const QString name = QFileInfo(path).completeBaseName();
        fractal.name = document::uniqueName({}, name.isEmpty() ? QStringLiteral("table") : name);
        if (table.spaceRows.empty())
            fractal.system = systemOf(table);
        else
            fractal.system = spaceSystemOf(table);
        file = document::fileOf(std::move(fractal));
        result.isOrderAssumed = !table.isOrdered;
    }
    file.problems = std::move(table.problems);
    for (document::Entry& entry : file.entries) {
        const auto remark = [&](const auto& rows) {
            const auto warn = [&](std::size_t i, const QString& sentence) {
                entry.problems << document::Problem{document::Problem::Severity::Warning, entry.fractal->name,
                                                    table.lines[i], 1, sentence};
            };
            if (const auto place = someWeightMissing(rows))
                warn(*place,
                     QCoreApplication::translate(
                         "Text", "Map %1 has no weight, so the weights of all maps are taken from the "
                                 "determinants and those that are given are not used.")
                         .arg(*place + 1));
            for (std::size_t i = 0; i < rows.size() && entry.problems.size() < mostRemarks; ++i)
                if (const auto sentence =
                        rows[i].weight ? weightRemark(i + 1, *rows[i].weight) : std::nullopt)
                    warn(i, *sentence);
        };
        remark(table.rows);
        remark(table.spaceRows);
    }
    return result;
}

} // namespace

Collection readCollection(const QByteArray& bytes, const QString& path, const ReadOptions& options) {
    if (looksLikePng(bytes)) return {QStringLiteral("png"), fileOf(readPngSystem(bytes)), false};
    if (looksLikeSvg(bytes)) return {QStringLiteral("svg"), fileOf(readSvgSystem(bytes)), false};
    if (looksLikeFlame(bytes)) return {QStringLiteral("flame"), readFlame(bytes, options.axis), false};
    constexpr qsizetype sample = 4000; // bytes, enough for five lines of a matrix
    const bool isTable = options.columns || isTableToFractintUnknown(QString::fromUtf8(bytes.left(sample)));
    document::FractalFile file;
    if (!isTable) file = readFractint(bytes, QFileInfo(path).completeBaseName());
    const auto isLoaded = [](const document::Entry& entry) {
        return document::dimension(*entry.fractal) != 0;
    };
    if (std::ranges::none_of(file.entries, isLoaded))
        if (auto table = collectionOfTable(bytes, path, options.columns);
            table && (file.entries.isEmpty() || !table->file.entries.isEmpty()))
            return std::move(*table);
    return {QStringLiteral("fractint"),
            isTable ? readFractint(bytes, QFileInfo(path).completeBaseName()) : std::move(file), false};
}

} // namespace io
