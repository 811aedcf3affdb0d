// SPDX-License-Identifier: MIT
#include "document/space_geometry.h"

#include "ifs/extent/extent.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace document {

namespace {

// Looser than rounding, as in the plane: nobody sees more digits.
constexpr double relativeTolerance = 1e-6;
// The window waits for the cage: of so many maps it may be a little larger than it has to be.
constexpr std::size_t manyMaps = 10'000;
constexpr double coarseTolerance = 1e-2;

// Clouds have none: that of the solid behind them.
attractor::Look solidLook(attractor::LookInSpace look) {
    using attractor::LookInSpace;
    switch (look) {
    case LookInSpace::Ink:
        return attractor::Look::Ink;
    case LookInSpace::Depth:
        return attractor::Look::Depth;
    case LookInSpace::Normals:
        return attractor::Look::Normals;
    case LookInSpace::Stone:
    case LookInSpace::Cloud:
    case LookInSpace::XRay:
        break;
    }
    return attractor::Look::Stone;
}

} // namespace

QString spaceObstacle(const Fractal& fractal) {
    if (space(fractal)) return {};
    return QCoreApplication::translate("document::SpaceGeometry", "This entry is not a system in space.");
}

std::shared_ptr<const ifs::SupportFunction<3>> spaceSupport(const Fractal& fractal) {
    const System3* system = system3(fractal);
    if (!system) return nullptr;
    auto support = ifs::SupportFunction<3>::of(ifs::activeMaps(*system).maps);
    return support ? std::make_shared<const ifs::SupportFunction<3>>(*std::move(support)) : nullptr;
}

std::optional<ifs::ControlCage<3>> spaceCage(const Fractal& fractal) {
    const Shape<3>* shape = space(fractal);
    if (!shape) return std::nullopt;
    if (shape->cage) return shape->cage;
    const auto support = spaceSupport(fractal);
    if (!support) return ifs::polygonAtRest<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    const double tolerance = shape->system.maps.size() > manyMaps ? coarseTolerance : relativeTolerance;
    auto simplex = ifs::minimalCanonicalSimplex(*support, tolerance * support->radius());
    constexpr double rounding = 1e-14; // numbers that should be none are no sight in a table
    for (ifs::Vector<3>& vertex : simplex.vertices)
        vertex =
            vertex.unaryExpr([&](double x) { return std::abs(x) <= rounding * support->radius() ? 0 : x; });
    return ifs::cageAtRest<3>(simplex.vertices);
}

Extent extentAlong(const Fractal& fractal, const ifs::Vector<3>& u) {
    const auto cage = spaceCage(fractal);
    if (!cage) return {};
    const ifs::AffineMap<3> placed = ifs::displayMap(*cage);
    const auto support = spaceSupport(fractal);
    const auto reach = [&](const ifs::Vector<3>& direction) {
        double most = direction.dot(cage->current.front());
        if (support) {
            const ifs::Vector<3> inner = placed.linear.transpose() * direction;
            return (*support)(inner, relativeTolerance * support->radius()).value +
                   direction.dot(placed.translation);
        }
        for (const ifs::Vector<3>& vertex : cage->current)
            most = std::max(most, direction.dot(vertex));
        return most;
    };
    return {-reach(-u), reach(u)};
}

attractor::OrbitCamera fittedTo(const Fractal& fractal, attractor::OrbitCamera camera, double margin) {
    const auto support = spaceSupport(fractal);
    const auto cage = spaceCage(fractal);
    if (!cage) return camera;
    const ifs::AffineMap<3> placed = ifs::displayMap(*cage);
    const double fine = support ? 1e-3 * support->radius() : 0;
    const auto reach = [&](const ifs::Vector<3>& u) {
        double most = u.dot(cage->current.front());
        for (const ifs::Vector<3>& vertex : cage->current)
            most = std::max(most, u.dot(vertex));
        if (!support) return most;
        const ifs::Vector<3> inner = placed.linear.transpose() * u;
        const auto value = (*support)(inner, fine * inner.norm());
        return std::max(most, value.value + value.error + u.dot(placed.translation));
    };
    return attractor::fitted(std::move(camera), reach, margin);
}

attractor::SpaceRequest spaceRequest(const Fractal& fractal, const attractor::OrbitCamera& camera) {
    attractor::SpaceRequest request;
    const Shape<3>* shape = space(fractal);
    if (shape) {
        request.system = shape->system;
        request.cage = shape->cage;
    }
    request.clip = fractal.inSpace.clip;
    if (solidColour(fractal) == attractor::SolidColour::Address) request.key = attractor::SolidKey::Address;
    if (fractal.inSpace.look == attractor::LookInSpace::XRay)
        request.cloudColour = attractor::CloudColour::MeanDepth;
    request.camera = camera;
    request.appearance = fractal.appearance;
    return request;
}

attractor::SolidColour solidColour(const Fractal& fractal) {
    using attractor::SolidColour;
    const bool byMap = fractal.appearance.colourBy == attractor::ColourBy::Map;
    return fractal.inSpace.colourBy.value_or(byMap ? SolidColour::Map : SolidColour::Plain);
}

attractor::SolidAppearance solidAppearance(const Fractal& fractal) {
    using attractor::LookInSpace;
    const attractor::SpaceAppearance& inSpace = fractal.inSpace;
    const attractor::Appearance& appearance = fractal.appearance;
    const attractor::Appearance standard;
    attractor::SolidAppearance result = attractor::appearanceOf(solidLook(inSpace.look));
    if (result.look == attractor::Look::Stone || !(appearance.background == standard.background))
        result.background = appearance.background;
    if (result.look == attractor::Look::Depth || result.look == attractor::Look::Normals) return result;
    if (!(appearance.plain == standard.plain)) result.plain = appearance.plain;
    result.keyLight = attractor::lampAt(inSpace.lightAzimuth, inSpace.lightElevation);
    result.fog = inSpace.fog;
    result.palette = appearance.palette;
    result.colourBy = solidColour(fractal);
    if (const System3* system = system3(fractal); system && result.colourBy == attractor::SolidColour::Map)
        for (std::size_t i = 0; i < system->maps.size(); ++i)
            result.mapColours.push_back(attractor::mapColour(appearance, system->maps[i].id, i));
    return result;
}

attractor::Rgba backgroundInSpace(const Fractal& fractal) {
    const bool isCloud = attractor::showsCloud(fractal.inSpace.look);
    return isCloud ? fractal.appearance.background : solidAppearance(fractal).background;
}

Fractal withSpaceCageMoved(Fractal fractal, ifs::ControlCage<3> cage) {
    if (Shape<3>* shape = space(fractal)) shape->cage = std::move(cage);
    return fractal;
}

} // namespace document
