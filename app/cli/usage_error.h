// SPDX-License-Identifier: MIT
#pragma once

#include "exit_status.h"

#include <QString>

namespace cli {

// Ends a subcommand from wherever an argument turns out to make no sense; caught in main, status 2.
struct UsageError {
    QString sentence;
};

} // namespace cli
