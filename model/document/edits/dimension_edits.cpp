// SPDX-License-Identifier: MIT
#include "document/edits/dimension_edits.h"

#include "document/edits/cage/cage_edits.h"
#include "document/edits/maps/symmetry_edits.h"
#include "document/fractal/space_geometry.h"
#include "document/moments/animated_fractal.h"
#include "document/text/text.h"
#include "ifs/system/barycentric.h"

#include <algorithm>
#include <cmath>

namespace document {

namespace {

ifs::AffineMap<3> liftedMap(const ifs::AffineMap<2>& map, double scale) {
    ifs::AffineMap<3> result;
    result.linear.setZero();
    result.linear.topLeftCorner<2, 2>() = map.linear;
    result.linear(2, 2) = scale;
    result.translation = {map.translation.x(), map.translation.y(), 0};
    return result;
}

double thickness(const ifs::AffineMap<2>& map) {
    return std::sqrt(std::abs(ifs::determinant<2>(map.linear)));
}

// The triangle in z = 0 with a fourth corner over its middle, as high as √(2·area), or, over a triangle too
// thin for that, as its longest side; now by the factor of the placement higher.
ifs::ControlCage<3> liftedCage(const ifs::ControlCage<2>& cage) {
    const auto raised = [](const std::vector<ifs::Vector<2>>& corners, double height) {
        std::vector<ifs::Vector<3>> result;
        ifs::Vector<2> middle = ifs::Vector<2>::Zero();
        for (const ifs::Vector<2>& corner : corners) {
            result.emplace_back(corner.x(), corner.y(), 0);
            middle += corner / double(corners.size());
        }
        result.emplace_back(middle.x(), middle.y(), height);
        return result;
    };
    ifs::Matrix<2> sides;
    sides << cage.rest[1] - cage.rest[0], cage.rest[2] - cage.rest[0];
    double height = std::sqrt(std::abs(sides.determinant()));
    ifs::ControlCage<3> result;
    result.rest = raised(cage.rest, height);
    if (!ifs::isAffineBasis<3>({result.rest[0], result.rest[1], result.rest[2], result.rest[3]})) {
        const ifs::Vector<2> third = sides.col(1) - sides.col(0);
        height = std::max({sides.col(0).norm(), sides.col(1).norm(), third.norm()});
        result.rest = raised(cage.rest, height);
    }
    result.current = raised(cage.current, height * thickness(ifs::displayMap(cage)));
    return result;
}

// The rows are the horizontal and the vertical of somebody who looks against the direction.
using PlaneProjection = Eigen::Matrix<double, 2, 3>;

std::optional<PlaneProjection> planeProjection(const ifs::Vector<3>& direction) {
    if (!direction.allFinite() || direction.isZero(0)) return std::nullopt;
    const ifs::Vector<3> d = direction.stableNormalized(); // any length > 0
    ifs::Vector<3> up = ifs::Vector<3>::UnitY() - d.y() * d;
    if (up.norm() > 1e-9)
        up.normalize();
    else
        up = ifs::Vector<3>(0, 0, d.y() > 0 ? -1 : 1);
    PlaneProjection projection;
    projection << up.y() * d.z() - up.z() * d.y(), up.z() * d.x() - up.x() * d.z(),
        up.x() * d.y() - up.y() * d.x(), up.x(), up.y(), up.z();
    return projection;
}

bool keepsLine(const ifs::Matrix<3>& linear, const ifs::Vector<3>& d) { // `d` must have unit length
    constexpr double rounding = 1e-9;
    const ifs::Vector<3> image = linear * d;
    const ifs::Vector<3> aside = image - d * d.dot(image);
    return aside.norm() <= rounding * ifs::spectralNorm<3>(linear);
}

// The maps in displayed coordinates; nullopt when the cage cannot be taken into them.
std::optional<System3> displayedSystem(const Shape<3>& shape) {
    if (!shape.cage) return shape.system;
    auto baked = ifs::bake(shape.system, *shape.cage);
    return baked ? std::optional(std::move(baked->system)) : std::nullopt;
}

} // namespace

QString dimensionLoss(const Fractal& entry) {
    if (!animationFacts(entry)) return {};
    return Text::tr("The animation of “%1” cannot be taken to another dimension, so it is left out.")
        .arg(entry.name);
}

QString liftObstacle(const Fractal& fractal) {
    const Shape<2>* shape = plane(fractal);
    if (!shape)
        return Text::tr("“%1” is not a system in the plane, so it cannot be lifted.").arg(fractal.name);
    if (ifs::activeMaps(shape->system).isLinked())
        return Text::tr("The maps of “%1” are linked, and maps in space cannot be linked.").arg(fractal.name);
    if (shape->cage && shape->cage->rest.size() != 3 && shape->cage->current != shape->cage->rest)
        return Text::tr("The cage of “%1” has more than three corners, so it cannot become a tetrahedron. "
                        "Bake or reset it first.")
            .arg(fractal.name);
    return {};
}

std::optional<Fractal> lifted(Fractal fractal, std::optional<double> scale) {
    if (!liftObstacle(fractal).isEmpty()) return std::nullopt;
    const Shape<2> flat = *plane(fractal);
    Shape<3> shape;
    for (const ifs::WeightedMap<2>& map : flat.system.maps)
        shape.system.maps.push_back(
            {map.id, liftedMap(map.map, scale.value_or(thickness(map.map))), map.weight, map.enabled});
    shape.system.symmetry = ifs::lifted(flat.system.symmetry);
    if (flat.cage && flat.cage->rest.size() == 3) {
        if (const auto cage = liftedCage(*flat.cage); ifs::isValid(cage)) {
            shape.cage = cage;
        } else if (flat.cage->current != flat.cage->rest) { // too thin for a tetrahedron
            auto without = baked(fractal);
            return without ? lifted(*std::move(without), scale) : std::nullopt;
        }
    }
    for (const MovedBranch<2>& branch : flat.moved)
        shape.moved.push_back({branch.word, liftedMap(branch.change, thickness(branch.change))});
    fractal.shape = std::move(shape);
    fractal.supports = {};
    return fractal;
}

QString flattenObstacle(const Fractal& fractal, const ifs::Vector<3>& direction) {
    const Shape<3>* shape = space(fractal);
    if (!shape)
        return Text::tr("“%1” is not a system in space, so it cannot be flattened.").arg(fractal.name);
    if (!planeProjection(direction)) return Text::tr("The direction must have a length other than 0.");
    if (!shape->moved.empty())
        return Text::tr("“%1” has moved branches, which cannot be flattened. Reset them first.")
            .arg(fractal.name);
    auto system = displayedSystem(*shape);
    if (system) *system = ifs::expanded(*system);
    if (!system)
        return Text::tr("The cage of “%1” cannot be baked into its maps, so it cannot be flattened.")
            .arg(fractal.name);
    for (std::size_t i = 0; i < system->maps.size(); ++i)
        if (!keepsLine(system->maps[i].map.linear, direction.stableNormalized()))
            return Text::tr(
                       "Map %1 of “%2” does not keep this direction, so the projection is not an iterated "
                       "function system. Export a picture seen from that direction instead.")
                .arg(i + 1)
                .arg(fractal.name);
    return {};
}

std::optional<Fractal> flattened(Fractal fractal, const ifs::Vector<3>& direction) {
    fractal = expanded(std::move(fractal));
    if (!flattenObstacle(fractal, direction).isEmpty()) return std::nullopt;
    const PlaneProjection projection = *planeProjection(direction);
    const System3 system = *displayedSystem(*space(fractal));
    Shape<2> shape;
    for (const ifs::WeightedMap<3>& map : system.maps) {
        const ifs::AffineMap<2> flat{projection * map.map.linear * projection.transpose(),
                                     projection * map.map.translation};
        shape.system.maps.push_back({map.id, flat, map.weight, map.enabled});
    }
    fractal.shape = std::move(shape);
    fractal.supports = {};
    return fractal;
}

} // namespace document
