// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/timeline/animation_edits.h"

#include <vector>

// The frames of the keys of a track; none if there is no such track.
inline std::vector<int> keyFramesIn(const document::Fractal& fractal, const document::Track& track) {
    std::vector<int> frames;
    for (const document::TrackKeys& one : document::tracksOf(fractal))
        if (one.track == track)
            for (const auto& key : one.keys)
                frames.push_back(key.frame);
    return frames;
}
