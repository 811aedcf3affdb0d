// SPDX-License-Identifier: MIT
#include "io/fractint/typed_comments.h"

#include "io/text/metadata_line.h"
#include "io/text/typed_coefficient.h"

#include <cstddef>
#include <optional>

namespace io {

namespace {

constexpr const char* exactKey = "exact";

template <int Dim> constexpr int coefficients = Dim*(Dim + 1);

// "; barycage: exact 2 b 1/3"; nullopt where it is too long, or nothing is typed.
template <int Dim>
std::optional<QByteArray> lineOf(const ifs::WeightedMap<Dim>& map, std::size_t number, int which) {
    const ifs::TypedCoefficient* typed = map.typed.of(which, map.map);
    if (!typed) return std::nullopt;
    const QByteArray line =
        metadataLine(exactKey, QByteArray::number(qulonglong(number)) + ' ' + char('a' + which) + ' ' +
                                   QByteArray::fromStdString(typed->text));
    return line.size() <= maxMetadataLine ? std::optional(line) : std::nullopt;
}

} // namespace

template <int Dim> QByteArrayList typedComments(const ifs::IteratedFunctionSystem<Dim>& system) {
    QByteArrayList lines;
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        if (system.maps[i].typed.isEmpty()) continue;
        for (int which = 0; which < coefficients<Dim>; ++which)
            if (const auto line = lineOf<Dim>(system.maps[i], i + 1, which);
                line && std::size_t(lines.size()) < maxTypedLines)
                lines << *line;
    }
    return lines;
}

// The number of the map counts among the bytes of its line: the longest that there can be does here.
template <int Dim> ifs::TypedCoefficients storedTyped(const ifs::WeightedMap<Dim>& map, std::size_t& left) {
    constexpr std::size_t longest = 999'999;
    ifs::TypedCoefficients stored;
    if (map.typed.isEmpty()) return stored;
    for (int which = 0; which < coefficients<Dim>; ++which)
        if (left > 0 && lineOf<Dim>(map, longest, which)) {
            stored.set(*map.typed.of(which, map.map));
            --left;
        }
    return stored;
}

bool TypedComments::read(const QByteArray& key, const QByteArrayList& values) {
    if (key != exactKey || values.size() < 3 || values[1].size() != 1) return false;
    bool isNumber = false;
    const int map = values[0].toInt(&isNumber), which = values[1].front() - 'a';
    if (!isNumber || map < 1 || which < 0 || which >= coefficients<3> || m_lines.size() >= maxTypedLines)
        return false;
    m_lines.push_back({std::size_t(map), which, QString::fromUtf8(values.sliced(2).join(' '))});
    return true;
}

template <int Dim> void TypedComments::applyTo(ifs::IteratedFunctionSystem<Dim>& system) const {
    for (const auto& [number, which, text] : m_lines)
        if (number <= system.maps.size()) keepTyped<Dim>(system.maps[number - 1], which, text);
}

template QByteArrayList typedComments(const ifs::IteratedFunctionSystem<2>&);
template QByteArrayList typedComments(const ifs::IteratedFunctionSystem<3>&);
template ifs::TypedCoefficients storedTyped(const ifs::WeightedMap<2>&, std::size_t&);
template ifs::TypedCoefficients storedTyped(const ifs::WeightedMap<3>&, std::size_t&);
template void TypedComments::applyTo(ifs::IteratedFunctionSystem<2>&) const;
template void TypedComments::applyTo(ifs::IteratedFunctionSystem<3>&) const;

} // namespace io
