// SPDX-License-Identifier: MIT
#pragma once

#include "io/picture/space_export.h"
#include "io/sums/sum_files.h"

#include <cstdint>
#include <memory>
#include <vector>

// picture_sums.h for pictures in space. A cloud is counted in parts as the density in the plane is. A solid
// has no samples: what is put together are its bands, of pixels. docs/formats.md, "Files of sums".
namespace io {

struct SpaceSums {
    SpaceExport picture;
    std::vector<std::uint64_t> passes; // solids: a single pass of 1
    std::vector<SumShare> drawn;       // same meaning as in PictureSums
    std::shared_ptr<SumFiles> files;   // nullptr: none
};

bool areOfSpace(const SumFiles& files);

// The picture that the request in sound files asks for.
struct LoadedSpaceSums {
    SpaceSums sums;
    Failure failure;
};
LoadedSpaceSums spaceSumsIn(const std::shared_ptr<SumFiles>& files, int threads);

// Like those for the plane. For a solid, `part` is all of the rows.
SpaceSums partOf(const SpaceExport& picture, int firstRow, int endRow, const attractor::PicturePart& part);
void addPass(SpaceSums& sums, std::uint64_t samples); // clouds only

ExportOutcome exportSums(const SpaceSums& sums, const QString& path, const Progress& progress = {},
                         std::stop_token stop = {});
Failure incompleteness(const SpaceSums& sums);
// A solid has the bits per channel of its bands.
ExportOutcome exportPicture(const SpaceSums& sums, const QString& path, const Progress& progress = {},
                            std::stop_token stop = {});

} // namespace io
