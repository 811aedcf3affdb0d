// SPDX-License-Identifier: MIT
#include "ifs/extent/support_container.h"

#include "ifs/linear/inverse.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ifs {

namespace {

constexpr std::size_t minSweeps = 2; // sweeps of shrink(), for any number of maps

// Precomputed data for map i in direction g. Only the heights change between sweeps, so the position of A_iᵀg
// in the fan is found once.
template <int Dim> struct PulledBack {
    double offset;      // offset ⟨g, offset_i⟩
    double ofEllipsoid; // bound of A_iᵀg that does not depend on the heights
    typename DirectionFan<Dim>::Combination parts;

    double bound(const std::vector<double>& heights) const {
        double ofFan = 0;
        for (int k = 0; k < Dim; ++k)
            ofFan += parts.factor[k] * heights[parts.index[std::size_t(k)]];
        return std::min(ofFan, ofEllipsoid);
    }
};

} // namespace

template <int Dim> Vector<Dim> solveFixedPoint(const AffineMap<Dim>& map) {
    return (Matrix<Dim>::Identity() - map.linear).inverse() * map.translation;
}

// The H with H_g = max_i constant(g, i) + H(A_iᵀg): linear equations once the maximising maps are known,
// which a few rounds of choosing them find (Howard's policy iteration), however slowly the maps contract. Not
// verified.
template <int Dim>
template <class Constant>
std::vector<double> SupportContainer<Dim>::solved(Constant constant, double tie) const {
    constexpr int rounds = 20;
    const auto& directions = fan.directions();
    const auto count = Eigen::Index(directions.size());
    std::vector<double> solution(directions.size());
    std::vector<std::size_t> chosen(directions.size(), offsets.size());
    for (int round = 0; round < rounds; ++round) {
        Eigen::MatrixXd equations = Eigen::MatrixXd::Identity(count, count);
        Eigen::VectorXd constants(count);
        bool changed = false;
        for (std::size_t g = 0; g < directions.size(); ++g) {
            double most = -std::numeric_limits<double>::infinity();
            std::size_t best = 0;
            for (std::size_t i = 0; i < offsets.size(); ++i) {
                const double height = constant(g, i) + fan.bound(transposed[i] * directions[g], solution);
                if (height > most + (best == chosen[g] ? tie : 0)) {
                    most = height;
                    best = i;
                }
            }
            changed = changed || best != chosen[g];
            chosen[g] = best;
            const auto parts = fan.combination(transposed[best] * directions[g]);
            for (int k = 0; k < Dim; ++k)
                equations(Eigen::Index(g), parts.index[std::size_t(k)]) -= parts.factor[k];
            constants[Eigen::Index(g)] = constant(g, best);
        }
        if (!changed) break;
        const Eigen::VectorXd next = ifs::solution(equations, constants);
        solution.assign(next.begin(), next.end());
    }
    return solution;
}

template <int Dim> bool SupportContainer<Dim>::solve() {
    const auto& directions = fan.directions();
    if (20 * directions.size() * offsets.size() > maxTableWork) return false;
    const auto offset = [&](std::size_t g, std::size_t i) { return directions[g].dot(offsets[i]); };
    std::vector<double> solution = solved(offset, rounding());
    const std::vector<double> margin = solved([](std::size_t, std::size_t) { return 1.0; }, 1e-9);
    const double widest = std::ranges::max(margin);
    if (!(widest > 0 && std::isfinite(widest))) return false;
    const double widening = std::max(1e-9 * radius, 2 * rounding() * widest); // cost of rounding
    for (std::size_t g = 0; g < directions.size(); ++g)
        solution[g] += widening * margin[g] / widest;
    for (std::size_t g = 0; g < directions.size(); ++g) {
        if (!(directions[g].dot(anchor) + rounding() <= solution[g])) return false;
        for (std::size_t i = 0; i < offsets.size(); ++i)
            if (!(offset(g, i) + fan.bound(transposed[i] * directions[g], solution) + rounding() <=
                  solution[g]))
                return false;
    }
    for (std::size_t g = 0; g < directions.size(); ++g)
        heights[g] = std::min(heights[g], solution[g]);
    return true;
}

