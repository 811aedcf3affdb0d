// SPDX-License-Identifier: MIT
#pragma once

#include "options/options.h"

// One function per command: its table of options, with the places of their values, and what it does once
// these are filled in.
namespace cli {

Command animateCommand();
Command collageCommand();
Command encodeCommand();
Command galleryCommand();
Command mergeCommand();
Command infoCommand();
Command morphCommand();
Command pageCommand();
Command renderCommand();
Command stealCommand();
Command convertCommand();

} // namespace cli
