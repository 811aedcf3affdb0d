// SPDX-License-Identifier: MIT
#pragma once

#include "animate/animate_arguments.h"
#include "process/input.h"

#include "document/moments/animated_fractal.h"

#include <string>
#include <vector>

namespace cli {

// The entry that is named, or the first one with an animation; nullptr after a message.
const document::Entry* animatedEntry(const Input& input, const std::vector<std::string>& names,
                                     ExitStatus& status);

// The numbers of the files to be written, ascending. A warning says when --frames asks for more than there
// are.
std::vector<int> filesOf(const AnimateArguments& arguments, const Input& input,
                         const document::Fractal& entry);

} // namespace cli
