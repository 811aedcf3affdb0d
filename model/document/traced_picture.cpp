// SPDX-License-Identifier: MIT
#include "document/traced_picture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace document {

namespace {

using TracedShape = TraceOptions::Shape;

constexpr double margin = 0.25;       // margin around the shape, as a share of its longer side
constexpr int opaqueLevel = 127;      // largest 255 − opacity that counts as opaque
constexpr int coarseSide = 256;       // most cells along the longer side of the coarse shape
constexpr double outlineError = 0.75; // pixels

// Cropped, and seen as the options want it.
collage::GreyPicture prepared(const collage::GreyPicture& picture, const TraceOptions& options) {
    collage::GreyPicture part = options.crop ? collage::cropped(picture, *options.crop) : picture;
    if (options.shape == TracedShape::Dark) std::ranges::fill(part.opacity, std::uint8_t(255));
    return part;
}

std::optional<int> levelOf(const collage::GreyPicture& part, const TraceOptions& options) {
    if (options.threshold) return options.threshold;
    if (collage::isShapedByOpacity(part)) return opaqueLevel;
    return collage::otsuThreshold(part.grey);
}

using Outline = std::vector<ifs::Vector<2>>;

double distanceToSegment(const ifs::Vector<2>& p, const ifs::Vector<2>& a, const ifs::Vector<2>& b) {
    const ifs::Vector<2> along = b - a;
    const double square = along.squaredNorm();
    const double t = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0;
    return (p - a - t * along).norm();
}

// The corner between two others that is farthest from the line between them, and how far.
std::pair<std::size_t, double> farthestPoint(const Outline& outline, std::size_t first, std::size_t last) {
    std::pair<std::size_t, double> found{first, 0};
    for (std::size_t k = first + 1; k < last; ++k) {
        const double distance = distanceToSegment(outline[k], outline[first], outline[last % outline.size()]);
        if (distance > found.second) found = {k, distance};
    }
    return found;
}

// A closed outline with as few of its corners as the error allows (Douglas and Peucker 1973).
Outline simplified(const Outline& outline, double error) {
    std::vector<std::uint8_t> stays(outline.size());
    std::vector<std::pair<std::size_t, std::size_t>> parts;
    const std::size_t opposite = farthestPoint(outline, 0, outline.size()).first;
    stays[0] = stays[opposite] = 1;
    parts.emplace_back(0, opposite);
    parts.emplace_back(opposite, outline.size());
    while (!parts.empty()) {
        const auto [first, last] = parts.back();
        parts.pop_back();
        const auto [corner, distance] = farthestPoint(outline, first, last);
        if (distance <= error) continue;
        stays[corner] = 1;
        parts.emplace_back(first, corner);
        parts.emplace_back(corner, last);
    }
    Outline result;
    for (std::size_t k = 0; k < outline.size(); ++k)
        if (stays[k] != 0) result.push_back(outline[k]);
    return result.size() < 3 ? outline : result; // speck
}

// The edges between set and other pixels, with the shape on the left seen with y up; corners are (x, y) of
// the grid of pixels, y down.
class Outlines {
public:
    explicit Outlines(const collage::Mask& mask) : m_mask(mask) {
        for (int y = 0; y < mask.height; ++y)
            for (int x = 0; x < mask.width; ++x) {
                if (!mask(x, y)) continue;
                if (!isSet(x, y - 1)) add({x + 1, y}, {x, y});
                if (!isSet(x - 1, y)) add({x, y}, {x, y + 1});
                if (!isSet(x, y + 1)) add({x, y + 1}, {x + 1, y + 1});
                if (!isSet(x + 1, y)) add({x + 1, y + 1}, {x + 1, y});
            }
    }

    std::vector<std::vector<ifs::Vector<2>>> closed() {
        std::vector<std::vector<ifs::Vector<2>>> all;
        const double pixel = 1.0 / m_mask.height;
        while (!m_next.empty()) {
            std::vector<ifs::Vector<2>> outline;
            Corner at = m_next.begin()->first;
            Corner before{at.first * 2 - m_next.begin()->second.first,
                          at.second * 2 - m_next.begin()->second.second};
            for (auto edge = m_next.find(at); edge != m_next.end(); edge = m_next.find(at)) {
                const Corner to = edge->second;
                const bool turns = to.first - at.first != at.first - before.first ||
                                   to.second - at.second != at.second - before.second;
                if (turns || outline.empty())
                    outline.emplace_back((at.first - m_mask.width / 2.0) * pixel,
                                         (m_mask.height / 2.0 - at.second) * pixel);
                m_next.erase(edge);
                before = at;
                at = to;
            }
            all.push_back(simplified(outline, outlineError * pixel));
        }
        return all;
    }

private:
    using Corner = std::pair<int, int>;
    bool isSet(int x, int y) const {
        return x >= 0 && y >= 0 && x < m_mask.width && y < m_mask.height && m_mask(x, y);
    }
    void add(const Corner& from, const Corner& to) { m_next.emplace(from, to); }

