// SPDX-License-Identifier: MIT
#include "document/edits/cage/placements.h"

#include "document/edits/cage/cage_edits.h"
#include "document/edits/maps/link_expansion.h"
#include "document/edits/maps/symmetry_edits.h"
#include "document/edits/timeline/keyed_maps.h"

#include <memory>
#include <optional>
#include <utility>

namespace document {

namespace {

template <int Dim> bool hasCageKeys(const Shape<Dim>& shape) {
    return shape.animation && !shape.animation->cage.empty();
}
bool hasCageKeys(const Fractal& entry) {
    if (const auto* shape = plane(entry)) return hasCageKeys(*shape);
    const auto* shape = space(entry);
    return shape && hasCageKeys(*shape);
}

template <int Dim> bool isPlacedByKeys(const Shape<Dim>& shape) {
    return shape.cage && shape.animation->cage.front().value != shape.cage->rest;
}

std::optional<Fractal> withPlacementBaked(const Fractal& entry) {
    if (hasCageKeys(entry) || !rewriteObstacle(entry).isEmpty()) return std::nullopt;
    return baked(entry);
}

// False where a part is left that other programs do not know.
bool listMaps(Fractal& entry) {
    if (isSymmetric(entry)) {
        if (!expandObstacle(entry).isEmpty()) return false;
        entry = expanded(std::move(entry));
    }
    if (!isLinked(entry)) return true;
    if (!linkExpansionObstacle(entry).isEmpty()) return false;
    entry = withLinksExpanded(std::move(entry));
    return true;
}

template <class Change> BakedFile changed(FractalFile file, Change change) {
    BakedFile result;
    for (Entry& entry : file.entries) {
        if (dimension(*entry.fractal) == 0) continue;
        Fractal after = *entry.fractal;
        if (!change(after)) result.left << entry.fractal->name;
        if (after != *entry.fractal) entry.fractal = std::make_shared<const Fractal>(std::move(after));
    }
    result.file = std::move(file);
    return result;
}

bool bake(Fractal& entry) {
    if (!isPlaced(entry)) return true;
    auto after = withPlacementBaked(entry);
    if (after) entry = *std::move(after);
    return after.has_value();
}

} // namespace

bool isPlaced(const Fractal& entry) {
    if (!hasCageKeys(entry)) return !isAtRest(entry);
    const auto* shape = plane(entry);
    return shape ? isPlacedByKeys(*shape) : isPlacedByKeys(*space(entry));
}

QStringList placedEntries(const FractalFile& file) {
    QStringList names;
    for (const Entry& entry : file.entries)
        if (isPlaced(*entry.fractal)) names << entry.fractal->name;
    return names;
}

BakedFile withPlacementsBaked(FractalFile file) {
    return changed(std::move(file), bake);
}

BakedFile forOtherPrograms(FractalFile file) {
    return changed(std::move(file), [](Fractal& entry) {
        const bool isBaked = bake(entry);
        return listMaps(entry) && isBaked;
    });
}

} // namespace document
