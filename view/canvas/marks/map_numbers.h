// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/marks/scene_mark.h"

namespace view {

// The numbers of the maps in their images of the cage, and their fixed points, in the colours of the maps, as
// io::PictureOverlay draws them on pictures. Off at first.
class MapNumbers : public SceneMark {
public:
    // Limit, beyond which numbers would hide the picture and each other.
    static constexpr std::size_t maxMaps = 200;

    MapNumbers() { setVisible(false); }

protected:
    void paintOver(QPainter& painter, const CanvasScene& canvas, const OverlayStyle& style) override;
};

} // namespace view
