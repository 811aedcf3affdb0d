// SPDX-License-Identifier: MIT
#include "attractor/light/stereo.h"

#include <algorithm>
#include <cstddef>

namespace attractor {

namespace {

// The grey of code values, as colours are weighed on screens (Rec. 709).
std::uint32_t grey(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
    return (2126 * red + 7152 * green + 722 * blue + 5000) / 10000;
}

std::uint32_t anaglyph(std::uint32_t left, std::uint32_t right) {
    const std::uint32_t red = grey(left >> 16 & 0xFF, left >> 8 & 0xFF, left & 0xFF);
    return std::max(left >> 24, right >> 24) << 24 | red << 16 | (right & 0xFFFF);
}

Rgba16 anaglyph(const Rgba16& left, const Rgba16& right) {
    return {static_cast<std::uint16_t>(grey(left.red, left.green, left.blue)), right.green, right.blue,
            std::max(left.alpha, right.alpha)};
}

template <class Pixel>
std::vector<Pixel> both(Stereo stereo, const std::vector<Pixel>& left, const std::vector<Pixel>& right,
                        int width) {
    std::vector<Pixel> result;
    if (stereo == Stereo::Anaglyph) {
        result.reserve(left.size());
        for (std::size_t k = 0; k < left.size(); ++k)
            result.push_back(anaglyph(left[k], right[k]));
        return result;
    }
    result.reserve(2 * left.size());
    for (auto from = std::ptrdiff_t{0}; from < std::ptrdiff_t(left.size()); from += width) {
        result.insert(result.end(), left.begin() + from, left.begin() + from + width);
        result.insert(result.end(), right.begin() + from, right.begin() + from + width);
    }
    return result;
}

} // namespace

std::vector<std::uint32_t> joined(Stereo stereo, const std::vector<std::uint32_t>& left,
                                  const std::vector<std::uint32_t>& right, int width) {
    return both(stereo, left, right, width);
}

std::vector<Rgba16> joined(Stereo stereo, const std::vector<Rgba16>& left, const std::vector<Rgba16>& right,
                           int width) {
    return both(stereo, left, right, width);
}

} // namespace attractor
