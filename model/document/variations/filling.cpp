// SPDX-License-Identifier: MIT
#include "document/variations/filling.h"

#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"

#include "attractor/render/cloud_rendering.h"
#include "attractor/render/renderer.h"
#include "ifs/links/linked_existence.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace document {

namespace {

constexpr int side = 32; // cells along a side of the grid
constexpr std::uint64_t samples = std::uint64_t{20} * side * side;
constexpr double azimuth = 30; // degrees; first view of a solid
constexpr double elevation = 20;

double shareOf(std::span<const std::uint32_t> pixels) {
    const auto drawn = std::ranges::count_if(pixels, [](std::uint32_t pixel) { return (pixel >> 24) >= 32; });
    return double(drawn) / (side * side);
}

attractor::Appearance opaquePoints() {
    attractor::Appearance appearance;
    appearance.colourBy = attractor::ColourBy::Plain;
    appearance.background = {0, 0, 0, 0};
    return appearance;
}

template <int Dim> double aspectOf(const ifs::Vector<Dim>& size) {
    return size.maxCoeff() > 0 ? size.minCoeff() / size.maxCoeff() : 0;
}

Filling fillingOfPlane(const Fractal& bare) {
    const auto box = displayedBox(bare);
    if (!box) return {};
    attractor::Camera camera;
    camera.width = camera.height = side;
    attractor::RenderRequest request = renderRequest(bare, attractor::fitted(camera, box->min, box->max, 0));
    request.samples = samples;
    request.appearance = opaquePoints();
    return {shareOf(attractor::render(request).pixels), aspectOf<2>(box->max - box->min)};
}

Filling fillingOfSpace(const Fractal& bare) {
    if (!spaceSupport(bare)) return {};
    ifs::Vector<3> size;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const Extent extent = extentAlong(bare, ifs::Vector<3>::Unit(axis));
        size[axis] = extent.high - extent.low;
    }
    attractor::OrbitCamera camera;
    camera.orientation = attractor::orbit(azimuth, elevation);
    camera.size.width = camera.size.height = side;
    attractor::SpaceRequest request = spaceRequest(bare, fittedToPicture(bare, camera, 0));
    request.samples = samples;
    request.appearance = opaquePoints();
    attractor::CloudRendering rendering(std::move(request));
    std::vector<std::uint32_t> pixels(std::size_t(side) * side);
    if (!rendering.refine() || !rendering.tone(pixels)) return {};
    return {shareOf(pixels), aspectOf<3>(size)};
}

template <int Dim> Fractal bareOf(const ifs::IteratedFunctionSystem<Dim>& system) {
    Fractal bare;
    bare.shape = Shape<Dim>{system};
    return bare;
}

template <int Dim> bool isCertain(const ifs::IteratedFunctionSystem<Dim>& system) {
    return ifs::classifyLinked<Dim>(ifs::activeMaps(system)).hasFactor();
}

} // namespace

Filling filling(const Fractal& fractal) {
    if (const System2* system = system2(fractal)) return fillingOfPlane(bareOf(*system));
    if (const System3* system = system3(fractal)) return fillingOfSpace(bareOf(*system));
    return {};
}

double fillsAs(const Filling& filling, const Filling& wanted) {
    const auto part = [](double is, double shall) { return shall > 0 ? is / shall : 1; };
    return std::min(part(filling.share, wanted.share), part(filling.aspect, wanted.aspect));
}

bool hasCertainAttractor(const Fractal& fractal) {
    if (const System2* system = system2(fractal)) return isCertain(*system);
    const System3* system = system3(fractal);
    return system && isCertain(*system);
}

} // namespace document
