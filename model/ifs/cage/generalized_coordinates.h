// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/cage/jet.h"
#include "ifs/system/affine_map.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

// Barycentric coordinates with respect to more than three corners: λ_j(x) with Σλ_j = 1, Σλ_j v_j = x,
// λ_j(v_k) = δ_jk, linear along edges. docs/mathematics.md, "Generalized coordinates".
namespace ifs {

constexpr std::size_t maxCorners = 64;

// Returns true for at least three corners, all finite, no two of whose edges touch except neighbours in their
// common corner.
bool isSimplePolygon(std::span<const Vector<2>> polygon);
// Returns true if the polygon is simple and turns the same way at every corner, by no less than an angle of
// 1e-6.
bool isStrictlyConvex(std::span<const Vector<2>> polygon);
double signedArea(std::span<const Vector<2>> polygon); // > 0 if counter-clockwise

enum class Coordinates {
    Wachspress, // strictly convex polygons, in them and on their edges; smooth, positive; poles outside
    MeanValue,  // simple polygons, the whole plane; smooth except at the corners; may be negative
};

// Coordinates of x, one per corner of a polygon of 3 to 64, of either orientation. Always finite: where there
// are no coordinates (degenerate polygons, poles) the corners get equal shares.
std::vector<double> generalizedCoordinates(Coordinates kind, std::span<const Vector<2>> polygon,
                                           const Vector<2>& x);

// The same with their derivatives. nullopt in a corner, where mean value coordinates have none, and in poles.
std::optional<std::vector<Jet>> coordinateJets(Coordinates kind, std::span<const Vector<2>> polygon,
                                               const Vector<2>& x);

// The affine map for which Σ|to_j − map(from_j)|² is least; interpolates Dim + 1 points. Points that lie on
// one line (in one plane) are stretched across it as much as `previous` does.
template <int Dim>
AffineMap<Dim> affineFit(std::span<const Vector<Dim>> from, std::span<const Vector<Dim>> to,
                         const Matrix<Dim>& previous = Matrix<Dim>::Identity());

// x ↦ Σ λ_j(x) v_j′: takes the polygon v to the polygon v′. Exactly the affine fit when v′ is an affine image
// of v. The same bits on every machine.
class PolygonDeformation {
public:
    // Both polygons must have equally many corners, 3 to 64.
    PolygonDeformation(Coordinates kind, std::span<const Vector<2>> from, std::span<const Vector<2>> to);

    Vector<2> operator()(const Vector<2>& x) const; // finite for finite x

    // F(x + δ) = value + linear·δ + F″(δ, δ)/2 + F‴(δ, δ, δ)/6 + O(|δ|⁴)
    struct Expansion {
        Vector<2> value = Vector<2>::Zero();
        Matrix<2> linear = Matrix<2>::Zero();
        // xx xy yy
        std::array<Vector<2>, 3> second{Vector<2>::Zero(), Vector<2>::Zero(), Vector<2>::Zero()};
        // xxx xxy xyy yyy
        std::array<Vector<2>, 4> third{Vector<2>::Zero(), Vector<2>::Zero(), Vector<2>::Zero(),
                                       Vector<2>::Zero()};
    };
    // Nullopt under the same conditions as coordinateJets().
    std::optional<Expansion> expansion(const Vector<2>& x) const;
    Expansion expansion(const Vector<2>& x, std::span<const Jet> coordinates) const;

    const AffineMap<2>& fit() const { return m_fit; }
    Coordinates coordinates() const { return m_kind; }
    std::span<const Vector<2>> from() const { return m_from; }
    std::span<const Vector<2>> residuals() const { return m_residuals; } // v_j′ − fit(v_j)

private:
    Coordinates m_kind;
    std::vector<Vector<2>> m_from;
    AffineMap<2> m_fit;
    std::vector<Vector<2>> m_residuals;
    double m_size = 0;
};

} // namespace ifs
