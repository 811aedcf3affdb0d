// SPDX-License-Identifier: MIT
#include "document/tops/divided_words.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace document {

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
    struct Word {
        ifs::AffineMap<2> map;
        double probability;
    };
    std::vector<Word> words;
    for (std::size_t i = 0; i < first.maps.size(); ++i)
        words.push_back({first.maps[i], first.probabilities[i]});
    while (words.size() < count) {
        const auto largest = std::ranges::max_element(
            words, {}, [](const Word& word) { return ifs::spectralNorm<2>(word.map.linear); });
        const Word whole = *largest;
        std::vector<Word> parts;
        for (std::size_t i = 0; i < first.maps.size(); ++i)
            parts.push_back({whole.map * first.maps[i], whole.probability * first.probabilities[i]});
        words.insert(words.erase(largest), parts.begin(), parts.end());
    }
    shape->system = {};
    for (const Word& word : words)
        ifs::append(shape->system, word.map, word.probability);
    shape->moved.clear();
    shape->animation.reset();
    divided.appearance.mapColours = {};
    divided.appearance.mapBlends = {};
    divided.mapLabels = {}; // its maps are words of the former ones
    divided.supports = {};
    return divided;
}

} // namespace document