template <int Dim> void SupportContainer<Dim>::shrink(std::size_t maxWork) {
    const auto& directions = fan.directions();
    const std::size_t sweepWork = directions.size() * offsets.size();
    const auto pulledBack = [&](std::size_t g, std::size_t i) {
        const Vector<Dim> v = transposed[i] * directions[g];
        return PulledBack<Dim>{directions[g].dot(offsets[i]), ellipsoid.bound(v), fan.combination(v)};
    };
    std::vector<PulledBack<Dim>> known; // kept for few maps, which take many sweeps
    if (sweepWork <= maxTableWork)
        for (std::size_t g = 0; g < directions.size(); ++g)
            for (std::size_t i = 0; i < offsets.size(); ++i)
                known.push_back(pulledBack(g, i));
    double progress = radius;
    const std::size_t most = std::max(maxWork, minSweeps * sweepWork);
    for (std::size_t work = 0; work < most && progress > 1e-6 * radius; work += sweepWork) {
        progress = 0;
        for (std::size_t g = 0; g < directions.size(); ++g) {
            double height = -std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < offsets.size(); ++i) {
                const PulledBack<Dim> image =
                    known.empty() ? pulledBack(g, i) : known[g * offsets.size() + i];
                height = std::max(height, image.offset + image.bound(heights));
            }
            height += rounding();
            progress = std::max(progress, heights[g] - height);
            heights[g] = std::min(heights[g], height);
        }
    }
}

template <int Dim> Vector<Dim> SupportContainer<Dim>::recentre() {
    Vector<Dim> middle, half;
    for (int k = 0; k < Dim; ++k) {
        const double high = heights[2 * std::size_t(k)], low = -heights[2 * std::size_t(k) + 1];
        middle[k] = (low + high) / 2;
        half[k] = (high - low) / 2;
    }
    const double moved = rounding();
    if (half.norm() + moved >= radius) return Vector<Dim>::Zero();
    for (std::size_t g = 0; g < heights.size(); ++g)
        heights[g] += moved - fan.directions()[g].dot(middle);
    ellipsoid.centre -= middle;
    ellipsoid.shape *= 1 + 1e-12;
    radius = half.norm() + moved;
    return middle;
}

// The map that the heights say leads farthest in a direction g takes it to another, and so on, round and
// round in the end: a cycle gives a point that its maps leave where it is, and the way there the images of
// that.
template <int Dim> void SupportContainer<Dim>::findPoints() {
    const auto& directions = fan.directions();
    points.assign(directions.size(), anchor);
    m_symbol.assign(directions.size(), 0);
    m_successor.assign(directions.size(), 0);
    for (std::size_t g = 0; g < directions.size(); ++g) {
        double most = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < offsets.size(); ++i)
            if (const double height =
                    directions[g].dot(offsets[i]) + fan.bound(transposed[i] * directions[g], heights);
                height > most) {
                most = height;
                m_symbol[g] = i;
            }
        const auto parts = fan.combination(transposed[m_symbol[g]] * directions[g]);
        Eigen::Index nearest = 0;
        parts.factor.maxCoeff(&nearest);
        m_successor[g] = parts.index[std::size_t(nearest)];
    }
    std::vector<char> isKnown(directions.size(), 0);
    for (std::size_t g = 0; g < directions.size(); ++g) {
        std::vector<std::size_t> way;
        std::size_t end = g;
        for (; !isKnown[end] && std::ranges::find(way, end) == way.end(); end = m_successor[end])
            way.push_back(end);
        if (!isKnown[end]) {
            AffineMap<Dim> cycle = map(m_symbol[end]);
            for (std::size_t k = m_successor[end]; k != end; k = m_successor[k])
                cycle = cycle * map(m_symbol[k]);
            if (const Vector<Dim> fixed = solveFixedPoint<Dim>(cycle); fixed.allFinite()) points[end] = fixed;
            isKnown[end] = 1;
        }
        for (; !way.empty(); way.pop_back())
            if (const std::size_t k = way.back(); !isKnown[k]) {
                points[k] = map(m_symbol[k])(points[m_successor[k]]);
                isKnown[k] = 1;
            }
    }
}

