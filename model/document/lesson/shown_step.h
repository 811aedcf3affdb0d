// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"
#include "document/lesson/lesson.h"

// What a step of a lesson shows of the file of its fractals.
namespace document {

// The entry that the step names; nullptr where the file has none. A step without a name has the first entry
// that can be shown.
const Entry* entryOf(const FractalFile& file, const LessonState& state);

struct ShownStep {
    Fractal fractal;  // entry at the moment of the step, without animation
    bool fits = true; // false: the entry's cage has other corners than the lesson's, and is kept
};
// The entry with the cage and the colours of the step.
ShownStep shownIn(const LessonState& state, const Fractal& entry);

// The same of an entry that stays animated.
ShownStep withCageAndColours(const LessonState& state, const Fractal& entry);

} // namespace document
