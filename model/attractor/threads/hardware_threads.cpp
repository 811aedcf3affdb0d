// SPDX-License-Identifier: MIT
#include "attractor/threads/hardware_threads.h"

#include <algorithm>
#include <thread>

namespace attractor {

int hardwareThreads() {
    return std::max(1, int(std::thread::hardware_concurrency()));
}

} // namespace attractor