template <int Dim> bool SupportContainer<Dim>::isLoose() const {
    constexpr double bearable = 1.5;
    for (int k = 0; k < Dim; ++k) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const Vector<Dim>& point : points) {
            low = std::min(low, point[k]);
            high = std::max(high, point[k]);
        }
        if (heights[2 * std::size_t(k)] + heights[2 * std::size_t(k) + 1] >
            bearable * (high - low) + rounding())
            return true;
    }
    return false;
}

namespace {

// A real eigenvector of the eigenvalue of largest modulus; 0 where there is none.
Vector<2> leadingDirection(const Matrix<2>& matrix) {
    const double half = matrix.trace() / 2, square = half * half - matrix.determinant();
    if (!(square >= 0)) return Vector<2>::Zero();
    const double value = half < 0 ? half - std::sqrt(square) : half + std::sqrt(square);
    const Matrix<2> rest = matrix - value * Matrix<2>::Identity();
    const Vector<2> row = rest.row(rest.row(0).norm() < rest.row(1).norm() ? 1 : 0);
    return {-row.y(), row.x()};
}

} // namespace

template <int Dim> std::vector<std::vector<std::size_t>> SupportContainer<Dim>::cycles() const {
    std::vector<std::vector<std::size_t>> result;
    // Number of the walk, from 1, that first met each direction.
    std::vector<std::size_t> way(m_successor.size(), 0);
    for (std::size_t g = 0; g < m_successor.size(); ++g) {
        std::size_t k = g;
        for (; way[k] == 0; k = m_successor[k])
            way[k] = g + 1;
        if (way[k] != g + 1) continue;
        std::vector<std::size_t>& cycle = result.emplace_back();
        for (; cycle.empty() || k != cycle.front(); k = m_successor[k])
            cycle.push_back(k);
    }
    return result;
}

template <int Dim> std::vector<Vector<Dim>> SupportContainer<Dim>::cycleDirections() const {
    std::vector<Vector<Dim>> result;
    if constexpr (Dim == 2)
        for (const std::vector<std::size_t>& cycle : cycles()) {
            Matrix<2> around = Matrix<2>::Identity();
            for (const std::size_t g : cycle)
                around = transposed[m_symbol[g]] * around;
            Vector<2> direction = leadingDirection(around);
            for (const std::size_t g : cycle) {
                if (!(direction.norm() > 0 && direction.allFinite())) break;
                direction.normalize();
                result.insert(result.end(), {direction, -direction});
                direction = transposed[m_symbol[g]] * direction;
            }
        }
    return result;
}

template <int Dim>
void SupportContainer<Dim>::lengthen(std::vector<int>& address, std::size_t direction) const {
    constexpr int maxSymbols = 4'000;
    Matrix<Dim> rest = Matrix<Dim>::Identity();
    for (int n = 0; n < maxSymbols && rest.cwiseAbs().maxCoeff() > 0x1p-60; ++n) {
        address.push_back(int(indices[m_symbol[direction]]));
        rest = transposed[m_symbol[direction]] * rest;
        direction = m_successor[direction];
    }
}

template Vector<2> solveFixedPoint<2>(const AffineMap<2>&);
template Vector<3> solveFixedPoint<3>(const AffineMap<3>&);
template struct SupportContainer<2>;
template struct SupportContainer<3>;

} // namespace ifs
