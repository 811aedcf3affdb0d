// SPDX-License-Identifier: MIT
#include "ifs/copies/copy_error.h"

#include <algorithm>
#include <cmath>

namespace ifs {

CopyStep inside(const CopyStep& outer, const CopyStep& inner) {
    return {outer.linear * inner.linear, inner.level, inner.isProjection,
            outer.shift + spectralNorm<2>(outer.linear) * inner.shift,
            outer.missing + spectralNorm<2>(outer.linear) * inner.missing};
}

CopyDeviation deviation(const CopyExpansion& expansion, std::uint64_t maxCopies) {
    CopyDeviation result;
    std::vector<CopyStep> open = expansion.picture;
    for (std::uint64_t copies = 0; !open.empty(); ++copies) {
        if (copies > maxCopies) {
            result.largest = result.error = result.missing = HUGE_VAL;
            return result;
        }
        const CopyStep copy = open.back();
        open.pop_back();
        const bool isLeaf = copy.isProjection || copy.level == 0;
        if (isLeaf) result.missing = std::max(result.missing, copy.missing);
        if (copy.isProjection) { // a projection shows everything, however deep the picture
            result.error = std::max(result.error, copy.shift);
        } else if (copy.level == 0) {
            const double size = spectralNorm<2>(copy.linear) * expansion.diameter;
            result.largest = std::max(result.largest, size);
            result.area += std::abs(determinant<2>(copy.linear)) * expansion.area;
            result.length += size;
            const double longer = (copy.linear * expansion.fibre).norm();
            const double beyond =
                spectralNorm<2>(copy.linear) * std::min(expansion.diameter, expansion.excess);
            result.error = std::max(result.error, beyond + longer + copy.shift);
        } else {
            for (const CopyStep& inner : expansion.copies[std::size_t(copy.level)])
                open.push_back(inside(copy, inner));
        }
    }
    return result;
}

} // namespace ifs
