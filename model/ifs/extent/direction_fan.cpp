// SPDX-License-Identifier: MIT
#include "ifs/extent/direction_fan.h"

#include "ifs/extent/polygon.h"

#include <algorithm>
#include <iterator>

namespace ifs {

template <int Dim> DirectionFan<Dim>::DirectionFan(int depth) {
    constexpr std::size_t orthants = std::size_t(1) << Dim;
    m_splits.resize(orthants << depth);
    m_cones.resize(orthants << depth);
    for (int k = 0; k < Dim; ++k)
        for (const double sign : {1.0, -1.0})
            m_directions.push_back(sign * Vector<Dim>::Unit(k));
    for (std::size_t orthant = 0; orthant < orthants; ++orthant) {
        Cone cone;
        for (std::size_t k = 0; k < Dim; ++k)
            cone[k] = std::uint32_t(2 * k + (orthant >> (Dim - 1 - k) & 1));
        divide(orthants + orthant, cone);
    }
}

namespace {

// Counter-clockwise from e_1 on.
bool comesFirst(const Vector<2>& a, const Vector<2>& b) {
    const auto isBelow = [](const Vector<2>& v) { return v.y() < 0 || (v.y() == 0 && v.x() < 0); };
    return isBelow(a) != isBelow(b) ? isBelow(b) : cross(a, b) > 0;
}

} // namespace

template <int Dim> DirectionFan<Dim>::DirectionFan(const std::vector<Vector<Dim>>& directions) {
    for (int k = 0; k < Dim; ++k)
        for (const double sign : {1.0, -1.0})
            m_directions.push_back(sign * Vector<Dim>::Unit(k));
    for (const Vector<Dim>& direction : directions)
        index(direction.normalized());
    for (std::uint32_t k = 0; k < m_directions.size(); ++k)
        m_around.push_back(k);
    if constexpr (Dim == 2)
        std::ranges::sort(m_around, comesFirst, [this](std::uint32_t k) { return m_directions[k]; });
}

// v = p_g g + p_h h with the directions g and h beside it. However near to each other they are, what rounding
// leaves of v is no more than a few ulps of |v|: p_g is chosen last, and a negative share means that v is
// parallel to the other.
template <int Dim> auto DirectionFan<Dim>::between(const Vector<Dim>& v) const -> Combination {
    Combination result;
    if constexpr (Dim == 2) {
        const auto after = std::ranges::upper_bound(m_around, v, comesFirst,
                                                    [this](std::uint32_t k) { return m_directions[k]; });
        result.index = {after == m_around.begin() ? m_around.back() : *std::prev(after),
                        after == m_around.end() ? m_around.front() : *after};
        const Vector<2>& g = m_directions[result.index[0]];
        const Vector<2>& h = m_directions[result.index[1]];
        const double ofH = cross(g, v) / cross(g, h), ofG = g.dot(v - ofH * h);
        result.factor = {ofG, ofH};
        if (!(ofH >= 0)) result.factor = {std::max(0.0, g.dot(v)), 0};
        if (!(ofG >= 0)) result.factor = {0, std::max(0.0, h.dot(v))};
    }
    return result;
}

template <int Dim> void DirectionFan<Dim>::divide(std::size_t cell, const Cone& cone) {
    if (cell >= m_splits.size()) {
        m_cones[cell - m_splits.size()] = cone;
        return;
    }
    const Split split = m_splits[cell] = widestAngle(cone);
    const std::size_t a = std::size_t(split.a), b = std::size_t(split.b);
    const std::uint32_t between = index((m_directions[cone[a]] + m_directions[cone[b]]) / split.length);
    Cone half = cone;
    half[b] = between;
    divide(2 * cell, half);
    half = cone;
    half[a] = between;
    divide(2 * cell + 1, half);
}

// The wider the angle, the shorter the sum of two unit vectors.
template <int Dim> auto DirectionFan<Dim>::widestAngle(const Cone& cone) const -> Split {
    Split widest{0, 1, 2};
    for (int a = 0; a < Dim; ++a)
        for (int b = a + 1; b < Dim; ++b) {
            const double length =
                (m_directions[cone[std::size_t(a)]] + m_directions[cone[std::size_t(b)]]).norm();
            if (length < widest.length) widest = {a, b, length};
        }
    return widest;
}

template <int Dim> std::uint32_t DirectionFan<Dim>::index(const Vector<Dim>& direction) {
    const auto isSame = [&](const Vector<Dim>& known) { return (known - direction).squaredNorm() < 1e-24; };
    const auto known = std::ranges::find_if(m_directions, isSame);
    const auto position = std::uint32_t(known - m_directions.begin());
    if (known == m_directions.end()) m_directions.push_back(direction);
    return position;
}

template class DirectionFan<2>;
template class DirectionFan<3>;

} // namespace ifs
