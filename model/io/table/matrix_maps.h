// SPDX-License-Identifier: MIT
#pragma once

#include "io/table/written_map.h"

#include <QString>

namespace io {

// Maps written with the matrices of LaTeX: a matrix and, behind it, a vector; or both in one, 2 × 3 or with
// 0 0 1 below. Factors before them are multiplied in, columns of letters are skipped, and a matrix without a
// vector has none.
WrittenMaps matrixMaps(const QString& text);

} // namespace io
