// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/coupled_entries.h"
#include "ifs/tops/tear.h"

#include <QString>

namespace view {

// Sentences about a fractal transformation: why there is none, and how continuous it is.
QString sentenceOf(const document::CouplingOutcome& flaw, const QString& from, const QString& to);
// A bound of the jumps of the transformation to the partner, said to be a bound.
QString sentenceOf(const ifs::Tear& tear);
// The verdict on a homeomorphism, and a bound of the jumps of the way back.
QString sentenceOf(const ifs::Tear& back, ifs::Homeomorphism verdict);

} // namespace view
