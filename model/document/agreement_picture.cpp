// SPDX-License-Identifier: MIT
#include "document/agreement_picture.h"

#include <algorithm>

namespace document {

namespace {

constexpr int leastSide = 768; // of the picture, so that its hatching is fine
constexpr int period = 9;      // of the hatching, pixels
constexpr int stroke = 3;      // its width

constexpr QRgb bothColour = qRgba(128, 128, 128, 110);
constexpr QRgb excessColour = qRgba(225, 60, 50, 110), excessStroke = qRgba(190, 20, 20, 235);
constexpr QRgb missingColour = qRgba(60, 120, 235, 110), missingStroke = qRgba(20, 70, 210, 235);

QRgb colourAt(bool isTarget, bool isCompared, int x, int y) {
    if (isTarget && isCompared) return bothColour;
    if (isCompared) return (x + y) % period < stroke ? excessStroke : excessColour;
    if (isTarget) return (x - y + (1 << 20)) % period < stroke ? missingStroke : missingColour;
    return 0;
}

QImage pictureOf(const collage::Mask& target, const collage::Mask& compared) {
    const int factor = std::max(1, leastSide / std::max(target.width, target.height));
    QImage image(target.width * factor, target.height * factor, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < image.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < image.width(); ++x)
            line[x] = qPremultiply(
                colourAt(target(x / factor, y / factor), compared(x / factor, y / factor), x, y));
    }
    return image;
}

} // namespace

std::optional<MeasuredFractal> measured(const Fractal& fractal, const TracedPicture& traced,
                                        Compared compared) {
    const auto maps = collageMaps(fractal);
    if (!maps || maps->maps.empty()) return std::nullopt;
    const collage::MeasuredCollage images = collage::measuredCollage(traced.target, maps->maps);
    MeasuredFractal result{images.measure.images, images.measure.contraction, images.measure.bound, {}, {}};
    const collage::Grid& grid = traced.target.grid;
    if (compared == Compared::Attractor) {
        if (result.contraction >= 1) return std::nullopt;
        result.agreement = collage::attractorAgreement(traced.target, maps->maps);
        result.picture = pictureOf(traced.target.mask, collage::attractorMask(grid, maps->maps));
    } else {
        result.picture = pictureOf(traced.target.mask, images.images);
    }
    result.area = {grid.left, grid.top, grid.width * grid.cell, grid.height * grid.cell};
    return result;
}

} // namespace document
