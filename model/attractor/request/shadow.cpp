// SPDX-License-Identifier: MIT
#include "attractor/request/shadow.h"

#include "attractor/colour/palette.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace attractor {

namespace {

// Dark enough for a shadow on paper, and light enough to be seen on a dark ground.
Rgba darkened(const Rgba& colour) {
    constexpr double kept = 0.4; // share kept of each code value
    const auto channel = [](std::uint8_t value) {
        return static_cast<std::uint8_t>(std::lround(kept * value));
    };
    return {channel(colour.red), channel(colour.green), channel(colour.blue), colour.alpha};
}

} // namespace

ifs::AffineMap<2> shadowMap(const Appearance& appearance, double ground, YAxis yAxis) {
    const double up = yAxis == YAxis::Up ? 1 : -1;
    ifs::AffineMap<2> map;
    map.linear << 1, up * appearance.shadowLean, 0, appearance.shadowLength;
    map.translation << -up * appearance.shadowLean * ground, (1 - appearance.shadowLength) * ground;
    return map;
}

Appearance shadowAppearance(const Appearance& appearance, const ifs::IteratedFunctionSystem<2>& system) {
    Appearance result = appearance;
    result.shadow = 0;
    result.background.alpha = 0;
    result.plain = darkened(appearance.plain);
    for (Palette::Stop& stop : result.palette.stops)
        stop.colour = darkened(stop.colour);
    if (appearance.colourBy != ColourBy::Map) return result;
    for (std::size_t index = 0; index < system.maps.size(); ++index) {
        const ifs::MapId id = system.maps[index].id;
        result.mapColours[id] = darkened(mapColour(appearance, id, index));
    }
    return result;
}

// Every cage is affine in its current vertices, whether it bends or not.
ifs::ControlCage<2> movedCage(const std::optional<ifs::ControlCage<2>>& cage, const ifs::AffineMap<2>& map) {
    ifs::ControlCage<2> moved =
        cage && ifs::isValid(*cage)
            ? *cage
            : ifs::cageAtRest<2>({ifs::Vector<2>(0, 0), ifs::Vector<2>(1, 0), ifs::Vector<2>(0, 1)});
    for (ifs::Vector<2>& vertex : moved.current)
        vertex = map(vertex);
    return moved;
}

bool hasShadow(const RenderRequest& request) {
    return request.shadow && request.appearance.shadow > 0;
}

std::optional<RenderRequest> shadowRequest(const RenderRequest& request) {
    if (!hasShadow(request)) return std::nullopt;
    RenderRequest result = request;
    result.shadow.reset();
    result.exposure.reset();
    result.cage = movedCage(request.cage, *request.shadow);
    result.appearance = shadowAppearance(request.appearance, request.system);
    result.samples = shadowSamples(request, request.samples);
    return result;
}

RenderRequest requestAboveShadow(RenderRequest request) {
    request.shadow.reset();
    request.appearance.background.alpha = 0;
    return request;
}

std::uint64_t shadowSamples(const RenderRequest& request, std::uint64_t samples) {
    if (request.algorithm != Algorithm::Density || !request.shadow) return samples;
    constexpr double least = 0.125, most = 4;
    const double area = std::clamp(std::abs(ifs::determinant<2>(request.shadow->linear)), least, most);
    return static_cast<std::uint64_t>(static_cast<double>(samples) * area + 0.5);
}

} // namespace attractor
