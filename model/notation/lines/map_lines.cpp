// SPDX-License-Identifier: MIT
#include "notation/lines/map_lines.h"

#include "ifs/system/links.h"
#include "notation/lines/look_lines.h"
#include "notation/text/number.h"
#include "notation/text/symmetry_name.h"
#include "notation/text/typed_coefficient.h"
#include "notation/text/words.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>

namespace notation {

namespace {

constexpr std::size_t maxLinkedMaps = 256;
// Lines of an entry, whose total is limited; further ones are left out.
constexpr std::size_t maxTypedLines = 100'000;
constexpr std::size_t maxFrameNumbers = 9; // numbers of a frame in space

template <int Dim> constexpr int coefficients = Dim*(Dim + 1);

// With one such map the determinant rule serves for all, and the rows hold probabilities.
template <int Dim> bool lacksWeight(const ifs::WeightedMap<Dim>& map) {
    return map.enabled && !map.weight;
}

std::string numberOf(std::size_t index) {
    return std::to_string(index + 1);
}

} // namespace

template <int Dim>
std::vector<std::string> weightLines(const ifs::IteratedFunctionSystem<Dim>& system,
                                     const attractor::MapColours& colours) {
    std::vector<std::string> lines;
    const auto& maps = system.maps;
    const bool noWeights = std::ranges::none_of(maps, [](const auto& map) { return map.weight.has_value(); });
    const bool isRuled = std::ranges::any_of(maps, lacksWeight<Dim>);
    if (noWeights && !maps.empty()) lines.push_back(ownLine("unweighted", "all"));
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const auto& map = maps[i];
        const std::string weight = map.weight ? ' ' + formatNumber(*map.weight) : "";
        if (!map.enabled)
            lines.push_back(ownLine("off", numberOf(i) + weight));
        else if (!map.weight && !noWeights)
            lines.push_back(ownLine("unweighted", numberOf(i)));
        else if (isRuled && map.weight && *map.weight > 0 && std::isfinite(*map.weight))
            lines.push_back(ownLine("weight", numberOf(i) + weight));
        if (const auto* colour = colours.find(map.id))
            lines.push_back(ownLine("map-colour", numberOf(i) + ' ' + colourText(*colour)));
    }
    return lines;
}

template <int Dim> std::vector<std::string> symmetryLines(const ifs::Symmetry<Dim>& symmetry) {
    if (symmetry.group == ifs::SymmetryGroup::None) return {};
    std::string name = symmetryName(symmetry.group, symmetry.order);
    if (symmetry.angle != 0 && symmetry.group != ifs::SymmetryGroup::Rotation)
        name += ':' + formatNumber(symmetry.angle);
    std::vector<std::string> lines{ownLine("symmetry", name)}, centre, frame;
    for (int i = 0; i < Dim; ++i) {
        centre.push_back(formatNumber(symmetry.centre[i]));
        for (int j = 0; j < Dim; ++j)
            frame.push_back(formatNumber(symmetry.frame(i, j)));
    }
    if (symmetry.centre != ifs::Vector<Dim>::Zero()) append(lines, ownLines("symmetry-centre", centre));
    if (symmetry.frame != ifs::Matrix<Dim>::Identity()) append(lines, ownLines("symmetry-frame", frame));
    return lines;
}

template <int Dim> std::vector<std::string> linkLines(const ifs::IteratedFunctionSystem<Dim>& system) {
    std::vector<std::string> lines;
    if (system.links.empty()) return lines;
    const std::size_t n = system.maps.size();
    const std::vector<double> matrix = ifs::linkMatrix(system);
    for (std::size_t i = 0; i < n; ++i) {
        const auto row = std::span(matrix).subspan(i * n, n);
        if (std::ranges::all_of(row, [](double weight) { return weight == 1; })) continue;
        std::string text = numberOf(i);
        for (const double weight : row) {
            const std::string value = formatNumber(weight);
            if (ownLine("links", text).size() + 1 + value.size() > maxOwnLine) {
                lines.push_back(ownLine("links", text));
                text = numberOf(i);
            }
            text += ' ' + value;
        }
        lines.push_back(ownLine("links", text));
    }
    return lines;
}

