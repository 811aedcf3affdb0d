// SPDX-License-Identifier: MIT
#pragma once

#include "document/lesson/lesson.h"

#include <QLatin1String>

#include <span>

// The words that lesson files use for what a step shows.
namespace io {

template <class Value> struct LessonWord {
    QLatin1String word;
    Value value;
};

std::span<const LessonWord<document::LessonTool>> lessonTools();
std::span<const LessonWord<attractor::ColourBy>> lessonColours();
std::span<const LessonWord<document::Outline>> lessonOutlines();
std::span<const LessonWord<bool document::LessonState::*>> lessonMarks();  // marks that can be hidden
std::span<const LessonWord<bool document::LessonState::*>> lessonExtras(); // marks that can be added

} // namespace io
