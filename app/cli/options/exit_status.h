// SPDX-License-Identifier: MIT
#pragma once

namespace cli {

enum class ExitStatus {
    Done = 0,
    InputProblems = 1,
    WrongUsage = 2,
    CannotReadOrWrite = 3,
    // As shells have it after a signal.
    HungUp = 129,
    Interrupted = 130,
    Terminated = 143,
};

} // namespace cli
