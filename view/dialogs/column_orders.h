// SPDX-License-Identifier: MIT
#pragma once

#include "io/table_columns.h"

class QComboBox;

namespace view {

// The orders of columns that programs and books use, the most usual first.
void addColumnOrders(QComboBox* box);
io::TableColumns chosenColumns(const QComboBox* box);

} // namespace view
