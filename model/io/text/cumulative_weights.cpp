// SPDX-License-Identifier: MIT
#include "io/text/cumulative_weights.h"
#include "document/text/text.h"

#include <cmath>

namespace io {

std::optional<QString> cumulativeRemark(const std::vector<std::optional<double>>& weights) {
    constexpr double tolerance = 1e-6; // relative error of rounded values
    if (weights.size() < 2) return std::nullopt;
    double before = -1;
    for (const auto& weight : weights) {
        if (!weight || *weight < 0 || *weight < before) return std::nullopt;
        before = *weight;
    }
    const double beforeLast = *weights[weights.size() - 2];
    if (beforeLast == 0 || beforeLast == before) return std::nullopt; // excludes 0 0 1 and 1 1 1
    for (const int whole : {1, 100})
        if (std::abs(before - whole) <= tolerance * whole)
            return Text::tr("The weights rise to %1, so they may be running sums. They are read as weights; "
                            "to read them as sums, name their column “cumulative” instead of “p”.")
                .arg(whole);
    return std::nullopt;
}

} // namespace io
