// SPDX-License-Identifier: MIT
#pragma once

#include "render/render_arguments.h"
#include "render/shown_frame.h"

#include "io/picture/space_export.h"

// `render` for an entry in space.
namespace cli {

// Throws UsageError for an option that only entries in space have.
void refuseSpaceOptions(const RenderArguments& options);

// The picture that the options ask for. Throws UsageError.
io::SpaceExport spaceExportOf(const Shown& shown, const RenderArguments& options, const QString& fileName);

} // namespace cli
