// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/space_request.h"
#include "attractor/samples/prepared_space.h"
#include "ifs/canonical_systems.h"

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
