// SPDX-License-Identifier: MIT
#include "document/edits/timeline/keyed_maps.h"

#include "document/branches/addresses.h"
#include "document/maps/map_names.h"
#include "document/text/text.h"

#include <algorithm>
#include <variant>
#include <vector>

namespace document {

namespace {

// "Map 2", "A branch" or, where nothing has keys, nothing.
template <int Dim> QString keyed(const Fractal& entry, const Shape<Dim>& shape) {
    if (!shape.animation) return {};
    const auto& maps = shape.system.maps;
    for (std::size_t i = 0; i < maps.size(); ++i)
        if (std::ranges::count(shape.animation->maps, maps[i].id, &animation::MapTrack<Dim>::map) > 0)
            return Text::tr("Map %1", "begins a sentence").arg(mapTitle(entry, i));
    return shape.animation->branches.empty() ? QString() : Text::tr("A branch");
}

template <int Dim> bool movesSingleMaps(const Shape<Dim>& shape) {
    const auto namesMaps = [](const animation::Motion<Dim>& motion) {
        return std::visit(
            [](const auto& which) {
                if constexpr (requires { which.maps; })
                    return !which.maps.empty();
                else
                    return false;
            },
            motion);
    };
    return shape.animation && std::ranges::any_of(shape.animation->motions, namesMaps);
}

QString keyedIn(const Fractal& entry) {
    if (const auto* shape = plane(entry)) return keyed(entry, *shape);
    if (const auto* shape = space(entry)) return keyed(entry, *shape);
    return {};
}

} // namespace

QString branchAsMapObstacle(const Fractal& entry) {
    if (const QString keyed = keyedIn(entry); !keyed.isEmpty())
        return Text::tr(
                   "%1 has keys, which the maps of the new system could not follow. Remove its keys in the "
                   "timeline first.")
            .arg(keyed);
    const auto* inPlane = plane(entry);
    const auto* inSpace = space(entry);
    if ((inPlane && movesSingleMaps(*inPlane)) || (inSpace && movesSingleMaps(*inSpace)))
        return Text::tr(
            "A motion moves single maps, and the maps of the new system are others. Remove this motion "
            "from the timeline first.");
    return {};
}

QString rewriteObstacle(const Fractal& entry) {
    const QString keyed = keyedIn(entry);
    if (keyed.isEmpty()) return {};
    return Text::tr(
               "%1 has keys: it would be rewritten at this frame only, and what has none at every frame. "
               "Remove its keys in the timeline first.")
        .arg(keyed);
}

} // namespace document
