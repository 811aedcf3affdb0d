// SPDX-License-Identifier: MIT
#include "document/edits/cage/space_cage_edits.h"

#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/text/text.h"

namespace document {

namespace {

bool rests(const Fractal& fractal) {
    const Shape<3>* shape = space(fractal);
    return !shape || !shape->cage || shape->cage->rest == shape->cage->current;
}

// The placement of the code by the cage of an entry in space.
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

QString spaceFitObstacle(const Fractal& fractal) {
    if (const QString obstacle = spaceObstacle(fractal); !obstacle.isEmpty()) return obstacle;
    const Shape<3>& shape = *space(fractal);
    if (ifs::activeMaps(shape.system).maps.empty())
        return Text::tr("No map is active, so there is nothing to enclose.");
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
        space(after)->cage.reset(); // the cage follows the code from now on
        return spaceSupport(fractal) ? std::optional(std::move(after)) : std::nullopt;
    }
    const auto support = displayedSupport<3>(fractal);
    if (!support) return std::nullopt;
    const double tolerance = extentTolerance(*system) * support->radius();
    const ifs::CanonicalSimplex<3> simplex = orientation
                                                 ? ifs::canonicalSimplex<3>(*support, *orientation, tolerance)
                                                 : ifs::minimalCanonicalSimplex(*support, tolerance);
    return withCageThrough(fractal, {simplex.vertices.begin(), simplex.vertices.end()});
}

std::vector<ifs::Vector<3>> verticesAround(const System3& system, const ifs::SupportFunction<3>& support,
                                           SpacePolyhedron choice, int corners) {
    for (const auto& fit : cageFits<3>())
        if (fit.choice == choice)
            return fit.around(support, extentTolerance(system) * support.radius(), corners);
    const ifs::Simplex<3> simplex = simplexAround(system, support);
    return {simplex.begin(), simplex.end()};
}

std::optional<Fractal> withPolyhedronFitted(const Fractal& fractal, SpacePolyhedron choice, int corners) {
    const auto support = displayedSupport<3>(fractal);
    if (!support) return std::nullopt;
    return withCageThrough(fractal, verticesAround(*system3(fractal), *support, choice, corners));
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
