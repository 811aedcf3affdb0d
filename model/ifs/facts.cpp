// SPDX-License-Identifier: MIT
#include "ifs/facts.h"
#include "ifs/extent/extent.h"

#include "ifs/deadline.h"
#include "ifs/dimension/dimension.h"
#include "ifs/dimension/measure.h"
#include "ifs/extent/polygon.h"
#include "ifs/links/linked_existence.h"
#include "ifs/links/linked_extent.h"
#include "ifs/links/linked_measure.h"
#include "ifs/processor_clock.h"
#include "ifs/separation/affine_hull.h"
#include "ifs/separation/determinant_sum.h"
#include "ifs/separation/exact_hull.h"
#include "ifs/separation/exact_map.h"
#include "ifs/separation/graph_proof.h"
#include "ifs/separation/hull_cover.h"
#include "ifs/separation/hull_pieces.h"
#include "ifs/separation/neighbour_graph.h"
#include "ifs/tiles/tile_area.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

namespace ifs {

namespace {

using Time = ProcessorClock::duration;

// Shares out the time that there is, and keeps account of the facts that it did not suffice for.
class Budget {
public:
    Budget(const FactLimits& limits, std::vector<LongFact>& late) : m_perFact(limits.perFact), m_late(late) {
        if (limits.together) m_end = ProcessorClock::now() + *limits.together;
    }

    // `find` gets a stop token and returns true if it has finished. It is not called if no time is left.
    template <class Find> bool spend(LongFact fact, Find find) {
        const FactLimits::Time time = available();
        bool isFound = !time || *time > Time::zero();
        if (isFound) {
            const Deadline deadline(time);
            isFound = find(deadline.token());
        }
        if (!isFound) m_late.push_back(fact);
        return isFound;
    }

    void leaveOut(std::initializer_list<LongFact> facts) { m_late.insert(m_late.end(), facts); }

private:
    FactLimits::Time available() const {
        if (!m_end) return m_perFact;
        const Time left = *m_end - ProcessorClock::now();
        return m_perFact ? std::min(*m_perFact, left) : left;
    }

