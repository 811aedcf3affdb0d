// SPDX-License-Identifier: MIT
#include "collage/random_start.h"

#include <Eigen/LU>

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
    // Finaliser of SplitMix64 (Steele, Lea and Flood 2014).
    static std::uint64_t mixed(std::uint64_t x) {
        x += 0x9E3779B97F4A7C15;
        x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9;
        x = (x ^ (x >> 27)) * 0x94D049BB133111EB;
        return x ^ (x >> 31);
    }
    double unit() { return double(m_engine() >> 11) * 0x1p-53; }

    std::mt19937_64 m_engine; // portable, unlike the distributions of the library
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

ifs::AffineMap<2> similarity(double scale, double angle, bool mirrors) {
    const double sigma = mirrors ? -1 : 1;
    const double a = scale * std::cos(angle), b = scale * std::sin(angle);
    return ifs::affineMap(a, -sigma * b, b, sigma * a, 0, 0);
}

// Distance to the target, in cells; for a point beyond the grid, by way of the edge.
double distance(const Target& target, const ifs::Vector<2>& point) {
    const double x = std::clamp(point.x(), 0.0, target.grid.width - 1.0);
    const double y = std::clamp(point.y(), 0.0, target.grid.height - 1.0);
    const std::size_t cell = target.mask.index(int(x), int(y));
    return std::sqrt(double(target.features.square[cell])) + std::abs(point.x() - x) +
           std::abs(point.y() - y);
}

class LedStart {
public:
    LedStart(const Target& target, const Constraints& constraints, std::uint64_t seed, std::uint64_t index)
        : m_target(target), m_constraints(constraints), m_random(seed, index) {
        for (int k = 0; k < samples; ++k)
            m_samples.push_back(cell());
    }

    std::vector<ifs::AffineMap<2>> maps(std::size_t count) {
        const std::size_t leader = count > 1 && m_constraints.isStem(0) ? 1 : 0;
        std::vector<ifs::AffineMap<2>> result(count);
        result[leader] = m_leader = leading(leader);
        m_back = m_leader.linear.inverse();
        for (std::size_t i = 0; i < count; ++i)
            if (i != leader) result[i] = filling(i, std::sqrt(double(count)));
        return result;
    }

private:
    static constexpr int samples = 160, leaders = 60, places = 8, fillings = 10;

    ifs::Vector<2> cell() {
        const std::size_t k = m_random.below(m_target.cells.size());
        return {m_target.columns[k], m_target.rows[k]};
    }
    bool mirrors() { return m_random.below(3) == 0 && m_constraints.mirrors == Mirrors::Allowed; }
    // Mean distance of the target's image from the target.
    double excess(const ifs::AffineMap<2>& map) const {
        double sum = 0;
        for (const ifs::Vector<2>& point : m_samples)
            sum += distance(m_target, map(point));
        return sum / samples;
    }

    ifs::AffineMap<2> leading(std::size_t index) {
        ifs::AffineMap<2> best;
        double least = HUGE_VAL;
        for (int attempt = 0; attempt < leaders; ++attempt) {
            const double scale = m_random.between(0.7, 0.9);
            // Small turns as in plants, or large ones as in spirals.
            const double turn = attempt % 2 == 0 ? 0.2 : std::numbers::pi;
            const bool isMirror = attempt % 8 == 7 && mirrors();
            ifs::AffineMap<2> map = similarity(scale, m_random.between(-turn, turn), isMirror);
            const ifs::Vector<2> fixed = cell();
            map.translation = fixed - map.linear * fixed;
            map = constrained(m_constraints, index, map, m_target.mean);
            const double error = excess(map) / (1 - scale);
            if (error >= least) continue;
            least = error;
            best = map;
        }
        return best;
    }
    // The farthest of a few cells from the images so far.
    ifs::Vector<2> uncovered() {
        ifs::Vector<2> best = m_target.mean;
        double farthest = -1;
        for (int attempt = 0; attempt < places; ++attempt) {
            const ifs::Vector<2> place = cell();
            double free = distance(m_target, m_back * (place - m_leader.translation));
            for (const ifs::Vector<2>& other : m_taken)
                free = std::min(free, (place - other).norm());
            if (free <= farthest) continue;
            farthest = free;
            best = place;
        }
        m_taken.push_back(best);
        return best;
    }
    ifs::AffineMap<2> filling(std::size_t index, double root) {
        const ifs::Vector<2> place = uncovered();
        ifs::AffineMap<2> best;
        double least = HUGE_VAL;
        for (int attempt = 0; attempt < fillings; ++attempt) {
            const double scale = m_random.between(0.3 / root, 1 / root);
            ifs::AffineMap<2> map = similarity(scale, m_random.between(0, 2 * std::numbers::pi), mirrors());
            map.translation = place - map.linear * m_target.mean;
            map = constrained(m_constraints, index, map, m_target.mean);
            const double error = excess(map) / scale;
            if (error >= least) continue;
            least = error;
            best = map;
        }
        return best;
    }

    const Target& m_target;
    const Constraints& m_constraints;
    Random m_random;
    std::vector<ifs::Vector<2>> m_samples; // samples of the target
    ifs::AffineMap<2> m_leader;
    ifs::Matrix<2> m_back; // inverse of its linear part
    std::vector<ifs::Vector<2>> m_taken;
};

} // namespace

std::vector<ifs::AffineMap<2>> ledStart(const Target& target, int maps, const Constraints& constraints,
                                        std::uint64_t seed, std::uint64_t index) {
    return LedStart(target, constraints, seed, index).maps(std::size_t(maps));
}

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
        ifs::AffineMap<2> map = similarity(scale, angle, mirrors);
        map.translation = places.back() - map.linear * target.mean;
        result.push_back(constrained(constraints, std::size_t(i), map, target.mean));
    }
    return result;
}

} // namespace collage
