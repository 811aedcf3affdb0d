// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/tops/coupled_system.h"
#include "attractor/tops/mip_picture.h"
#include "attractor/tops/theft_request.h"

#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>

namespace attractor {

enum class TheftOutcome { Done, Stopped, CutShort, NotTaken };

// Draws some rows at a time; take(pixels) gets whole rows from the top on, 0xAARRGGBB premultiplied, in the
// calling thread, and says whether to go on. CutShort: the system has too many words for isExact.
TheftOutcome steal(const CoupledSystem& system, const MipPicture& picture, const TheftRequest& request,
                   const std::function<bool(std::span<const std::uint32_t> pixels)>& take,
                   const std::stop_token& stop);

} // namespace attractor
