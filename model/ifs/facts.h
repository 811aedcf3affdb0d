// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/attractor_existence.h"
#include "ifs/extreme_points.h"
#include "ifs/iterated_function_system.h"
#include "ifs/moments.h"
#include "ifs/support_function.h"

#include <optional>
#include <vector>

namespace ifs {

// What can be said for certain about a system; nullopt where nothing can.
template <int Dim> struct Facts {
    std::vector<double> probabilities; // one for each map, 0 for a map that takes no part
    ActiveMaps<Dim> active;
    Existence existence;             // of the active maps
    std::optional<Vector<Dim>> mean; // can exist without the covariance
    std::optional<Moments<Dim>> moments;
    std::optional<SupportFunction<Dim>> support;
    std::optional<BoundingBox<Dim>> box;
    std::optional<CanonicalSimplex<Dim>> simplex; // the minimal one
    std::optional<HullIn<Dim>> hull;
    // In the plane, for each vertex of the hull its address when it is eventually periodic and proved.
    std::vector<std::optional<PeriodicPoint>> extremePoints;
    std::optional<double> similarityDimension;
    std::optional<double> affinityDimension; // not above Dim; in space, of similarities only
};

// `hullTolerance` in the system's own units; nullopt: 1e-6 of the diagonal of the bounding box.
template <int Dim>
Facts<Dim> factsOf(const IteratedFunctionSystem<Dim>& system, std::optional<double> hullTolerance = {});

// All but the affinity dimension and the addresses of the hull, which can take longer than the rest.
template <int Dim>
Facts<Dim> geometricFacts(const IteratedFunctionSystem<Dim>& system,
                          std::optional<double> hullTolerance = {});

// Those of the attractor's image under an affine map T: of the maps T∘w∘T⁻¹, whose attractor it is. Extents
// come from the support function of the code (which is kept), so that they are as sharp however T leans. An
// image that is flat has extents and moments, but no maps and no dimension.
Facts<2> moved(const AffineMap<2>& transformation, const Facts<2>& facts);

// Extents of the image T(A): h_T(A)(u) = h_A(Tᵀu) + ⟨u,t⟩.
template <int Dim>
BoundingBox<Dim> boundingBoxOfImage(const AffineMap<Dim>& transformation, const SupportFunction<Dim>& support,
                                    double tolerance = 0);
template <int Dim>
CanonicalSimplex<Dim> minimalCanonicalSimplexOfImage(const AffineMap<Dim>& transformation,
                                                     const SupportFunction<Dim>& support,
                                                     double tolerance = 0);

} // namespace ifs
