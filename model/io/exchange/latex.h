// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal.h"

#include <QByteArray>
#include <QList>

#include <memory>

namespace io {

// For a paper or a task sheet, not to be read again: of every system a formula per active map, and in the
// plane a TikZ figure of the control polygon at rest and its images, in the colours of the maps. Needs
// amsmath and tikz.
QByteArray writeLatex(const QList<std::shared_ptr<const document::Fractal>>& fractals);

} // namespace io
