// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/iterated_function_system.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace attractor {

// Values of maps by id. Stored as one sorted vector, because a system is copied at every step of a drag and
// may have 10⁵ maps.
template <class Value> class MapValues {
public:
    const Value* find(ifs::MapId id) const { // nullptr: no value
        const auto found = std::ranges::lower_bound(m_values, id, {}, idOf);
        return found != m_values.end() && found->first == id ? &found->second : nullptr;
    }
    Value& operator[](ifs::MapId id) { // fast for increasing ids
        const bool isLast = m_values.empty() || m_values.back().first < id;
        auto found = isLast ? m_values.end() : std::ranges::lower_bound(m_values, id, {}, idOf);
        if (found == m_values.end() || found->first != id) found = m_values.insert(found, {id, Value{}});
        return found->second;
    }
    bool empty() const { return m_values.empty(); }
    void reserve(std::size_t count) { m_values.reserve(count); }

    // Forgets the values of the maps for which `isGone(id)`.
    template <typename Predicate> void eraseIf(Predicate isGone) {
        std::erase_if(m_values, [&](const auto& value) { return isGone(value.first); });
    }

    friend bool operator==(const MapValues&, const MapValues&) = default;

private:
    static constexpr auto idOf = &std::pair<ifs::MapId, Value>::first;
    std::vector<std::pair<ifs::MapId, Value>> m_values; // sorted by id
};

} // namespace attractor
