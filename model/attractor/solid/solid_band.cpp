// SPDX-License-Identifier: MIT
#include "attractor/solid/solid_band.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace attractor {

namespace {

constexpr double maxBentPixels = 0.25;   // by which a first-order map of a perspective may be off
constexpr double maxSinglePixels = 2048; // wider words are composed in double precision
constexpr double minEyeShare = 0x1p-14;  // of the eye's distance: words that reach the eye and are smaller

kernels::SolidWord screenWord(const SeenWord& seen, int colour, int firstRow, const DepthRange& range) {
    const double codes = maxDepthCode / (range.far - range.near);
    kernels::SolidWord word;
    for (int row = 0; row < 3; ++row) {
        const double factor = row == 2 ? codes : 1;
        const double origin = row == 0 ? 0 : row == 1 ? firstRow : range.near;
        for (int column = 0; column < 3; ++column)
            word.linear[static_cast<std::size_t>(3 * row + column)] =
                static_cast<float>(factor * seen.onScreen.linear(row, column));
        word.middle[static_cast<std::size_t>(row)] =
            static_cast<float>(factor * (seen.onScreen.translation[row] - origin));
    }
    word.colour = colour;
    return word;
}

} // namespace

void SolidScene::setSystem(PreparedSpace prepared) {
    system = std::move(prepared);
    boxMaps.clear();
    colours.clear();
    coefficients.reset();
    covers = {};
    if (system.maps.empty()) return;
    for (const ifs::AffineMap<3>& map : system.maps)
        boxMaps.push_back(system.inBox(map));
    for (const std::size_t index : system.index)
        colours.push_back(static_cast<std::uint8_t>(index & 0xFF));
    coefficients.emplace(system);
    covers = Covers(system);
}

void SolidScene::setView(const SpaceView& newView) {
    view = newView;
    facing = FacingCover(system, view, covers.ofAtMost(facingPoints));
}

void SolidBand::draw(const SolidScene& scene, int firstRow, int rows, DepthRaster& raster,
                     const std::stop_token& stop) {
    constexpr std::size_t budget = 1U << 24;
    constexpr std::size_t wideBudget = 1U << 18;
    constexpr std::size_t widePerPixel = 16;
    m_job.maps.count = scene.system.maps.size();
    for (std::size_t k = 0; k < 9; ++k)
        m_job.maps.linear[k] = scene.coefficients->coefficients[k].data();
    for (std::size_t k = 0; k < 3; ++k)
        m_job.maps.shift[k] = scene.coefficients->coefficients[9 + k].data();
    m_job.maps.colours = scene.colours.data();
    m_job.band = &m_keys;
    // Of a system whose words lie on each other there are too many: then larger ones are drawn.
    for (const std::size_t points : {SolidScene::leafPoints, Covers::maxPoints}) {
        m_covers = scene.covers.ofAtMost(points);
        if (!scene.facing.isEmpty()) m_covers.insert(m_covers.begin(), scene.facing.cover());
        m_job.covers = m_covers;
        m_job.budget = scene.system.contracts ? budget : 0;
        m_wideBudget = wideBudget + widePerPixel * static_cast<std::size_t>(raster.width * rows);
        m_keys.reset(raster.width, rows);
        if (!walk(scene, firstRow, stop)) return;
        if (m_job.budget > 0 || m_wideBudget == 0) break;
    }
    m_isCutShort = m_isCutShort || m_job.budget == 0 || m_wideBudget == 0;
    const auto width = static_cast<std::size_t>(raster.width);
    for (int y = 0; y < rows; ++y)
        std::copy_n(m_keys.row(y), width,
                    raster.keys.begin() +
                        static_cast<std::ptrdiff_t>(static_cast<std::size_t>(firstRow + y) * width));
}

SolidBand::Work SolidBand::takeWork() {
    return {std::exchange(m_job.words, 0), std::exchange(m_job.points, 0),
            std::exchange(m_isCutShort, false)};
}

void SolidBand::expand(const SolidScene& scene, const Open& open) {
    const std::size_t first = m_open.size();
    m_wideBudget -= std::min(m_wideBudget, scene.boxMaps.size());
    m_order.clear();
    for (std::size_t i = 0; i < scene.boxMaps.size(); ++i) {
        Open child{open.word * scene.boxMaps[i],
                   open.colour == kernels::SolidWord::uncoloured ? scene.colours[i] : open.colour};
        if (!seen(child.word, scene.view).meets(scene.view.size)) continue;
        m_order.emplace_back(child.word.translation.z() - child.word.linear.row(2).cwiseAbs().sum(),
                             m_open.size() - first);
        m_open.push_back(child);
    }
    std::sort(m_order.rbegin(), m_order.rend()); // the nearest comes last, on top
    std::vector<Open> sorted;
    for (const auto& [depth, index] : m_order)
        sorted.push_back(m_open[first + index]);
    std::copy(sorted.begin(), sorted.end(), m_open.begin() + static_cast<std::ptrdiff_t>(first));
}

bool SolidBand::walk(const SolidScene& scene, int firstRow, const std::stop_token& stop) {
    constexpr std::size_t maxOpen = 1U << 18;
    const double codes = maxDepthCode / (scene.range.far - scene.range.near);
    m_open.assign(1, {scene.view.toPixels * scene.system.fromBox()});
    while (!m_open.empty()) {
        const Open open = m_open.back();
        m_open.pop_back();
        ++m_job.words;
        if (m_job.words % 256 == 0 && stop.stop_requested()) return false;
        const SeenWord word = seen(open.word, scene.view);
        if (!word.meets(scene.view.size) || !word.onScreen.translation.allFinite()) continue;
        const bool spent =
            m_job.budget == 0 || m_wideBudget == 0 || m_open.size() + scene.boxMaps.size() > maxOpen;
        if (word.reachesEye) {
            if (!spent && word.half.z() > minEyeShare * scene.view.eyeDistance) expand(scene, open);
            continue;
        }
        const bool isSingle = word.miss <= maxBentPixels && word.size() <= maxSinglePixels;
        const kernels::SolidWord shown = screenWord(word, open.colour, firstRow, scene.range);
        m_job.pixelsPerCode = static_cast<float>(word.scale / codes);
        if (!isSingle && !spent) {
            if (!kernels::isHidden(shown, static_cast<float>(word.miss + maxBentPixels), m_keys))
                expand(scene, open);
        } else if (!kernels::drawSolid(shown, m_job, stop)) {
            return false;
        }
    }
    return true;
}

} // namespace attractor
