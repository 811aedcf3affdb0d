// SPDX-License-Identifier: MIT
#pragma once

namespace light {

// Registers "light": a Menger sponge at 1920 × 1080 from depths to pixels, one thread.
void addBenchmark();

} // namespace light
