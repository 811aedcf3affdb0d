// SPDX-License-Identifier: MIT
#include "notation/value/entry.h"

#include "ifs/system/recurring_branch.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace notation {

namespace {

// The address of a branch; nullopt where one of its maps is gone.
std::optional<ifs::Word> addressOf(const std::vector<ifs::MapId>& word, bool recurs,
                                   const std::map<ifs::MapId, int>& indices) {
    ifs::Word address;
    for (std::size_t i = recurs ? 1 : 0; i < word.size(); ++i) {
        const auto found = indices.find(word[i]);
        if (found == indices.end() || found->second < 0) return std::nullopt;
        address.push_back(found->second);
    }
    return address;
}

} // namespace

template <int Dim>
std::vector<ifs::MovedBranch<Dim>> movedBranches(const ifs::IteratedFunctionSystem<Dim>& system,
                                                 const std::vector<animation::BranchPose<Dim>>& moved) {
    std::vector<ifs::MovedBranch<Dim>> result, inside, again;
    if (moved.empty()) return result;
    std::map<ifs::MapId, int> indices; // indices of maps in addresses; −1: removed
    for (const animation::BranchPose<Dim>& branch : moved)
        for (const ifs::MapId id : branch.word)
            indices[id] = -1;
    for (std::size_t i = 0; i < system.maps.size(); ++i)
        if (const auto named = indices.find(system.maps[i].id); named != indices.end())
            named->second = int(i);
    const std::vector<ifs::AffineMap<Dim>> maps = ifs::mapsOf(system);
    std::set<ifs::Word> known; // for several changes of one branch, the first counts
    for (const animation::BranchPose<Dim>& branch : moved) {
        const bool recurs = !branch.word.empty() && branch.word.front() == ifs::MapId::None;
        const auto address = addressOf(branch.word, recurs, indices);
        if (!address) continue;
        const ifs::MovedBranch<Dim> stored{*address, branch.change};
        if (!recurs) {
            result.push_back(stored);
            continue;
        }
        std::vector<ifs::MovedBranch<Dim>> all = ifs::recurring<Dim>(stored, maps);
        for (auto each = std::next(all.begin()); each != all.end(); ++each)
            if (known.insert(each->word).second) again.push_back(std::move(*each));
        inside.push_back(std::move(all.front()));
    }
    std::ranges::move(inside, std::back_inserter(result));
    std::ranges::move(again, std::back_inserter(result));
    return result;
}
template std::vector<ifs::MovedBranch<2>> movedBranches(const ifs::IteratedFunctionSystem<2>&,
                                                        const std::vector<animation::BranchPose<2>>&);
template std::vector<ifs::MovedBranch<3>> movedBranches(const ifs::IteratedFunctionSystem<3>&,
                                                        const std::vector<animation::BranchPose<3>>&);

} // namespace notation
