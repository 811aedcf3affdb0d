// SPDX-License-Identifier: MIT
#include "attractor/samples/address_strata.h"

#include "attractor/arithmetic/arithmetic.h"

#include <algorithm>
#include <limits>

namespace attractor {

namespace {

constexpr int guideBits = 13;
constexpr std::size_t maxStrata = 8192; // limit that fits into the cache
constexpr int maxDepth = 64;

ifs::AffineMap<2> inBox(const PreparedSystem& system, const ifs::AffineMap<2>& map) {
    const ifs::Vector<2>& half = system.halfExtent;
    const ifs::Vector<2> shift = map(system.centre) - system.centre;
    return ifs::affineMap(map.linear(0, 0), map.linear(0, 1) * half.y() / half.x(),
                          map.linear(1, 0) * half.x() / half.y(), map.linear(1, 1), shift.x() / half.x(),
                          shift.y() / half.y());
}

bool isSame(const PreparedSystem& a, const PreparedSystem& b) {
    return a.maps == b.maps && a.probabilities == b.probabilities && a.centre == b.centre &&
           a.halfExtent == b.halfExtent && a.note == b.note;
}

} // namespace

struct AddressStrata::Node {
    ifs::AffineMap<2> map;
    double probability = 1;
    int depth = 0;
};

AddressStrata::Node AddressStrata::child(const Node& node, std::size_t map) const {
    return {node.map * m_maps.maps[map], node.probability * m_maps.probabilities[map], node.depth + 1};
}

// Number of strata whose measure is at most the threshold; some number above `most` if there are more.
std::size_t AddressStrata::leaves(const Node& node, double threshold, std::size_t most) const {
    if (node.probability <= threshold || node.depth >= maxDepth) return 1;
    std::size_t count = 0;
    for (std::size_t i = 0; i < m_maps.maps.size() && count <= most; ++i)
        count +=
            leaves({{}, node.probability * m_maps.probabilities[i], node.depth + 1}, threshold, most - count);
    return count;
}

void AddressStrata::add(const Node& node, double threshold, double& before) {
    if (!(node.probability <= threshold || node.depth >= maxDepth)) {
        for (std::size_t i = 0; i < m_maps.maps.size(); ++i)
            add(child(node, i), threshold, before);
        return;
    }
    const ifs::AffineMap<2>& w = node.map;
    before += node.probability;
    m_strata.push_back({static_cast<float>(w.linear(0, 0)), static_cast<float>(w.linear(0, 1)),
                        static_cast<float>(w.linear(1, 0)), static_cast<float>(w.linear(1, 1)),
                        static_cast<float>(w.translation.x()), static_cast<float>(w.translation.y()),
                        static_cast<std::uint32_t>(std::clamp(before * 0x1p32, 1.0, 0x1p32) - 1)});
}

void AddressStrata::makeGuide() {
    m_strata.back().last = std::numeric_limits<std::uint32_t>::max();
    m_guide.resize(std::size_t{1} << guideBits);
    std::uint32_t stratum = 0;
    for (std::size_t k = 0; k < m_guide.size(); ++k) {
        while (m_strata[stratum].last < k << (32 - guideBits))
            ++stratum;
        m_guide[k] = stratum;
    }
}

bool AddressStrata::isOf(const PreparedSystem& system) const {
    return !m_strata.empty() && isSame(system, m_system);
}

void AddressStrata::follow(const PreparedSystem& system) {
    if (isOf(system)) return;
    m_system = system;
    m_strata.clear();
    m_maps = system;
    for (ifs::AffineMap<2>& map : m_maps.maps)
        map = inBox(system, map);
    double threshold = 1;
    if (system.note == RenderNote::None && system.meanLogarithm < 0)
        for (double finer = 0.5; leaves({}, finer, maxStrata) <= maxStrata; finer /= 2) {
            threshold = finer;
            if (finer * static_cast<double>(SampleSet::size) <= 1) break;
        }
    double before = 0;
    add({}, threshold, before);
    makeGuide();
}

void AddressStrata::spread(std::uint64_t random, SampleSet& samples) const {
    if (m_strata.size() < 2) return;
    constexpr std::uint32_t golden = 0x9e3779b9; // multiples are evenly distributed for any number of them
    auto u = static_cast<std::uint32_t>(mixed(random) >> 32);
    float* const x = samples.x.data();
    float* const y = samples.y.data();
    for (std::size_t k = 0; k < SampleSet::size; ++k, u += golden) {
        const Stratum* s = m_strata.data() + m_guide[u >> (32 - guideBits)];
        while (s->last < u)
            ++s;
        const float px = x[k];
        const float py = y[k];
        x[k] = (s->xx * px + s->xy * py) + s->x;
        y[k] = (s->yx * px + s->yy * py) + s->y;
    }
}

} // namespace attractor
