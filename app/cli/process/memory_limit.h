// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace cli {

// Limits the heap of this process together with the stacks of its threads: larger requests meet
// std::bad_alloc. A lower limit that holds already is kept. Linux counts so; other systems may not.
void limitMemory(std::uint64_t bytes);

} // namespace cli
