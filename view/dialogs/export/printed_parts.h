// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal.h"
#include "io/picture/png_export.h"

#include <QFont>
#include <QImage>
#include <QRectF>
#include <QString>

#include <array>
#include <span>
#include <vector>

class QPainter;
class QWidget;

// What printed pages are made of.
namespace view {

constexpr int printedColumns = 8; // number, a to f, p
using PrintedRow = std::array<QString, printedColumns>;
// Of as many maps as anybody reads on paper.
std::vector<PrintedRow> coefficientRows(const document::System2& system);
// As many rows as are legible in the room, under their names; returns how many.
std::size_t paintCoefficients(QPainter& painter, const QRectF& room, double minHeight,
                              std::span<const PrintedRow> rows);

QFont printedFont(const QPainter& painter, double pixels, bool bold);

// The look on paper: a dark screen would drown the page in ink, and what glows on it would be pale on white.
document::Fractal onPaper(document::Fractal fractal);
// Null when the user has changed their mind, or closed the window.
QImage drawnForPaper(const io::PngExport& picture, QWidget* parent);

} // namespace view
