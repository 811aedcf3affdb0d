// SPDX-License-Identifier: MIT
#pragma once

#include "animation/animation.h"

#include <optional>
#include <string>
#include <string_view>

namespace animation {

constexpr int maxRate = 1000; // frames per second

// "24", "12.5" or "25/2", in lowest terms. The decimals by which the rates of television are known mean those
// rates: "29.97" is 30000/1001, and "23.976" or "23.98" is 24000/1001. nullopt for anything else, for 0 and
// beyond maxRate.
std::optional<FrameRate> parseRate(std::string_view text);

// The shortest that parseRate() takes for the same rate, with at most three decimals where these suffice.
std::string rateText(const FrameRate& rate);

} // namespace animation
