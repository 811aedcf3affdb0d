// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/maps/maps_edits.h"

#include <QString>

namespace view {

QString ruleName(document::WeightRule rule); // text of the menu

} // namespace view
