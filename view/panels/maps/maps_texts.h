// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/decomposition.h"
#include "ifs/system/iterated_function_system.h"

#include <QString>

#include <array>

// Texts of the table of maps about kinds, coefficients and itself, and the line about one map below it.
namespace view {

int decimalsOf(const QString& number);
// A number with no more than these decimals, whatever its size; one that would be 0 then has three digits.
QString steadyNumber(double value, int decimals);
QString kindText(ifs::MapKind kind);
QString kindTip(ifs::MapKind kind, int dimension);
QString coefficientTip(int dimension);
QString tableWhatsThis(int dimension);
// Names the number in one column of a map for document::TypedNumbers.
QString typedPlace(ifs::MapId map, int column);
// Determinant, norm and kind of the map of a row, and which of several selected ones it is; a hint where the
// row is −1.
QString factsText(const std::array<QString, 3>& facts, int row, int selected);

} // namespace view
