// SPDX-License-Identifier: MIT
#include "document/edits/cage/space_cage_edits.h"

#include "document/edits/cage/rounding.h"
#include "document/fractal/space_geometry.h"
#include "document/text/text.h"
#include "ifs/cage/space_hull_cage.h"

namespace document {

namespace {

QString noMap() {
    return Text::tr("No map is active, so there is nothing to enclose.");
}

QString noCodeBends() {
    return Text::tr("The cage bends the picture, and no affine code produces a bent picture. Choose "
                    "“Affine fit” to bake the closest affine placement.");
}

bool rests(const Fractal& fractal) {
    const Shape<3>* shape = space(fractal);
    return !shape || !shape->cage || shape->cage->rest == shape->cage->current;
}

// The code takes up its cage; branches that are shown elsewhere go with it.
std::optional<Fractal> withSpaceCageBaked(const Fractal& fractal) {
    const Shape<3>* shape = space(fractal);
    if (!shape || !shape->cage) return std::nullopt;
    auto baked = ifs::bake(shape->system, *shape->cage);
    if (!baked) return std::nullopt;
    const ifs::AffineMap<3> placed = ifs::displayMap(*shape->cage);
    dropRounding(baked->system);
    Fractal result = fractal;
    Shape<3>& after = *space(result);
    after.system = std::move(baked->system);
    after.cage = std::move(baked->cage);
    for (MovedBranch<3>& branch : after.moved)
        branch.change = ifs::conjugate(placed, branch.change).value_or(branch.change);
    return result;
}

// Where the cage of an entry in space puts its code.
ifs::AffineMap<3> placementOf(const Fractal& fractal) {
    const Shape<3>* shape = space(fractal);
    return shape && shape->cage ? ifs::displayMap(*shape->cage) : ifs::AffineMap<3>();
}

} // namespace

std::optional<Fractal> withCageThrough(const Fractal& fractal, const std::vector<ifs::Vector<3>>& vertices) {
    const auto present = spaceCage(fractal);
    if (!present) return std::nullopt;
    Fractal after = fractal;
    auto& cage = space(after)->cage;
    cage = rests(fractal) ? std::optional(ifs::polygonAtRest<3>(vertices))
                          : ifs::redefine<3>(*present, vertices);
    return cage && ifs::isValid(*cage) ? std::optional(after) : std::nullopt;
}

Fractal withSpaceCageMoved(Fractal fractal, ifs::ControlCage<3> cage, CageMode mode) {
    fractal = withSpaceCageMoved(std::move(fractal), std::move(cage));
    if (mode == CageMode::Rewrite)
        if (auto rewritten = spaceBaked(fractal)) return *std::move(rewritten);
    return fractal;
}

QString spaceBakeObstacle(const Fractal& fractal) {
    if (const QString obstacle = spaceObstacle(fractal); !obstacle.isEmpty()) return obstacle;
    if (rests(fractal)) return Text::tr("The cage is at rest: the picture shows the code.");
    if (ifs::bends(*space(fractal)->cage)) return noCodeBends();
    if (!ifs::isInvertible(*space(fractal)->cage))
        return Text::tr(
            "The cage is flat, so its placement cannot be baked into the code. Open the cage first.");
    return {};
}

std::optional<Fractal> spaceBaked(const Fractal& fractal) {
    return spaceBakeObstacle(fractal).isEmpty() ? withSpaceCageBaked(fractal) : std::nullopt;
}

QString spaceUnbakeObstacle(const Fractal& fractal) {
    if (const QString obstacle = spaceObstacle(fractal); !obstacle.isEmpty()) return obstacle;
    if (space(fractal)->system.maps.empty()) return noMap();
    if (!rests(fractal)) return Text::tr("The cage is not at rest: it already holds a placement.");
    if (const auto& cage = space(fractal)->cage; cage && cage->rest.size() != 4)
        return Text::tr("Only a cage with four vertices can be unbaked.");
    return {};
}

std::optional<Fractal> spaceUnbaked(const Fractal& fractal) {
    if (!spaceUnbakeObstacle(fractal).isEmpty()) return std::nullopt;
    const auto cage = spaceCage(fractal);
    const std::vector<ifs::Vector<3>> unit{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    Fractal after = fractal;
    space(after)->cage = ifs::ControlCage<3>{cage->rest, unit};
    auto result = withSpaceCageBaked(after);
    if (result) space(*result)->cage = ifs::ControlCage<3>{unit, cage->current};
    return result;
}

QString spaceFitObstacle(const Fractal& fractal) {
    if (const QString obstacle = spaceObstacle(fractal); !obstacle.isEmpty()) return obstacle;
    const Shape<3>& shape = *space(fractal);
    if (ifs::activeMaps(shape.system).maps.empty()) return noMap();
    if (shape.cage && ifs::bends(*shape.cage))
        return Text::tr("The cage bends the picture, so no other cage would show it. First "
                        "reset the cage or choose “Affine fit”.");
    if (shape.cage && !rests(fractal) && !ifs::isInvertible(*shape.cage))
        return Text::tr("The cage is flat. First open or reset the tetrahedron.");
    if (!spaceSupport(fractal)) return Text::tr("This system has no attractor that can be enclosed.");
    return {};
}

std::optional<Fractal> withTetrahedronFitted(const Fractal& fractal,
                                             const std::optional<ifs::Orientation<3>>& orientation) {
    const auto system = system3(fractal);
    if (!system) return std::nullopt;
    if (!orientation && rests(fractal)) {
        Fractal after = fractal;
        space(after)->cage.reset(); // it then follows the code
        return spaceSupport(fractal) ? std::optional(std::move(after)) : std::nullopt;
    }
    const auto displayed = ifs::conjugate(placementOf(fractal), *system);
    const auto support =
        displayed ? ifs::SupportFunction<3>::of(ifs::activeMaps(*displayed).maps) : std::nullopt;
    if (!support) return std::nullopt;
    const double tolerance = extentTolerance(*system) * support->radius();
    const ifs::CanonicalSimplex<3> simplex = orientation
                                                 ? ifs::canonicalSimplex<3>(*support, *orientation, tolerance)
                                                 : ifs::minimalCanonicalSimplex(*support, tolerance);
    return withCageThrough(fractal, {simplex.vertices.begin(), simplex.vertices.end()});
}

std::vector<ifs::Vector<3>> verticesAround(const System3& system, const ifs::SupportFunction<3>& support,
                                           SpacePolyhedron choice, int corners) {
    const double tolerance = extentTolerance(system) * support.radius();
    switch (choice) {
    case SpacePolyhedron::Simplex:
        break;
    case SpacePolyhedron::Box:
        return ifs::boxCage(support, tolerance);
    case SpacePolyhedron::Octahedron:
        return ifs::octahedronCage(support, tolerance);
    case SpacePolyhedron::Hull:
        return ifs::hullCage(support, corners, tolerance);
    }
    const ifs::Simplex<3> simplex = simplexAround(system, support);
    return {simplex.begin(), simplex.end()};
}

std::optional<Fractal> withPolyhedronFitted(const Fractal& fractal, SpacePolyhedron choice, int corners) {
    const System3* system = system3(fractal);
    const auto displayed = system ? ifs::conjugate(placementOf(fractal), *system) : std::nullopt;
    const auto support =
        displayed ? ifs::SupportFunction<3>::of(ifs::activeMaps(*displayed).maps) : std::nullopt;
    if (!support) return std::nullopt;
    return withCageThrough(fractal, verticesAround(*system, *support, choice, corners));
}

std::optional<Fractal> withBoxFitted(const Fractal& fractal) {
    const auto support = spaceSupport(fractal);
    if (!support) return std::nullopt;
    const auto box = ifs::boundingBoxOfImage(placementOf(fractal), *support,
                                             extentTolerance(*system3(fractal)) * support->radius());
    const auto known = [&box](double x) { return std::abs(x) <= 2 * box.error ? 0 : x; };
    const ifs::Vector<3> low = (box.min.array() - box.error).unaryExpr(known);
    const ifs::Vector<3> high = (box.max.array() + box.error).unaryExpr(known);
    return withCageThrough(
        fractal,
        {low, {high.x(), low.y(), low.z()}, {low.x(), high.y(), low.z()}, {low.x(), low.y(), high.z()}});
}

} // namespace document
