// SPDX-License-Identifier: MIT
#pragma once

#include "animate/animate_arguments.h"
#include "options/exit_status.h"
#include "process/input.h"
#include "process/progress_bar.h"

#include "document/fractal/fractal.h"

namespace cli {

// The frames of an entry as one video, which appears whole or not at all.
ExitStatus animateVideo(const AnimateArguments& arguments, const Input& input, const document::Fractal& entry,
                        ProgressMode mode);

} // namespace cli
