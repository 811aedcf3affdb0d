// SPDX-License-Identifier: MIT
#include "attractor/solid/solid_band.h"

#include "attractor/solid/clipped_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace attractor {

namespace {

constexpr double maxBentPixels = 0.25;   // pixels; error bound of the first-order map of a perspective
constexpr double maxSinglePixels = 2048; // pixels; wider words are composed in double precision
// Share of the eye's distance; smaller words that reach the eye are skipped.
constexpr double minEyeShare = 0x1p-14;

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

// The displayed pieces; by address, parts of them that are long enough to know their colours.
void SolidScene::setKey(SolidKey newKey) {
    key = newKey;
    roots.clear();
    const std::size_t count = boxMaps.size();
    if (count == 0) return;
    for (const PreparedSpace::Piece& piece : system.pieces()) {
        roots.push_back({piece.map, kernels::SolidWord::uncoloured, piece.word, piece.isMoved});
        if (!piece.word.empty()) roots.back().colour = colours[static_cast<std::size_t>(piece.word.front())];
    }
    if (key == SolidKey::Map) return;
    constexpr std::size_t steps = 256;
    constexpr std::size_t maxLength = 8;
    std::size_t words = 1, length = 0;
    for (; length < maxLength && (length == 0 || words * count <= steps); ++length)
        words *= count;
    for (std::size_t shorter = 0; shorter < length; ++shorter) {
        std::vector<Root> longer;
        for (Root& root : roots) {
            if (root.address.size() > shorter) {
                longer.push_back(std::move(root));
                continue;
            }
            for (std::size_t i = 0; i < count; ++i) {
                longer.push_back({root.word * boxMaps[i], 0, root.address, root.isMoved});
                longer.back().address.push_back(static_cast<int>(i));
            }
        }
        roots = std::move(longer);
    }
    for (Root& root : roots) {
        std::size_t number = 0;
        for (std::size_t k = 0; k < length; ++k)
            number = number * count + static_cast<std::size_t>(root.address[k]);
        root.colour = static_cast<int>(number * steps / words);
    }
}

void SolidScene::setView(const SpaceView& newView) {
    view = newView;
    if (view.bend && !system.maps.empty()) {
        if (!m_bends) m_bends = std::make_shared<BendTree>();
        m_bends->follow(*view.bend, view.afterBend, view.toPixels * system.fromBox(), boxMaps);
        view.bends = m_bends;
    }
    // True unless words are bent or moved, and so seen from many sides.
    const bool isSeenAlike = !view.bend && system.moved.empty();
    facing = isSeenAlike ? FacingCover(system, view, covers.ofAtMost(facingPoints)) : FacingCover();
    const bool canThin = facing.isEmpty() && system.contracts && system.moved.empty();
    thinningRatio = canThin ? commonRatio(system) : std::nullopt;
}

void SolidBand::draw(const SolidScene& scene, int firstRow, int rows, DepthRaster& raster,
                     const std::stop_token& stop) {
    constexpr std::size_t wordsPerPixel = 1024; // limit; leaves behind each other need hundreds
    constexpr std::size_t wideBudget = 1U << 18;
    constexpr std::size_t widePerPixel = 16;
    const auto pixels = static_cast<std::size_t>(raster.width * rows);
    std::size_t budget = (1U << 24) + wordsPerPixel * pixels;
    m_job.maps.count = scene.system.maps.size();
    for (std::size_t k = 0; k < 9; ++k)
        m_job.maps.linear[k] = scene.coefficients->coefficients[k].data();
    for (std::size_t k = 0; k < 3; ++k)
        m_job.maps.shift[k] = scene.coefficients->coefficients[9 + k].data();
    m_job.maps.colours = scene.colours.data();
    m_job.band = &m_keys;
    m_isThinning =
        scene.thinningRatio && ThinnedCovers::isExact(*scene.thinningRatio, raster.width, scene.range);
    if (m_isThinning) m_thinned.use(scene.covers, *scene.thinningRatio);
    // Coarser leaves, if words overlap and there are too many.
    for (const std::size_t points : {SolidScene::leafPoints, Covers::maxPoints}) {
        m_covers = scene.covers.ofAtMost(points);
        m_covers.insert(m_covers.begin(), scene.facing.isEmpty() ? kernels::Cover() : scene.facing.cover());
        m_job.covers = std::span(m_covers).subspan(scene.facing.isEmpty() ? 1 : 0);
        m_job.budget = scene.system.contracts ? budget : 0;
        m_wideBudget = wideBudget + widePerPixel * pixels;
        m_job.coarse = 0;
        m_keys.reset(raster.width, rows);
        if (!walk(scene, firstRow, stop)) return;
        if (m_job.budget > 0 || m_wideBudget == 0) break;
        budget = 1U << 24; // larger budgets would not help
    }
    m_isCoarse = m_isCoarse || m_job.coarse > 0;
    const auto width = static_cast<std::size_t>(raster.width);
    for (int y = 0; y < rows; ++y)
        std::copy_n(m_keys.row(y), width, raster.row(firstRow + y));
}

SolidBand::Work SolidBand::takeWork() {
    return {std::exchange(m_job.words, 0), std::exchange(m_job.points, 0), std::exchange(m_isCoarse, false)};
}

void SolidBand::expand(const SolidScene& scene, const Open& open, int firstRow) {
    m_wideBudget -= std::min(m_wideBudget, scene.boxMaps.size());
    m_children.clear();
    for (std::size_t i = 0; i < scene.boxMaps.size(); ++i)
        m_children.push_back(
            {childWord(open.word, i, scene.boxMaps[i], scene.view),
             open.colour == kernels::SolidWord::uncoloured ? scene.colours[i] : open.colour});
    openSorted(scene, firstRow);
}

// Opens the children that meet the view, the nearest one on top. Where words bend there are many: those that
// miss the band are left out at once.
void SolidBand::openSorted(const SolidScene& scene, int firstRow) {
    m_order.clear();
    for (std::size_t i = 0; i < m_children.size(); ++i) {
        SeenWord& word = m_children[i].seen;
        word = glimpsed(m_children[i].word, scene.view);
        if (!word.meets(scene.view.size)) continue;
        const double reach = word.half.y() + word.miss + 1;
        const double row = word.onScreen.translation.y() - firstRow;
        if (scene.view.bend && !word.reachesEye && (row + reach < 0 || row - reach > m_keys.rows())) continue;
        m_order.emplace_back(word.nearest(), i);
    }
    std::sort(m_order.rbegin(), m_order.rend());
    for (const auto& [depth, index] : m_order)
        m_open.push_back(std::move(m_children[index]));
}

// The coarsest cover whose points leave no holes in a word of that size, in pixels; nullptr where none is
// fine enough.
const kernels::Cover* SolidBand::coverFor(double size) const {
    for (const kernels::Cover& cover : m_job.covers)
        if (cover.onlyFor == 0 && static_cast<double>(cover.spacing) * size <= kernels::maxSpacing)
            return &cover;
    return nullptr;
}

// Draws with a thinned cover, if there is one.
bool SolidBand::drawWhole(const SeenWord& seen, const kernels::SolidWord& word, const std::stop_token& stop) {
    const std::span<const kernels::Cover> covers = m_job.covers;
    if (!m_isThinning) return kernels::drawSolid(word, m_job, stop);
    const kernels::Cover* thinned = m_thinned.find(seen.onScreen.linear, seen.scale, covers);
    const std::size_t before = m_job.points;
    if (thinned != nullptr) {
        m_covers.front() = *thinned;
        m_job.covers = m_covers;
    }
    const bool done = kernels::drawSolid(word, m_job, stop);
    m_job.covers = covers;
    if (thinned == nullptr) m_thinned.missed(m_job.points - before);
    return done;
}

bool SolidBand::walk(const SolidScene& scene, int firstRow, const std::stop_token& stop) {
    m_open.clear();
    m_children.clear();
    const ifs::AffineMap<3> box = scene.view.toPixels * scene.system.fromBox();
    for (const SolidScene::Root& root : scene.roots) {
        WalkedWord word{box * root.word};
        if (scene.view.bend && !root.isMoved) // sequential, so that every walk finds the same words
            word = walkedTo(root.address, rootWord(box, scene.view), scene.boxMaps, scene.view);
        m_children.push_back({std::move(word), root.colour});
    }
    openSorted(scene, firstRow);
    while (!m_open.empty()) {
        Open open = std::move(m_open.back());
        m_open.pop_back();
        ++m_job.words;
        if (m_job.words % 256 == 0 && stop.stop_requested()) return false;
        if (!draw(scene, open, firstRow, stop)) return false;
    }
    return true;
}

// Behind what there is, or outside the band, wherever its points are as far as is known.
bool SolidBand::isHidden(const SolidScene& scene, const SeenWord& word, int firstRow) {
    if (word.reachesEye || !word.onScreen.translation.allFinite()) return false;
    kernels::SolidWord shown = screenWord(word, 0, firstRow, scene.range);
    if (scene.view.bend) {
        const double miss = word.half.z() - word.onScreen.linear.row(2).cwiseAbs().sum();
        shown.middle[2] -= static_cast<float>(miss * maxDepthCode / (scene.range.far - scene.range.near));
    }
    return kernels::isHidden(shown, static_cast<float>(word.miss + maxBentPixels), m_keys);
}

// Draws the word as one, or else by its children. False when stopped.
bool SolidBand::draw(const SolidScene& scene, Open& open, int firstRow, const std::stop_token& stop) {
    constexpr std::size_t maxOpen = 1U << 18;
    const double codes = maxDepthCode / (scene.range.far - scene.range.near);
    SeenWord& word = open.seen;
    // Deferred, since most words are hidden or small before their bend matters.
    if (scene.view.bend && !open.word.follows) {
        if (isHidden(scene, word, firstRow)) return true;
        if (word.reachesEye || !(word.miss <= maxBentPixels)) word = seen(open.word, scene.view);
        if (!word.meets(scene.view.size)) return true;
    }
    if (!word.onScreen.translation.allFinite()) return true;
    const bool spent =
        m_job.budget == 0 || m_wideBudget == 0 || m_open.size() + scene.boxMaps.size() > maxOpen;
    if (word.reachesEye) {
        if (!(word.half.z() > minEyeShare * scene.view.eyeDistance)) return true;
        if (spent)
            ++m_job.coarse;
        else
            expand(scene, open, firstRow);
        return true;
    }
    const kernels::SolidWord shown = screenWord(word, open.colour, firstRow, scene.range);
    m_job.pixelsPerCode = static_cast<float>(word.scale / codes);
    const kernels::Cover* cover = word.isCut ? coverFor(word.size()) : nullptr;
    const bool isSingle = word.miss <= maxBentPixels &&
                          (word.isCut ? cover != nullptr && open.colour != kernels::SolidWord::uncoloured
                                      : word.size() <= maxSinglePixels);
    if (!isSingle) {
        if (isHidden(scene, word, firstRow)) return true;
        if (!spent) {
            expand(scene, open, firstRow);
            return true;
        }
        ++m_job.coarse;
    }
    if (!word.isCut) return drawWhole(word, shown, stop);
    if (cover == nullptr) cover = &m_covers.back();
    m_job.points += cover->size;
    m_wideBudget -= std::min(m_wideBudget, cover->size / kernels::solidLanes);
    drawClipped(straightened(open.word, scene.view).word, shown, *scene.view.clip, *cover, m_keys);
    return true;
}

} // namespace attractor
