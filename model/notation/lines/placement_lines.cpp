// SPDX-License-Identifier: MIT
#include "notation/lines/placement_lines.h"

#include "notation/text/number.h"
#include "notation/text/words.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace notation {

namespace {

constexpr std::string_view continued = " \\"; // end of a line that is continued by more coordinates
constexpr std::size_t maxVertices = 4096;     // limit against malicious files
constexpr std::size_t maxBranches = 1024;
constexpr std::size_t maxWord = 64;
constexpr std::size_t maxPieces = 100'000; // displayed pieces

// A point, on more than one line where its numbers are too long.
template <int Dim> std::vector<std::string> pointLines(std::string_view key, const ifs::Vector<Dim>& point) {
    std::vector<std::string> lines{ownLine(key, {})};
    for (int i = 0; i < Dim; ++i) {
        const std::string text = formatNumber(point[i]);
        const std::size_t mark = i + 1 < Dim ? continued.size() : 0;
        if (i > 0 && lines.back().size() + 1 + text.size() + mark > maxOwnLine) {
            lines.back() += continued;
            lines.push_back(ownLine(key, {}));
        }
        lines.back() += (lines.back().ends_with(' ') ? "" : " ") + text;
    }
    return lines;
}

// The word over as many lines as it needs, then the change in the order of a code row.
template <int Dim> std::vector<std::string> branchLines(const animation::BranchPose<Dim>& branch) {
    const bool recurs = branch.word.front() == ifs::MapId::None;
    std::vector<std::string> lines{ownLine("branch", recurs ? "0" : "")};
    for (const ifs::MapId id : std::span(branch.word).subspan(recurs ? 1 : 0)) {
        const std::string number = std::to_string(std::uint32_t(id));
        if (lines.back().size() + number.size() + 1 > maxOwnLine) lines.push_back(ownLine("branch", {}));
        lines.back() += (lines.back().ends_with(' ') ? "" : " ") + number;
    }
    for (int i = 0; i < Dim; ++i)
        append(lines, pointLines<Dim>("by", branch.change.linear.row(i).transpose()));
    append(lines, pointLines<Dim>("by", branch.change.translation));
    return lines;
}

template <int Dim> ifs::Vector<Dim> vectorOf(const std::vector<double>& coordinates) {
    return Eigen::Map<const ifs::Vector<Dim>>(coordinates.data());
}

} // namespace

template <int Dim> std::vector<std::string> placementLines(const Figure<Dim>& figure) {
    std::vector<std::string> lines;
    if (figure.cage) {
        for (const auto& vertex : figure.cage->rest)
            append(lines, pointLines<Dim>("rest", vertex));
        for (const auto& vertex : figure.cage->current)
            append(lines, pointLines<Dim>("current", vertex));
        if (figure.cage->deformation == ifs::Deformation::AffineFit)
            lines.push_back(ownLine("deformation", "affine-fit"));
    }
    for (const auto& branch : figure.moved)
        append(lines, branchLines(branch));
    return lines;
}
template std::vector<std::string> placementLines(const Figure<2>&);
template std::vector<std::string> placementLines(const Figure<3>&);

// One more point, or more coordinates of the last one.
bool PlacementReader::readPoint(const std::vector<std::string>& values, std::vector<Point>& points) {
    const bool continues = !points.empty() && points.back().isOpen;
    Point point = continues ? points.back() : Point();
    point.isOpen = !values.empty() && values.back() == "\\";
    for (const std::string& value : std::span(values).first(values.size() - (point.isOpen ? 1 : 0))) {
        const auto coordinate = parseNumber(value);
        if (!coordinate) return false;
        point.coordinates.push_back(*coordinate);
    }
    const std::size_t count = point.coordinates.size();
    if (point.isOpen ? count < 1 || count > 2 : count < 2 || count > 3) return false;
    if (continues)
        points.back() = std::move(point);
    else
        points.push_back(std::move(point));
    return true;
}

