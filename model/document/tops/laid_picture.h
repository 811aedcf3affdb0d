// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "attractor/tops/deferred_theft.h"
#include "attractor/tops/mip_picture.h"
#include "document/edits/coupled_entries.h"
#include "document/tops/kept_theft.h"

#include <memory>
#include <optional>
#include <stop_token>

namespace document {

// A picture, and where it lies on G.
struct LaidPicture {
    std::shared_ptr<const attractor::MipPicture> picture;
    ifs::AffineMap<2> toPicture; // coordinates of G → pixels of the picture
};

// The view in which a picture of that size shows G as it would be rendered.
attractor::View pictureView(const Fractal& fractal, int width, int height);

// The picture as the mode lays it on G. What a filter puts there is drawn by `there`, which keeps its keys.
// nullopt when stopped.
std::optional<LaidPicture> laid(const CoupledEntries& entries,
                                const std::shared_ptr<const attractor::MipPicture>& picture, TheftMode mode,
                                const std::optional<attractor::View>& view, attractor::DeferredTheft& there,
                                const std::stop_token& stop);

bool isFilter(TheftMode mode);

} // namespace document
