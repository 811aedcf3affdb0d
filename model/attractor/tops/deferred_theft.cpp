// SPDX-License-Identifier: MIT
#include "attractor/tops/deferred_theft.h"

#include "attractor/colour/srgb_transfer.h"
#include "attractor/threads/job_shares.h"
#include "attractor/tops/key_colours.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>

namespace attractor {

namespace {

constexpr int bandRows = 32; // rows coloured at a time by one thread
// Found at a time by one thread: every word that reaches into a band goes through all of its samples for it.
constexpr int keyRows = 128;

// work(first row, number of rows) for bands of at most so many rows that cover the picture; false when
// stopped.
bool inBands(Workers& workers, int height, int most, const std::stop_token& stop,
             const std::function<bool(int first, int rows)>& work) {
    JobShares shares;
    shares.reset(std::size_t((height + most - 1) / most), workers);
    std::atomic<bool> isComplete = true;
    shares.run(workers, stop, [&](std::size_t job, std::size_t) {
        const int first = int(job) * most;
        if (!work(first, std::min(most, height - first))) isComplete = false;
    });
    return isComplete && !shares.left() && !stop.stop_requested();
}

// A premultiplied pixel over light of this opacity, over the background.
std::uint32_t over(std::uint32_t pixel, const LinearColour& seen, double opacity, const Rgba& background) {
    const std::uint32_t rest = 255 - (pixel >> 24);
    const double share = seen.alpha * opacity;
    const auto channel = [&](int shift, double light, std::uint8_t below) {
        const double code = seen.alpha > 0 ? double(encoded(light / seen.alpha)) : 0;
        const double mixed = code * share + double(below) * (1 - share);
        return std::min(255U, ((pixel >> shift) & 255) + std::uint32_t(mixed * rest / 255 + 0.5)) << shift;
    };
    return 0xFF000000U | channel(16, seen.red, background.red) | channel(8, seen.green, background.green) |
           channel(0, seen.blue, background.blue);
}

} // namespace

bool DeferredTheft::draw(const CoupledSystem& system, const MipPicture& picture, const TheftRequest& request,
                         std::span<std::uint32_t> pixels, const std::stop_token& stop) {
    if (stop.stop_requested() || !keep(system, request, stop)) return false;
    const KeyColours colours(*m_tops, picture, request);
    const auto width = std::size_t(request.camera.width);
    return inBands(m_workers, request.camera.height, bandRows, stop, [&](int first, int rows) {
        const std::size_t begin = width * std::size_t(first), count = width * std::size_t(rows);
        colours.paint(std::span(m_keys).subspan(begin, count), pixels.subspan(begin, count));
        return true;
    });
}

bool DeferredTheft::keep(const CoupledSystem& system, const TheftRequest& request,
                         const std::stop_token& stop) {
    const auto width = std::size_t(request.camera.width);
    const std::size_t count = width * std::size_t(request.camera.height);
    m_hasKeptKeys = m_tops && m_keys.size() == count && m_camera == request.camera &&
                    m_points == request.points && m_seed == request.seed && m_from == system.from &&
                    m_probabilities == system.probabilities;
    if (m_hasKeptKeys) {
        m_tops->moveTo(system);
        return true;
    }
    m_keys.resize(count);
    m_tops.emplace(system, request.camera, request.points, request.seed, stop);
    const bool isDrawn = inBands(m_workers, request.camera.height, keyRows, stop, [&](int first, int rows) {
        return m_tops->drawKeys(
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

void DeferredTheft::layUnder(std::span<std::uint32_t> pixels, const MipPicture& picture,
                             const TheftRequest& request, double opacity) {
    const ifs::AffineMap<2> toPicture =
        request.toPicture * ifs::inverse(worldToPixel(request.camera)).value_or(ifs::AffineMap<2>());
    const double zoom = std::abs(ifs::determinant<2>(toPicture.linear));
    const auto width = std::size_t(request.camera.width);
    inBands(m_workers, request.camera.height, bandRows, {}, [&](int first, int rows) {
        for (int row = first; row < first + rows; ++row)
            for (std::size_t column = 0; column < width; ++column) {
                std::uint32_t& pixel = pixels[std::size_t(row) * width + column];
                if (pixel >> 24 == 255) continue;
                const ifs::Vector<2> at = toPicture({double(column) + .5, row + .5});
                pixel = over(pixel, picture.at(at.x(), at.y(), zoom), opacity, request.background);
            }
        return true;
    });
}

} // namespace attractor
