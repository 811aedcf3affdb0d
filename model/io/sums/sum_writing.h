// SPDX-License-Identifier: MIT
#pragma once

#include "io/sums/sum_files.h"

#include <functional>
#include <memory>
#include <span>

// What files of sums of the plane and of space have in common.
namespace io {

// Whole rows of tiles: rows from `first` on whose number is a multiple of 16 begin and end them.
void writeTiles(const attractor::CellSums& sums, const SumHeader& header, SumWriter& writer);

// Writes a file of sums, filled by fill(), which is false when stopped or one of the files fails.
ExportOutcome writeSums(const SumHeader& header, const std::shared_ptr<SumFiles>& files,
                        const std::function<bool(SumWriter&)>& fill, const QString& path);

// What is drawn here of a picture, and what the files hold.
attractor::DividedPicture dividedPicture(const std::vector<std::uint64_t>& passes,
                                         const std::vector<SumShare>& drawn,
                                         const std::shared_ptr<SumFiles>& files);

// Why a picture cannot be drawn again as the file of this name has it.
QString otherPixels(const QString& name);

// What is missing of a picture of so many rows of pixels; nullopt when all units of all passes are there.
Failure missingIn(const SumHeader& header, int rows,
                  const std::function<std::uint64_t(std::span<const std::uint64_t> passes)>& units);

} // namespace io
