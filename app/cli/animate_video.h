// SPDX-License-Identifier: MIT
#pragma once

#include "animate_arguments.h"
#include "exit_status.h"
#include "input.h"
#include "progress_bar.h"

#include "document/fractal.h"

namespace cli {

// The frames of an entry as one video, which appears whole or not at all.
ExitStatus animateVideo(const AnimateArguments& arguments, const Input& input, const document::Fractal& entry,
                        ProgressMode mode);

} // namespace cli