bool PlacementReader::readWord(const std::vector<std::string>& values) {
    if (m_branches.empty() || !m_branches.back().by.empty()) {
        if (m_branches.size() >= maxBranches) return false;
        m_branches.emplace_back();
    }
    std::vector<int> symbols;
    for (const std::string& value : values)
        symbols.push_back(wholeNumber(value));
    std::vector<int>& word = m_branches.back().word;
    const bool begins = word.empty() && !values.empty() && values.front() == "0";
    const auto first = symbols.begin() + (begins ? 1 : 0);
    if (first == symbols.end() || *std::min_element(first, symbols.end()) < 1 ||
        word.size() + symbols.size() > maxWord)
        return false;
    word.insert(word.end(), symbols.begin(), symbols.end());
    return true;
}

bool PlacementReader::read(const std::string& key, const std::vector<std::string>& values) {
    if (key == "rest" || key == "current") {
        auto& vertices = key == "rest" ? m_rest : m_current;
        return vertices.size() < maxVertices && readPoint(values, vertices);
    }
    if (key == "deformation") {
        if (values.size() != 1 || (values[0] != "affine-fit" && values[0] != "bend")) return false;
        m_deformation = values[0] == "bend" ? ifs::Deformation::Bend : ifs::Deformation::AffineFit;
        return true;
    }
    if (key == "branch") return readWord(values);
    if (key != "by" || m_branches.empty()) return false;
    std::vector<Point>& by = m_branches.back().by;
    const bool isComplete = !by.empty() && !by.back().isOpen && by.size() > by.front().coordinates.size();
    return !isComplete && readPoint(values, by);
}

template <int Dim> void PlacementReader::applyCage(Figure<Dim>& figure) const {
    ifs::ControlCage<Dim> cage{{}, {}, m_deformation};
    const auto take = [](const std::vector<Point>& points, std::vector<ifs::Vector<Dim>>& vertices) {
        for (const Point& point : points)
            if (point.dimension() == Dim) vertices.push_back(vectorOf<Dim>(point.coordinates));
    };
    take(m_rest, cage.rest);
    take(m_current, cage.current);
    if (ifs::isValid(cage)) figure.cage = std::move(cage);
}

template <int Dim> void PlacementReader::applyTo(Figure<Dim>& figure) const {
    applyCage(figure);
    const auto& maps = figure.system.maps;
    const auto isHere = [](const Point& point) { return point.dimension() == Dim; };
    std::size_t pieces = 0;
    for (const Branch& branch : m_branches) {
        if (!branch.by.empty() && std::ranges::none_of(branch.by, isHere)) continue;
        animation::BranchPose<Dim> moved;
        for (const int symbol : branch.word)
            if (std::size_t(symbol) <= maps.size())
                moved.word.push_back(symbol == 0 ? ifs::MapId::None : maps[std::size_t(symbol) - 1].id);
        const bool isAddress = !moved.word.empty() && moved.word.back() != ifs::MapId::None;
        pieces += moved.word.size() * maps.size();
        const bool isKnown = std::ranges::find(figure.moved, moved.word, &animation::BranchPose<Dim>::word) !=
                             figure.moved.end();
        if (branch.by.size() != Dim + 1 || !std::ranges::all_of(branch.by, isHere) || !isAddress ||
            moved.word.size() != branch.word.size() || isKnown || pieces > maxPieces)
            continue;
        for (int i = 0; i < Dim; ++i)
            moved.change.linear.row(i) = vectorOf<Dim>(branch.by[std::size_t(i)].coordinates).transpose();
        moved.change.translation = vectorOf<Dim>(branch.by[Dim].coordinates);
        figure.moved.push_back(std::move(moved));
    }
}
template void PlacementReader::applyTo(Figure<2>&) const;
template void PlacementReader::applyTo(Figure<3>&) const;

} // namespace notation
