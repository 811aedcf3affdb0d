// SPDX-License-Identifier: MIT
#include "attractor/chaos_game.h"

#include "attractor/arithmetic.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace attractor {

namespace {

constexpr std::size_t lanes = SampleSet::lanes;
constexpr float escapeRadius = 1e6F; // in half boxes

// The maps in box coordinates, one array per coefficient.
struct Coefficients {
    std::vector<float> a, b, c, d, e, f;
};

Coefficients boxCoefficients(const DrawableSystem& system) {
    Coefficients result;
    const double hx = system.halfExtent.x();
    const double hy = system.halfExtent.y();
    for (const ifs::AffineMap<2>& map : system.maps) {
        const ifs::Vector<2> shift = map(system.centre) - system.centre;
        result.a.push_back(static_cast<float>(map.linear(0, 0)));
        result.b.push_back(static_cast<float>(map.linear(0, 1) * hy / hx));
        result.c.push_back(static_cast<float>(map.linear(1, 0) * hx / hy));
        result.d.push_back(static_cast<float>(map.linear(1, 1)));
        result.e.push_back(static_cast<float>(shift.x() / hx));
        result.f.push_back(static_cast<float>(shift.y() / hy));
    }
    return result;
}

// Steps after which an orbit has forgotten its start, from the mean logarithm of the contraction.
int burnIn(const DrawableSystem& system) {
    double logarithm = 0;
    for (std::size_t i = 0; i < system.maps.size(); ++i)
        logarithm += system.probabilities[i] * naturalLogarithm(ifs::spectralNorm<2>(system.maps[i].linear));
    return logarithm < 0 ? static_cast<int>(std::clamp(16 / -logarithm, 32.0, 2048.0)) : 256;
}

// xoshiro128++ in every lane.
struct Streams {
    std::array<std::array<std::uint32_t, lanes>, 4> state;

    Streams(std::uint64_t seed, std::uint64_t pass) {
        const std::uint64_t stream = mixed(mixed(seed) + pass);
        for (std::size_t lane = 0; lane < lanes; ++lane)
            for (std::size_t word = 0; word < 4; ++word)
                state[word][lane] = static_cast<std::uint32_t>(mixed(stream + 4 * lane + word) >> 32) | 1U;
    }

    std::uint32_t next(std::size_t lane) {
        auto& [s0, s1, s2, s3] = state;
        const std::uint32_t sum = s0[lane] + s3[lane];
        const std::uint32_t result = ((sum << 7) | (sum >> 25)) + s0[lane];
        const std::uint32_t shifted = s1[lane] << 9;
        s2[lane] ^= s0[lane];
        s3[lane] ^= s1[lane];
        s1[lane] ^= s2[lane];
        s0[lane] ^= s3[lane];
        s2[lane] ^= shifted;
        s3[lane] = (s3[lane] << 11) | (s3[lane] >> 21);
        return result;
    }
};

} // namespace

AliasTable::AliasTable(const std::vector<double>& probabilities) {
    const std::size_t count = probabilities.size();
    while ((std::size_t{1} << m_bits) < count)
        ++m_bits;
    const std::size_t slots = std::size_t{1} << m_bits;
    m_threshold.assign(slots, 0xffffffffU);
    m_own.resize(slots);
    m_alias.resize(slots);
    // Vose's construction over slots, in which maps beyond the last have probability 0.
    std::vector<double> share(slots, 0);
    std::vector<std::size_t> small;
    std::vector<std::size_t> large;
    for (std::size_t i = 0; i < slots; ++i) {
        share[i] = i < count ? probabilities[i] * static_cast<double>(slots) : 0;
        m_own[i] = m_alias[i] = static_cast<std::uint32_t>(i);
        (share[i] < 1 ? small : large).push_back(i);
    }
    while (!small.empty() && !large.empty()) {
        const std::size_t poor = small.back();
        const std::size_t rich = large.back();
        small.pop_back();
        m_threshold[poor] = static_cast<std::uint32_t>(std::min(share[poor] * 0x1p32, 4294967295.0));
        m_alias[poor] = static_cast<std::uint32_t>(rich);
        share[rich] -= 1 - share[poor];
        if (share[rich] < 1) {
            large.pop_back();
            small.push_back(rich);
        }
    }
    // What rounding has left over keeps its own map, or the likeliest one where there is none.
    const auto likeliest = static_cast<std::uint32_t>(
        std::max_element(probabilities.begin(), probabilities.end()) - probabilities.begin());
    for (const auto& rest : {small, large})
        for (std::size_t i : rest)
            m_own[i] = m_alias[i] = i < count ? static_cast<std::uint32_t>(i) : likeliest;
}

void drawSamples(const DrawableSystem& system, std::uint64_t seed, std::uint64_t pass, SampleSet& samples) {
    samples.x.resize(2 * SampleSet::size);
    samples.y.resize(2 * SampleSet::size);
    const Coefficients map = boxCoefficients(system);
    const AliasTable table(system.probabilities);
    Streams streams(seed, pass);
    std::array<float, lanes> x{};
    std::array<float, lanes> y{};
    const int skip = burnIn(system);
    const int steps = skip + static_cast<int>(SampleSet::size / lanes);
    for (int step = 0; step < steps; ++step) {
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const std::uint32_t i = table.draw(streams.next(lane));
            const float nextX = map.a[i] * x[lane] + map.b[i] * y[lane] + map.e[i];
            const float nextY = map.c[i] * x[lane] + map.d[i] * y[lane] + map.f[i];
            const bool inside = std::abs(nextX) < escapeRadius && std::abs(nextY) < escapeRadius;
            x[lane] = inside ? nextX : 0;
            y[lane] = inside ? nextY : 0;
        }
        if (step >= skip) {
            const auto at = static_cast<std::ptrdiff_t>(step - skip) * static_cast<std::ptrdiff_t>(lanes);
            std::copy(x.begin(), x.end(), samples.x.begin() + at);
            std::copy(y.begin(), y.end(), samples.y.begin() + at);
        }
    }
    std::copy_n(samples.x.begin(), SampleSet::size, samples.x.begin() + SampleSet::size);
    std::copy_n(samples.y.begin(), SampleSet::size, samples.y.begin() + SampleSet::size);
}

Orbit::Orbit(const DrawableSystem& system, std::uint64_t seed)
    : m_system(&system), m_table(system.probabilities), m_random(mixed(seed)) {
    m_point.x = ifs::fixedPoint(system.maps.front()).value_or(ifs::Vector<2>::Zero());
    m_farAway = 1e6 * (system.halfExtent.maxCoeff() + (m_point.x - system.centre).cwiseAbs().maxCoeff());
    for (int n = 0; n < skipped; ++n)
        step();
}

Orbit::Point Orbit::next() {
    step();
    return m_point;
}

void Orbit::step() {
    const auto random = static_cast<std::uint32_t>(mixed(m_random++) >> 32);
    const std::uint32_t i = m_table.draw(random);
    m_point.x = m_system->maps[i](m_point.x);
    m_point.lastMap = i;
    m_point.addressCoordinate = (i + m_point.addressCoordinate) / static_cast<double>(m_system->maps.size());
    if (!((m_point.x - m_system->centre).cwiseAbs().maxCoeff() <= m_farAway)) m_point.x = m_system->centre;
}

} // namespace attractor
