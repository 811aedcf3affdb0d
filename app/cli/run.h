// SPDX-License-Identifier: MIT
#pragma once

#include "options/exit_status.h"

#include <string>
#include <vector>

namespace cli {

// Returns true for calls that paint text on a picture: these need a QGuiApplication, the others a
// QCoreApplication.
bool paintsLetters(const std::vector<std::string>& words);

// Runs the program with the words that follow its name, on the standard streams and in the working folder of
// the process. May be called again; no two calls at the same time.
ExitStatus run(const std::vector<std::string>& words);

} // namespace cli
