// SPDX-License-Identifier: MIT
#pragma once

namespace cli {

enum class ExitStatus {
    Done = 0,
    InputProblems = 1,
    WrongUsage = 2,
    CannotReadOrWrite = 3,
    Interrupted = 130, // as shells expect after Ctrl+C
};

} // namespace cli
