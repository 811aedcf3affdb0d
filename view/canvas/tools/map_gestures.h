// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "gestures/pointer.h"
#include "ifs/cage/map_handles.h"

#include <QString>

#include <cstddef>
#include <functional>
#include <optional>
#include <variant>
#include <vector>

class QKeyEvent;

// Code shared by gestures on maps in plane and space.
namespace view {

// The name of the undo step that drags `count` maps, of which the one held is number `number`; or one corner.
QString mapsStepText(DragMode mode, std::size_t count, std::size_t number, std::optional<std::size_t> corner);

// Delete and Insert, Ctrl+A, and Alt with a digit, on the maps that are selected.
struct MapKey {
    bool isTaken = false;
    std::vector<ifs::MapId> selected{}; // new selection; empty: unchanged
    QString message{};
};
MapKey pressMapKey(const QKeyEvent& event, document::Document& document,
                   const std::vector<std::size_t>& selected);

// The part of a change, after(0) to after(1), that leaves an attractor. For linked maps, all of it: only some
// words count, and the picture shows when they no longer contract. The result of `after` must live until the
// next call.
template <int Dim>
ifs::SafeWay<Dim> wayWithAttractor(const std::function<const document::Fractal&(double)>& after) {
    const auto system = [&](double share) -> const auto& {
        return std::get<document::Shape<Dim>>(after(share).shape).system;
    };
    if (!system(1).links.empty()) return {};
    return ifs::safeWay<Dim>([&](double share) { return ifs::activeMaps(system(share)).maps; });
}

} // namespace view
