// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "document/lesson/lesson.h"

#include <QImage>
#include <QSize>

#include <stop_token>

namespace io {

// The canvas at a step of a lesson, in `size` pixels: the attractor, its steps or the points of the chaos
// game, in the view of the step, under the marks that the step shows. Grid, axes and panels are left out.
// `fractal` is what the step shows of its entry: document::shownIn(). Null when stopped.
QImage lessonPicture(const document::Fractal& fractal, const document::LessonState& state, const QSize& size,
                     const std::stop_token& stop = {});

} // namespace io
