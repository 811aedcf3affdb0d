// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace attractor {

// A picture of Algorithm::Density is a set of units: the words of the cut for sample set s, in their order,
// are divided into `unitsPerSet` runs of equal numbers of words, and run r is unit s·unitsPerSet + r. Sums
// over disjoint sets of units add up to the sums over their union, so that several machines draw one picture.
struct PicturePart {
    static constexpr std::uint64_t unitsPerSet = 64;

    // The units u with u mod count = index; none for a count of 0.
    std::uint64_t index = 0;
    std::uint64_t count = 1;

    bool holds(std::uint64_t unit) const { return count > 0 && unit % count == index; }
    // Returns true if any unit of [first, end) belongs to the part.
    bool meets(std::uint64_t first, std::uint64_t end) const { return unitsBefore(end) > unitsBefore(first); }
    std::uint64_t unitsBefore(std::uint64_t end) const {
        return count > 0 && end > index ? (end - index - 1) / count + 1 : 0;
    }

    friend bool operator==(const PicturePart&, const PicturePart&) = default;
};

} // namespace attractor
