// SPDX-License-Identifier: MIT
#include "animation/motions/motion_presets.h"

#include <array>

namespace animation {

namespace {

// Few cycles with small lags bend a plant as one; higher ones with larger lags let its twigs tremble.
constexpr std::array breeze{Wave{0.7, 1, 0, 25}, Wave{0.25, 2, 70, 60}, Wave{0.1, 5, 140, 110}};
constexpr std::array gusts{Wave{0.5, 1, 0, 20}, Wave{0.3, 3, 40, 45}, Wave{0.3, 4, 200, 80},
                           Wave{0.15, 7, 100, 130}};
constexpr std::array storm{Wave{0.6, 2, 0, 15}, Wave{0.4, 5, 60, 70}, Wave{0.3, 7, 250, 120},
                           Wave{0.2, 11, 20, 160}};
constexpr std::array underWater{Wave{0.8, 1, 0, 80}, Wave{0.2, 2, 120, 140}};
constexpr std::array breathing{Wave{1, 1, 0, 180}};
constexpr std::array weave{Wave{1, 1, 0, 0}};
constexpr std::array presets{SwayPreset{"Breeze", 4, breeze},       SwayPreset{"Gusts", 7, gusts},
                             SwayPreset{"Storm", 12, storm},        SwayPreset{"Under Water", 10, underWater},
                             SwayPreset{"Breathing", 3, breathing}, SwayPreset{"Weave", 15, weave}};

} // namespace

std::span<const SwayPreset> swayPresets() {
    return presets;
}

} // namespace animation
