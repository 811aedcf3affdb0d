// SPDX-License-Identifier: MIT
#include "document/lesson/shown_step.h"

#include "document/lesson/lesson_cage.h"
#include "document/moments/animated_fractal.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace document {

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
    AnimatedFrame frame = frameAt(entry, state.moment.value_or(animation::Moment()));
    frame.fractal.lasting = lastingCage(entry);
    return withCageAndColours(state, frame.fractal);
}

} // namespace document
