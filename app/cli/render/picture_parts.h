// SPDX-License-Identifier: MIT
#pragma once

#include "render/render_arguments.h"

#include "io/picture/plane_export.h"
#include "io/sums/picture_sums.h"
#include "io/sums/space_sums.h"
#include "options/exit_status.h"

#include <QString>

// Pictures that several machines or several runs draw: render --part, --band and --resume, and merge.
namespace cli {

// Throws UsageError where the options of parts make no sense together, or with others. A file is not read.
void checkParts(const RenderArguments& arguments, Format format);

// The part of the picture selected by --part and --band. Throws UsageError.
io::PictureSums partOfPicture(const io::PlaneExport& picture, const RenderArguments& arguments);
io::SpaceSums partOfPicture(const io::SpaceExport& picture, const RenderArguments& arguments);

// render --resume
ExitStatus resumePicture(const RenderArguments& arguments);

} // namespace cli
