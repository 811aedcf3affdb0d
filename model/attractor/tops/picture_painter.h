// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/tops/mip_picture.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace attractor {

// Paints pixels with what a picture shows at places of it, over a background: some of them at a time, in any
// order. 0xAARRGGBB, premultiplied.
class PicturePainter {
public:
    // Pixels in which there is nothing of the picture have `empty`.
    PicturePainter(const MipPicture& picture, const Rgba& background, std::span<std::uint32_t> pixels);

    std::uint32_t empty() const { return m_empty; }

    // Queues a pixel for the colour at (x, y), in pixels of the picture, at a level as mipLevel() gives it.
    void paint(std::size_t pixel, double x, double y, std::int32_t level) {
        if (!m_picture.isInside(x, y)) {
            m_pixels[pixel] = m_empty;
            return;
        }
        m_places[m_waiting] = m_picture.place(x, y, level);
        m_targets[m_waiting] = pixel;
        if (++m_waiting == together) finish();
    }
    void finish(); // paints the queued pixels

private:
    static constexpr std::size_t together = 128;

    const MipPicture& m_picture;
    LinearColour m_under;
    std::uint32_t m_empty;
    std::span<std::uint32_t> m_pixels;
    std::size_t m_waiting = 0;
    std::array<kernels::PicturePlace, together> m_places;
    std::array<std::size_t, together> m_targets{};
};

} // namespace attractor
