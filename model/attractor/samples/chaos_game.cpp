// SPDX-License-Identifier: MIT
#include "attractor/samples/chaos_game.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/kernels/kernels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

namespace attractor {

namespace {

// The maps in box coordinates, one array per coefficient (a b c d e f), as long as the alias table.
std::array<std::vector<float>, 6> boxCoefficients(const PreparedSystem& system, std::size_t slots) {
    std::array<std::vector<float>, 6> result;
    for (auto& coefficient : result)
        coefficient.assign(slots, 0);
    const double hx = system.halfExtent.x();
    const double hy = system.halfExtent.y();
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        const ifs::AffineMap<2>& map = system.maps[i];
        const ifs::Vector<2> shift = map(system.centre) - system.centre;
        const std::array<double, 6> row{map.linear(0, 0),
                                        map.linear(0, 1) * hy / hx,
                                        map.linear(1, 0) * hx / hy,
                                        map.linear(1, 1),
                                        shift.x() / hx,
                                        shift.y() / hy};
        for (std::size_t k = 0; k < row.size(); ++k)
            result[k][i] = static_cast<float>(row[k]);
    }
    return result;
}

// Steps after which an orbit has forgotten its start, from the mean logarithm of the contraction.
std::size_t burnIn(const PreparedSystem& system) {
    return system.meanLogarithm < 0
               ? static_cast<std::size_t>(std::clamp(16 / -system.meanLogarithm, 32.0, 2048.0))
               : 256;
}

kernels::Lanes freshLanes(std::uint64_t seed, std::uint64_t pass) {
    static_assert(kernels::Lanes::count == SampleSet::lanes);
    kernels::Lanes lanes;
    const std::uint64_t stream = mixed(mixed(seed) + pass);
    for (std::size_t lane = 0; lane < SampleSet::lanes; ++lane)
        for (std::size_t word = 0; word < 4; ++word)
            lanes.random[word][lane] = static_cast<std::uint32_t>(mixed(stream + 4 * lane + word) >> 32) | 1U;
    return lanes;
}

struct Range {
    float low = 0;
    float high = 0;
    bool near = true; // true within the escape radius
};

Range range(std::span<const float> values) { // a multiple of 64 of them
    constexpr std::size_t width = 16;        // number of parallel extremes: the longest vector
    std::array<float, width> low{};
    std::array<float, width> high{};
    std::array<std::uint32_t, width> near{};
    near.fill(1);
    std::copy_n(values.begin(), width, low.begin());
    high = low;
    for (std::size_t i = 0; i < values.size(); i += width)
        for (std::size_t k = 0; k < width; ++k) {
            const float value = values[i + k];
            low[k] = value < low[k] ? value : low[k];
            high[k] = value > high[k] ? value : high[k];
            near[k] &= std::abs(value) < escapeRadius ? 1U : 0U; // false for NaN
        }
    return {*std::min_element(low.begin(), low.end()), *std::max_element(high.begin(), high.end()),
            *std::min_element(near.begin(), near.end()) == 1};
}

// The orbits of one (seed, pass); `arrange` may exchange their points before their extremes are taken.
PointExtremes drawOrbits(const PreparedSystem& system, std::uint64_t seed, std::uint64_t pass,
                         std::span<float> x, std::span<float> y, const auto& arrange) {
    const AliasTable table(system.probabilities);
    const auto coefficients = boxCoefficients(system, table.size());
    kernels::ChaosTables tables;
    tables.size = table.size();
    tables.threshold = table.thresholds().data();
    tables.alias = table.aliases().data();
    for (std::size_t k = 0; k < coefficients.size(); ++k)
        tables.coefficients[k] = coefficients[k].data();
    tables.escapeRadius = escapeRadius;
    Range inX, inY;
    // Hardly any system needs the guard.
    for (const kernels::Guard guard : {kernels::Guard::Off, kernels::Guard::On}) {
        kernels::Lanes lanes = freshLanes(seed, pass);
        kernels::iterate(lanes, tables, guard, burnIn(system), nullptr, nullptr);
        kernels::iterate(lanes, tables, guard, x.size() / kernels::Lanes::count, x.data(), y.data());
        arrange();
        inX = range(x);
        inY = range(y);
        if (inX.near && inY.near) break;
    }
    return {inX.low, inX.high, inY.low, inY.high};
}

} // namespace

void repeatBeginning(std::vector<float>& values) {
    std::copy_n(values.begin(), SampleSet::size, values.begin() + SampleSet::size);
    std::copy_n(values.begin(), kernels::chunk, values.end() - kernels::chunk);
}

