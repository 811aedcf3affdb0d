// SPDX-License-Identifier: MIT
#include "document/tops/divided_words.h"

#include "document/edits/coupled_entries.h"
#include "document/tops/kept_theft.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace document {

namespace {

struct Word {
    ifs::AffineMap<2> map;
    double probability;
    std::vector<std::size_t> ranks; // ranks of its symbols in the order of the maps; 0: on top
};

// The active maps, with the ranks that they have in the order that is kept.
std::vector<Word> symbolsOf(const ifs::ActiveMaps<2>& active, const std::optional<KeptTheft>& theft) {
    std::vector<Word> symbols;
    for (std::size_t i = 0; i < active.maps.size(); ++i)
        symbols.push_back({active.maps[i], active.probabilities[i], {i}});
    if (!theft) return symbols;
    if (const auto places = placesInOrder(theft->order, active.index))
        for (std::size_t rank = 0; rank < places->size(); ++rank)
            symbols[(*places)[rank]].ranks = {rank};
    return symbols;
}

Word composed(const Word& outer, const Word& symbol) {
    Word word{outer.map * symbol.map, outer.probability * symbol.probability, outer.ranks};
    word.ranks.insert(word.ranks.end(), symbol.ranks.begin(), symbol.ranks.end());
    return word;
}

// Addresses are ordered as the words with which they begin. Empty: the words are in order.
std::vector<std::size_t> orderOf(const std::vector<Word>& words) {
    std::vector<std::size_t> order(words.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(
        order, {}, [&](std::size_t word) -> const auto& { return words[word].ranks; });
    if (std::ranges::is_sorted(order)) order.clear();
    return order;
}

} // namespace

std::optional<std::size_t> commonMapCount(std::size_t n, std::size_t m) {
    if (n < 2 || m < 2) return std::nullopt;
    const std::size_t common = 1 + std::lcm(n - 1, m - 1);
    return common <= maxDividedMaps ? std::optional(common) : std::nullopt;
}

Fractal withWordsDivided(const Fractal& fractal, std::size_t count) {
    Fractal divided = fractal;
    Shape<2>* shape = plane(divided);
    if (shape == nullptr) return divided;
    const ifs::ActiveMaps<2> first = ifs::activeMaps(shape->system);
    if (first.maps.size() < 2 || first.maps.size() >= count) return divided;
    auto theft = keptTheft(fractal);
    const std::vector<Word> symbols = symbolsOf(first, theft);
    std::vector<Word> words = symbols;
    while (words.size() < count) {
        const auto largest = std::ranges::max_element(
            words, {}, [](const Word& word) { return ifs::spectralNorm<2>(word.map.linear); });
        std::vector<Word> parts;
        for (const Word& symbol : symbols)
            parts.push_back(composed(*largest, symbol));
        words.insert(words.erase(largest), parts.begin(), parts.end());
    }
    shape->system = {};
    for (const Word& word : words)
        ifs::append(shape->system, word.map, word.probability);
    shape->moved.clear();
    shape->animation.reset();
    divided.appearance.mapColours = {};
    divided.appearance.mapBlends = {};
    divided.mapLabels = {}; // maps are now words of the former ones
    divided.supports = {};
    if (theft) {
        theft->order = orderOf(words);
        divided = withTheft(std::move(divided), theft);
    }
    return divided;
}

} // namespace document