    const collage::Mask& m_mask;
    std::multimap<Corner, Corner> m_next;
};

void place(TracedPicture& traced, const Box& onto) {
    const collage::PixelBox shape = collage::boxOf(traced.mask);
    const ifs::Vector<2> size = onto.max - onto.min;
    // The smaller one of both sides of a line counts.
    const double pixel = std::min(size.x() > 0 ? size.x() / shape.width() : HUGE_VAL,
                                  size.y() > 0 ? size.y() / shape.height() : HUGE_VAL);
    if (!std::isfinite(pixel)) return;
    const ifs::Vector<2> away(shape.left + shape.width() / 2.0 - traced.mask.width / 2.0,
                              traced.mask.height / 2.0 - shape.top - shape.height() / 2.0);
    traced.place.height = pixel * traced.mask.height;
    traced.place.middle = (onto.min + onto.max) / 2 - pixel * away;
    traced.target = placed(std::move(traced.target), traced.place);
    if (traced.coarse) traced.coarse = placed(*std::move(traced.coarse), traced.place);
    const ifs::AffineMap<2> there = traced.place.map();
    for (Outline& outline : traced.outlines)
        for (ifs::Vector<2>& corner : outline)
            corner = there(corner);
}

} // namespace

collage::GreyPicture reducedForTracing(const collage::GreyPicture& picture) {
    const int longer = std::max(picture.width, picture.height);
    const int factor = (longer + maxTracedPixels - 1) / maxTracedPixels;
    if (factor <= 1) return picture;
    collage::GreyPicture small{
        std::max(1, picture.width / factor), std::max(1, picture.height / factor), {}, {}};
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            int grey = 0, opacity = 0, count = 0;
            for (int v = y * factor; v < std::min(picture.height, (y + 1) * factor); ++v)
                for (int u = x * factor; u < std::min(picture.width, (x + 1) * factor); ++u, ++count) {
                    const auto k = std::size_t(v) * std::size_t(picture.width) + std::size_t(u);
                    grey += picture.grey[k];
                    opacity += picture.opacity[k];
                }
            small.grey.push_back(std::uint8_t(grey / count));
            small.opacity.push_back(std::uint8_t(opacity / count));
        }
    return small;
}

std::optional<int> thresholdOf(const collage::GreyPicture& picture, const TraceOptions& options) {
    return levelOf(prepared(picture, options), options);
}

collage::Target placed(collage::Target target, const PicturePlace& place) {
    collage::Grid& grid = target.grid;
    grid.left = place.middle.x() + place.height * grid.left;
    grid.top = place.middle.y() + place.height * grid.top;
    grid.cell *= place.height;
    target.size *= place.height;
    return target;
}

std::optional<TracedPicture> tracedPicture(const collage::GreyPicture& picture, const TraceOptions& options,
                                           const std::optional<Box>& onto) {
    TracedPicture traced;
    traced.picture = prepared(picture, options);
    // No transparency: everything is opaque, and there is no shape.
    if (options.shape == TracedShape::Opaque && !collage::isShapedByOpacity(traced.picture))
        return std::nullopt;
    traced.mask = collage::targetMask(traced.picture, levelOf(traced.picture, options), options.polarity);
    const std::size_t area = collage::area(traced.mask);
    if (area == 0 || area == traced.mask.cells.size()) return std::nullopt;
    traced.target = collage::target(traced.mask, 1, margin);
    traced.coarseFactor = collage::factorFor(traced.mask, coarseSide);
    if (traced.coarseFactor > 1) traced.coarse = collage::target(traced.mask, traced.coarseFactor, margin);
    traced.outlines = Outlines(traced.mask).closed();
    if (onto) place(traced, *onto);
    return traced;
}

} // namespace document
