// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/voxels/voxel_surface.h"
#include "document/fractal/fractal.h"
#include "io/picture/plane_export.h"

#include <QString>

#include <cstdint>
#include <stop_token>

namespace io {

// Settings that turn a fractal in space into a body to print. Lengths are millimetres.
struct SolidOptions {
    static constexpr int maxResolution = 4096;
    static constexpr int leastOffered = 8; // least resolution at which anything is recognisable

    double longest = 0;   // of the sides of the mesh; 0: one unit of the system is a millimetre
    double voxel = 0;     // h, or a little less with a longest side; 0: by the resolution
    int resolution = 128; // h is the longest side divided by this
    double wall = 0;      // every point of the body lies in a ball of this diameter within it
    bool fillsCavities = false;
};

// Certified facts about the body S of an attractor A: A ⊂ S, and every point of S that is not in a filled
// cavity is within `bound` of A. docs/mathematics.md, "Voxels".
struct SolidFacts {
    ifs::Vector<3> size = ifs::Vector<3>::Zero(); // mm
    double volume = 0;                            // mm³
    double voxel = 0;                             // h
    double dilation = 0;                          // growth that makes the walls thick enough
    double bound = 0;                             // √3 h + dilation
    std::uint64_t islands = 0;                    // connected bodies
    std::uint64_t cavities = 0;                   // cavities without a way out, filled or not
    double cavityVolume = 0;                      // mm³
    std::uint64_t triangles = 0;
};
QString summaryOf(const SolidFacts& facts, const SolidOptions& options); // complete lines

// A body in millimetres: point i is origin + unit·mesh.points[i].
struct PrintableSolid {
    attractor::SurfaceMesh mesh;
    ifs::Vector<3> origin = ifs::Vector<3>::Zero();
    double unit = 1;
    SolidFacts facts;
    Failure failure;
    bool stopped = false;
};

// Why there is no body of it, as far as its cage and its dimension tell; this takes no time.
Failure obstacleToSolid(const document::Fractal& fractal);
// The same with these options, as far as can be known before any voxel is looked at.
Failure obstacleToSolid(const document::Fractal& fractal, const SolidOptions& options);

// The body; its surface is closed and a manifold, or there is a failure.
PrintableSolid printableSolid(const document::Fractal& fractal, const SolidOptions& options,
                              const Progress& progress = {}, const std::stop_token& stop = {});

} // namespace io
