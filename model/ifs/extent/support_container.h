// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/direction_fan.h"
#include "ifs/extent/outline.h"
#include "ifs/linear/rounding.h"
#include "ifs/system/affine_map.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace ifs {

// Bounds evaluated at most while a container is made smaller, unless the maps are too many for that.
inline constexpr std::size_t maxTableWork = 60'000;

// (I − A)⁻¹t of x ↦ A x + t; not finite when no single point is fixed.
template <int Dim> Vector<Dim> solveFixedPoint(const AffineMap<Dim>& map);

// {centre + shape·y : |y| ≤ 1}
template <int Dim> struct Ellipsoid {
    Vector<Dim> centre;
    Matrix<Dim> shape;

    // max ⟨v,x⟩ over the ellipsoid.
    double bound(const Vector<Dim>& v) const { return v.dot(centre) + (shape.transpose() * v).norm(); }
};

// The attractor inside both an ellipsoid and the polytope {x : ⟨g,x⟩ ≤ H_g} over the directions g of a fan,
// with a point of it for each direction. Everything is seen from `centre`, where the maps are
// x ↦ A x + offset; vectors u travel by the transposed matrices. docs/mathematics.md, "Support table".
template <int Dim> struct SupportContainer {
    Vector<Dim> centre;
    std::vector<std::size_t> indices; // indices of these maps among all
    std::vector<Matrix<Dim>> transposed;
    std::vector<Vector<Dim>> offsets;
    Vector<Dim> anchor; // point of the attractor
    Ellipsoid<Dim> ellipsoid;
    double radius = 0;  // radius about the centre
    double longest = 1; // maximum of 1 and all ‖A_i‖
    DirectionFan<Dim> fan;
    std::vector<double> heights;     // heights H_g
    std::vector<Vector<Dim>> points; // points of the attractor, far out in each direction
    // States of a search that are this close, relative to |v|, can never be one below the other.
    double mergeLimit = 0;

    explicit SupportContainer(DirectionFan<Dim> directions) : fan(std::move(directions)) {}

    double bound(const Vector<Dim>& v) const { return std::min(fan.bound(v, heights), ellipsoid.bound(v)); }

    // bound(v), and the point that is farthest in direction v among those of the nearest directions.
    Outline::Bracket bracket(const Vector<Dim>& v) const {
        const auto parts = fan.combination(v);
        Outline::Bracket result{0, -std::numeric_limits<double>::infinity(), 0};
        for (int k = 0; k < Dim; ++k) {
            const std::size_t direction = parts.index[std::size_t(k)];
            result.upper += parts.factor[k] * heights[direction];
            if (const double height = v.dot(points[direction]); height > result.lower) {
                result.lower = height;
                result.point = direction;
            }
        }
        result.upper = std::min(result.upper, ellipsoid.bound(v));
        return result;
    }

    const Vector<Dim>& point(std::size_t direction) const { return points[direction]; }

    // Appends the address of the point of a direction, as far as a double can tell.
    void lengthen(std::vector<int>& address, std::size_t direction) const;

    // Bound of the rounding error of a height.
    double rounding() const { return 16 * roundingUnit * radius * longest; }

    // Lowers the heights to the smallest polytope with these normals that every map takes into itself, a
    // little widened and then verified: the attractor lies in it when it holds any point at all, and then the
    // anchor too. False, and nothing is changed, when the fan is too coarse for maps that hardly contract, or
    // the maps are too many.
    bool solve();

    // H_g ← max_i ⟨g,offset_i⟩ + H(A_iᵀg) as long as it lowers the H: from any container to the same
    // polytope. `maxWork`: bounds evaluated at most.
    void shrink(std::size_t maxWork = maxTableWork);

    // Moves heights, ellipsoid and radius to the middle of the box if that lessens the radius; returns by how
    // far, so that centre, offsets and anchor can follow.
    Vector<Dim> recentre();

    // Fills `points`.
    void findPoints();

    // Returns true if the box of the points is much smaller than that of the heights.
    bool isLoose() const;

    // The directions, and their opposites, that the maps of each cycle of findPoints() leave as they are.
    // In the plane alone; none in space.
    std::vector<Vector<Dim>> cycleDirections() const;

private:
    AffineMap<Dim> map(std::size_t i) const { return {transposed[i].transpose(), offsets[i]}; }
    template <class Constant> std::vector<double> solved(Constant constant, double tie) const;

    std::vector<std::vector<std::size_t>> cycles() const; // cycles of directions
    // For each direction, the map and the direction whose point it takes to this one's.
    std::vector<std::size_t> m_symbol, m_successor;
};

} // namespace ifs
