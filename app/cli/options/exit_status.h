// SPDX-License-Identifier: MIT
#pragma once

namespace cli {

enum class ExitStatus {
    Done = 0,
    InputProblems = 1,
    WrongUsage = 2,
    CannotReadOrWrite = 3,
    // Status after a signal, as in shells.
    HungUp = 129,
    Interrupted = 130,
    Terminated = 143,
};

} // namespace cli
