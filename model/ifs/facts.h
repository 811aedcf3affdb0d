// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/dimension/measure.h"
#include "ifs/dimension/moments.h"
#include "ifs/existence/attractor_existence.h"
#include "ifs/extent/convex_hull.h"
#include "ifs/extent/convex_hull_3d.h"
#include "ifs/extent/extent.h"
#include "ifs/extent/extreme_points.h"
#include "ifs/separation/open_set.h"
#include "ifs/separation/piece_contacts.h"
#include "ifs/separation/surd_map.h"
#include "ifs/system/iterated_function_system.h"
#include "ifs/tiles/tile.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <vector>

namespace ifs {

template <int Dim> using HullIn = std::conditional_t<Dim == 2, ConvexHull, ConvexHull3>;

// Quantities that an invertible affine map of the attractor leaves as they are, areas apart.
struct Invariants {
    std::optional<double> entropy;          // nats, for the probabilities
    std::optional<double> lyapunovExponent; // similarities only
    std::optional<double> measureDimension; // similarities only; an upper bound if pieces overlap
    // True if the dimension of the affine hull replaces a greater value.
    bool isMeasureDimensionCapped = false;
    std::optional<JointSpectralRadius> jointSpectralRadius; // finite maps only
    std::optional<PieceContacts> contacts;                  // systems with extents only
    std::optional<OpenSetFacts> openSet;                    // present together with `contacts`
    std::optional<DimensionSpectrum> spectrum;              // similarities under the open set condition only
    std::optional<Tile> tile;                               // plane only
};

// Facts that can take long.
enum class LongFact {
    Existence, // all other facts but the moments depend on it
    Extents,   // box and simplex
    JointSpectralRadius,
    Contacts,
    Hull,
    AffinityDimension,
    ExtremePoints,
};

// Processor time allowed for the long facts; nullopt: until they are found, or proved to be too hard.
struct FactLimits {
    using Time = std::optional<std::chrono::duration<double>>;

    bool withAffinityDimension = true;
    Time perFact = {};
    Time together = {}; // processor time after which no further fact is begun
};

// Certified facts about a system; nullopt where nothing is certain. Facts of linked maps are those of the
// linked system; they have no support function, contacts, joint spectral radius, periodic extreme points, nor
// an affinity dimension unless all maps are similarities.
template <int Dim> struct Facts {
    std::vector<double> probabilities; // one for each map, 0 for a map that takes no part
    ActiveMaps<Dim> active;
    std::vector<SurdMap> typed;    // active maps without rounding; empty if nothing is typed
    Existence existence;           // existence for the active maps
    bool isPoint = false;          // true: the attractor is proved to be a single point
    std::optional<Mean<Dim>> mean; // possible without the covariance
    std::optional<Moments<Dim>> moments;
    std::optional<SupportFunction<Dim>> support;
    std::optional<BoundingBox<Dim>> box;
    std::optional<CanonicalSimplex<Dim>> simplex; // minimal simplex
    std::optional<HullIn<Dim>> hull;
    // Addresses of the vertices of the hull, in the plane: each where it is eventually periodic and proved.
    // Empty until requested.
    std::vector<std::optional<PeriodicPoint>> extremePoints;
    bool isHullExact = false; // proved by `extremePoints`, up to the rounding of the vertices
    std::optional<double> similarityDimension;
    std::optional<double> affinityDimension; // at most Dim; in space, for similarities only
    double affinityDimensionError = 0;       // error bound
    bool isAffinityDimensionCapped = false;  // true if Dim replaces a greater value
    Invariants invariants;                   // empty until requested
    std::vector<LongFact> late; // missing because they would take more time than FactLimits allow

    bool isLate(LongFact fact) const { return std::ranges::find(late, fact) != late.end(); }
};

// Default tolerance of a hull: 1e-6 of the diagonal of the box, in the system's own units.
template <int Dim> double usualHullTolerance(const BoundingBox<Dim>& box) {
    return 1e-6 * (box.max - box.min).stableNorm();
}

// `hullTolerance` in the system's own units; nullopt: the usual one.
template <int Dim>
Facts<Dim> factsOf(const IteratedFunctionSystem<Dim>& system, std::optional<double> hullTolerance = {},
                   const FactLimits& limits = {});

// All facts but the affinity dimension, the addresses of the hull and the invariants, which can take longer
// than the rest; without a limit of time.
template <int Dim>
Facts<Dim> geometricFacts(const IteratedFunctionSystem<Dim>& system,
                          std::optional<double> hullTolerance = {});

// Leaves the affinity dimension as a set in this space can have it.
template <int Dim> void capAffinityDimension(Facts<Dim>& facts);

template <int Dim> Invariants invariantsOf(const Facts<Dim>& facts);
// Invariants of an image whose area is `areaFactor` times that of the attractor.
Invariants scaled(Invariants invariants, double areaFactor);

// Facts of the attractor's image under an affine map T: of the maps T∘w∘T⁻¹, whose attractor it is. Extents
// come from the support function of the code (which is kept), so that they are as sharp however T leans. An
// image that is flat has extents and moments, but no maps and no dimension, and in space no hull.
template <int Dim> Facts<Dim> moved(const AffineMap<Dim>& transformation, const Facts<Dim>& facts);

} // namespace ifs
