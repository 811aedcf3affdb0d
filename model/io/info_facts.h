// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/attractor_existence.h"
#include "ifs/iterated_function_system.h"
#include "ifs/moments.h"
#include "ifs/support_function.h"

#include <optional>
#include <vector>

namespace io {

// What can be said for certain about a system; nullopt where nothing can.
template <int Dim> struct Facts {
    std::vector<double> probabilities; // one for each map, 0 for a map that takes no part
    ifs::Existence existence;
    std::optional<ifs::Moments<Dim>> moments;
    std::optional<ifs::BoundingBox<Dim>> box;
    std::optional<ifs::CanonicalSimplex<Dim>> simplex; // the minimal one
    std::optional<ifs::HullIn<Dim>> hull;
    std::optional<double> similarityDimension;
    std::optional<double> affinityDimension; // not above Dim; in the plane
};

// `hullTolerance` in the system's own units; nullopt: 1e-6 of the diagonal of the bounding box.
template <int Dim>
Facts<Dim> factsOf(const ifs::IteratedFunctionSystem<Dim>& system, std::optional<double> hullTolerance = {});

} // namespace io