template <int Dim> std::vector<std::string> typedLines(const ifs::IteratedFunctionSystem<Dim>& system) {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        const auto& map = system.maps[i];
        for (int which = 0; !map.typed.isEmpty() && which < coefficients<Dim>; ++which) {
            const ifs::TypedCoefficient* typed = map.typed.of(which, map.map);
            if (!typed || lines.size() >= maxTypedLines) continue;
            const std::string line =
                ownLine("exact", numberOf(i) + ' ' + char('a' + which) + ' ' + typed->text);
            if (line.size() <= maxOwnLine) lines.push_back(line);
        }
    }
    return lines;
}

bool MapReader::read(const std::string& key, const std::vector<std::string>& values) {
    if (key == "unweighted" || key == "off" || key == "weight") return readWeight(key, values);
    if (key == "links") return readLinks(values);
    if (key == "exact") return readTyped(values);
    return readSymmetry(key, values);
}

bool MapReader::readWeight(const std::string& key, const std::vector<std::string>& values) {
    if (values.empty() || values.size() > 2) return false;
    Setting setting;
    const bool isUnweighted = key == "unweighted";
    if (isUnweighted && values.size() != 1) return false;
    if (!isUnweighted || values[0] != "all") {
        setting.map = wholeNumber(values[0]);
        if (setting.map < 1) return false;
    }
    if (!isUnweighted && values.size() == 2) {
        setting.weight = parseNumber(values[1]);
        if (!setting.weight) return false;
    }
    if (key == "weight" && !(setting.weight.value_or(0) > 0)) return false;
    (isUnweighted ? m_unweighted : key == "off" ? m_off : m_weights).push_back(setting);
    return true;
}

bool MapReader::readNumbers(const std::vector<std::string>& values, std::vector<double>& numbers) {
    for (const std::string& value : values) {
        const auto number = parseNumber(value);
        if (!number || numbers.size() == maxFrameNumbers) return false;
        numbers.push_back(*number);
    }
    return !values.empty();
}

// What is wrong with the values comes out when the symmetry is applied.
bool MapReader::readSymmetry(const std::string& key, const std::vector<std::string>& values) {
    if (key == "symmetry") {
        m_isSymmetryUnderstood = m_isSymmetryUnderstood && m_symmetry.empty() && values.size() == 1;
        m_symmetry = values.empty() ? std::string() : values[0];
    } else if (key == "symmetry-centre") {
        m_isSymmetryUnderstood = readNumbers(values, m_centre) && m_isSymmetryUnderstood;
    } else if (key == "symmetry-frame") {
        m_isSymmetryUnderstood = readNumbers(values, m_frame) && m_isSymmetryUnderstood;
    } else {
        return false;
    }
    return true;
}

bool MapReader::readLinks(const std::vector<std::string>& values) {
    if (values.size() < 2) return false;
    const int map = wholeNumber(values[0]);
    if (map < 1) return false;
    std::vector<double>& row = m_rows[map];
    if (row.size() + values.size() > maxLinkedMaps + 1) return false;
    for (const std::string& value : std::span(values).subspan(1))
        row.push_back(parseNumber(value).value_or(-1));
    return true;
}

bool MapReader::readTyped(const std::vector<std::string>& values) {
    if (values.size() < 3 || values[1].size() != 1 || m_typed.size() >= maxTypedLines) return false;
    const int map = wholeNumber(values[0]), which = values[1].front() - 'a';
    if (map < 1 || which < 0 || which >= coefficients<3>) return false;
    m_typed.push_back({std::size_t(map), which, joined(values, 2)});
    return true;
}

