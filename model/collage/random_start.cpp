// SPDX-License-Identifier: MIT
#include "collage/random_start.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace collage {

namespace {

class Random {
public:
    Random(std::uint64_t seed, std::uint64_t index) : m_engine(mixed(seed + mixed(index))) {}

    double between(double least, double greatest) { return least + (greatest - least) * unit(); }
    std::size_t below(std::size_t count) { return std::min(count - 1, std::size_t(unit() * double(count))); }

private:
    // The finaliser of SplitMix64 (Steele, Lea and Flood 2014).
    static std::uint64_t mixed(std::uint64_t x) {
        x += 0x9E3779B97F4A7C15;
        x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9;
        x = (x ^ (x >> 27)) * 0x94D049BB133111EB;
        return x ^ (x >> 31);
    }
    double unit() { return double(m_engine() >> 11) * 0x1p-53; }

    std::mt19937_64 m_engine; // the same everywhere, unlike the distributions of the library
};

// The farthest from the others of a few cells.
ifs::Vector<2> freePlace(const Target& target, const std::vector<ifs::Vector<2>>& taken, Random& random) {
    ifs::Vector<2> best = target.mean;
    double bestDistance = -1;
    for (int attempt = 0; attempt < 3; ++attempt) {
        const std::size_t k = random.below(target.cells.size());
        const ifs::Vector<2> place(target.columns[k], target.rows[k]);
        double distance = HUGE_VAL;
        for (const ifs::Vector<2>& other : taken)
            distance = std::min(distance, (place - other).norm());
        if (distance <= bestDistance) continue;
        best = place;
        bestDistance = distance;
    }
    return best;
}

} // namespace

std::vector<ifs::AffineMap<2>> randomStart(const Target& target, int maps, const Constraints& constraints,
                                           std::uint64_t seed, std::uint64_t index) {
    Random random(seed, index);
    std::vector<ifs::Vector<2>> places;
    std::vector<ifs::AffineMap<2>> result;
    const double root = std::sqrt(double(maps));
    for (int i = 0; i < maps; ++i) {
        places.push_back(freePlace(target, places, random));
        const double scale = random.between(0.5 / root, std::min(0.75, 1.4 / root));
        const double angle = random.between(0, 2 * std::numbers::pi);
        const bool mirrors = random.below(3) == 0 && constraints.mirrors == Mirrors::Allowed;
        const double sigma = mirrors ? -1 : 1;
        const double a = scale * std::cos(angle), b = scale * std::sin(angle);
        ifs::AffineMap<2> map = ifs::affineMap(a, -sigma * b, b, sigma * a, 0, 0);
        map.translation = places.back() - map.linear * target.mean;
        result.push_back(constrained(constraints, std::size_t(i), map, target.mean));
    }
    return result;
}

} // namespace collage
