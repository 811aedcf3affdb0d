// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/tops/key_tops.h"
#include "attractor/tops/mip_picture.h"
#include "attractor/tops/theft_request.h"

#include <cstdint>
#include <span>
#include <vector>

namespace attractor {

// Colours of keys: those of the picture at the decoded places. Data shared by words and samples is
// precomputed, so that a pixel needs one small map and one look-up.
class KeyColours {
public:
    KeyColours(const KeyTops& tops, const MipPicture& picture, const TheftRequest& request);

    // Paints as many pixels as there are keys; 0xAARRGGBB, premultiplied. The picture must outlive this
    // object.
    void paint(std::span<const std::uint32_t> keys, std::span<std::uint32_t> pixels) const;

private:
    // A key is shown at piece.map(sample), on the sum of their levels.
    struct Piece {
        double xx, xy, yx, yy, x, y;
        std::int32_t level;
    };
    struct Sample {
        double x, y;
        std::int32_t level;
    };

    const MipPicture& m_picture;
    Rgba m_background;
    std::vector<Piece> m_pieces;
    std::vector<Sample> m_samples;
};

} // namespace attractor
