// SPDX-License-Identifier: MIT
#include "attractor/request/space_appearance.h"

#include <cmath>

namespace attractor {

bool showsCloud(LookInSpace look) {
    return look == LookInSpace::Cloud || look == LookInSpace::XRay;
}

bool isUsable(const SpaceClip& clip) {
    return clip.normal.allFinite() && clip.normal.norm() > 0 && std::isfinite(clip.normal.norm()) &&
           clip.lowest <= clip.highest && (std::isfinite(clip.lowest) || std::isfinite(clip.highest));
}

} // namespace attractor
