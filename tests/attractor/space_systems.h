// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/space_request.h"
#include "attractor/samples/prepared_space.h"
#include "ifs/canonical_systems.h"

#include <array>

// Systems in space; docs/mathematics.md, "Canonical test systems".
namespace systems {

using System3 = ifs::IteratedFunctionSystem<3>;

inline ifs::AffineMap<3> scaled(double ratio, double x, double y, double z) {
    ifs::AffineMap<3> map;
    map.linear *= ratio;
    map.translation = {x, y, z};
    return map;
}

inline System3 menger() { // in the unit cube
    System3 result;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                if ((i == 1) + (j == 1) + (k == 1) < 2)
                    ifs::append<3>(result, scaled(1.0 / 3, i / 3.0, j / 3.0, k / 3.0));
    return result;
}

inline System3 tetrahedron() { // between corners of the unit cube
    System3 result;
    for (const auto& [x, y, z] : {std::array{0., 0., 0.}, {.5, .5, 0.}, {.5, 0., .5}, {0., .5, .5}})
        ifs::append<3>(result, scaled(0.5, x, y, z));
    return result;
}

inline System3 fern3() {
    return canonical::system(canonical::fern3(), canonical::fernWeights);
}

// Five maps of a body onto pieces that lie on each other: together they have 2.2 times its volume.
inline System3 heavyOverlaps() {
    constexpr std::array<std::array<double, 12>, 5> rows{
        {{-0.560, -0.523, -0.145, 0.624, -0.490, -0.199, 0.167, -0.073, 0.726, -0.195, 0.637, -0.957},
         {-0.082, -0.458, 0.671, -0.648, -0.270, -0.258, 0.407, -0.663, -0.235, 0.027, 0.347, -0.757},
         {-0.373, -0.499, 0.148, 0.360, -0.427, -0.558, -0.516, 0.245, -0.481, 0.374, -0.934, 0.811},
         {-0.371, 0.330, -0.560, -0.575, -0.466, 0.141, -0.349, 0.529, 0.504, 0.253, -0.001, 0.475},
         {0.254, -0.511, 0.669, -0.387, -0.576, -0.202, -0.691, 0.151, 0.279, 0.493, -0.009, -0.765}}};
    System3 result;
    for (const auto& row : rows) {
        ifs::AffineMap<3> map;
        for (int k = 0; k < 9; ++k)
            map.linear(k / 3, k % 3) = row[std::size_t(k)];
        map.translation = {row[9], row[10], row[11]};
        ifs::append<3>(result, map);
    }
    return result;
}

// All of the attractor in a picture of the given size.
inline attractor::SpaceRequest spaceRequest(const System3& system, int width, int height, double azimuth = 30,
                                            double elevation = 20) {
    attractor::SpaceRequest request;
    request.system = system;
    request.camera.size = {width, height};
    request.camera.orientation = attractor::orbit(azimuth, elevation);
    const attractor::PreparedSpace prepared = attractor::preparedSpace(system);
    if (const auto support = ifs::SupportFunction<3>::of(prepared.maps))
        request.camera = attractor::fitted(request.camera, *support, {});
    else
        request.camera = attractor::fitted(request.camera, prepared.centre - prepared.halfExtent,
                                           prepared.centre + prepared.halfExtent);
    return request;
}

} // namespace systems
