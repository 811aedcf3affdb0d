// SPDX-License-Identifier: MIT
#include "io/info_facts.h"

#include "ifs/dimension.h"

#include <algorithm>

namespace io {

template <int Dim>
Facts<Dim> factsOf(const ifs::IteratedFunctionSystem<Dim>& system, std::optional<double> hullTolerance) {
    Facts<Dim> facts;
    facts.probabilities = ifs::probabilities(system);
    const auto active = ifs::activeMaps(system);
    facts.existence = ifs::classify<Dim>(active.maps);
    facts.moments = ifs::moments(active);
    const auto support = ifs::SupportFunction<Dim>::of(active.maps);
    if (!support) return facts;
    facts.box = ifs::boundingBox(*support);
    facts.simplex = ifs::minimalCanonicalSimplex(*support);
    facts.similarityDimension = ifs::similarityDimension<Dim>(active.maps);
    const double diagonal = (facts.box->max - facts.box->min).norm();
    facts.hull = ifs::convexHull(*support, hullTolerance.value_or(1e-6 * diagonal));
    if constexpr (Dim == 2)
        if (const auto dimension = ifs::affinityDimension(active.maps))
            facts.affinityDimension = std::min(*dimension, double(Dim));
    return facts;
}

template Facts<2> factsOf(const ifs::IteratedFunctionSystem<2>&, std::optional<double>);
template Facts<3> factsOf(const ifs::IteratedFunctionSystem<3>&, std::optional<double>);

} // namespace io
