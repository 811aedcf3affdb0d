// SPDX-License-Identifier: MIT
#pragma once

#include "animation/animation.h"

#include <QString>

// Labels of a ruler of frames and their distances.
namespace view {

enum class RulerUnit { Frames, Seconds };

// Frames from one label to the next: of the steps 1, 2, 5, 10, … of the unit, the smallest that is at least
// `wanted` frames.
int rulerStep(double wanted, const animation::FrameRate& rate, RulerUnit unit);
QString rulerText(int frame, const animation::FrameRate& rate, RulerUnit unit);

} // namespace view
