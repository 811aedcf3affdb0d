// SPDX-License-Identifier: MIT
#include "document/edits/agreement_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace document {

namespace {

constexpr int minSide = 768; // pixels of the picture, for fine hatching
constexpr int period = 9;    // pixels between two lines of the hatching
constexpr int stroke = 3;    // pixels of a line

// Colours of a pixel for each step of the hatching, premultiplied. Patterns are indexed by the shapes that
// its cell belongs to: 1 the target, 2 the shape compared with it.
using Pattern = std::array<QRgb, period>;

std::array<Pattern, 4> patterns() {
    std::array<Pattern, 4> all{};
    for (int step = 0; step < period; ++step) {
        const auto k = std::size_t(step);
        const bool isStroke = step < stroke;
        all[1][k] = qPremultiply(isStroke ? qRgba(20, 70, 210, 235) : qRgba(60, 120, 235, 110)); // missing
        all[2][k] = qPremultiply(isStroke ? qRgba(190, 20, 20, 235) : qRgba(225, 60, 50, 110));  // too much
        all[3][k] = qPremultiply(qRgba(128, 128, 128, 110));
    }
    return all;
}

struct Picture {
    QImage image;
    QRect used;
};

Picture pictureOf(const collage::Mask& target, const collage::Mask& compared) {
    const int factor = std::max(1, minSide / std::max(target.width, target.height));
    QImage image(target.width * factor, target.height * factor, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    const collage::PixelBox a = collage::boxOf(target), b = collage::boxOf(compared);
    const QRect cells =
        QRect(a.left, a.top, a.width(), a.height()) | QRect(b.left, b.top, b.width(), b.height());
    const QRect used(cells.topLeft() * factor, cells.size() * factor);
    const std::array<Pattern, 4> all = patterns();
    for (int y = used.top(); y <= used.bottom(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        const std::size_t row = target.index(0, y / factor);
        int up = (used.left() + y) % period, down = (used.left() + image.height() - y) % period;
        for (int x = used.left(); x <= used.right(); ++x) {
            const std::size_t cell = row + std::size_t(x / factor);
            const auto of =
                std::size_t((target.cells[cell] != 0 ? 1 : 0) + (compared.cells[cell] != 0 ? 2 : 0));
            line[x] = all[of][std::size_t(of == 1 ? down : up)];
            up = up + 1 == period ? 0 : up + 1;
            down = down + 1 == period ? 0 : down + 1;
        }
    }
    return {image, used};
}

// Converts from cells of factor² pixels. A pixel of the shape is at most a diagonal of a cell away from one
// that is set, and the other way round: the attractor may differ from the shape by that much more.
void inPixels(MeasuredFractal& measured, int factor) {
    measured.agreement.mean *= factor;
    measured.agreement.p95 *= factor;
    measured.agreement.hausdorff *= factor;
    if (measured.bound) measured.bound = factor * (*measured.bound + std::sqrt(2.0));
}

} // namespace

std::optional<MeasuredFractal> measured(const Fractal& fractal, const TracedPicture& traced,
                                        Compared compared, Detail detail) {
    const auto maps = collageMaps(fractal);
    if (!maps || maps->maps.empty()) return std::nullopt;
    const bool isCoarse = detail == Detail::Live && traced.coarse;
    const collage::Target& target = isCoarse ? *traced.coarse : traced.target;
    const auto search = detail == Detail::Live ? collage::NormSearch::Hurried : collage::NormSearch::Thorough;
    const collage::MeasuredCollage images = collage::measuredCollage(target, maps->maps, search);
    MeasuredFractal result;
    result.agreement = images.measure.images;
    result.overlap = images.measure.overlap;
    result.contraction = images.measure.contraction;
    result.bound = images.measure.bound;
    result.norm = images.measure.norm;
    const collage::Grid& grid = target.grid;
    Picture picture;
    if (compared == Compared::Attractor) {
        if (!result.bound) return std::nullopt;
        result.agreement = collage::attractorAgreement(target, maps->maps);
        picture = pictureOf(target.mask, collage::attractorMask(grid, maps->maps));
    } else {
        picture = pictureOf(target.mask, images.images);
    }
    result.picture = picture.image;
    result.used = picture.used;
    if (isCoarse) inPixels(result, traced.coarseFactor);
    result.area = {grid.left, grid.top, grid.width * grid.cell, grid.height * grid.cell};
    return result;
}

} // namespace document
