// SPDX-License-Identifier: MIT
#include "document/space_geometry.h"

#include "ifs/extent/extent.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace document {

namespace {

// Looser than rounding, as in the plane: nobody sees more digits.
constexpr double relativeTolerance = 1e-6;

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
    return ifs::cageAtRest<3>(
        ifs::minimalCanonicalSimplex(*support, relativeTolerance * support->radius()).vertices);
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
    request.camera = camera;
    request.appearance = fractal.appearance;
    return request;
}

attractor::SolidAppearance solidAppearance(const Fractal& fractal) {
    attractor::SolidAppearance result;
    const attractor::Appearance& appearance = fractal.appearance;
    result.background = appearance.background;
    if (appearance.colourBy != attractor::ColourBy::Map) return result;
    result.colourBy = attractor::SolidColour::Map;
    if (const System3* system = system3(fractal))
        for (std::size_t i = 0; i < system->maps.size(); ++i)
            result.mapColours.push_back(attractor::mapColour(appearance, system->maps[i].id, i));
    return result;
}

Fractal withSpaceCageMoved(Fractal fractal, ifs::ControlCage<3> cage) {
    if (Shape<3>* shape = space(fractal)) shape->cage = std::move(cage);
    return fractal;
}

} // namespace document
