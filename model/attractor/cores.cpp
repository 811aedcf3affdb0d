// SPDX-License-Identifier: MIT
#include "attractor/cores.h"

#include <algorithm>
#include <thread>

namespace attractor {

int coreCount() {
    return std::max(1, int(std::thread::hardware_concurrency()));
}

} // namespace attractor
