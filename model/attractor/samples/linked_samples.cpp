// SPDX-License-Identifier: MIT
#include "attractor/samples/linked_samples.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/kernels/kernels.h"
#include "attractor/samples/chaos_game.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace attractor {

namespace {

class SampleDraw {
public:
    SampleDraw(const PreparedSystem& system, std::uint64_t stream, std::vector<SampleSet>& sets)
        : m_system(system), m_sets(sets), m_counts(sets.size(), 0), m_random(stream) {
        const double hx = system.halfExtent.x(), hy = system.halfExtent.y();
        for (const ifs::AffineMap<2>& map : system.maps) {
            const ifs::Vector<2> shift = map(system.centre) - system.centre;
            m_maps.push_back({float(map.linear(0, 0)), float(map.linear(0, 1) * hy / hx),
                              float(map.linear(1, 0) * hx / hy), float(map.linear(1, 1)),
                              float(shift.x() / hx), float(shift.y() / hy)});
        }
    }

    void run() {
        const std::vector<AliasTable> next = nextMaps(m_system);
        for (const auto& part : m_system.chain.closed)
            runPart(part, next);
        complete();
    }

private:
    struct Point {
        float x = 0, y = 0;
    };

    std::uint32_t random() { return static_cast<std::uint32_t>(mixed(m_random++) >> 32); }

    Point applied(std::size_t map, const Point& at) const {
        const std::array<float, 6>& c = m_maps[map];
        const Point to{c[0] * at.x + c[1] * at.y + c[4], c[2] * at.x + c[3] * at.y + c[5]};
        return std::abs(to.x) < escapeRadius && std::abs(to.y) < escapeRadius ? to : Point{};
    }

    bool isFull(std::size_t set) const { return m_counts[set] == SampleSet::size; }

    void keep(std::size_t set, const Point& point) {
        if (isFull(set)) return;
        m_sets[set].x[m_counts[set]] = point.x;
        m_sets[set].y[m_counts[set]++] = point.y;
    }

    // Runs parallel orbits until all sets of the part are full, or the rest is left to complete().
    void runPart(const std::vector<std::size_t>& part, const std::vector<AliasTable>& next) {
        std::vector<double> start(m_maps.size(), 0);
        double total = 0;
        for (const std::size_t i : part)
            total += start[i] = m_system.chain.stationary[i];
        for (double& share : start)
            share /= total;
        const AliasTable first(start);
        const double forgets =
            m_system.meanLogarithm < 0 ? std::clamp(16 / -m_system.meanLogarithm, 32.0, 2048.0) : 256;
        const std::size_t most = 4 * part.size() * SampleSet::size / SampleSet::lanes;
        std::array<Point, SampleSet::lanes> points{};
        std::array<std::uint32_t, SampleSet::lanes> states{};
        for (std::size_t lane = 0; lane < SampleSet::lanes; ++lane)
            states[lane] = first.draw(random());
        for (std::size_t step = 0; step < std::size_t(forgets) + most; ++step) {
            for (std::size_t lane = 0; lane < SampleSet::lanes; ++lane) {
                const std::uint32_t map = next[states[lane]].draw(random());
                if (step >= std::size_t(forgets)) keep(m_system.sampleSetOf[map], points[lane]);
                points[lane] = applied(map, points[lane]);
                states[lane] = map;
            }
            if (std::ranges::all_of(part, [this](std::size_t i) { return isFull(m_system.sampleSetOf[i]); }))
                break;
        }
    }

    // Completes sets of rarely drawn maps from the maps before them.
    void complete() {
        const std::size_t n = m_maps.size();
        std::vector<std::size_t> used(m_sets.size(), 0);
        const auto advance = [&](std::size_t j) {
            const std::size_t set = m_system.sampleSetOf[j];
            const auto row = m_system.chain.backward.begin() + std::ptrdiff_t(j * n);
            const AliasTable before(std::vector<double>(row, row + std::ptrdiff_t(n)));
            for (std::size_t k = 0; k < 2 * SampleSet::size && !isFull(set); ++k) {
                const std::uint32_t map = before.draw(random());
                const std::size_t from = m_system.sampleSetOf[map];
                if (m_counts[from] == 0) continue;
                const std::size_t at = used[from]++ % m_counts[from];
                keep(set, applied(map, {m_sets[from].x[at], m_sets[from].y[at]}));
            }
        };
        for (std::size_t round = 0; round <= n; ++round) {
            if (std::ranges::all_of(m_counts, [](std::size_t count) { return count == SampleSet::size; }))
                break;
            for (std::size_t j = 0; j < n; ++j)
                advance(j);
        }
    }

    const PreparedSystem& m_system;
    std::vector<SampleSet>& m_sets;
    std::vector<std::size_t> m_counts;        // number of points of each set so far
    std::vector<std::array<float, 6>> m_maps; // a b c d e f in box coordinates
    std::uint64_t m_random;
};

// Extremes, and the beginning once more.
void finish(SampleSet& set) {
    const auto [lowX, highX] = std::minmax_element(set.x.begin(), set.x.begin() + SampleSet::size);
    const auto [lowY, highY] = std::minmax_element(set.y.begin(), set.y.begin() + SampleSet::size);
    set.lowX = *lowX;
    set.highX = *highX;
    set.lowY = *lowY;
    set.highY = *highY;
    for (auto* values : {&set.x, &set.y}) {
        std::copy_n(values->begin(), SampleSet::size, values->begin() + SampleSet::size);
        std::copy_n(values->begin(), kernels::chunk, values->end() - kernels::chunk);
    }
}

} // namespace

void drawLinkedSamples(const PreparedSystem& system, std::uint64_t seed, std::uint64_t pass,
                       std::vector<SampleSet>& sets) {
    for (SampleSet& set : sets)
        for (auto* values : {&set.x, &set.y})
            values->assign(2 * SampleSet::size + kernels::chunk, 0);
    SampleDraw(system, mixed(mixed(seed) + pass), sets).run();
    for (SampleSet& set : sets)
        finish(set);
}

} // namespace attractor
