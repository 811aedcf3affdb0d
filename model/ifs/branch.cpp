// SPDX-License-Identifier: MIT
#include "ifs/branch.h"

namespace ifs {

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

std::vector<Word> cutSet(const Word& word, std::size_t mapCount) {
    std::vector<Word> words{word};
    for (std::size_t j = word.size(); j-- > 0;)
        for (int symbol = 0; symbol < int(mapCount); ++symbol)
            if (symbol != word[j]) {
                words.emplace_back(word.begin(), word.begin() + std::ptrdiff_t(j));
                words.back().push_back(symbol);
            }
    return words;
}

template <int Dim>
IteratedFunctionSystem<Dim> withBranchChanged(const IteratedFunctionSystem<Dim>& system, const Word& branch,
                                              const AffineMap<Dim>& change) {
    const ActiveMaps<Dim> active = activeMaps(system);
    IteratedFunctionSystem<Dim> result;
    for (const Word& word : cutSet(branch, active.maps.size())) {
        const AffineMap<Dim> map = composed<Dim>(active.maps, word);
        double probability = 1;
        for (const int symbol : word)
            probability *= active.probabilities[std::size_t(symbol)];
        append(result, word == branch ? change * map : map, std::optional(probability));
    }
    return result;
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template AffineMap<Dim> composed<Dim>(std::span<const AffineMap<Dim>>, const Word&);                     \
    template std::optional<Vector<Dim>> addressPoint<Dim>(std::span<const AffineMap<Dim>>, const Word&,      \
                                                          const Word&);                                      \
    template IteratedFunctionSystem<Dim> withBranchChanged<Dim>(const IteratedFunctionSystem<Dim>&,          \
                                                                const Word&, const AffineMap<Dim>&);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace ifs
