// SPDX-License-Identifier: MIT
#include "ifs/system/branch.h"

#include <algorithm>
#include <limits>

namespace ifs {

namespace {

template <int Dim>
void addPieces(const MovedBranch<Dim>& piece, std::span<const MovedBranch<Dim>> moved, std::size_t mapCount,
               std::vector<MovedBranch<Dim>>& result) {
    std::vector<MovedBranch<Dim>> inside;
    MovedBranch<Dim> whole = piece;
    for (const MovedBranch<Dim>& branch : moved) {
        if (branch.word == piece.word)
            whole.change = whole.change * branch.change;
        else
            inside.push_back(branch);
    }
    if (inside.empty()) {
        result.push_back(std::move(whole));
        return;
    }
    const std::size_t length = piece.word.size();
    whole.word.push_back(0);
    for (int& symbol = whole.word.back(); symbol < int(mapCount); ++symbol) {
        std::vector<MovedBranch<Dim>> below;
        std::ranges::copy_if(inside, std::back_inserter(below),
                             [&](const MovedBranch<Dim>& branch) { return branch.word[length] == symbol; });
        addPieces<Dim>(whole, below, mapCount, result);
    }
}

} // namespace

std::optional<Word> overMaps(const Word& word, std::span<const std::size_t> indices) {
    Word letters;
    for (const int symbol : word) {
        const auto letter = std::ranges::lower_bound(indices, std::size_t(symbol));
        if (letter == indices.end() || *letter != std::size_t(symbol)) return std::nullopt;
        letters.push_back(int(letter - indices.begin()));
    }
    return letters;
}

template <int Dim> AffineMap<Dim> composed(std::span<const AffineMap<Dim>> maps, const Word& word) {
    AffineMap<Dim> result;
    for (const int symbol : word)
        result = result * maps[std::size_t(symbol)];
    return result;
}

template <int Dim>
std::optional<Vector<Dim>> addressPoint(std::span<const AffineMap<Dim>> maps, const Word& prefix,
                                        const Word& period) {
    auto point = fixedPoint(composed(maps, period));
    if (!point) return std::nullopt;
    for (auto symbol = prefix.rbegin(); symbol != prefix.rend(); ++symbol)
        point = maps[std::size_t(*symbol)](*point);
    return point;
}

std::vector<Departure> departures(const Word& word, std::size_t mapCount) {
    std::vector<Departure> all;
    all.reserve(word.size() * mapCount);
    for (std::size_t kept = word.size(); kept-- > 0;)
        for (int symbol = 0; symbol < int(mapCount); ++symbol)
            if (symbol != word[kept]) all.push_back({kept, symbol});
    return all;
}

std::vector<Word> cutSet(const Word& word, std::size_t mapCount) {
    std::vector<Word> words{word};
    for (const auto& [kept, symbol] : departures(word, mapCount)) {
        words.emplace_back(word.begin(), word.begin() + std::ptrdiff_t(kept));
        words.back().push_back(symbol);
    }
    return words;
}

template <int Dim>
IteratedFunctionSystem<Dim> withBranchChanged(const IteratedFunctionSystem<Dim>& system, const Word& branch,
                                              const AffineMap<Dim>& change) {
    const ActiveMaps<Dim> active = activeMaps(system);
    IteratedFunctionSystem<Dim> result;
    // Maps of the words at which words of the cut set leave the branch: without their last symbol.
    std::vector<AffineMap<Dim>> beginnings(1);
    std::vector<double> chances{1};
    for (const int symbol : branch) {
        beginnings.push_back(beginnings.back() * active.maps[std::size_t(symbol)]);
        chances.push_back(chances.back() * active.probabilities[std::size_t(symbol)]);
    }
    const std::vector<Departure> others = departures(branch, active.maps.size());
    result.maps.reserve(1 + others.size());
    // Avoids append(), which searches all maps for a free id.
    const auto add = [&](const AffineMap<Dim>& map, double probability) {
        // Positive, because a product of many small probabilities underflows to 0, which would switch the map
        // off.
        result.maps.push_back({.id = MapId{std::uint32_t(result.maps.size() + 1)},
                               .map = map,
                               .weight = std::max(probability, std::numeric_limits<double>::min())});
    };
    add(change * beginnings.back(), chances.back());
    for (const auto& [kept, symbol] : others)
        add(beginnings[kept] * active.maps[std::size_t(symbol)],
            chances[kept] * active.probabilities[std::size_t(symbol)]);
    return result;
}

template <int Dim>
std::vector<MovedBranch<Dim>> pieces(std::span<const MovedBranch<Dim>> moved, std::size_t mapCount,
                                     std::size_t longest) {
    std::vector<MovedBranch<Dim>> shown;
    std::ranges::copy_if(moved, std::back_inserter(shown),
                         [&](const MovedBranch<Dim>& branch) { return branch.word.size() <= longest; });
    std::vector<MovedBranch<Dim>> result;
    addPieces<Dim>({}, shown, mapCount, result);
    return result;
}

template <int Dim>
std::vector<AffineMap<Dim>> pieceMaps(std::span<const MovedBranch<Dim>> pieces,
                                      std::span<const AffineMap<Dim>> maps) {
    std::vector<AffineMap<Dim>> result;
    for (const auto& [word, change] : pieces)
        result.push_back(change * composed<Dim>(maps, word));
    return result;
}

template <int Dim>
const MovedBranch<Dim>& pieceOf(std::span<const MovedBranch<Dim>> pieces, const Word& address) {
    // No word begins another, so that the last word not after the address is the one that the address begins
    // with.
    return *std::prev(std::ranges::upper_bound(pieces, address, {}, &MovedBranch<Dim>::word));
}

template <int Dim>
std::vector<MovedBranch<Dim>> overMaps(std::span<const MovedBranch<Dim>> moved,
                                       std::span<const std::size_t> indices) {
    std::vector<MovedBranch<Dim>> result;
    for (const auto& [word, change] : moved)
        if (auto letters = overMaps(word, indices)) result.push_back({*std::move(letters), change});
    return result;
}

std::vector<Word> overCutSet(const Word& word, const Word& branch, std::size_t mapCount) {
    const int others = int(mapCount) - 1;
    const auto withoutFirst = [&](std::size_t kept) { return int(branch.size() - kept) * others; };
    Word indices;
    for (std::span<const int> rest = word; !rest.empty();) {
        const auto kept = std::size_t(std::ranges::mismatch(rest, branch).in1 - rest.begin());
        if (kept == branch.size()) {
            indices.push_back(0);
            rest = rest.subspan(kept);
        } else if (kept < rest.size()) {
            const int symbol = rest[kept];
            indices.push_back(1 + withoutFirst(kept + 1) + symbol - (symbol > branch[kept] ? 1 : 0));
            rest = rest.subspan(kept + 1);
        } else { // continues with the rest of the branch
            std::vector<Word> result(std::size_t(1 + withoutFirst(kept)), indices);
            for (std::size_t k = 0; k < result.size(); ++k)
                result[k].push_back(int(k));
            return result;
        }
    }
    return {indices};
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template AffineMap<Dim> composed<Dim>(std::span<const AffineMap<Dim>>, const Word&);                     \
    template std::optional<Vector<Dim>> addressPoint<Dim>(std::span<const AffineMap<Dim>>, const Word&,      \
                                                          const Word&);                                      \
    template IteratedFunctionSystem<Dim> withBranchChanged<Dim>(const IteratedFunctionSystem<Dim>&,          \
                                                                const Word&, const AffineMap<Dim>&);         \
    template std::vector<MovedBranch<Dim>> pieces<Dim>(std::span<const MovedBranch<Dim>>, std::size_t,       \
                                                       std::size_t);                                         \
    template std::vector<AffineMap<Dim>> pieceMaps<Dim>(std::span<const MovedBranch<Dim>>,                   \
                                                        std::span<const AffineMap<Dim>>);                    \
    template const MovedBranch<Dim>& pieceOf<Dim>(std::span<const MovedBranch<Dim>>, const Word&);           \
    template std::vector<MovedBranch<Dim>> overMaps<Dim>(std::span<const MovedBranch<Dim>>,                  \
                                                         std::span<const std::size_t>);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace ifs
