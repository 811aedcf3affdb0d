// SPDX-License-Identifier: MIT
#pragma once

#include "io/table/written_map.h"

#include <QString>

namespace io {

// Maps written as equations, alone or in the lines of a program: x' = 0.85x + 0.04y and y' = …, in LaTeX as
// well; or both at once, f(x, y) = (0.85x + 0.04y, …). Two maps or more, else none.
WrittenMaps equationMaps(const QString& text);

} // namespace io
