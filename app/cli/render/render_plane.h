// SPDX-License-Identifier: MIT
#pragma once

#include "render/render_arguments.h"
#include "render/shown_frame.h"

#include "io/picture/plane_export.h"

// `render` and `animate` for an entry in the plane. What makes no sense throws UsageError.
namespace cli {

// --cage and --rest-cage.
void applyCage(document::Fractal& fractal, const RenderArguments& arguments);

// The camera given by --view, else by the keys of an animation, else fitted around its frames or the picture.
attractor::Camera cameraOf(const Shown& shown, const RenderArguments& arguments, const QString& fileName);

io::PlaneExport planeExportOf(const Shown& shown, const attractor::Camera& camera,
                              const RenderArguments& arguments, int step);

} // namespace cli
