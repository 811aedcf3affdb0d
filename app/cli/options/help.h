// SPDX-License-Identifier: MIT
#pragma once

#include "options/options.h"

#include <string>

namespace cli {

// The commands, or the options of one of them by groups, each with its value name and its default; no line is
// longer than 80 characters.
std::string helpText(const Program& program, const Command* command);

} // namespace cli
