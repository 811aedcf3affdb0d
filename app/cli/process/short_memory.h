// SPDX-License-Identifier: MIT
#pragma once

namespace cli {

// Says so on standard error, without needing any; the exit status.
int memoryIsShort() noexcept;

} // namespace cli
