// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace attractor {

// Picture of a solid, rows from the top: in every pixel the smallest key of all points that fall into it. The
// upper 24 bits are depth, linear from 0 at `near` to 0xFFFFFE at `far`; the lower 8 are a colour, the first
// map of the point's address modulo 256. `near` and `far` are depths along the view away from the eye, in
// units of the system, 0 in the plane of the target.
struct DepthRaster {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> keys; // all rows, or a range of them
    double near = 0;
    double far = 0;
    int firstRow = 0; // first row that is kept

    bool holds(int y) const { return y >= firstRow && y < height && offset(y) < keys.size(); }
    const std::uint32_t* row(int y) const { return keys.data() + offset(y); }
    std::uint32_t* row(int y) { return keys.data() + offset(y); }

private:
    std::size_t offset(int y) const {
        return static_cast<std::size_t>(y - firstRow) * static_cast<std::size_t>(width);
    }
};

constexpr std::uint32_t emptyKey = 0xFFFFFFFF; // key of an empty pixel
constexpr std::uint32_t maxDepthCode = 0xFFFFFE;

// The depth in a key that is not empty.
inline std::uint32_t depthCode(std::uint32_t key) {
    return key >> 8;
}
inline std::uint8_t colourIndex(std::uint32_t key) {
    return static_cast<std::uint8_t>(key & 0xFF);
}
inline double depthOf(const DepthRaster& raster, std::uint32_t key) {
    return raster.near + (raster.far - raster.near) * depthCode(key) / maxDepthCode;
}

} // namespace attractor
