// SPDX-License-Identifier: MIT
#include "panels/maps/weight_rule_name.h"

#include <QCoreApplication>

namespace view {

QString ruleName(document::WeightRule rule) {
    switch (rule) {
    case document::WeightRule::Determinant:
        return QCoreApplication::translate("view::MapsPanel", "By |Determinant|");
    case document::WeightRule::Equal:
        return QCoreApplication::translate("view::MapsPanel", "Equal");
    case document::WeightRule::Dimension:
        return QCoreApplication::translate("view::MapsPanel", "By Dimension");
    case document::WeightRule::Normalise:
        break;
    }
    return QCoreApplication::translate("view::MapsPanel", "Normalise");
}

} // namespace view
