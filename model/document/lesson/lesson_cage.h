// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "document/lesson/lesson.h"

#include <optional>

namespace document {

// The fractal with its cage where a step of a lesson has it; nullopt where the cage has other corners.
std::optional<Fractal> withLessonCage(const Fractal& fractal, const LessonCage& cage);

} // namespace document
