// SPDX-License-Identifier: MIT
#include "ifs/system/recurring_branch.h"

#include <algorithm>
#include <cstddef>

namespace ifs {

namespace {

constexpr double unseen = 1e-7; // relative to the attractor
constexpr std::size_t maxWord = 256;
constexpr std::size_t maxPieces = 1U << 15;
constexpr double maxCondition = 1e9; // limit at which rounding moves points by less than a pixel

} // namespace

template <int Dim>
std::vector<MovedBranch<Dim>> recurring(const MovedBranch<Dim>& branch,
                                        std::span<const AffineMap<Dim>> maps) {
    std::vector<MovedBranch<Dim>> result{branch};
    const AffineMap<Dim> map = composed<Dim>(maps, branch.word), step = branch.change * map;
    const auto back = inverse<Dim>(map);
    if (branch.word.empty() || !back || !isFinite<Dim>(step) || !(spectralRadius<Dim>(step.linear) < 1))
        return result;
    AffineMap<Dim> shown = step, inward = map, outward = *back;
    const std::size_t longest = std::min(maxWord, maxPieces / maps.size());
    while (result.back().word.size() + branch.word.size() <= longest &&
           spectralNorm<Dim>(shown.linear) > unseen &&
           spectralNorm<Dim>(inward.linear) * spectralNorm<Dim>(outward.linear) < maxCondition) {
        MovedBranch<Dim> next{result.back().word, inward * branch.change * outward};
        next.word.insert(next.word.end(), branch.word.begin(), branch.word.end());
        result.push_back(std::move(next));
        shown = step * shown;
        inward = map * inward;
        outward = outward * *back;
    }
    return result;
}

template std::vector<MovedBranch<2>> recurring<2>(const MovedBranch<2>&, std::span<const AffineMap<2>>);
template std::vector<MovedBranch<3>> recurring<3>(const MovedBranch<3>&, std::span<const AffineMap<3>>);

} // namespace ifs
