// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/render/renderer.h"
#include "bench/plain_rivals.h"

#include <cstdint>
#include <string>
#include <vector>

// The systems that the engine is measured with.
namespace engine {

constexpr std::uint64_t tenMillion = 10'000'000;

struct Case {
    std::string name;
    attractor::RenderRequest request;
    attractor::PreparedSystem drawable;
    rivals::Points points;
};

std::vector<Case>& cases(); // sierpinski, fern, maple, flower, random32
// A drag: every frame has another cage, so nothing but the system stays.
attractor::RenderRequest dragged(attractor::RenderRequest request, int frame);
// The same in a cage of eight corners around the maple, of which two are moved by 20 % of its size.
attractor::RenderRequest bent(attractor::RenderRequest request, int frame);

} // namespace engine
