// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/coupled_entries.h"
#include "ifs/tops/tear.h"

#include <QString>

namespace view {

// What the user reads of a fractal transformation: why there is none, and how continuous it is.
QString sentenceOf(const document::CouplingOutcome& flaw, const QString& from, const QString& to);
QString sentenceOf(const ifs::Tear& tear);
// Whether it is a homeomorphism, to what is torn either way: from the first attractor to the second and back.
QString sentenceOf(const ifs::Tear& there, const ifs::Tear& back, ifs::Homeomorphism verdict);

} // namespace view
