// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

// The target of a collage: the pixels of a picture that belong to the shape to be approximated.
namespace collage {

// Rows from the top, `width` values each. Opacity 255 is opaque.
struct GreyPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> grey;
    std::vector<std::uint8_t> opacity;
};

// Rows from the top; 1 where a pixel belongs to the shape, else 0.
struct Mask {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> cells;

    bool operator()(int x, int y) const { return cells[index(x, y)] != 0; }
    std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(width) + std::size_t(x); }

    friend bool operator==(const Mask&, const Mask&) = default;
};
Mask emptyMask(int width, int height);
std::size_t area(const Mask& mask); // number of pixels

// Pixels from `left` to `right`, exclusive, and from `top` to `bottom`, exclusive.
struct PixelBox {
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;

    int width() const { return right - left; }
    int height() const { return bottom - top; }

    friend bool operator==(const PixelBox&, const PixelBox&) = default;
};
PixelBox boxOf(const Mask& mask); // smallest box around the shape; all 0 for an empty mask
// The part of a picture within the box, which must not extend beyond the picture.
GreyPicture cropped(const GreyPicture& picture, const PixelBox& box);

// The grey level t that separates the levels ≤ t from those above best (Otsu 1979: the greatest variance
// between both classes); nullopt when all levels are equal.
std::optional<int> otsuThreshold(const std::vector<std::uint8_t>& levels);

enum class Polarity { Shape, Background }; // pixels that targetMask() selects

// Returns true if there are transparent pixels, so that the opaque ones are the shape.
bool isShapedByOpacity(const GreyPicture& picture);

// The shape in a picture: its opaque pixels if it has transparent ones (opacity below 128), else its dark
// ones. A pixel is dark when its grey level is ≤ threshold, and opaque when 255 − opacity is; without a
// threshold, Otsu's and 127 serve. Polarity::Background takes the other pixels. All pixels of one grey level
// give an empty mask.
Mask targetMask(const GreyPicture& picture, std::optional<int> threshold, Polarity polarity);

} // namespace collage
