// SPDX-License-Identifier: MIT
#pragma once

#include "dialogs/export/print_preview.h"
#include "document/fractal_file.h"
#include "document/lesson/lesson.h"

#include <QImage>
#include <QList>
#include <QRectF>
#include <QString>

#include <functional>

class QPainter;
class QWidget;

namespace view {

// Shows a print preview of the lesson, and prints it from there: showPrintPreview(). The steps show the
// entries of `file`.
void printLesson(const document::Lesson& lesson, const document::FractalFile& file, QWidget* parent,
                 const PrintSaid& said);

// Title, and for each step its number, title, picture and text, from the top of `page` down. A picture stays
// on one page with its title; `newPage` begins another one. A null picture takes no room.
void paintLesson(QPainter& painter, const QRectF& page, const document::Lesson& lesson,
                 const QList<QImage>& pictures, const std::function<void()>& newPage);

} // namespace view
