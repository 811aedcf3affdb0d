// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QByteArray>
#include <QList>

#include <memory>

namespace io {

// Writes for a paper or a worksheet, not to be read again: for every system a formula per active map, and in
// the plane a TikZ figure of the control polygon at rest and its images, in the colours of the maps, with
// their numbers and fixed points. Needs amsmath and tikz.
QByteArray writeLatex(const QList<std::shared_ptr<const document::Fractal>>& fractals);

// Parts of it to be pasted, each empty for an entry that holds none of it. Only maps that take part. Numbers
// are those of readableNumber(), with a comment where any is rounded; what does not fit a page is in several
// environments.
QByteArray latexTable(const document::Fractal& fractal);         // tabular of coefficients and shares
QByteArray latexMatrices(const document::Fractal& fractal);      // align* of the formulas
QByteArray latexInvariantForm(const document::Fractal& fractal); // plane only: matrices S_i of the triangle
QByteArray tikzFigure(const document::Fractal& fractal);         // plane only

} // namespace io
