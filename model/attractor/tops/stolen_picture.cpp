// SPDX-License-Identifier: MIT
#include "attractor/tops/stolen_picture.h"

#include "attractor/colour/srgb_transfer.h"
#include "attractor/threads/job_shares.h"
#include "attractor/threads/workers.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <vector>

namespace attractor {

namespace {

constexpr std::size_t bandPixels = 1U << 18; // drawn at a time by one thread
constexpr int bandRows = 64;

// Straight sRGB under a premultiplied colour in linear light, premultiplied again as codes.
std::uint32_t packed(const LinearColour& over, const LinearColour& under) {
    if (over.alpha >= 1)
        return 0xFF000000U | std::uint32_t(encoded(over.red)) << 16 |
               std::uint32_t(encoded(over.green)) << 8 | std::uint32_t(encoded(over.blue));
    const double rest = (1 - over.alpha) * under.alpha, alpha = over.alpha + rest;
    if (!(alpha > 0)) return 0;
    const auto opacity = std::uint32_t(std::clamp(alpha, 0.0, 1.0) * 255 + 0.5);
    const auto channel = [&](double above, double below) {
        const double light = std::clamp((above + rest * below) / alpha, 0.0, 1.0);
        return (std::uint32_t(encoded(light)) * opacity + 127) / 255;
    };
    return opacity << 24 | channel(over.red, under.red) << 16 | channel(over.green, under.green) << 8 |
           channel(over.blue, under.blue);
}

struct Band {
    std::vector<TopPoint> points;
    std::vector<std::uint32_t> pixels;
};

class Theft {
public:
    Theft(const CoupledSystem& system, const MipPicture& picture, const TheftRequest& request,
          const std::stop_token& stop)
        : m_picture(picture),
          m_request(request),
          m_exact(system, request.camera),
          m_stop(stop),
          m_workers(std::size_t(std::clamp(request.threads, 1, 256))),
          m_bands(m_workers.size()) {
        if (!request.isExact)
            m_keys = std::make_unique<KeyTops>(system, request.camera, request.points, request.seed, stop);
    }

    TheftOutcome run(const std::function<bool(std::span<const std::uint32_t>)>& take) {
        const Camera& camera = m_request.camera;
        const int rows = int(std::clamp<std::size_t>(bandPixels / std::size_t(camera.width), 1, bandRows));
        for (int first = 0; first < camera.height;) {
            const int left = (camera.height - first + rows - 1) / rows;
            const auto bands = std::min(m_bands.size(), std::size_t(left));
            if (!drawBands(first, rows, bands))
                return m_stop.stop_requested() ? TheftOutcome::Stopped : TheftOutcome::CutShort;
            for (std::size_t k = 0; k < bands; ++k)
                if (!take(m_bands[k].pixels)) return TheftOutcome::NotTaken;
            first += rows * int(bands);
        }
        return TheftOutcome::Done;
    }

private:
    bool drawBands(int first, int rows, std::size_t bands) {
        JobShares shares;
        shares.reset(bands, m_workers);
        std::atomic<bool> isComplete = true;
        shares.run(m_workers, m_stop, [&](std::size_t job, std::size_t) {
            if (!drawBand(m_bands[job], first + int(job) * rows, rows)) isComplete = false;
        });
        return isComplete && !shares.left();
    }

    bool drawBand(Band& band, int first, int rows) const {
        const int count = std::min(rows, m_request.camera.height - first);
        band.points.resize(std::size_t(m_request.camera.width) * std::size_t(count));
        band.pixels.resize(band.points.size());
        const bool isDrawn =
            m_keys ? m_keys->draw(first, band.points, m_stop) : m_exact.draw(first, band.points, m_stop);
        if (isDrawn) colour(band.points, m_picture, m_request, band.pixels);
        return isDrawn;
    }

    const MipPicture& m_picture;
    const TheftRequest& m_request;
    ExactTops m_exact;
    std::unique_ptr<KeyTops> m_keys;
    std::stop_token m_stop;
    Workers m_workers;
    std::vector<Band> m_bands;
};

} // namespace

void colour(std::span<const TopPoint> points, const MipPicture& picture, const TheftRequest& request,
            std::span<std::uint32_t> pixels) {
    const LinearColour under = linearColour(request.background);
    const ifs::AffineMap<2>& toPicture = request.toPicture;
    const double pixel = request.camera.pixelsPerUnit;
    const double zoom = std::abs(ifs::determinant<2>(toPicture.linear)) / (pixel * pixel); // of areas
    const std::uint32_t empty = packed({0, 0, 0, 0}, under);
    for (std::size_t k = 0; k < points.size(); ++k) {
        const TopPoint& point = points[k];
        if (point.isEmpty()) {
            pixels[k] = empty;
            continue;
        }
        const ifs::Vector<2> at = toPicture({point.x, point.y});
        pixels[k] = packed(picture.at(at.x(), at.y(), point.stretch * zoom), under);
    }
}

TheftOutcome steal(const CoupledSystem& system, const MipPicture& picture, const TheftRequest& request,
                   const std::function<bool(std::span<const std::uint32_t> pixels)>& take,
                   const std::stop_token& stop) {
    return Theft(system, picture, request, stop).run(take);
}

} // namespace attractor
