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
    std::optional<double> entropy;          // of the probabilities, in nats
    std::optional<double> lyapunovExponent; // of similarities
    std::optional<double> measureDimension; // of similarities; an upper bound where pieces overlap
    bool isMeasureDimensionCapped = false;  // the dimension of the affine hull stands for more than that
    std::optional<JointSpectralRadius> jointSpectralRadius; // of finite maps
    std::optional<PieceContacts> contacts;                  // where there is an attractor
    std::optional<OpenSetFacts> openSet;                    // with them
    std::optional<DimensionSpectrum> spectrum;              // of similarities under the open set condition
    std::optional<Tile> tile;                               // in the plane
};

// Facts that can take long.
enum class LongFact {
    Existence, // and with it everything else but the moments
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
    Time together = {}; // facts not begun by then are left out
};

// Certified facts about a system; nullopt where nothing is certain. Facts of linked maps are those of the
// linked system; they have no support function, contacts, joint spectral radius, periodic extreme points, nor
// an affinity dimension unless all maps are similarities.
template <int Dim> struct Facts {
    std::vector<double> probabilities; // one for each map, 0 for a map that takes no part
    ActiveMaps<Dim> active;
    std::vector<SurdMap> typed;    // these without rounding; empty where nothing is typed
    Existence existence;           // of the active maps
    std::optional<Mean<Dim>> mean; // can exist without the covariance
    std::optional<Moments<Dim>> moments;
    std::optional<SupportFunction<Dim>> support;
    std::optional<BoundingBox<Dim>> box;
    std::optional<CanonicalSimplex<Dim>> simplex; // the minimal one
    std::optional<HullIn<Dim>> hull;
    // Addresses of the vertices of the hull, in the plane: each where it is eventually periodic and proved.
    // Empty until requested.
    std::vector<std::optional<PeriodicPoint>> extremePoints;
    bool isHullExact = false; // proved with them, but for the rounding of the vertices
    std::optional<double> similarityDimension;
    std::optional<double> affinityDimension; // not above Dim; in space, of similarities only
    double affinityDimensionError = 0;       // how far it is off, at most
    bool isAffinityDimensionCapped = false;  // Dim stands for more than that
    Invariants invariants;                   // empty until they are asked for
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
