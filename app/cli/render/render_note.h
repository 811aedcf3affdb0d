// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/render_request.h"
#include "document/fractal/fractal.h"

#include <QString>

// Messages about a picture.
namespace cli {

QString sentenceOf(attractor::RenderNote note, bool isInSpace); // empty if there is nothing to report
void reportNote(attractor::RenderNote note, bool isInSpace, const QString& fileName);

// Says so when not.
bool hasMaps(const document::Fractal& fractal, const QString& fileName);

} // namespace cli
