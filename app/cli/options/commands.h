// SPDX-License-Identifier: MIT
#pragma once

#include "options/options.h"

// The commands, a function for each: its table of options, with the places of their values, and the work to
// do once these are filled in.
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
