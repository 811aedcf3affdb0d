// SPDX-License-Identifier: MIT
#include "document/tops/laid_picture.h"

#include "document/fractal/fractal_geometry.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace document {

namespace {

constexpr int reducedSide = 48; // pixels of the longer side after Reduce
constexpr int posterisedSide = 768;
constexpr int shades = 4; // levels of each channel after Posterise
constexpr std::uint64_t pointsThere = 3'000'000;

Box boxOf(const Fractal& fractal) {
    return displayedBox(fractal).value_or(Box{{-1, -1}, {1, 1}});
}

// The map from the box to pixels, corner to corner.
ifs::AffineMap<2> cover(const Box& box, int width, int height) {
    const double across = std::max(box.max.x() - box.min.x(), 1e-300);
    const double high = std::max(box.max.y() - box.min.y(), 1e-300);
    return ifs::affineMap(width / across, 0, 0, -height / high, -box.min.x() * width / across,
                          box.max.y() * height / high);
}

std::shared_ptr<const attractor::MipPicture> gridPicture() {
    static const auto grid =
        std::make_shared<const attractor::MipPicture>(attractor::picture(attractor::Pattern::Grid));
    return grid;
}

std::uint8_t posterised(std::uint32_t code) {
    return std::uint8_t(((code * (shades - 1) + 127) / 255) * 255 / (shades - 1));
}

// Premultiplied pixels as a picture.
attractor::MipPicture pictureOf(const std::vector<std::uint32_t>& pixels, int width, int height,
                                TheftMode mode) {
    std::vector<attractor::Rgba> straight;
    straight.reserve(pixels.size());
    for (const std::uint32_t pixel : pixels) {
        const std::uint32_t alpha = pixel >> 24;
        const auto channel = [&](int shift) {
            if (alpha == 0) return std::uint8_t{0};
            const std::uint32_t code = std::min(255U, (((pixel >> shift) & 255) * 255 + alpha / 2) / alpha);
            return mode == TheftMode::Posterise ? posterised(code) : std::uint8_t(code);
        };
        straight.push_back({channel(16), channel(8), channel(0), std::uint8_t(alpha)});
    }
    return {width, height, straight};
}

// The picture lies on F, and G shows it through the inverse transformation, in few pixels or shades.
std::optional<LaidPicture> filtered(const CoupledEntries& entries, const attractor::MipPicture& picture,
                                    TheftMode mode, attractor::DeferredTheft& there,
                                    const std::stop_token& stop) {
    const int side = mode == TheftMode::Reduce ? reducedSide : posterisedSide;
    const Box box = boxOf(entries.to);
    const ifs::Vector<2> extent = box.max - box.min;
    const double scale = side / std::max({extent.x(), extent.y(), 1e-300});
    attractor::Camera camera;
    camera.width = std::clamp(int(std::ceil(extent.x() * scale)), 1, side);
    camera.height = std::clamp(int(std::ceil(extent.y() * scale)), 1, side);
    camera.centre = (box.min + box.max) / 2;
    camera.pixelsPerUnit = scale;
    const auto& maps = entries.toAttractor.maps();
    const attractor::CoupledSystem back(entries.toAttractor, entries.fromAttractor,
                                        ifs::determinantWeights<2>(maps));
    attractor::TheftRequest request;
    request.camera = camera;
    request.toPicture = cover(boxOf(entries.from), picture.width(), picture.height());
    request.points = pointsThere;
    request.background = {0, 0, 0, 0};
    std::vector<std::uint32_t> pixels(std::size_t(camera.width) * std::size_t(camera.height));
    if (!there.draw(back, picture, request, pixels, stop)) return std::nullopt;
    return LaidPicture{
        std::make_shared<const attractor::MipPicture>(pictureOf(pixels, camera.width, camera.height, mode)),
        attractor::worldToPixel(camera)};
}

} // namespace

bool isFilter(TheftMode mode) {
    return mode == TheftMode::Reduce || mode == TheftMode::Posterise;
}

attractor::View pictureView(const Fractal& fractal, int width, int height) {
    const Box box = boxOf(fractal);
    attractor::Camera camera;
    camera.width = width;
    camera.height = height;
    camera = attractor::fitted(camera, box.min, box.max);
    return {camera.centre, double(height) / camera.pixelsPerUnit};
}

std::optional<LaidPicture> laid(const CoupledEntries& entries,
                                const std::shared_ptr<const attractor::MipPicture>& picture, TheftMode mode,
                                const std::optional<attractor::View>& view, attractor::DeferredTheft& there,
                                const std::stop_token& stop) {
    if (isFilter(mode)) return filtered(entries, *picture, mode, there, stop);
    const auto shown = mode == TheftMode::DeformationGrid ? gridPicture() : picture;
    if (mode != TheftMode::StealColours)
        return LaidPicture{shown, cover(boxOf(entries.to), shown->width(), shown->height())};
    const attractor::View seen = view.value_or(pictureView(entries.to, shown->width(), shown->height()));
    return LaidPicture{shown,
                       attractor::worldToPixel(attractor::cameraOf(seen, {shown->width(), shown->height()}))};
}

} // namespace document
