// SPDX-License-Identifier: MIT
#pragma once

namespace attractor {

// Threads that run at once on this machine, at least 1: what RenderRequest::threads is set to where speed
// counts.
int coreCount();

} // namespace attractor
