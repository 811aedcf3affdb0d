// SPDX-License-Identifier: MIT
#include "document/fractal/recurring_branches.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace document {

std::vector<ifs::MapId> recurringWord(std::vector<ifs::MapId> address) {
    address.insert(address.begin(), ifs::MapId::None);
    return address;
}

template <int Dim> std::vector<StoredBranch<Dim>> storedBranches(const Shape<Dim>& shape) {
    std::vector<StoredBranch<Dim>> result;
    const auto& maps = shape.system.maps;
    std::vector<std::pair<ifs::MapId, int>> named; // ids and indices; −1: removed
    for (const MovedBranch<Dim>& branch : shape.moved)
        for (const ifs::MapId id : branch.word)
            named.emplace_back(id, -1);
    std::ranges::sort(named);
    const auto indexOf = [&](ifs::MapId id) {
        const auto found = std::ranges::lower_bound(named, id, {}, &std::pair<ifs::MapId, int>::first);
        return found != named.end() && found->first == id ? &found->second : nullptr;
    };
    for (std::size_t index = 0; !named.empty() && index < maps.size(); ++index)
        if (int* known = indexOf(maps[index].id)) *known = int(index);
    for (const auto& [word, change] : shape.moved) {
        StoredBranch<Dim> stored{{{}, change}, recurs(word)};
        const std::span<const ifs::MapId> address = std::span(word).subspan(stored.recurs ? 1 : 0);
        for (const ifs::MapId id : address)
            if (const int index = *indexOf(id); index >= 0) stored.branch.word.push_back(index);
        if (stored.branch.word.size() == address.size()) result.push_back(std::move(stored));
    }
    return result;
}
template std::vector<StoredBranch<2>> storedBranches(const Shape<2>&);
template std::vector<StoredBranch<3>> storedBranches(const Shape<3>&);

} // namespace document
