// SPDX-License-Identifier: MIT
#include "process/memory_limit.h"

#include <algorithm>
#include <sys/resource.h>

namespace cli {

void limitMemory(std::uint64_t bytes) {
    rlimit limit{};
    if (::getrlimit(RLIMIT_DATA, &limit) != 0) return;
    limit.rlim_cur = std::min<rlim_t>(limit.rlim_cur, rlim_t(bytes));
    ::setrlimit(RLIMIT_DATA, &limit);
}

} // namespace cli
