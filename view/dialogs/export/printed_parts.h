// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "io/export_job.h"

#include <QFont>
#include <QImage>
#include <QRectF>
#include <QStringList>

#include <span>
#include <vector>

class QPainter;
class QWidget;

// Building blocks of printed pages.
namespace view {

struct PrintedTable {
    QStringList names; // names of the columns; the first has the numbers of the rows
    std::vector<QStringList> rows;
};
// Number, a to f or, in space, a to l, and p.
QStringList coefficientNames(int dimension);
// Tables of as many maps as anybody reads on paper.
template <int Dim> PrintedTable coefficientTable(const ifs::IteratedFunctionSystem<Dim>& system);
PrintedTable cornerTable(const ifs::ControlCage<3>& cage); // current corners

struct Printed {
    std::size_t rows = 0;
    double bottom = 0;
};
// Paints rows from `first` on, as many as are legible in the room, under the names of the columns.
Printed paintTable(QPainter& painter, const QRectF& room, double minHeight, const PrintedTable& table,
                   std::size_t first);

QFont printedFont(const QPainter& painter, double pixels, bool bold);

// The look on paper: a dark screen would drown the page in ink, and what glows on it would be pale on white.
document::Fractal onPaper(document::Fractal fractal);
// Null when the user has changed their mind, or closed the window.
QImage drawnForPaper(const io::PlaneExport& picture, QWidget* parent);
QImage drawnForPaper(const io::SpaceExport& picture, QWidget* parent);

// The initial camera of a solid.
attractor::OrbitCamera standardView();
// An entry in space as it looks on paper, `longSide` pixels along the longer side.
io::SpaceExport spacePicture(const document::Fractal& fractal, attractor::OrbitCamera camera, int longSide);
// Crops the empty sides, which have only the ground's colour; for a line, a tenth of the picture is left.
QImage withoutEmptySides(const QImage& picture, QRgb ground);

} // namespace view
