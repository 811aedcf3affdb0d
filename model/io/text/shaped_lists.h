// SPDX-License-Identifier: MIT
#pragma once

#include "io/text/literal_lists.h"

namespace io {

// Lists of rows in place of matrix(c(…), nrow = …, ncol = …, byrow = TRUE) of R, which fills columns unless
// it is told otherwise, and of array(…).reshape(rows, columns) of NumPy. A matrix of one column becomes a
// list.
void shapeMatrices(Literal& root);

} // namespace io
