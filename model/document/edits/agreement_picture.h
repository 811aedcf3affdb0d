// SPDX-License-Identifier: MIT
#pragma once

#include "collage/measure/agreement.h"
#include "document/edits/collage_edits.h"

#include <QImage>
#include <QRectF>

#include <memory>

namespace document {

// The side of the comparison that is not the target.
enum class Compared { Collage, Attractor };
// Cells used for a measurement. Live takes the coarse cells of the target, if it has any: distances stay in
// pixels, and the bound stays one, though a larger one.
enum class Detail { Full, Live };

// Agreement of a fractal with a target, in numbers and as a picture over the plane.
struct MeasuredFractal {
    collage::Agreement agreement; // agreement of the requested sets
    double overlap = 1;           // overlap of the collage, as are the values that follow
    double contraction = 0;
    std::optional<double> bound;
    ifs::ContractingNorm<2> norm; // norm of the bound
    QImage picture; // both grey; too much red, hatched like /; missing blue, hatched like a backslash
    QRect used;     // pixels of the picture that are not empty
    QRectF area;    // area of the picture in the plane: top is its largest y, its height is positive
};

// nullopt when the maps cannot be compared. Any thread.
std::optional<MeasuredFractal> measured(const Fractal& fractal, const TracedPicture& traced,
                                        Compared compared, Detail detail = Detail::Full);

} // namespace document
