// SPDX-License-Identifier: MIT
#include "web/engine_state.h"

#include "attractor/light/solid_appearance.h"
#include "attractor/light/solid_light.h"

#include <cstddef>
#include <utility>

namespace web {

double Engine::drawPlane(double samples, bool begin) {
    if (begin || !density) {
        Shown<2> now = shown(plane);
        attractor::RenderRequest request;
        request.camera = cameraOf(now);
        request.system = std::move(now.system);
        request.cage = std::move(now.cage);
        request.moved = std::move(now.moved);
        request.appearance = std::move(now.appearance);
        request.samples = std::uint64_t(samples);
        request.exposure = exposure;
        if (density)
            density->restart(std::move(request));
        else
            density = std::make_unique<attractor::Rendering>(std::move(request));
    }
    density->refine({}, std::uint64_t(samples));
    frame = density->frame(std::move(frame));
    exposure = frame.exposure;
    return double(frame.samples);
}

double Engine::drawCloud(attractor::SpaceRequest request, bool begin) {
    request.exposure = exposure;
    const std::uint64_t samples = request.samples;
    if (!cloud)
        cloud = std::make_unique<attractor::CloudRendering>(std::move(request));
    else if (begin)
        cloud->restart(std::move(request));
    cloud->refine({}, samples);
    exposure = cloud->exposure();
    cloud->tone(std::span(pixels));
    return double(cloud->samples());
}

void Engine::drawSolid(attractor::SpaceRequest request, const Shown<3>& now) {
    using attractor::LookInSpace;
    constexpr attractor::Look looks[] = {attractor::Look::Stone, attractor::Look::Ink,
                                         attractor::Look::Stone, attractor::Look::Stone,
                                         attractor::Look::Depth, attractor::Look::Normals};
    attractor::SolidAppearance shown = attractor::appearanceOf(looks[std::size_t(now.inSpace.look)]);
    if (shown.look != attractor::Look::Depth && shown.look != attractor::Look::Normals) {
        const attractor::Appearance standard;
        if (shown.look == attractor::Look::Stone || !(now.appearance.background == standard.background))
            shown.background = now.appearance.background;
        if (!(now.appearance.plain == standard.plain)) shown.plain = now.appearance.plain;
        shown.keyLight = attractor::lampAt(now.inSpace.lightAzimuth, now.inSpace.lightElevation);
        shown.fog = now.inSpace.fog;
        shown.palette = now.appearance.palette;
        shown.colourBy = now.inSpace.colourBy.value_or(now.appearance.colourBy == attractor::ColourBy::Map
                                                           ? attractor::SolidColour::Map
                                                           : attractor::SolidColour::Plain);
        for (std::size_t i = 0; i < space.system.maps.size(); ++i)
            shown.mapColours.push_back(attractor::mapColour(now.appearance, space.system.maps[i].id, i));
    }
    if (shown.colourBy == attractor::SolidColour::Address) request.key = attractor::SolidKey::Address;
    const attractor::OrbitCamera seen = request.camera;
    if (solid)
        solid->restart(std::move(request));
    else
        solid = std::make_unique<attractor::SolidRendering>(std::move(request));
    solid->draw();
    const double middle = seen.target.y(), reach = seen.height / 2;
    pixels = attractor::lit(solid->raster(), shown,
                            attractor::solidView(seen, middle - reach, middle + reach), alone);
}

double Engine::drawSpace(double samples, bool begin) {
    const Shown<3> now = shown(space);
    attractor::SpaceRequest request;
    request.system = now.system;
    request.cage = now.cage;
    request.moved = now.moved;
    request.camera = cameraOf(now);
    request.clip = now.inSpace.clip;
    request.appearance = now.appearance;
    request.samples = std::uint64_t(samples);
    if (now.inSpace.look == attractor::LookInSpace::XRay)
        request.cloudColour = attractor::CloudColour::MeanDepth;
    pixels.assign(std::size_t(orbit.size.width) * std::size_t(orbit.size.height), 0);
    if (attractor::showsCloud(now.inSpace.look)) return drawCloud(std::move(request), begin);
    drawSolid(std::move(request), now);
    return 0;
}

} // namespace web
