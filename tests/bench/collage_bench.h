// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

// Collages: random starts against a plain fit, and the numbers beside a map that is dragged.
namespace collage_bench {

// How many starts the search makes while a plain one makes one: 4 maps, a target of 128 × 128 cells, 40
// iterations, one thread. The plain one is scalar and in double precision, with whole feature transforms.
// Shortest of `repetitions`, which take turns; NaN if the plain one does not fit as well.
double startsRatio(int repetitions);

struct Drag {
    std::vector<double> picture; // milliseconds until the picture of a mouse event has been painted,
    std::vector<double> numbers; // and until the numbers of it or of a later event are shown
};
// A map dragged by a corner in a canvas of 1920 × 1080 pixels, with the panel of collages open, or without
// a target; the target has 512 × 512 pixels. Needs a QApplication.
enum class WithTarget { No, Yes };
Drag drag(WithTarget target, int events);

} // namespace collage_bench
