// SPDX-License-Identifier: MIT
#pragma once

#include "io/sums/sum_files.h"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

// Code shared by files of sums of the plane and of space.
namespace io {

// Whole rows of tiles: rows from `first` on whose number is a multiple of 16 begin and end them.
void writeTiles(const attractor::CellSums& sums, const SumHeader& header, SumWriter& writer);

// Writes a file of sums, filled by fill(), which is false when stopped or one of the files fails.
ExportOutcome writeSums(const SumHeader& header, const std::shared_ptr<SumFiles>& files,
                        const std::function<bool(SumWriter&)>& fill, const QString& path);

// Combines the shares to draw here with those in the files.
attractor::DividedPicture dividedPicture(const std::vector<std::uint64_t>& passes,
                                         const std::vector<SumShare>& drawn,
                                         const std::shared_ptr<SumFiles>& files);

// Why a picture cannot be drawn again as the file of this name has it.
QString otherPixels(const QString& name);

// Returns true if both have the same cells, of the same kind.
bool haveSameCells(const SumHeader& a, const SumHeader& b);

// Makes of `sums` what the files hold: of the picture that their request asks for. False if it asks for none.
template <class Sums, class Picture>
bool takeFiles(Sums& sums, const std::optional<Picture>& picture, const std::shared_ptr<SumFiles>& files,
               int threads) {
    if (picture) sums.picture = *picture;
    sums.picture.request.threads = threads;
    sums.picture.request.samples = files->header().passes.front();
    sums.passes = files->header().passes;
    sums.files = files;
    return picture.has_value();
}

// A description of the parts missing in a picture of `rows` rows of pixels; nullopt when all units of all
// passes are there.
Failure missingIn(const SumHeader& header, int rows,
                  const std::function<std::uint64_t(std::span<const std::uint64_t> passes)>& units);

} // namespace io
