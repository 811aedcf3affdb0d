// SPDX-License-Identifier: MIT
#include "attractor/tops/key_tops.h"

#include "attractor/tops/top_cut.h"

#include <algorithm>
#include <utility>

namespace attractor {

namespace {

constexpr std::size_t wordsBetween = 64; // words between two checks of the stop token

kernels::KeyWord keyWord(const TopWord& word, const CoupledSamples& samples, std::size_t rank) {
    const ifs::Matrix<2> linear = word.shown.linear * samples.scale;
    const ifs::Vector<2> middle = word.shown(samples.centre);
    return {float(linear(0, 0)),
            float(linear(0, 1)),
            float(linear(1, 0)),
            float(linear(1, 1)),
            float(middle.x()),
            float(middle.y()),
            static_cast<std::uint32_t>(rank * samples.size)};
}

} // namespace

KeyTops::KeyTops(const CoupledSystem& system, const Camera& camera, std::uint64_t points, std::uint64_t seed,
                 const std::stop_token& stop)
    : m_width(camera.width) {
    const std::uint64_t wanted = std::clamp<std::uint64_t>(points, 1, maxPoints);
    const auto words = std::size_t(std::max<std::uint64_t>(1, wanted / CoupledSamples::usual));
    TopCut cut = topCut(system, camera, words, stop);
    if (stop.stop_requested() || cut.words.empty()) return;
    const std::size_t size =
        std::clamp<std::size_t>(wanted / cut.words.size(), 1, CoupledSamples::maxPerWord);
    m_samples = coupledSamples(system, seed, size, 1 / std::max(1.0, cut.size));
    m_tree = std::move(cut.tree);
    constexpr double rounding = 1; // pixels; exceeds the error of single precision
    for (const TopWord& word : cut.words) {
        m_boxes.push_back({word.box.left - rounding, word.box.right + rounding, word.box.top - rounding,
                           word.box.bottom + rounding});
        // Divided by the camera's scale.
        m_sources.push_back({word.number, word.shown.linear / camera.pixelsPerUnit});
        m_pieces.push_back({{}, 0, word.address, word.step});
        m_words.push_back(keyWord(word, m_samples, m_words.size()));
    }
    movePieces(system);
}

void KeyTops::moveTo(const CoupledSystem& system) {
    if (m_pieces.empty()) return;
    m_samples.moveTo(system);
    movePieces(system);
}

void KeyTops::movePieces(const CoupledSystem& system) {
    const auto images = m_tree.images(system);
    for (std::size_t k = 0; k < m_pieces.size(); ++k) {
        const WordTree::Image& image = images[m_sources[k].word];
        m_pieces[k].to = image.to;
        m_pieces[k].stretch =
            system.wholeRatio * stretchOf(image.areaRatio, image.to.linear, m_sources[k].from);
    }
}

bool KeyTops::draw(int firstRow, std::span<TopPoint> points, const std::stop_token& stop) const {
    std::vector<std::uint32_t> keys(points.size());
    if (!drawKeys(firstRow, keys, stop)) return false;
    decode(keys, points);
    return true;
}

// Draws from the lowest word to the top one.
bool KeyTops::drawKeys(int firstRow, std::span<std::uint32_t> keys, const std::stop_token& stop) const {
    const int endRow = firstRow + int(keys.size() / std::size_t(m_width));
    std::ranges::fill(keys, kernels::noKey);
    const kernels::KeyRows rows{m_width, firstRow, endRow, keys};
    std::size_t drawn = 0;
    for (std::size_t k = m_words.size(); k-- > 0;) {
        const PixelBox& box = m_boxes[k];
        if (!box.meets(m_width, firstRow, endRow)) continue;
        if (drawn++ % wordsBetween == 0 && stop.stop_requested()) return false;
        const auto reach =
            box.isWithin(m_width, firstRow, endRow) ? kernels::KeyReach::Inside : kernels::KeyReach::Across;
        kernels::putKeys(m_words[k], reach, m_samples.x.data(), m_samples.y.data(), m_samples.size, rows);
    }
    return !stop.stop_requested();
}

void KeyTops::decode(std::span<const std::uint32_t> keys, std::span<TopPoint> points) const {
    for (std::size_t k = 0; k < points.size(); ++k)
        points[k] = pointOf(keys[k]);
}

// v_σ(y_s)
TopPoint KeyTops::pointOf(std::uint32_t key) const {
    if (key == kernels::noKey) return {};
    const Piece& piece = m_pieces[key / m_samples.size];
    const CoupledSamples::Image& sample = m_samples.images[key % m_samples.size];
    const ifs::Vector<2> image = piece.to({sample.x, sample.y});
    return {image.x(), image.y(), piece.stretch * sample.stretch,
            piece.address + piece.step * sample.address};
}

} // namespace attractor
