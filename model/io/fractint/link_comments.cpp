// SPDX-License-Identifier: MIT
#include "io/fractint/link_comments.h"

#include "document/text/text.h"
#include "ifs/system/links.h"
#include "io/text/metadata_line.h"
#include "io/text/number.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace io {

namespace {

constexpr const char* linksKey = "links";
constexpr std::size_t maxLinkedMaps = 256;

} // namespace

template <int Dim> QByteArrayList linkComments(const ifs::IteratedFunctionSystem<Dim>& system) {
    if (system.links.empty()) return {};
    const std::size_t n = system.maps.size();
    const std::vector<double> matrix = ifs::linkMatrix(system);
    QByteArrayList lines;
    for (std::size_t i = 0; i < n; ++i) {
        const auto row = std::span(matrix).subspan(i * n, n);
        if (std::ranges::all_of(row, [](double weight) { return weight == 1; })) continue;
        const QByteArray number = QByteArray::number(qulonglong(i) + 1);
        QByteArray text = number;
        for (const double weight : row) {
            const QByteArray value = formatNumber(weight);
            if (metadataLine(linksKey, text).size() + 1 + value.size() > maxMetadataLine) {
                lines << metadataLine(linksKey, text);
                text = number;
            }
            text += ' ' + value;
        }
        lines << metadataLine(linksKey, text);
    }
    return lines;
}

// Numbers that are none are told of when the links are applied.
bool LinkComments::read(const QByteArray& key, const QByteArrayList& values, std::size_t line) {
    if (key != linksKey || values.size() < 2) return false;
    const int map = values[0].toInt();
    if (map < 1) return false;
    std::vector<double>& row = m_rows[map];
    if (row.size() + std::size_t(values.size()) > maxLinkedMaps + 1) return false;
    for (const QByteArray& value : values.sliced(1))
        row.push_back(parseNumber(QString::fromLatin1(value)).value_or(-1));
    m_lines.push_back(line);
    return true;
}

template <int Dim>
LinkComments::Outcome LinkComments::applyTo(ifs::IteratedFunctionSystem<Dim>& system) const {
    if (m_rows.empty()) return {};
    const std::size_t n = system.maps.size();
    if (Dim == 3)
        return {Text::tr("Maps of a system in space cannot be linked: the links are not applied, and "
                         "their lines are kept."),
                true};
    if (n > maxLinkedMaps)
        return {Text::tr("More than %1 maps cannot be linked: the links are not "
                         "applied, and their lines are kept.")
                    .arg(maxLinkedMaps),
                true};
    const auto fits = [n](const auto& numbered) {
        const auto& [map, row] = numbered;
        return std::size_t(map) <= n && row.size() == n &&
               std::ranges::all_of(row, [](double weight) { return weight >= 0 && std::isfinite(weight); });
    };
    if (const auto wrong = std::ranges::find_if_not(m_rows, fits); wrong != m_rows.end())
        return {Text::tr("The links of map %1 are not valid, so no links are applied: a "
                         "row of links has one number for each map, 0 or larger.")
                    .arg(wrong->first),
                false};
    std::vector<double> matrix(n * n, 1);
    for (const auto& [map, row] : m_rows)
        std::ranges::copy(row, matrix.begin() + std::ptrdiff_t((std::size_t(map) - 1) * n));
    ifs::setLinks(system, matrix);
    auto unlinked = system;
    unlinked.links.clear();
    if (ifs::countActive(system) == 0 && ifs::countActive(unlinked) > 0)
        return {Text::tr("With these links every sequence of maps ends, so no map is active."), false};
    return {};
}

template QByteArrayList linkComments<2>(const ifs::IteratedFunctionSystem<2>&);
template QByteArrayList linkComments<3>(const ifs::IteratedFunctionSystem<3>&);
template LinkComments::Outcome LinkComments::applyTo<2>(ifs::IteratedFunctionSystem<2>&) const;
template LinkComments::Outcome LinkComments::applyTo<3>(ifs::IteratedFunctionSystem<3>&) const;

} // namespace io
