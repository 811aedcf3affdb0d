// SPDX-License-Identifier: MIT
#include "attractor/tops/stolen_picture.h"

#include "attractor/threads/job_shares.h"
#include "attractor/threads/workers.h"
#include "attractor/tops/exact_tops.h"
#include "attractor/tops/key_colours.h"
#include "attractor/tops/key_tops.h"
#include "attractor/tops/picture_painter.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <vector>

namespace attractor {

namespace {

constexpr std::size_t bandPixels = 1U << 18; // pixels drawn at a time by one thread
constexpr int maxBandRows = 64;

// The colours of pixels of F; `points` and `pixels` are as many.
void colour(std::span<const TopPoint> points, const MipPicture& picture, const TheftRequest& request,
            std::span<std::uint32_t> pixels) {
    PicturePainter painter(picture, request.background, pixels);
    const double zoom = picturePixels(request);
    for (std::size_t k = 0; k < points.size(); ++k) {
        const TopPoint& point = points[k];
        if (point.isEmpty()) {
            pixels[k] = painter.empty();
            continue;
        }
        const ifs::Vector<2> at = request.toPicture({point.x, point.y});
        painter.paint(k, at.x(), at.y(), mipLevel(point.stretch * zoom));
    }
    painter.finish();
}

struct Band {
    std::vector<TopPoint> points;    // exact tops only
    std::vector<std::uint32_t> keys; // key tops only
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
        if (request.isExact) return;
        m_keys = std::make_unique<KeyTops>(system, request.camera, request.points, request.seed, stop);
        m_colours = std::make_unique<KeyColours>(*m_keys, picture, request);
    }

    TheftOutcome run(const std::function<bool(std::span<const std::uint32_t>)>& take) {
        const Camera& camera = m_request.camera;
        const int rows = int(std::clamp<std::size_t>(bandPixels / std::size_t(camera.width), 1, maxBandRows));
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
        band.pixels.resize(std::size_t(m_request.camera.width) * std::size_t(count));
        if (m_keys) {
            band.keys.resize(band.pixels.size());
            if (!m_keys->drawKeys(first, band.keys, m_stop)) return false;
            m_colours->paint(band.keys, band.pixels);
            return true;
        }
        band.points.resize(band.pixels.size());
        if (!m_exact.draw(first, band.points, m_stop)) return false;
        colour(band.points, m_picture, m_request, band.pixels);
        return true;
    }

    const MipPicture& m_picture;
    const TheftRequest& m_request;
    ExactTops m_exact;
    std::unique_ptr<KeyTops> m_keys;
    std::unique_ptr<KeyColours> m_colours;
    std::stop_token m_stop;
    Workers m_workers;
    std::vector<Band> m_bands;
};

} // namespace

TheftOutcome steal(const CoupledSystem& system, const MipPicture& picture, const TheftRequest& request,
                   const std::function<bool(std::span<const std::uint32_t> pixels)>& take,
                   const std::stop_token& stop) {
    return Theft(system, picture, request, stop).run(take);
}

} // namespace attractor
