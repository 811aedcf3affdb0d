// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace geometry {

// How long certified geometry takes for each plane system of the bundled collection: the shortest of
// `repetitions` times of this thread, from the maps on, in ascending order.
struct Distribution {
    std::string name;
    std::vector<double> milliseconds = {};
    int missed = 0; // systems whose certificate is wider than asked for
};

// The convex hull to 1e-6 of the diagonal of the box, and the minimal canonical simplex to 1e-11 of its leg.
std::vector<Distribution> measureCollection(int repetitions);

} // namespace geometry
