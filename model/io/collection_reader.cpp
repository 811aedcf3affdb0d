// SPDX-License-Identifier: MIT
#include "io/collection_reader.h"

#include "io/fractint_reader.h"
#include "io/png_system.h"
#include "io/svg_system.h"
#include "io/table_reader.h"
#include "io/unrelated_format.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace io {

namespace {

document::Problem errorOf(const QString& sentence) {
    return {document::Problem::Severity::Error, {}, 0, 0, sentence};
}

document::FractalFile fileOf(const EmbeddedSystem& embedded) {
    if (!embedded.failure) return readFractint(embedded.text);
    document::FractalFile file;
    file.problems << errorOf(*embedded.failure);
    return file;
}

// A table that is not one to Fractint (rows of 7 numbers without commas are).
std::optional<document::FractalFile> fileOfTable(const QByteArray& bytes, const QString& path,
                                                 const std::optional<TableColumns>& columns) {
    if (unrelatedFormat(bytes)) return std::nullopt;
    if (bytes.size() > largestTable) {
        document::FractalFile file;
        file.problems << errorOf(QCoreApplication::translate(
            "Text",
            "No iterated function system was found, and for a table of numbers the file is too large: the "
            "limit is 64 MB."));
        return file;
    }
    Table table = readTable(QString::fromUtf8(bytes), columns);
    const bool hasErrors = !table.problems.isEmpty();
    if (!table.isTable) return std::nullopt;
    document::FractalFile file;
    if (!hasErrors) {
        document::Fractal fractal;
        const QString name = QFileInfo(path).completeBaseName();
        fractal.name = document::uniqueName({}, name.isEmpty() ? QStringLiteral("table") : name);
        fractal.system = systemOf(table);
        file = document::fileOf(std::move(fractal));
    }
    file.problems = std::move(table.problems);
    return file;
}

} // namespace

Collection readCollection(const QByteArray& bytes, const QString& path, const ReadOptions& options) {
    if (looksLikePng(bytes)) return {QStringLiteral("png"), fileOf(readPngSystem(bytes))};
    if (looksLikeSvg(bytes)) return {QStringLiteral("svg"), fileOf(readSvgSystem(bytes))};
    if (looksLikeFlame(bytes)) return {QStringLiteral("flame"), readFlame(bytes, options.axis)};
    constexpr qsizetype sample = 1000; // bytes, enough for five lines of a matrix
    const bool isTable = options.columns || beginsWithMatrices(QString::fromUtf8(bytes.left(sample)));
    document::FractalFile file;
    if (!isTable) file = readFractint(bytes, QFileInfo(path).completeBaseName());
    if (file.entries.isEmpty())
        if (auto table = fileOfTable(bytes, path, options.columns))
            return {QStringLiteral("table"), std::move(*table)};
    return {QStringLiteral("fractint"),
            isTable ? readFractint(bytes, QFileInfo(path).completeBaseName()) : std::move(file)};
}

} // namespace io
