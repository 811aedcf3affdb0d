// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/iterated_function_system.h"

#include <QString>

#include <utility>
#include <vector>

namespace document {

// An artist's label of a map, as of a layer.
struct MapLabel {
    QString name;          // one line; empty: the map is called by its number
    bool isLocked = false; // true: coefficients and weight are not edited

    friend bool operator==(const MapLabel&, const MapLabel&) = default;
};

// The labels of the maps of an entry, by id. In one piece, because an entry is copied at every step of a drag
// and may have 10⁵ maps. A label without a name or a lock is not kept.
class MapLabels {
public:
    MapLabel of(ifs::MapId id) const;
    void set(ifs::MapId id, MapLabel label); // fast for increasing ids
    bool isEmpty() const { return m_labels.empty(); }

    // Forgets the labels of the maps for which `isGone(id)`.
    template <typename Predicate> void eraseIf(Predicate isGone) {
        std::erase_if(m_labels, [&](const auto& label) { return isGone(label.first); });
    }

    friend bool operator==(const MapLabels&, const MapLabels&) = default;

private:
    std::vector<std::pair<ifs::MapId, MapLabel>> m_labels; // sorted by id
};

} // namespace document