AliasTable::AliasTable(const std::vector<double>& probabilities) {
    const std::size_t count = probabilities.size();
    std::size_t slots = 16;
    while (slots < count)
        slots *= 2;
    m_threshold.assign(slots, std::numeric_limits<std::int32_t>::min());
    m_alias.resize(slots);
    // Vose's construction over slots, in which maps beyond the last have probability 0.
    std::vector<double> share(slots, 0);
    std::vector<std::size_t> small;
    std::vector<std::size_t> large;
    for (std::size_t i = 0; i < slots; ++i) {
        share[i] = i < count ? probabilities[i] * static_cast<double>(slots) : 0;
        (share[i] < 1 ? small : large).push_back(i);
    }
    while (!small.empty() && !large.empty()) {
        const std::size_t poor = small.back();
        const std::size_t rich = large.back();
        small.pop_back();
        m_threshold[poor] =
            static_cast<std::int32_t>(std::clamp(share[poor] * 0x1p32, 0.0, 4294967295.0) - 0x1p31);
        m_alias[poor] = static_cast<std::int32_t>(rich);
        share[rich] -= 1 - share[poor];
        if (share[rich] < 1) {
            large.pop_back();
            small.push_back(rich);
        }
    }
    // Slots left over by rounding keep their own map, or the likeliest one if they have none.
    const auto likeliest =
        std::max_element(probabilities.begin(), probabilities.end()) - probabilities.begin();
    for (const auto& rest : {small, large})
        for (std::size_t i : rest)
            m_alias[i] = static_cast<std::int32_t>(i < count ? static_cast<std::ptrdiff_t>(i) : likeliest);
}

std::vector<AliasTable> nextMaps(const PreparedSystem& system) {
    if (!system.isLinked()) return {AliasTable(system.probabilities)};
    const std::size_t n = system.chain.size;
    std::vector<AliasTable> tables;
    tables.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
        const auto row = system.chain.forward.begin() + std::ptrdiff_t(i * n);
        tables.emplace_back(std::vector<double>(row, row + std::ptrdiff_t(n)));
    }
    return tables;
}

PointExtremes drawPoints(const PreparedSystem& system, std::uint64_t seed, std::uint64_t pass,
                         std::span<float> x, std::span<float> y) {
    return drawOrbits(system, seed, pass, x, y, [] {});
}

void drawSamples(const PreparedSystem& system, std::uint64_t seed, std::uint64_t pass, SampleSet& samples,
                 const AddressStrata* strata) {
    samples.x.resize(2 * SampleSet::size + kernels::chunk);
    samples.y.resize(2 * SampleSet::size + kernels::chunk);
    const PointExtremes extremes = drawOrbits(system, seed, pass, std::span(samples.x).first(SampleSet::size),
                                              std::span(samples.y).first(SampleSet::size), [&] {
                                                  if (strata != nullptr)
                                                      strata->spread(mixed(seed) + mixed(pass), samples);
                                              });
    samples.lowX = extremes.lowX;
    samples.highX = extremes.highX;
    samples.lowY = extremes.lowY;
    samples.highY = extremes.highY;
    repeatBeginning(samples.x);
    repeatBeginning(samples.y);
}

Orbit::Orbit(const PreparedSystem& system, std::uint64_t seed, int dropped, ColourCoordinates colours)
    : m_system(&system),
      m_colours(colours.empty() ? ColourCoordinates(system.maps.size()) : std::move(colours)),
      m_next(nextMaps(system)),
      m_pieces(ifs::pieces<2>(system.moved, system.maps.size())),
      m_random(mixed(seed)) {
    m_point.colourCoordinate = m_colours.beginning();
    std::size_t longest = 0;
    for (const auto& [word, change] : m_pieces)
        longest = std::max(longest, word.size());
    m_address.assign(longest, 0); // same as for the fixed point of the first map
    m_point.x = ifs::fixedPoint(system.maps.front()).value_or(ifs::Vector<2>::Zero());
    if (system.isLinked()) {
        m_point.x = system.centre;
        m_point.lastMap =
            AliasTable(system.chain.stationary).draw(static_cast<std::uint32_t>(mixed(m_random++) >> 32));
    }
    m_farAway = 1e6 * (system.halfExtent.maxCoeff() + (m_point.x - system.centre).cwiseAbs().maxCoeff());
    for (int n = 0; n < dropped; ++n)
        step();
}

Orbit::Point Orbit::next() {
    step();
    Point shown = m_point;
    if (!m_system->moved.empty()) shown.x = change()(m_point.x);
    return shown;
}

const ifs::AffineMap<2>& Orbit::change() const {
    return ifs::pieceOf<2>(m_pieces, m_address).change;
}

void Orbit::step() {
    const auto random = static_cast<std::uint32_t>(mixed(m_random++) >> 32);
    const std::uint32_t i = m_next[m_next.size() > 1 ? m_point.lastMap : 0].draw(random);
    m_point.x = m_system->maps[i](m_point.x);
    m_point.lastMap = i;
    if (!m_address.empty()) {
        std::shift_right(m_address.begin(), m_address.end(), 1);
        m_address.front() = static_cast<int>(i);
    }
    m_point.addressCoordinate = (i + m_point.addressCoordinate) / static_cast<double>(m_system->maps.size());
    m_point.colourCoordinate = m_colours.next(i, m_point.colourCoordinate);
    if (!((m_point.x - m_system->centre).cwiseAbs().maxCoeff() <= m_farAway)) m_point.x = m_system->centre;
}

} // namespace attractor
