// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/decomposition.h"

#include <QString>

// What the table of maps says of kinds, coefficients and itself, and the line below it of one map.
namespace view {

class MapsModel;

QString kindText(ifs::MapKind kind);
QString kindTip(ifs::MapKind kind, int dimension);
QString coefficientTip(int dimension);
QString tableWhatsThis(int dimension);
// Of the map of a row, and which of several selected ones it is; a hint where the row is −1.
QString factsText(const MapsModel& model, int row, int selected);

} // namespace view