template <int Dim> void MapReader::applyWeights(ifs::IteratedFunctionSystem<Dim>& system) const {
    auto& maps = system.maps;
    const auto mapAt = [&](int number) {
        return std::size_t(number) <= maps.size() ? &maps[std::size_t(number) - 1] : nullptr;
    };
    for (const Setting& setting : m_unweighted) {
        if (setting.map == 0)
            for (auto& map : maps)
                map.weight.reset();
        else if (auto* map = mapAt(setting.map))
            map->weight.reset();
    }
    for (const Setting& setting : m_off) {
        auto* map = mapAt(setting.map);
        if (map == nullptr || (map->weight && *map->weight != 0)) continue; // switched on by another program
        map->enabled = false;
        map->weight = setting.weight;
    }
    // Rows switched off by another program stay off. If no map lacks a weight, the rows hold the weights
    // themselves.
    if (std::ranges::none_of(maps, lacksWeight<Dim>)) return;
    for (const Setting& setting : m_weights)
        if (auto* map = mapAt(setting.map); map && map->enabled && map->weight.value_or(0) > 0)
            map->weight = setting.weight;
}

template <int Dim> std::optional<ifs::Symmetry<Dim>> MapReader::symmetry() const {
    const auto named = m_isSymmetryUnderstood ? symmetryNamed(m_symmetry) : std::nullopt;
    if (!named || named->group == ifs::SymmetryGroup::None || !named->centre.empty()) return std::nullopt;
    auto symmetry = symmetryIn<Dim>(*named);
    if (!symmetry || (!m_centre.empty() && m_centre.size() != Dim) ||
        (!m_frame.empty() && m_frame.size() != Dim * Dim))
        return std::nullopt;
    if (!m_centre.empty()) symmetry->centre = Eigen::Map<const ifs::Vector<Dim>>(m_centre.data());
    if (!m_frame.empty())
        symmetry->frame = Eigen::Map<const Eigen::Matrix<double, Dim, Dim, Eigen::RowMajor>>(m_frame.data());
    return ifs::isValid(*symmetry) ? symmetry : std::nullopt;
}

template <int Dim> void MapReader::applySymmetry(ifs::IteratedFunctionSystem<Dim>& system) const {
    const auto symmetry = this->symmetry<Dim>();
    if (!symmetry) return;
    ifs::IteratedFunctionSystem<Dim> tried;
    tried.maps.resize(system.maps.size());
    tried.symmetry = *symmetry;
    if (ifs::copiesOfEachMap(tried) > 1) system.symmetry = *symmetry;
}

void MapReader::applyLinks(ifs::IteratedFunctionSystem<2>& system) const {
    const std::size_t n = system.maps.size();
    const auto fits = [n](const auto& numbered) {
        const auto& [map, row] = numbered;
        return std::size_t(map) <= n && row.size() == n &&
               std::ranges::all_of(row, [](double weight) { return weight >= 0 && std::isfinite(weight); });
    };
    if (m_rows.empty() || n > maxLinkedMaps || !std::ranges::all_of(m_rows, fits)) return;
    std::vector<double> matrix(n * n, 1);
    for (const auto& [map, row] : m_rows)
        std::ranges::copy(row, matrix.begin() + std::ptrdiff_t((std::size_t(map) - 1) * n));
    ifs::setLinks(system, matrix);
}

template <int Dim> void MapReader::applyTo(ifs::IteratedFunctionSystem<Dim>& system) const {
    applyWeights(system);
    for (const auto& [number, which, text] : m_typed)
        if (number <= system.maps.size()) keepTyped<Dim>(system.maps[number - 1], which, text);
    applySymmetry(system);
    if constexpr (Dim == 2) applyLinks(system);
}

template std::vector<std::string> weightLines(const ifs::IteratedFunctionSystem<2>&,
                                              const attractor::MapColours&);
template std::vector<std::string> weightLines(const ifs::IteratedFunctionSystem<3>&,
                                              const attractor::MapColours&);
template std::vector<std::string> symmetryLines(const ifs::Symmetry<2>&);
template std::vector<std::string> symmetryLines(const ifs::Symmetry<3>&);
template std::vector<std::string> linkLines(const ifs::IteratedFunctionSystem<2>&);
template std::vector<std::string> linkLines(const ifs::IteratedFunctionSystem<3>&);
template std::vector<std::string> typedLines(const ifs::IteratedFunctionSystem<2>&);
template std::vector<std::string> typedLines(const ifs::IteratedFunctionSystem<3>&);
template void MapReader::applyTo(ifs::IteratedFunctionSystem<2>&) const;
template void MapReader::applyTo(ifs::IteratedFunctionSystem<3>&) const;

} // namespace notation
