// SPDX-License-Identifier: MIT
#include "document/lesson/shown_step.h"

#include "document/edits/cage/cage_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/moments/animated_fractal.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace document {

namespace {

// The fractal with its cage there; nullopt where the cage has other corners.
std::optional<Fractal> withLessonCage(const Fractal& fractal, const LessonCage& cage) {
    const auto moved = [&](auto present, const auto& corners) -> std::optional<Fractal> {
        if (!present || present->current.size() != corners.size()) return std::nullopt;
        if (present->current == corners) return fractal;
        present->current = corners;
        return withCageMoved(fractal, *std::move(present), CageMode::Place);
    };
    if (std::holds_alternative<LessonAtRest>(cage))
        return isAtRest(fractal) ? fractal : withCageAtRest(fractal);
    if (const auto* inPlane = std::get_if<std::vector<ifs::Vector<2>>>(&cage))
        return moved(plane(fractal) ? std::optional(effectiveCage(fractal)) : std::nullopt, *inPlane);
    if (const auto* inSpace = std::get_if<std::vector<ifs::Vector<3>>>(&cage))
        return moved(space(fractal) ? spaceCage(fractal) : std::nullopt, *inSpace);
    return fractal;
}

} // namespace

const Entry* entryOf(const FractalFile& file, const LessonState& state) {
    const auto found = std::ranges::find_if(file.entries, [&](const Entry& entry) {
        return state.entry.isEmpty() ? dimension(*entry.fractal) != 0
                                     : lessonLine(entry.fractal->name) == state.entry;
    });
    return found == file.entries.end() ? nullptr : &*found;
}

ShownStep withCageAndColours(const LessonState& state, const Fractal& entry) {
    std::optional<Fractal> shown = withLessonCage(entry, state.cage);
    const bool fits = shown.has_value();
    if (!fits) shown = entry;
    if (state.colourBy && plane(entry)) shown->appearance.colourBy = *state.colourBy;
    return {*std::move(shown), fits};
}

ShownStep shownIn(const LessonState& state, const Fractal& entry) {
    if (!animationFacts(entry)) return withCageAndColours(state, entry);
    return withCageAndColours(state, frameAt(entry, state.moment.value_or(animation::Moment())).fractal);
}

} // namespace document
