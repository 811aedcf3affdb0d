// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "canvas/items/map_frames_item.h"
#include "canvas/scene/handle_model.h"

namespace view {

// Frames by index in the system. Maps that are held have all of them, or of very many those near the view, if
// need be thinned out; of maps that are not, the one that is pointed at in the table is hinted at.
struct FrameLayout {
    std::vector<MapFrame> frames;
    bool isThinnedOut = false;
};

FrameLayout frameLayout(const HandleModel& handles, const CanvasSelection& selection,
                        const document::Fractal& fractal, const attractor::Camera& camera);

} // namespace view
