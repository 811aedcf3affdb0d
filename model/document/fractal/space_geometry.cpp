// SPDX-License-Identifier: MIT
#include "document/fractal/space_geometry.h"
#include "document/fractal/fractal_geometry.h"
#include "document/text/text.h"
#include "ifs/cage/cage_surface.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace document {

namespace {

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

constexpr double precision = 1e-6; // relative; no more digits are visible
constexpr double rough = 1e-3;

using Reach = std::function<double(const ifs::Vector<3>&)>; // max ⟨u, x⟩ over the displayed set

double farthest(const std::vector<ifs::Vector<3>>& points, const ifs::Vector<3>& u) {
    double most = u.dot(points.front());
    for (const ifs::Vector<3>& point : points)
        most = std::max(most, u.dot(point));
    return most;
}

// Points that contain the displayed picture: without an attractor, or where it is bent, the cage and the
// simplices around moved branches; of very many maps the simplex around them, because asking all of them
// takes long.
std::vector<ifs::Vector<3>> pointsAround(const Fractal& fractal, const ifs::ControlCage<3>& cage) {
    const Shape<3>& shape = *space(fractal);
    const bool isMoved = !shape.moved.empty();
    const bool bends = ifs::bends(cage);
    if (!spaceSupport(fractal) || (!isMoved && (bends || shape.system.maps.size() <= manyMapsInSpace)))
        return cage.current;
    std::vector<ifs::Vector<3>> points;
    std::optional<ifs::CageDeformation> bend;
    if (bends) {
        points = cage.current;
        bend.emplace(cage.rest, cage.current);
    }
    const ifs::AffineMap<3> placed = ifs::displayMap(cage);
    const auto vertices = fractal.supports.simplexInSpace(shape.system).rest;
    for (const ifs::AffineMap<3>& piece : shownPieces(shape))
        for (const ifs::Vector<3>& vertex : vertices) {
            const ifs::Vector<3> at = piece(vertex);
            points.push_back(bend ? (*bend)(at) : placed(at));
        }
    return points;
}

std::optional<Reach> reachOf(const Fractal& fractal, double tolerance) {
    const auto cage = spaceCage(fractal);
    if (!cage) return std::nullopt;
    const auto support = spaceSupport(fractal);
    if (!support || ifs::bends(*cage) || system3(fractal)->maps.size() > manyMapsInSpace)
        return
            [points = pointsAround(fractal, *cage)](const ifs::Vector<3>& u) { return farthest(points, u); };
    std::vector<ifs::AffineMap<3>> pieces = shownPieces(*space(fractal));
    for (ifs::AffineMap<3>& piece : pieces)
        piece = ifs::displayMap(*cage) * piece;
    return [support, pieces = std::move(pieces), tolerance](const ifs::Vector<3>& u) {
        double farthest = -HUGE_VAL;
        for (const ifs::AffineMap<3>& placed : pieces) {
            const ifs::Vector<3> inner = placed.linear.transpose() * u;
            const auto value = (*support)(inner, tolerance * support->radius() * inner.norm());
            const double reach =
                value.value + (tolerance > precision ? value.error : 0) + u.dot(placed.translation);
            farthest = std::max(farthest, reach);
        }
        return farthest;
    };
}

ifs::Vector<3> displayedAt(const ifs::ControlCage<3>& cage, const ifs::Vector<3>& point) {
    if (ifs::bends(cage)) return ifs::CageDeformation(cage.rest, cage.current)(point);
    return ifs::displayMap(cage)(point);
}

} // namespace

QString spaceObstacle(const Fractal& fractal) {
    if (space(fractal)) return {};
    return Text::tr("This entry is not a system in space.");
}

std::shared_ptr<const ifs::SupportFunction<3>> spaceSupport(const Fractal& fractal) {
    const System3* system = system3(fractal);
    return system ? fractal.supports.support(*system) : nullptr;
}

std::optional<ifs::ControlCage<3>> spaceCage(const Fractal& fractal) {
    const Shape<3>* shape = space(fractal);
    if (!shape) return std::nullopt;
    if (shape->cage) return shape->cage;
    const ifs::ControlCage<3>* lasting = fractal.lasting.space();
    return lasting ? *lasting : fractal.supports.simplexInSpace(shape->system);
}

bool isSpaceExtentKnown(const Fractal& fractal) {
    const System3* system = system3(fractal);
    return !system || fractal.supports.isSimplexKnown(*system);
}

std::optional<ifs::ControlCage<3>> knownSpaceCage(const Fractal& fractal) {
    const Shape<3>* shape = space(fractal);
    const bool costsNothing = shape && (shape->cage || fractal.lasting.space());
    return costsNothing || isSpaceExtentKnown(fractal) ? spaceCage(fractal) : std::nullopt;
}

Extent extentAlong(const Fractal& fractal, const ifs::Vector<3>& u) {
    const std::optional<Reach> reach = reachOf(fractal, precision);
    return reach ? Extent{-(*reach)(-u), (*reach)(u)} : Extent{};
}

std::optional<ifs::Vector<3>> centreOfPicture(const Fractal& fractal) {
    const auto support = spaceSupport(fractal);
    const auto cage = support ? spaceCage(fractal) : std::nullopt;
    if (!cage) return std::nullopt;
    if (system3(fractal)->maps.size() > manyMapsInSpace) return displayedAt(*cage, support->centre());
    if (ifs::bends(*cage)) {
        Fractal straight = fractal;
        space(straight)->cage = ifs::ControlCage<3>{cage->rest, cage->rest};
        return displayedAt(*cage, *centreOfPicture(straight));
    }
    const Reach reach = *reachOf(fractal, precision);
    ifs::Vector<3> centre;
    for (int i = 0; i < 3; ++i)
        centre[i] = (reach(ifs::Vector<3>::Unit(i)) - reach(-ifs::Vector<3>::Unit(i))) / 2;
    return centre;
}

std::function<double(const ifs::Vector<3>&)> reachOfVertices(std::vector<ifs::Vector<3>> vertices) {
    return [points = std::move(vertices)](const ifs::Vector<3>& u) { return farthest(points, u); };
}

attractor::OrbitCamera fittedToPicture(const Fractal& fractal, attractor::OrbitCamera camera, double margin) {
    const std::optional<Reach> reach = reachOf(fractal, rough);
    return reach ? attractor::fitted(std::move(camera), *reach, margin) : camera;
}

attractor::OrbitCamera fittedTo(const Fractal& fractal, attractor::OrbitCamera camera, double margin) {
    const auto cage = spaceCage(fractal);
    const std::optional<Reach> reach = reachOf(fractal, rough);
    if (!cage || !reach) return camera;
    const auto withCage = [&](const ifs::Vector<3>& u) {
        return std::max((*reach)(u), farthest(cage->current, u));
    };
    return attractor::fitted(std::move(camera), withCage, margin);
}

attractor::SpaceRequest spaceRequest(const Fractal& fractal, const attractor::OrbitCamera& camera) {
    attractor::SpaceRequest request;
    const Shape<3>* shape = space(fractal);
    if (shape) {
        request.system = shape->system;
        request.cage = shape->cage;
        request.moved = movedBranches(*shape);
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

} // namespace document
