// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/affine_map.h"
#include "ifs/barycentric.h"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

// Certified extents of an attractor, from h_A(u) = max over x in A of ⟨u,x⟩ by branch and bound over
// addresses with merging of equal states. docs/mathematics.md, "Support function".
namespace ifs {

template <int Dim> struct SupportValue {
    double value = 0;         // a value attained on the attractor (up to rounding): value ≤ h_A(u)
    double error = 0;         // h_A(u) ≤ value + error, certified, rounding included
    Vector<Dim> point;        // a point of the attractor with ⟨u, point⟩ = value
    std::vector<int> address; // its address as far as it is known, outermost first
};

class Outline;

// Answers h_A(u) for one list of maps. Construction classifies the system and finds a container of the
// attractor.
template <int Dim> class SupportFunction {
public:
    // nullopt when the maps are not hyperbolic or eventually contractive.
    static std::optional<SupportFunction> of(std::span<const AffineMap<Dim>> maps);

    // Stops at `tolerance` (absolute, ≥ a few ulps of the size) or when `maxNodes` words are open; either way
    // the error returned is certified. u need not be unit; u = 0 gives 0. In the plane, a known outline of
    // the attractor as seen from centre() shortens the search: the better it is, the more.
    SupportValue<Dim> operator()(const Vector<Dim>& u, double tolerance = 0, int maxNodes = 200'000,
                                 const Outline* known = nullptr) const;

    // What is known of the attractor after the first question, seen from centre(): good enough for most
    // searches to be short. In the plane; nullptr in space.
    const Outline* outline() const;

    // A ⊂ Ball(centre, radius).
    const Vector<Dim>& centre() const { return m_centre; }
    double radius() const { return m_radius; }
    Vector<Dim> pointOfAttractor() const; // the fixed point of the first map
    const std::vector<AffineMap<Dim>>& maps() const { return m_maps; }
    // Places among the maps of those that can lead to extreme points: of many in the plane, the outer ones.
    const std::vector<std::size_t>& mapsToTheHull() const;

    // max ‖A_i‖_* < 1 and C with |x| ≤ ‖x‖_* ≤ C|x|, as contractingNorm() found them.
    double contractivity() const { return m_contractivity; }
    double normEquivalence() const { return m_normEquivalence; }

    // What rounding may have cost a support value at |u| = 1, over addresses of that many symbols.
    double roundingError(int depth) const;

private:
    SupportFunction() = default;
    Vector<Dim> follow(const std::vector<int>& address, const Vector<Dim>& start) const;
    template <class Known>
    SupportValue<Dim> search(const Known& known, const Vector<Dim>& u, double tolerance, int maxNodes) const;

    std::vector<AffineMap<Dim>> m_maps;
    Vector<Dim> m_centre = Vector<Dim>::Zero();
    double m_radius = 0;
    double m_contractivity = 0;
    double m_normEquivalence = 1;
    struct Container;
    std::shared_ptr<const Container> m_container;
};

template <int Dim> struct BoundingBox {
    Vector<Dim> min = Vector<Dim>::Zero();
    Vector<Dim> max = Vector<Dim>::Zero();
    double error =
        0; // the attractor lies within this distance outside the box, and reaches each face within it
};
template <int Dim> BoundingBox<Dim> boundingBox(const SupportFunction<Dim>& support, double tolerance = 0);

// {x : ω_j x_j ≥ α_j, Σ ω_j x_j ≤ γ}: legs parallel to the axes, all of one length.
template <int Dim> using Orientation = std::array<int, Dim>; // each +1 or −1

template <int Dim> struct CanonicalSimplex {
    Orientation<Dim> orientation{};
    double leg = 0;        // 1 when the attractor is a single point and the leg would vanish
    Simplex<Dim> vertices; // V_0 the right-angle corner, V_k = V_0 + ω_k·leg·e_k
    double error = 0;      // A lies within this distance of the simplex
};
// Of every orientation, in the order (+,+), (−,+), (+,−), (−,−); in space likewise, x changing fastest.
template <int Dim>
std::vector<CanonicalSimplex<Dim>> canonicalSimplices(const SupportFunction<Dim>& support,
                                                      double tolerance = 0);
template <int Dim>
CanonicalSimplex<Dim> canonicalSimplex(const SupportFunction<Dim>& support,
                                       const std::type_identity_t<Orientation<Dim>>& orientation,
                                       double tolerance = 0);
// The one with the smallest leg; ties (relative 1e-12) go to the first.
template <int Dim>
CanonicalSimplex<Dim> minimalCanonicalSimplex(const SupportFunction<Dim>& support, double tolerance = 0);

// Extreme points of the convex hull to a tolerance, counter-clockwise, each on the attractor.
struct ConvexHull {
    std::vector<Vector<2>> vertices; // 1 or 2 for a point or a segment
    double area = 0;
    double error = 0; // conv A lies within this distance of the polygon (a-posteriori certificate)
};
ConvexHull convexHull(const SupportFunction<2>& support, double tolerance);

// The same in space. A set within a plane, on a line or in one point has volume 0, and facets only on one
// side of the plane, or none.
struct ConvexHull3 {
    std::vector<Vector<3>> vertices;
    std::vector<std::array<int, 3>> facets; // triangles, counter-clockwise seen from outside
    double volume = 0;
    double error = 0;
};
ConvexHull3 convexHull(const SupportFunction<3>& support, double tolerance);

template <int Dim> using HullIn = std::conditional_t<Dim == 2, ConvexHull, ConvexHull3>;

} // namespace ifs
