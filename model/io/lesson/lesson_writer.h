// SPDX-License-Identifier: MIT
#pragma once

#include "document/lesson/lesson.h"

#include <QByteArray>

namespace io {

// The lesson as a file: UTF-8, lines that end in LF. Reads back as the same lesson if its texts are as
// document::lessonText() and lessonLine() leave them.
QByteArray writeLesson(const document::Lesson& lesson);

} // namespace io
