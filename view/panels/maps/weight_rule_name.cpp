// SPDX-License-Identifier: MIT
#include "panels/maps/weight_rule_name.h"

#include "panels/maps/maps_panel.h"

namespace view {

QString ruleName(document::WeightRule rule) {
    switch (rule) {
    case document::WeightRule::Determinant:
        return MapsPanel::tr("By |Determinant|");
    case document::WeightRule::Equal:
        return MapsPanel::tr("Equal");
    case document::WeightRule::Dimension:
        return MapsPanel::tr("By Dimension");
    case document::WeightRule::Normalise:
        break;
    }
    return MapsPanel::tr("Normalise");
}

} // namespace view
