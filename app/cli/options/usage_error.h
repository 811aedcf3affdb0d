// SPDX-License-Identifier: MIT
#pragma once

#include "options/exit_status.h"

#include <QString>

namespace cli {

// Ends a subcommand from wherever an argument turns out to make no sense; caught in main, status 2.
struct UsageError {
    QString sentence;
};

// The same for a file that an argument names and that is no good.
struct InputError {
    QString fileName;
    QString sentence;
    ExitStatus status = ExitStatus::InputProblems;
};

} // namespace cli
