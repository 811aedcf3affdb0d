// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/decomposition.h"

#include <QString>

// What the table of maps says of kinds, coefficients and itself.
namespace view {

QString kindText(ifs::MapKind kind);
QString kindTip(ifs::MapKind kind, int dimension);
QString coefficientTip(int dimension);
QString tableWhatsThis(int dimension);

} // namespace view
