// SPDX-License-Identifier: MIT
#pragma once

#include "exit_status.h"

#include <CLI/CLI.hpp>

#include <functional>

// One function per subcommand: it declares the arguments, and sets `run` when the subcommand is the one that
// is called.
namespace cli {

using Run = std::function<ExitStatus()>;

void addGalleryCommand(CLI::App& program, Run& run);
void addInfoCommand(CLI::App& program, Run& run);
void addRenderCommand(CLI::App& program, Run& run);
void addConvertCommand(CLI::App& program, Run& run);

} // namespace cli
