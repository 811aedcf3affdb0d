// SPDX-License-Identifier: MIT
#pragma once

#include "render_arguments.h"

#include "attractor/light/solid_appearance.h"
#include "document/fractal.h"

// `render` with the looks stone, ink and normals.
namespace cli {

// nullopt for a name that is none of these.
std::optional<attractor::Look> solidLook(const std::string& name);

// What the options and the entry say of a solid. Throws UsageError.
attractor::SolidAppearance solidAppearance(attractor::Look look, const document::Fractal& fractal,
                                           const RenderArguments& options);

// Throws UsageError for options of a light that the look does not have.
void refuseLight(const RenderArguments& options, const QString& reason);

} // namespace cli
