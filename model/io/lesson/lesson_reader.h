// SPDX-License-Identifier: MIT
#pragma once

#include "document/lesson/lesson.h"
#include "document/problem.h"

#include <QByteArray>

namespace io {

// Content of a lesson file. Lenient: a line that is not understood gives a warning, and the rest counts; a
// setting of a later version is kept. An error, and no step, when it is no lesson. docs/formats.md,
// "Lessons".
struct LessonFile {
    document::Lesson lesson;
    document::Problems problems;
};

// Reads at most 4 MB, and the numbers of steps, letters and corners that lesson.h allows.
LessonFile readLesson(const QByteArray& bytes);

} // namespace io
