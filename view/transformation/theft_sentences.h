// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/coupled_entries.h"
#include "ifs/tops/tear.h"

#include <QString>

namespace view {

// What the user reads of a fractal transformation: why there is none, and how continuous it is.
QString sentenceOf(const document::CouplingOutcome& flaw, const QString& from, const QString& to);
// How far a transformation to the partner may jump, and that this is a bound.
QString sentenceOf(const ifs::Tear& tear);
// Whether it is a homeomorphism, and how far the way back may jump.
QString sentenceOf(const ifs::Tear& back, ifs::Homeomorphism verdict);

} // namespace view
