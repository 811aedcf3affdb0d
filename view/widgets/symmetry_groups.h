// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/symmetry.h"

class QComboBox;

namespace view {

// Lists the groups that exist in a dimension, None first; the data of an item is the group as a number.
void fillSymmetryGroups(QComboBox* box, int dimension);
ifs::SymmetryGroup chosenSymmetryGroup(const QComboBox* box);

bool hasOrder(ifs::SymmetryGroup group);
bool hasMirrors(ifs::SymmetryGroup group);

} // namespace view
