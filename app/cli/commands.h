// SPDX-License-Identifier: MIT
#pragma once

#include "exit_status.h"

#include <CLI/CLI.hpp>

#include <functional>

// One function per command: it declares the arguments and returns what the command does once they are filled
// in. An option has a group, what stands for its value, and its default; the footer of a command is its
// usage.
namespace cli {

struct Command {
    CLI::App* app;
    std::function<ExitStatus()> run;
};

Command animateCommand(CLI::App& program);
Command collageCommand(CLI::App& program);
Command encodeCommand(CLI::App& program);
Command galleryCommand(CLI::App& program);
Command mergeCommand(CLI::App& program);
Command infoCommand(CLI::App& program);
Command morphCommand(CLI::App& program);
Command renderCommand(CLI::App& program);
Command stealCommand(CLI::App& program);
Command convertCommand(CLI::App& program);

} // namespace cli
