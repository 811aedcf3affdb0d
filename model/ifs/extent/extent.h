// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/support_function.h"
#include "ifs/system/barycentric.h"

#include <array>
#include <span>
#include <type_traits>
#include <vector>

// The box and the simplices around an attractor, from its support function.
namespace ifs {

template <int Dim> struct BoundingBox {
    Vector<Dim> min = Vector<Dim>::Zero();
    Vector<Dim> max = Vector<Dim>::Zero();
    // The attractor lies within this distance outside the box, and reaches each face within it.
    double error = 0;
};
template <int Dim> BoundingBox<Dim> boundingBox(const SupportFunction<Dim>& support, double tolerance = 0);

// {x : ω_j x_j ≥ α_j, Σ ω_j x_j ≤ γ}: legs parallel to the axes, all of one length.
template <int Dim> using Orientation = std::array<int, Dim>; // each +1 or −1

template <int Dim> struct CanonicalSimplex {
    Orientation<Dim> orientation{};
    double leg = 0;        // 1 if the attractor is a single point, where the leg would vanish
    Simplex<Dim> vertices; // V_0 the right-angle corner, V_k = V_0 + ω_k·leg·e_k
    double error = 0;      // bound of the distance from A to the simplex
};
// The canonical simplexes of every orientation, in the order (+,+), (−,+), (+,−), (−,−); in space likewise, x
// changing fastest.
template <int Dim>
std::vector<CanonicalSimplex<Dim>> canonicalSimplices(const SupportFunction<Dim>& support,
                                                      double tolerance = 0);
template <int Dim>
CanonicalSimplex<Dim> canonicalSimplex(const SupportFunction<Dim>& support,
                                       const std::type_identity_t<Orientation<Dim>>& orientation,
                                       double tolerance = 0);
// The one with the smallest leg; ties (relative 1e-12, or within the errors) go to the first, so that every
// tolerance chooses the same one of a symmetric attractor.
template <int Dim>
CanonicalSimplex<Dim> minimalCanonicalSimplex(const SupportFunction<Dim>& support, double tolerance = 0);

// Extents of the image T(A): h_T(A)(u) = h_A(Tᵀu) + ⟨u,t⟩.
template <int Dim>
BoundingBox<Dim> boundingBoxOfImage(const AffineMap<Dim>& transformation, const SupportFunction<Dim>& support,
                                    double tolerance = 0);
template <int Dim>
CanonicalSimplex<Dim> minimalCanonicalSimplexOfImage(const AffineMap<Dim>& transformation,
                                                     const SupportFunction<Dim>& support,
                                                     double tolerance = 0);

// Extents of a union of images of A, of which there is at least one.
template <int Dim>
BoundingBox<Dim> boundingBoxOfImages(std::span<const AffineMap<Dim>> images,
                                     const SupportFunction<Dim>& support, double tolerance = 0);
template <int Dim>
CanonicalSimplex<Dim> minimalCanonicalSimplexOfImages(std::span<const AffineMap<Dim>> images,
                                                      const SupportFunction<Dim>& support,
                                                      double tolerance = 0);

} // namespace ifs
