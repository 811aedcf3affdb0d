// SPDX-License-Identifier: MIT
#include "panels/analysis/separation_texts.h"

#include <QCoreApplication>

namespace view {

namespace {

struct SeparationText {
    Q_DECLARE_TR_FUNCTIONS(Analysis)
};

bool holds(const std::optional<ifs::OpenSetFacts>& facts) {
    return facts && facts->condition == ifs::OpenSetCondition::Holds;
}

} // namespace

QString separationText(const ifs::Invariants& invariants) {
    switch (invariants.contacts->separation) {
    case ifs::Separation::Strong:
        return SeparationText::tr("strong: no two pieces meet");
    case ifs::Separation::Overlapping:
        return SeparationText::tr("none: pieces coincide");
    case ifs::Separation::Unknown:
        break;
    }
    return holds(invariants.openSet) ? SeparationText::tr("pieces may touch, but do not overlap")
                                     : SeparationText::tr("unknown");
}

QString connectednessText(ifs::Connectedness connectedness) {
    switch (connectedness) {
    case ifs::Connectedness::Connected:
        return SeparationText::tr("connected");
    case ifs::Connectedness::ConnectedToRounding:
        return SeparationText::tr("connected, within rounding error");
    case ifs::Connectedness::Disconnected:
        return SeparationText::tr("not connected");
    case ifs::Connectedness::Unknown:
        break;
    }
    return SeparationText::tr("unknown");
}

QString openSetText(const ifs::OpenSetFacts& facts) {
    const bool isExact = facts.certainty == ifs::Certainty::Exact;
    switch (facts.condition) {
    case ifs::OpenSetCondition::Holds:
        return isExact ? SeparationText::tr("holds") : SeparationText::tr("holds, within rounding error");
    case ifs::OpenSetCondition::Fails:
        return isExact ? SeparationText::tr("fails") : SeparationText::tr("fails, within rounding error");
    case ifs::OpenSetCondition::Unknown:
        break;
    }
    return SeparationText::tr("unknown");
}

QString openSetRemark(const ifs::Invariants& invariants) {
    switch (invariants.contacts->separation) {
    case ifs::Separation::Strong:
        return SeparationText::tr("(of the attractor: its pieces are disjoint)");
    case ifs::Separation::Overlapping:
        return SeparationText::tr("(upper bound: pieces coincide)");
    case ifs::Separation::Unknown:
        break;
    }
    if (!invariants.openSet || invariants.openSet->condition == ifs::OpenSetCondition::Unknown)
        return SeparationText::tr("(if the open set condition holds; else an upper bound)");
    if (!holds(invariants.openSet)) return SeparationText::tr("(upper bound: the open set condition fails)");
    return invariants.openSet->certainty == ifs::Certainty::Exact
               ? SeparationText::tr("(the open set condition holds)")
               : SeparationText::tr("(the open set condition holds, within rounding error)");
}

QString roundingRemark(ifs::Certainty certainty) {
    return certainty == ifs::Certainty::Exact ? QString()
                                              : u' ' + SeparationText::tr("(within rounding error)");
}

} // namespace view
