// SPDX-License-Identifier: MIT
#pragma once

#include "io/picture/plane_export.h"
#include "io/sums/sum_files.h"

#include <memory>
#include <optional>
#include <vector>

// A picture whose samples are counted by several machines or in several runs (docs/formats.md, Files of
// sums).
namespace io {

// A picture in parts: `drawn` is to be drawn here, the rest is in the files. The first pass has as many
// samples as the request.
struct PictureSums {
    PlaneExport picture;
    std::vector<std::uint64_t> passes;
    std::vector<SumShare> drawn; // at most one share of each pass, all of the same rows; none is in the files
    std::shared_ptr<SumFiles> files; // nullptr: none
};

// The picture that the request in sound files asks for.
struct LoadedSums {
    PictureSums sums;
    Failure failure;
};
LoadedSums sumsIn(const std::shared_ptr<SumFiles>& files, int threads);

// The units in rows [firstRow, endRow) of the picture as the file will name it: drawn from the text of its
// request, so that every machine draws the same.
PictureSums partOf(const PlaneExport& picture, int firstRow, int endRow, const attractor::PicturePart& part);
// Adds a pass of `samples` samples to those that the files hold.
void addPass(PictureSums& sums, std::uint64_t samples);

// Draws the missing part and writes it, together with the sums in the files, into one file of sums.
ExportOutcome exportSums(const PictureSums& sums, const QString& path, const Progress& progress = {},
                         std::stop_token stop = {});
// A description of the missing parts; nullopt when all units of all passes are there.
Failure incompleteness(const PictureSums& sums);
// The picture itself, unless it is incomplete.
ExportOutcome exportPicture(const PictureSums& sums, const QString& path, const Progress& progress = {},
                            std::stop_token stop = {});

} // namespace io
