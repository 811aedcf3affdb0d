// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/renderer.h"
#include "document/fractal.h"

#include <QString>

namespace view {

// Why the canvas does not show what one would expect, as whole sentences; empty when it does.
QString noteOn(const document::Fractal& fractal, attractor::RenderNote note);

} // namespace view
