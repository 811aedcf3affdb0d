// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/facts.h"

#include <QString>

namespace view {

QString separationText(const ifs::Invariants& invariants);
QString connectednessText(ifs::Connectedness connectedness);
QString openSetText(const ifs::OpenSetFacts& facts);

// What makes of Moran's number, and of the entropy divided by the Lyapunov exponent, a dimension or only an
// upper bound: a remark in brackets.
QString openSetRemark(const ifs::Invariants& invariants);

// "(within rounding error)", unless a proof is exact.
QString roundingRemark(ifs::Certainty certainty);

} // namespace view