    FactLimits::Time m_perFact;
    std::optional<ProcessorClock::time_point> m_end;
    std::vector<LongFact>& m_late;
};

template <int Dim> void setExtentsOfPoint(Facts<Dim>& facts, const Mean<Dim>& known) {
    facts.box = BoundingBox<Dim>{known.point, known.point, known.error};
    CanonicalSimplex<Dim> simplex;
    simplex.orientation.fill(1);
    simplex.leg = 1;
    simplex.error = known.error;
    simplex.vertices[0] = known.point;
    for (int k = 0; k < Dim; ++k)
        simplex.vertices[std::size_t(k) + 1] = known.point + Vector<Dim>::Unit(k);
    facts.simplex = simplex;
    facts.hull.emplace();
    facts.hull->vertices = {known.point};
    facts.hull->error = known.error;
}

// Returns true if the attractor is a point, whose facts are those of the point, rounded.
template <int Dim> bool settlePoint(Facts<Dim>& facts) {
    if (!facts.existence.exists()) return false;
    const auto known = commonFixedPoint<Dim>(facts.active.maps);
    if (!known) return false;
    facts.isPoint = true;
    facts.similarityDimension = 0;
    setExtentsOfPoint(facts, *known);
    facts.mean = *known;
    facts.moments = Moments<Dim>{known->point, Matrix<Dim>::Zero(), Matrix<Dim>::Zero(), known->error};
    return true;
}

template <int Dim>
bool findExistence(Facts<Dim>& facts, const IteratedFunctionSystem<Dim>& system, Budget& budget) {
    facts.probabilities = probabilities(system);
    facts.active = activeMaps(system);
    facts.typed = typedMaps(system, facts.active);
    facts.mean = mean(facts.active);
    facts.moments = moments(facts.active);
    return budget.spend(LongFact::Existence, [&](const std::stop_token&) {
        facts.existence = classify<Dim>(facts.active.maps);
        facts.support = SupportFunction<Dim>::of(facts.active.maps);
        if (facts.support) facts.similarityDimension = similarityDimension<Dim>(facts.active.maps);
        settlePoint(facts);
        return true;
    });
}

template <int Dim> void findExtents(Facts<Dim>& facts, Budget& budget) {
    if (facts.isPoint || !facts.support) return;
    budget.spend(LongFact::Extents, [&](const std::stop_token& stop) {
        facts.support->outline(stop);
        if (stop.stop_requested()) return false;
        facts.box = boundingBox(*facts.support);
        facts.simplex = minimalCanonicalSimplex(*facts.support);
        return true;
    });
}

// The usual tolerance is a share of the box.
template <int Dim> void findHull(Facts<Dim>& facts, std::optional<double> tolerance, Budget& budget) {
    if (facts.isPoint || !facts.support) return;
    if (!facts.box && !tolerance) return budget.leaveOut({LongFact::Hull});
    budget.spend(LongFact::Hull, [&](const std::stop_token& stop) {
        const double wanted = tolerance ? *tolerance : usualHullTolerance(*facts.box);
        facts.hull = convexHull(*facts.support, wanted, stop);
        return facts.hull.has_value();
    });
}

// Bounds the dimension of the measure by that of a subspace that holds the attractor.
void setMeasureDimension(Invariants& invariants, double bound, int ofHull) {
    constexpr double rounding = 1e-12;
    invariants.measureDimension = std::min(bound, double(ofHull));
    invariants.isMeasureDimensionCapped = bound > ofHull * (1 + rounding);
}

template <int Dim> void findLinkedMeasure(Facts<Dim>& facts) {
    facts.moments = linkedMoments<Dim>(facts.active);
    if (facts.moments) facts.mean = Mean<Dim>{facts.moments->mean, facts.moments->meanError};
    if (const auto dimension = linkedDimension<Dim>(facts.active))
        if (const auto error = linkedDimensionError<Dim>(facts.active, *dimension)) {
            facts.similarityDimension = dimension;
            facts.affinityDimensionError = *error;
        }
    facts.affinityDimension = facts.similarityDimension;
    capAffinityDimension(facts);
    Invariants& invariants = facts.invariants;
    invariants.entropy = entropyRate(transitions(facts.active));
    invariants.lyapunovExponent = linkedLyapunovExponent<Dim>(facts.active);
    if (const auto bound = linkedMeasureDimension<Dim>(facts.active)) {
        const auto hull = affineHull<Dim>(facts.active.maps); // kept by all maps, so it holds their attractor
        setMeasureDimension(invariants, *bound, hull ? hull->dimension : Dim);
    }
}

void findLinkedExtents(Facts<2>& facts, std::optional<double> hullTolerance, Budget& budget) {
    std::optional<LinkedExtent> extent;
    budget.spend(LongFact::Extents, [&](const std::stop_token&) {
        extent = LinkedExtent::of(facts.active, facts.existence);
        if (!extent) return true;
        facts.box = boundingBox(*extent);
        facts.simplex = minimalCanonicalSimplex(*extent);
        return true;
    });
    if (!extent) return;
    budget.spend(LongFact::Hull, [&](const std::stop_token& stop) {
        facts.hull = convexHull(*extent, hullTolerance.value_or(usualHullTolerance(*facts.box)), stop);
        if (facts.hull) facts.extremePoints.assign(facts.hull->vertices.size(), std::nullopt);
        return facts.hull.has_value();
    });
}

// Finds the facts of linked maps, which are all different; facts without a counterpart stay empty.
template <int Dim> void findLinked(Facts<Dim>& facts, std::optional<double> hullTolerance, Budget& budget) {
    const bool isKnown = budget.spend(LongFact::Existence, [&](const std::stop_token&) {
        facts.existence = classifyLinked<Dim>(facts.active);
        return true;
    });
    if (!isKnown) budget.leaveOut({LongFact::Extents, LongFact::Hull});
    if (!isKnown || !facts.existence.exists()) return;
    findLinkedMeasure(facts);
    if constexpr (Dim == 2) findLinkedExtents(facts, hullTolerance, budget);
}

// False, and nothing is found, where the maps are not linked.
template <int Dim>
bool areLinked(Facts<Dim>& facts, const IteratedFunctionSystem<Dim>& system,
               std::optional<double> hullTolerance, Budget& budget) {
    if (system.links.empty()) return false;
    facts.probabilities = probabilities(system);
    facts.active = activeMaps(system);
    if (!facts.active.isLinked()) return false;
    findLinked(facts, hullTolerance, budget);
    return true;
}

} // namespace

template <int Dim>
Facts<Dim> geometricFacts(const IteratedFunctionSystem<Dim>& system, std::optional<double> hullTolerance) {
    Facts<Dim> facts;
    Budget unlimited({}, facts.late);
    if (areLinked(facts, system, hullTolerance, unlimited)) return facts;
    findExistence(facts, system, unlimited);
    findExtents(facts, unlimited);
    findHull(facts, hullTolerance, unlimited);
    return facts;
}

namespace {

// Replaces vertices by the exact points of their addresses. Where two of them meet in one point, or one no
// longer stands out, the hull drops it: the loss counts as error.
bool settleExtremePoints(Facts<2>& facts, const std::stop_token& stop) {
    ConvexHull& hull = *facts.hull;
    const auto found = periodicExtremePoints(*facts.support, hull, stop);
    if (stop.stop_requested()) return false;
    Polygon points = hull.vertices;
    for (std::size_t k = 0; k < points.size(); ++k)
        if (found[k]) points[k] = found[k]->point;
    const Polygon before =
        std::exchange(hull.vertices,
                      convexHull(points, 1e-14 * (facts.support->radius() + facts.support->centre().norm())));
    double lost = 0;
    for (const auto& vertex : before)
        lost = std::max(lost, distanceToConvex(hull.vertices, vertex));
    hull.error += lost;
    hull.area = area(hull.vertices);
    for (const auto& vertex : hull.vertices) {
        facts.extremePoints.emplace_back();
        for (std::size_t k = 0; k < points.size(); ++k)
            if (found[k] && points[k] == vertex) facts.extremePoints.back() = found[k];
    }
    facts.isHullExact = isExactHull(facts.active.maps, facts.extremePoints);
    if (facts.isHullExact)
        hull.error = std::min(hull.error, roundingOf(facts.active.maps, facts.extremePoints));
    return true;
}

// Of what is proved for the stored coefficients.
template <int Dim> Certainty certaintyOf(const Facts<Dim>& facts) {
    return facts.typed.empty() ? Certainty::Exact : Certainty::ToRounding;
}

// Pieces of a point are the point.
template <int Dim> void findContactsOfPoint(const Facts<Dim>& facts, Invariants& result) {
    const auto& maps = facts.active.maps;
    PieceContacts contacts;
    if (maps.size() == 1) contacts.separation = Separation::Strong;
    contacts.connectedness = Connectedness::Connected;
    result.contacts = contacts;
    result.openSet = openSetFacts<Dim>(maps, *result.contacts, nullptr);
    settleByHull<Dim>(*result.openSet, *result.contacts, maps, std::nullopt, certaintyOf(facts));
}

bool isOpenSetOpen(const OpenSetFacts& known) {
    return known.condition == OpenSetCondition::Unknown ||
           (known.condition == OpenSetCondition::Holds && known.certainty == Certainty::ToRounding);
}

template <int Dim> void findSpectrum(const Facts<Dim>& facts, Invariants& result) {
    if (result.openSet->condition == OpenSetCondition::Holds && facts.similarityDimension > 0.0)
        result.spectrum = dimensionSpectrum<Dim>(facts.active);
}

// Returns true if the hull, if it is the attractor, is a tile whose area is not known.
bool fillExactly(const Invariants& found, const std::vector<AffineMap<2>>& maps) {
    const bool isKnown = found.tile && found.tile->area;
    return !isKnown && found.openSet->condition == OpenSetCondition::Holds &&
           excessOfDeterminants<2>(maps).sign() == 0;
}

void setArea(Invariants& found, double area) {
    if (!found.tile) found.tile.emplace().isExact = true;
    found.tile->area = area;
}

// Boxes and segments of maps along the axes, and segments on any line.
template <int Dim> void findFullHull(const Facts<Dim>& facts, Invariants& result) {
    const auto& maps = facts.active.maps;
    const auto pieces = piecesOfHull<Dim>(maps);
    settleByHull<Dim>(*result.openSet, *result.contacts, maps, pieces, certaintyOf(facts));
    if constexpr (Dim == 2)
        if (pieces && pieces->coverHull && pieces->area && facts.typed.empty() && fillExactly(result, maps))
            setArea(result, *pieces->area);
}

template <int Dim> void findContacts(const Facts<Dim>& facts, Invariants& result) {
    const auto& maps = facts.active.maps;
    auto graph = facts.box ? neighbourGraph<Dim>(maps, *facts.box) : std::nullopt;
    const bool isProved = graph && isGraphOf(*graph, facts.typed);
    if (graph && !facts.typed.empty())
        graph->setCertainty(isProved ? Certainty::Exact : Certainty::ToRounding);
    const NeighbourGraph* neighbours = graph ? &*graph : nullptr;
    result.contacts = pieceContacts(*facts.support, neighbours);
    prove(*result.contacts, facts.typed, isProved);
    result.openSet = openSetFacts<Dim>(maps, *result.contacts, neighbours);
    proveDimension(*result.openSet, facts.typed);
    if constexpr (Dim == 2) {
        if (facts.box) result.tile = tile(maps, *facts.box, neighbours);
        if (result.tile && !facts.typed.empty())
            result.tile->isExact =
                (!result.tile->area || isAreaOf(maps, facts.typed)) &&
                (!result.tile->boundaryDimension || neighbours->certainty() == Certainty::Exact);
        if (result.tile && result.tile->area)
            settleByOpenSet<2>(*result.openSet, maps,
                               result.tile->isExact ? Certainty::Exact : Certainty::ToRounding);
    }
    findFullHull(facts, result);
    findSpectrum(facts, result);
}

template <int Dim> void findInvariants(const Facts<Dim>& facts, Invariants& result, Budget& budget) {
    const auto& active = facts.active;
    if (active.maps.empty() || !std::ranges::all_of(active.maps, isFinite<Dim>)) return;
    result.entropy = entropy(active.probabilities);
    result.lyapunovExponent = lyapunovExponent(active);
    budget.spend(LongFact::JointSpectralRadius, [&](const std::stop_token&) {
        result.jointSpectralRadius = jointSpectralRadius<Dim>(active.maps, facts.existence);
        return true;
    });
    if (!facts.support && !facts.isPoint) return;
    if (facts.similarityDimension == 0.0)
        result.measureDimension = 0;
    else if (const auto bound = measureDimension(active)) {
        const auto hull = affineHull<Dim>(active.maps);
        setMeasureDimension(result, *bound, hull ? hull->dimension : Dim);
    }
    budget.spend(LongFact::Contacts, [&](const std::stop_token&) {
        facts.support ? findContacts(facts, result) : findContactsOfPoint(facts, result);
        const bool isExact = facts.typed.empty() || active.maps.size() == 1;
        if (facts.isPoint)
            result.openSet->dimension =
                HausdorffDimension{.proof = HausdorffDimension::Proof::Convex,
                                   .certainty = isExact ? Certainty::Exact : Certainty::ToRounding};
        return true;
    });
}

// A hull whose inside has disjoint images is an open set as the condition asks for. A hull that is the union
// of its images is the attractor, and convex.
void settleByExactHull(const Facts<2>& facts, Invariants& invariants) {
    if (!invariants.contacts || !facts.isHullExact || !facts.typed.empty() || facts.isPoint) return;
    const auto& maps = facts.active.maps;
    OpenSetFacts& openSet = *invariants.openSet;
    if (isOpenSetOpen(openSet) && haveImagesDisjointInsides(maps, facts.extremePoints)) {
        settleByOpenSet<2>(openSet, maps, Certainty::Exact);
        findSpectrum(facts, invariants);
    }
    const bool isPolygon = facts.hull->vertices.size() > 2,
               fills = isPolygon && fillExactly(invariants, maps);
    const Connectedness known = invariants.contacts->connectedness;
    if (known == Connectedness::Disconnected) return;
    if (known == Connectedness::Connected && openSet.dimension && !fills) return;
    if (!imagesCoverHull(maps, facts.extremePoints)) return;
    settleConvex(openSet, *invariants.contacts, isPolygon ? 2 : 1, Certainty::Exact);
    if (fills) setArea(invariants, facts.hull->area);
}

void findAffinityDimension(Facts<2>& facts, Budget& budget) {
    budget.spend(LongFact::AffinityDimension, [&](const std::stop_token& stop) {
        facts.affinityDimension = affinityDimension(facts.active.maps, stop);
        facts.affinityDimensionError = facts.affinityDimension == 0.0 ? 0 : affinityDimensionError;
        return facts.affinityDimension || !stop.stop_requested();
    });
}

void findExtremePoints(Facts<2>& facts, Budget& budget) {
    if (facts.isPoint) {
        facts.extremePoints = {PeriodicPoint{{}, {0}, facts.hull->vertices.front()}};
        facts.isHullExact = true;
        return;
    }
    const bool isFound = budget.spend(LongFact::ExtremePoints, [&](const std::stop_token& stop) {
        return settleExtremePoints(facts, stop);
    });
    if (!isFound) facts.extremePoints.assign(facts.hull->vertices.size(), std::nullopt);
    settleByExactHull(facts, facts.invariants);
}

// Tries the addresses of the hull for facts that come without them: they tell whether its images overlap, and
// whether they cover it.
void settleByAddresses(Facts<2> facts, Invariants& invariants) {
    constexpr std::chrono::seconds patience(2);
    if (!facts.hull || !facts.support || facts.isPoint || !invariants.contacts) return;
    const Connectedness known = invariants.contacts->connectedness;
    const bool isConnectionKnown = known == Connectedness::Connected || known == Connectedness::Disconnected;
    if (isConnectionKnown && !isOpenSetOpen(*invariants.openSet)) return;
    if (facts.extremePoints.empty() && !settleExtremePoints(facts, Deadline(patience).token())) return;
    settleByExactHull(facts, invariants);
}

} // namespace

template <int Dim> Invariants invariantsOf(const Facts<Dim>& facts) {
    if (facts.active.isLinked()) return facts.invariants;
    Invariants result;
    std::vector<LongFact> late;
    Budget unlimited({}, late);
    findInvariants(facts, result, unlimited);
    if constexpr (Dim == 2) settleByAddresses(facts, result);
    return result;
}

template <int Dim>
Facts<Dim> factsOf(const IteratedFunctionSystem<Dim>& system, std::optional<double> hullTolerance,
                   const FactLimits& limits) {
    Facts<Dim> facts;
    Budget budget(limits, facts.late);
    if (areLinked(facts, system, hullTolerance, budget)) return facts;
    const bool isExistenceKnown = findExistence(facts, system, budget);
    if (!isExistenceKnown) budget.leaveOut({LongFact::Extents, LongFact::Contacts, LongFact::Hull});
    if (!isExistenceKnown && Dim == 3) budget.leaveOut({LongFact::AffinityDimension});
    findExtents(facts, budget);
    findInvariants(facts, facts.invariants, budget); // within less time than what follows
    findHull(facts, hullTolerance, budget);
    facts.affinityDimension = facts.similarityDimension;
    if (const auto& dimension = facts.similarityDimension)
        facts.affinityDimensionError = similarityDimensionError<Dim>(facts.active.maps, *dimension);
    if constexpr (Dim == 2) {
        if (limits.withAffinityDimension && !facts.affinityDimension) findAffinityDimension(facts, budget);
        if (facts.hull) findExtremePoints(facts, budget);
    }
    capAffinityDimension(facts);
    return facts;
}

template <int Dim> void capAffinityDimension(Facts<Dim>& facts) {
    if (!facts.affinityDimension) return;
    const auto [value, error, isCapped] = capped(*facts.affinityDimension, facts.affinityDimensionError, Dim);
    facts.affinityDimension = value;
    facts.affinityDimensionError = error;
    facts.isAffinityDimensionCapped = isCapped;
}

Invariants scaled(Invariants invariants, double areaFactor) {
    if (invariants.tile && invariants.tile->area) *invariants.tile->area *= areaFactor;
    return invariants;
}

namespace {

ConvexHull moved(const AffineMap<2>& transformation, const ConvexHull& hull) {
    ConvexHull result;
    double size = 0;
    for (const auto& vertex : hull.vertices) {
        result.vertices.push_back(transformation(vertex));
        size = std::max(size, result.vertices.back().norm());
    }
    const double rounding = 16 * std::numeric_limits<double>::epsilon() * size;
    result.vertices = convexHull(std::move(result.vertices), rounding);
    result.area = area(result.vertices);
    result.error = spectralNorm<2>(transformation.linear) * hull.error + 2 * rounding;
    return result;
}

// An affine image of facets is facets; a reflection turns them round.
ConvexHull3 moved(const AffineMap<3>& transformation, const ConvexHull3& hull) {
    const double determinant = ifs::determinant<3>(transformation.linear);
    ConvexHull3 result = hull;
    double size = 0;
    for (auto& vertex : result.vertices) {
        vertex = transformation(vertex);
        size = std::max(size, vertex.norm());
    }
    if (determinant < 0)
        for (auto& facet : result.facets)
            std::swap(facet[1], facet[2]);
    result.volume = std::abs(determinant) * hull.volume;
    result.error = spectralNorm<3>(transformation.linear) * hull.error +
                   32 * std::numeric_limits<double>::epsilon() * size;
    return result;
}

template <int Dim> Mean<Dim> moved(const AffineMap<Dim>& transformation, const Mean<Dim>& mean) {
    const double stretch = spectralNorm<Dim>(transformation.linear);
    const double reach = stretch * mean.point.norm() + transformation.translation.norm();
    return {transformation(mean.point),
            stretch * mean.error + 2 * Dim * std::numeric_limits<double>::epsilon() * reach};
}

template <int Dim> Moments<Dim> moved(const AffineMap<Dim>& transformation, const Moments<Dim>& moments) {
    const Matrix<Dim>& linear = transformation.linear;
    const double stretch = spectralNorm<Dim>(linear);
    const double rounding = 4 * Dim * std::numeric_limits<double>::epsilon();
    Moments<Dim> result{transformation(moments.mean), linear * moments.covariance * linear.transpose(),
                        linear * moments.longRunCovariance * linear.transpose()};
    result.meanError = moved(transformation, Mean<Dim>{moments.mean, moments.meanError}).error;
    result.covarianceError =
        stretch * stretch * (Dim * moments.covarianceError + rounding * moments.covariance.norm());
    return result;
}

// The extents are those of the maps of the image.
template <int Dim> Facts<Dim> linkedImage(Facts<Dim> image) {
    std::vector<LongFact> late;
    Budget unlimited({}, late);
    Facts<Dim> found;
    found.active = image.active;
    findLinked(found, {}, unlimited);
    image.box = found.box;
    image.simplex = found.simplex;
    image.hull = std::move(found.hull);
    image.extremePoints = std::move(found.extremePoints);
    if (found.existence.verdict != Verdict::Undecided) image.existence = found.existence;
    return image;
}

} // namespace

template <int Dim> Facts<Dim> moved(const AffineMap<Dim>& transformation, const Facts<Dim>& facts) {
    if (transformation == AffineMap<Dim>{}) return facts;
    Facts<Dim> result = facts;
    if (facts.mean) result.mean = moved(transformation, *facts.mean);
    if (facts.moments) result.moments = moved(transformation, *facts.moments);
    if (facts.support) {
        const double tolerance = 1e-12 * facts.support->radius() * spectralNorm<Dim>(transformation.linear);
        result.box = boundingBoxOfImage(transformation, *facts.support, tolerance);
        result.simplex = minimalCanonicalSimplexOfImage(transformation, *facts.support, tolerance);
    }
    if (facts.hull) result.hull = moved(transformation, *facts.hull);
    if (facts.isPoint) setExtentsOfPoint(result, *result.mean);
    result.typed.clear();
    result.extremePoints.clear();
    result.isHullExact = false;
    result.invariants = scaled(facts.invariants, std::abs(determinant<Dim>(transformation.linear)));
    const auto sigma = singularValues<Dim>(transformation.linear);
    if (!(sigma[Dim - 1] > 1e-6 * sigma[0])) {
        if constexpr (Dim == 3) result.hull.reset();
        result.active.maps.clear();
        result.similarityDimension.reset();
        result.affinityDimension.reset();
        result.isAffinityDimensionCapped = false;
        result.invariants = {};
        return result;
    }
    for (auto& map : result.active.maps)
        map = *conjugate(transformation, map);
    if (facts.active.isLinked()) return linkedImage(std::move(result));
    // An attractor has an image, even if no word of the image's maps is known to contract.
    if (const auto seen = classify<Dim>(result.active.maps);
        seen.verdict != Verdict::Undecided || facts.existence.verdict == Verdict::Undecided)
        result.existence = seen;
    return result;
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template Facts<Dim> geometricFacts(const IteratedFunctionSystem<Dim>&, std::optional<double>);           \
    template Facts<Dim> factsOf(const IteratedFunctionSystem<Dim>&, std::optional<double>,                   \
                                const FactLimits&);                                                          \
    template void capAffinityDimension(Facts<Dim>&);                                                         \
    template Invariants invariantsOf(const Facts<Dim>&);                                                     \
    template Facts<Dim> moved(const AffineMap<Dim>&, const Facts<Dim>&);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace ifs
