// SPDX-License-Identifier: MIT
#pragma once

#include "options/options.h"

#include <string>

// Writes the parts of the completions and of the manual page that follow from the tables of options. They
// are committed between marks in resources/completions and resources/linux, ./dev describe renews them, and
// a test compares them.
namespace cli {

// Describes the program for bash, zsh, fish or the manual page; or lists the options that change a frame of
// an animation, for a test. Throws UsageError for any other reader.
std::string describe(const Program& program, const std::string& reader);

} // namespace cli
