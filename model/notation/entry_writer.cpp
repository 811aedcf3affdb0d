// SPDX-License-Identifier: MIT
#include "notation/entry_writer.h"

#include "notation/lines/look_lines.h"
#include "notation/lines/map_lines.h"
#include "notation/lines/placement_lines.h"
#include "notation/rows/row_reader.h"
#include "notation/text/number.h"
#include "notation/text/words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace notation {

namespace {

using Cells = std::vector<std::vector<std::string>>;

// Without white space at its ends, that of Unicode too; the text is UTF-8.
std::string_view trimmedText(std::string_view text) {
    constexpr std::array<std::string_view, 17> spaces{
        "\xc2\x85",     "\xc2\xa0",     "\xe1\x9a\x80", "\xe2\x80\x80", "\xe2\x80\x81", "\xe2\x80\x82",
        "\xe2\x80\x83", "\xe2\x80\x84", "\xe2\x80\x85", "\xe2\x80\x86", "\xe2\x80\x87", "\xe2\x80\x88",
        "\xe2\x80\x89", "\xe2\x80\x8a", "\xe2\x80\xaf", "\xe2\x81\x9f", "\xe3\x80\x80"};
    for (std::size_t before = text.size() + 1; text.size() < before;) {
        before = text.size();
        text = trimmed(text);
        for (const std::string_view space : spaces) {
            if (text.starts_with(space)) text.remove_prefix(space.size());
            if (text.ends_with(space)) text.remove_suffix(space.size());
        }
    }
    return text;
}

// One word that hides no brace, comment or prefix.
std::string storedName(std::string_view name) {
    std::string stored;
    for (const char c : trimmedText(name)) {
        const bool isLegal = (static_cast<unsigned char>(c) > 0x20 && c != 0x7f) &&
                             std::string_view("(){};:").find(c) == std::string_view::npos;
        stored += isLegal ? c : '_';
    }
    if (stored.empty()) return "unnamed";
    return lowered(stored) == "comment" ? stored + '_' : stored;
}

// One line that is not taken for one of Barycage's.
std::string storedComment(const std::string& comment) {
    std::string stored = comment;
    std::ranges::replace_if(
        stored, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    stored = std::string(trimmedText(stored));
    if (isOwnComment(stored)) stored[stored.find(':')] = ' ';
    return stored;
}

std::string cellOf(double value) {
    return formatNumber(std::isfinite(value) ? std::clamp(value, -maxCoefficient, maxCoefficient) : 0);
}

// The probabilities where a map that takes part has no weight, so that every program draws the same.
template <int Dim> std::vector<double> rowWeights(ifs::IteratedFunctionSystem<Dim> system) {
    system.links.clear(); // keeps weights of maps to which no link leads
    const std::vector<double> probabilities = ifs::probabilities(system);
    bool allGiven = true;
    for (std::size_t i = 0; i < system.maps.size(); ++i)
        allGiven = allGiven && (probabilities[i] == 0 || system.maps[i].weight);
    std::vector<double> weights(system.maps.size());
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        const auto& map = system.maps[i];
        if (probabilities[i] > 0) weights[i] = allGiven ? *map.weight : probabilities[i];
        const std::optional<double> given = map.enabled ? map.weight : 0;
        if (given && !(*given > 0)) weights[i] = *given;
    }
    return weights;
}

template <int Dim> Cells cellsOf(const ifs::IteratedFunctionSystem<Dim>& system) {
    const std::vector<double> weights = rowWeights(system);
    Cells rows;
    for (std::size_t k = 0; k < system.maps.size(); ++k) {
        std::vector<std::string> row;
        for (int which = 0; which < Dim * (Dim + 1); ++which)
            row.push_back(cellOf(ifs::coefficient<Dim>(system.maps[k].map, which)));
        row.push_back(cellOf(weights[k]));
        rows.push_back(std::move(row));
    }
    return rows;
}

// Lines without line ends, columns aligned to the right.
std::vector<std::string> alignedRows(const Cells& rows) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], row[i].size());
    }
    std::vector<std::string> lines;
    for (const auto& row : rows) {
        std::string line = " ";
        for (std::size_t i = 0; i < row.size(); ++i)
            line += std::string(1 + widths[i] - row[i].size(), ' ') + row[i];
        lines.push_back(std::move(line));
    }
    return lines;
}

// Each row on two lines where one would be longer than other programs read.
std::vector<std::string> brokenRows(const Cells& rows) {
    std::vector<std::string> whole = alignedRows(rows);
    const auto fits = [](const std::string& line) { return Offset(line.size()) <= maxLine; };
    if (std::ranges::all_of(whole, fits)) return whole;
    Cells first, second;
    for (const auto& row : rows) {
        const auto middle = row.begin() + std::ptrdiff_t((row.size() + 1) / 2);
        first.emplace_back(row.begin(), middle);
        second.emplace_back(middle, row.end());
    }
    const std::vector<std::string> begins = alignedRows(first), ends = alignedRows(second);
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < begins.size(); ++i) {
        lines.push_back(begins[i]);
        lines.push_back("  " + ends[i]);
    }
    return lines;
}

template <int Dim> std::vector<std::string> figureLines(const Entry& entry, const Figure<Dim>& figure) {
    const std::size_t maps = figure.system.maps.size();
    std::vector<std::string> lines = placementLines(figure);
    append(lines, symmetryLines(figure.system.symmetry));
    append(lines, appearanceLines(entry.appearance));
    append(lines, weightLines(figure.system, entry.appearance.mapColours));
    append(lines, mapBlendLines(entry.appearance, maps));
    append(lines, linkLines(figure.system));
    append(lines, typedLines(figure.system));
    for (const std::string& line : entry.otherLines)
        lines.push_back("; " + line);
    if (!lines.empty()) lines.insert(lines.begin(), ownLine("version", "1"));
    append(lines, brokenRows(cellsOf(figure.system)));
    return lines;
}

} // namespace

std::string written(const Entry& entry) {
    const auto* plane = std::get_if<Figure<2>>(&entry.figure);
    const auto* space = std::get_if<Figure<3>>(&entry.figure);
    std::string text = storedName(entry.name) + (space ? " (3D) {" : " {");
    if (const std::string comment = storedComment(entry.headerComment); !comment.empty())
        text += " ; " + comment;
    text += '\n';
    for (const std::string& comment : entry.comments) {
        const std::string stored = storedComment(comment);
        text += (stored.empty() ? "  ;" : "  ; " + stored) + '\n';
    }
    std::vector<std::string> lines;
    if (plane) lines = figureLines(entry, *plane);
    if (space) lines = figureLines(entry, *space);
    for (const std::string& line : lines)
        text += line + '\n';
    return text + "}\n";
}

} // namespace notation
