// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace cli {

// From now on, the heap of this process and the stacks of its threads get no more than that in all: what asks
// for more meets std::bad_alloc. A lower limit that holds already is kept. Linux counts so; other systems may
// not.
void limitMemory(std::uint64_t bytes);

} // namespace cli
