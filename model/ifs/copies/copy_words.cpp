// SPDX-License-Identifier: MIT
#include "ifs/copies/copy_words.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace ifs {

namespace {

constexpr std::size_t maxWords = 4000;
constexpr std::size_t maxBars = 20'000; // bars of all projections

class WordsWriter {
public:
    WordsWriter(const std::vector<AffineMap<2>>& maps, const CopyFrame& frame, std::size_t firstProjection)
        : m_maps(maps), m_frame(frame), m_firstProjection(firstProjection) {}

    void add(const AffineMap<2>& map, std::optional<std::size_t> first) {
        const double thinness = m_frame.thinness;
        const double length = spectralNorm<2>(map.linear);
        const bool isDot = length < thinness / 2;
        const double least = isDot ? std::max(length, thinness / 4) : thinness;
        CopyWords::Word word{{thickened(map, m_frame.centre, least), 0, {}, first}, map};
        const bool isThick = !isDot && word.copy.map == map;
        if (!isDot && !isThick) word.copy.projection = projectionFor(map.linear, length);
        (isThick ? m_open : m_result.words).push_back(word);
    }

    // Returns false for too many words.
    bool finish() {
        while (!m_open.empty()) {
            if (m_open.size() + m_result.words.size() > maxWords || m_bars > maxBars) return false;
            const CopyWords::Word outer = m_open.back();
            m_open.pop_back();
            for (std::size_t i = 0; i < m_maps.size(); ++i)
                add(outer.map * m_maps[i], outer.copy.first.value_or(i));
        }
        std::stable_sort(m_result.words.begin(), m_result.words.end(),
                         [](const auto& a, const auto& b) { return a.copy.first < b.copy.first; });
        return true;
    }

    CopyWords take() && { return std::move(m_result); }

private:
    // Projection of the attractor along the direction that the word keeps. The direction is rounded to half a
    // pixel, so that words share projections.
    std::size_t projectionFor(const Matrix<2>& linear, double length) {
        constexpr double pi = std::numbers::pi;
        const int size = int(std::ceil(std::log2(std::max(length / m_frame.thinness, 1.0))));
        const double longest = m_frame.thinness * std::exp2(size);
        const double turns = std::ceil(pi * longest * m_frame.diameter / m_frame.pixel);
        const Vector<2> along = longestDirection(linear);
        const double turn = std::round(std::atan2(along.y(), along.x()) / pi * turns);
        auto& projections = m_result.projections;
        const auto [known, isNew] =
            m_known.emplace(std::pair(size, int(std::fmod(turn + turns, turns))), projections.size());
        if (isNew) {
            const double angle = turn * pi / turns;
            projections.push_back(
                projectionAlong(m_maps, m_frame, {std::cos(angle), std::sin(angle)}, longest));
            m_bars += projections.back().bars.size();
        }
        return m_firstProjection + known->second;
    }

    const std::vector<AffineMap<2>>& m_maps;
    const CopyFrame& m_frame;
    std::size_t m_firstProjection;
    std::map<std::pair<int, int>, std::size_t> m_known; // indices of projections by size and direction
    std::size_t m_bars = 0;
    std::vector<CopyWords::Word> m_open;
    CopyWords m_result;
};

} // namespace

std::optional<CopyWords> copyWords(const std::vector<AffineMap<2>>& maps,
                                   std::span<const MovedBranch<2>> pieces, const CopyFrame& frame,
                                   std::size_t firstProjection) {
    WordsWriter writer(maps, frame, firstProjection);
    for (const auto& [branch, change] : pieces) {
        AffineMap<2> map = change;
        for (const int symbol : branch)
            map = map * maps[std::size_t(symbol)];
        writer.add(map, branch.empty() ? std::nullopt : std::optional(std::size_t(branch.front())));
    }
    if (!writer.finish()) return std::nullopt;
    return std::move(writer).take();
}

} // namespace ifs
