// SPDX-License-Identifier: MIT
#include "io/fractint/fractint_rows.h"

#include "io/fractint/metadata_comments.h"
#include "io/text/export_weights.h"
#include "io/text/number.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace io::fractint {

namespace {

template <int Dim> std::vector<Row> rows(const ifs::IteratedFunctionSystem<Dim>& system) {
    auto unlinked = system; // links are stored in comments and leave the rows unchanged
    unlinked.links.clear();
    const std::vector<double> probabilities = ifs::probabilities(unlinked);
    const std::vector<double> written = exportWeights(system);
    std::vector<Row> result;
    for (std::size_t k = 0; k < system.maps.size(); ++k) {
        const auto& map = system.maps[k];
        Row row{map.id, {}, map.enabled ? map.weight : 0, written[k], probabilities[k]};
        if (row.weight && !(*row.weight > 0)) row.written = *row.weight;
        for (int i = 0; i < Dim; ++i)
            for (int j = 0; j < Dim; ++j)
                row.coefficients.push_back(map.map.linear(i, j));
        for (int i = 0; i < Dim; ++i)
            row.coefficients.push_back(map.map.translation[i]);
        result.push_back(std::move(row));
    }
    return result;
}

} // namespace

std::vector<Row> rowsOf(const document::Fractal& fractal) {
    if (const auto* plane = document::system2(fractal)) return rows(*plane);
    if (const auto* space = document::system3(fractal)) return rows(*space);
    return {};
}

QByteArray numberText(double value) {
    constexpr double maxNumber = std::numeric_limits<float>::max();
    return formatNumber(std::isfinite(value) ? std::clamp(value, -maxNumber, maxNumber) : 0);
}

std::size_t secondLine(std::size_t numbers) {
    return (numbers + 1) / 2;
}

QByteArrayList alignedRows(const std::vector<std::vector<QByteArray>>& rows) {
    std::vector<qsizetype> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], row[i].size());
    }
    QByteArrayList lines;
    for (const auto& row : rows) {
        QByteArray line;
        for (std::size_t i = 0; i < row.size(); ++i)
            line += ' ' + row[i].rightJustified(widths[i]);
        lines << ' ' + line;
    }
    return lines;
}

QByteArrayList rowsOnTwoLines(const std::vector<std::vector<QByteArray>>& rows) {
    std::vector<std::vector<QByteArray>> first, second;
    for (const auto& row : rows) {
        const auto middle = row.begin() + static_cast<std::ptrdiff_t>(secondLine(row.size()));
        first.emplace_back(row.begin(), middle);
        second.emplace_back(middle, row.end());
    }
    const QByteArrayList begins = alignedRows(first), ends = alignedRows(second);
    QByteArrayList lines;
    for (qsizetype i = 0; i < begins.size(); ++i)
        lines << begins[i] << "  " + ends[i];
    return lines;
}

QByteArrayList brokenRows(const std::vector<std::vector<QByteArray>>& rows) {
    const QByteArrayList whole = alignedRows(rows);
    const auto fits = [](const QByteArray& line) { return line.size() <= maxLine; };
    return std::ranges::all_of(whole, fits) ? whole : rowsOnTwoLines(rows);
}

QByteArrayList closeRows(const std::vector<std::vector<QByteArray>>& rows) {
    QByteArrayList lines;
    for (const auto& row : rows) {
        QByteArray line(1, ' ');
        for (const QByteArray& cell : row)
            line += ' ' + cell;
        lines << line;
    }
    return lines;
}

QString storedName(const QString& name) {
    QString stored;
    for (const QChar c : name.trimmed()) {
        const bool isLegal =
            c.unicode() > 0x20 && c.unicode() != 0x7f && !QStringLiteral("(){};:").contains(c);
        stored += isLegal ? c : QLatin1Char('_');
    }
    if (stored.isEmpty()) return QStringLiteral("unnamed");
    const bool isCommentWord = stored.compare(QLatin1String("comment"), Qt::CaseInsensitive) == 0;
    return isCommentWord ? stored + QLatin1Char('_') : stored;
}

QString storedComment(const QString& comment) {
    QString stored = comment;
    for (QChar& c : stored)
        if (c.unicode() < 0x20) c = QLatin1Char(' ');
    stored = stored.trimmed();
    if (isOwnComment(stored.toUtf8())) stored.replace(stored.indexOf(QLatin1Char(':')), 1, QLatin1Char(' '));
    return stored;
}

} // namespace io::fractint
