// SPDX-License-Identifier: MIT
#include "panels/maps/weight_rule_name.h"
#include "document/text/text.h"

namespace view {

QString ruleName(document::WeightRule rule) {
    switch (rule) {
    case document::WeightRule::Determinant:
        return Text::tr("By |Determinant|");
    case document::WeightRule::Equal:
        return Text::tr("Equal");
    case document::WeightRule::Dimension:
        return Text::tr("By Dimension");
    case document::WeightRule::Normalise:
        break;
    }
    return Text::tr("Normalise");
}

} // namespace view
