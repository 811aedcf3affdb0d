// SPDX-License-Identifier: MIT
#include "attractor/tops/key_colours.h"

#include "attractor/tops/picture_painter.h"

#include <algorithm>

namespace attractor {

namespace {

constexpr std::size_t together = 16; // pixels tested together, usually all empty or all full

bool areEmpty(const std::uint32_t* keys) {
    std::uint32_t all = kernels::noKey; // neutral element of &: all bits set
    for (std::size_t k = 0; k < together; ++k)
        all &= keys[k];
    return all == kernels::noKey;
}

} // namespace

KeyColours::KeyColours(const KeyTops& tops, const MipPicture& picture, const TheftRequest& request)
    : m_picture(picture), m_background(request.background) {
    const double zoom = picturePixels(request);
    for (const KeyTops::Piece& piece : tops.pieces()) {
        const ifs::AffineMap<2> shown = request.toPicture * piece.to;
        const ifs::Matrix<2>& a = shown.linear;
        m_pieces.push_back({a(0, 0), a(0, 1), a(1, 0), a(1, 1), shown.translation.x(), shown.translation.y(),
                            mipLevel(piece.stretch * zoom)});
    }
    for (const CoupledSamples::Image& sample : tops.samples())
        m_samples.push_back({sample.x, sample.y, mipLevel(sample.stretch)});
}

void KeyColours::paint(std::span<const std::uint32_t> keys, std::span<std::uint32_t> pixels) const {
    PicturePainter painter(m_picture, m_background, pixels);
    const auto samples = std::uint32_t(m_samples.size());
    for (std::size_t first = 0; first < keys.size(); first += together) {
        const std::size_t count = std::min(together, keys.size() - first);
        std::fill_n(pixels.begin() + std::ptrdiff_t(first), count, painter.empty());
        if (count == together && areEmpty(keys.data() + first)) continue;
        for (std::size_t k = first; k < first + count; ++k) {
            const std::uint32_t key = keys[k];
            if (key == kernels::noKey) continue;
            const Piece& piece = m_pieces[key / samples];
            const Sample& sample = m_samples[key % samples];
            painter.paint(k, piece.xx * sample.x + piece.xy * sample.y + piece.x,
                          piece.yx * sample.x + piece.yy * sample.y + piece.y, piece.level + sample.level);
        }
    }
    painter.finish();
}

} // namespace attractor
