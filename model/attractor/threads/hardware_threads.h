// SPDX-License-Identifier: MIT
#pragma once

namespace attractor {

// Number of threads that this machine runs at once, at least 1: the fastest RenderRequest::threads.
int hardwareThreads();

} // namespace attractor
