// SPDX-License-Identifier: MIT
#pragma once

#include "io/video/libav/pointers.h"

#include <optional>

namespace io::libav {

// The palette of up to 256 colours that suits many pictures best, all of one size, AV_PIX_FMT_BGRA. One
// colour stands for transparency if there is any.
class PaletteMaker {
public:
    PaletteMaker(int width, int height, bool isTransparent);

    bool add(const Frame& picture); // false: out of memory, or a required FFmpeg library is missing
    Frame finish();                 // 16 × 16 colours; null after a failure

private:
    Pointer<AVFilterGraph> m_graph;
    int m_pictures = 0;
};

// Pictures in the colours of a palette, AV_PIX_FMT_PAL8. What is between the colours is shown by an ordered
// pattern that is fixed to the screen, so that nothing crawls from frame to frame.
class PaletteMap {
public:
    PaletteMap(int width, int height, const Frame& palette);

    Frame apply(const Frame& picture); // null after a failure

private:
    Pointer<AVFilterGraph> m_graph;
    int m_pictures = 0;
};

} // namespace io::libav
