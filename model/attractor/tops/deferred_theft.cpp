// SPDX-License-Identifier: MIT
#include "attractor/tops/deferred_theft.h"

#include "attractor/colour/srgb_transfer.h"
#include "attractor/threads/job_shares.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>

namespace attractor {

namespace {

constexpr int bandRows = 32; // drawn at a time by one thread

// work(first row, number of rows) for bands that cover the picture; false when stopped.
bool inBands(Workers& workers, int height, const std::stop_token& stop,
             const std::function<bool(int first, int rows)>& work) {
    JobShares shares;
    shares.reset(std::size_t((height + bandRows - 1) / bandRows), workers);
    std::atomic<bool> isComplete = true;
    shares.run(workers, stop, [&](std::size_t job, std::size_t) {
        const int first = int(job) * bandRows;
        if (!work(first, std::min(bandRows, height - first))) isComplete = false;
    });
    return isComplete && !shares.left() && !stop.stop_requested();
}

} // namespace

bool DeferredTheft::draw(const CoupledSystem& system, const MipPicture& picture, const TheftRequest& request,
                         std::span<std::uint32_t> pixels, const std::stop_token& stop) {
    const KeyTops tops(system, request.camera, request.points, request.seed, stop);
    if (stop.stop_requested() || !keep(tops, system, request, stop)) return false;
    const auto width = std::size_t(request.camera.width);
    return inBands(m_workers, request.camera.height, stop, [&](int first, int rows) {
        const std::size_t begin = width * std::size_t(first), count = width * std::size_t(rows);
        std::vector<TopPoint> points(count);
        tops.decode(std::span(m_keys).subspan(begin, count), points);
        colour(points, picture, request, pixels.subspan(begin, count));
        return true;
    });
}

bool DeferredTheft::keep(const KeyTops& tops, const CoupledSystem& system, const TheftRequest& request,
                         const std::stop_token& stop) {
    const auto width = std::size_t(request.camera.width);
    const std::size_t count = width * std::size_t(request.camera.height);
    m_hasKeptKeys = m_keys.size() == count && m_camera == request.camera && m_points == request.points &&
                    m_seed == request.seed && m_from == system.from &&
                    m_probabilities == system.probabilities;
    if (m_hasKeptKeys) return true;
    m_keys.resize(count);
    const bool isDrawn = inBands(m_workers, request.camera.height, stop, [&](int first, int rows) {
        return tops.drawKeys(
            first, std::span(m_keys).subspan(width * std::size_t(first), width * std::size_t(rows)), stop);
    });
    if (!isDrawn) m_keys.clear();
    m_camera = request.camera;
    m_points = request.points;
    m_seed = request.seed;
    m_from = system.from;
    m_probabilities = system.probabilities;
    return isDrawn;
}

void layUnder(std::span<std::uint32_t> pixels, const MipPicture& picture, const TheftRequest& request,
              double opacity) {
    const ifs::AffineMap<2> toPicture =
        request.toPicture * ifs::inverse(worldToPixel(request.camera)).value_or(ifs::AffineMap<2>());
    const double zoom = std::abs(ifs::determinant<2>(toPicture.linear));
    const Rgba& ground = request.background;
    const int width = request.camera.width;
    for (std::size_t k = 0; k < pixels.size(); ++k) {
        const std::uint32_t rest = 255 - (pixels[k] >> 24);
        if (rest == 0) continue;
        const ifs::Vector<2> pixel(double(k % std::size_t(width)) + .5, double(k / std::size_t(width)) + .5);
        const ifs::Vector<2> at = toPicture(pixel);
        const LinearColour seen = picture.at(at.x(), at.y(), zoom);
        const double share = seen.alpha * opacity;
        const auto channel = [&](int shift, double light, std::uint8_t below) {
            const double code = seen.alpha > 0 ? double(encoded(light / seen.alpha)) : 0;
            const double mixed = code * share + double(below) * (1 - share);
            return std::min(255U, ((pixels[k] >> shift) & 255) + std::uint32_t(mixed * rest / 255 + 0.5))
                   << shift;
        };
        pixels[k] = 0xFF000000U | channel(16, seen.red, ground.red) | channel(8, seen.green, ground.green) |
                    channel(0, seen.blue, ground.blue);
    }
}

} // namespace attractor
