// SPDX-License-Identifier: MIT
#pragma once

#include "render/render_arguments.h"

#include "attractor/light/solid_appearance.h"
#include "document/fractal/fractal.h"

// `render` with the looks of a solid.
namespace cli {

// Puts the options of a solid in the look of the entry into the entry. Throws UsageError.
void applySolidOptions(document::Fractal& fractal, const RenderArguments& options);

// Appearance of the solid of such an entry.
attractor::SolidAppearance solidAppearance(const document::Fractal& fractal, const RenderArguments& options);

} // namespace cli
