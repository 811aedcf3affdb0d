// SPDX-License-Identifier: MIT
#include "document/fractal/map_labels.h"

#include <algorithm>

namespace document {

namespace {

constexpr auto idOf = &std::pair<ifs::MapId, MapLabel>::first;

} // namespace

MapLabel MapLabels::of(ifs::MapId id) const {
    const auto found = std::ranges::lower_bound(m_labels, id, {}, idOf);
    return found != m_labels.end() && found->first == id ? found->second : MapLabel{};
}

void MapLabels::set(ifs::MapId id, MapLabel label) {
    const bool isLast = m_labels.empty() || m_labels.back().first < id;
    const auto found = isLast ? m_labels.end() : std::ranges::lower_bound(m_labels, id, {}, idOf);
    const bool isKnown = found != m_labels.end() && found->first == id;
    if (label == MapLabel{}) {
        if (isKnown) m_labels.erase(found);
    } else if (isKnown) {
        found->second = std::move(label);
    } else {
        m_labels.insert(found, {id, std::move(label)});
    }
}

} // namespace document
