// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

#include <QString>

#include <optional>
#include <span>

// Maps turned over, rotated and arranged by their images of the cage, as they are displayed. The centre of a
// map is the mean of the corners of its image; that of several maps the mean of their centres.
namespace document {

enum class MapsArrangement {
    FlipLeftRight, // flips all together about their centre
    FlipUpDown,
    RotateLeft, // 90° counter-clockwise with y up
    RotateRight,
    AlignInRow,       // centres at one height, their mean
    AlignInColumn,    // centres at one x, their mean
    DistributeAcross, // centres evenly between the outermost two
    DistributeUpwards,
    FitToCorners, // each map to the nearest corner of the cage, which becomes its fixed point
};

// Arranges maps of the plane. `indices` ascending, without doubles.
Fractal arranged(const Fractal& fractal, std::span<const std::size_t> indices, MapsArrangement arrangement);

// Arranges in one undo step; returns why nothing was done.
std::optional<QString> arrangeMaps(Document& document, std::span<const std::size_t> indices,
                                   MapsArrangement arrangement);

} // namespace document
