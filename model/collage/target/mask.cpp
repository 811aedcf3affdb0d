// SPDX-License-Identifier: MIT
#include "collage/target/mask.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace collage {

Mask emptyMask(int width, int height) {
    return {width, height, std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height))};
}

std::size_t area(const Mask& mask) {
    return std::size_t(std::ranges::count_if(mask.cells, [](std::uint8_t cell) { return cell != 0; }));
}

PixelBox boxOf(const Mask& mask) {
    PixelBox box{mask.width, mask.height, 0, 0};
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) {
            if (!mask(x, y)) continue;
            box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x + 1),
                   std::max(box.bottom, y + 1)};
        }
    return box.right == 0 ? PixelBox{} : box;
}

GreyPicture cropped(const GreyPicture& picture, const PixelBox& box) {
    GreyPicture part{box.width(), box.height(), {}, {}};
    for (int y = box.top; y < box.bottom; ++y) {
        const auto begin = std::ptrdiff_t(y) * picture.width + box.left;
        const auto end = begin + box.width();
        part.grey.insert(part.grey.end(), picture.grey.begin() + begin, picture.grey.begin() + end);
        part.opacity.insert(part.opacity.end(), picture.opacity.begin() + begin,
                            picture.opacity.begin() + end);
    }
    return part;
}

std::optional<int> otsuThreshold(const std::vector<std::uint8_t>& levels) {
    std::array<double, 256> count{};
    for (const std::uint8_t level : levels)
        ++count[level];
    double sum = 0;
    for (std::size_t level = 0; level < count.size(); ++level)
        sum += double(level) * count[level];
    const auto total = double(levels.size());
    double below = 0, sumBelow = 0, best = 0;
    // Middle of the levels between two classes without anything between them: all of these levels are equally
    // good.
    int first = -1, last = -1;
    for (int level = 0; level < 255; ++level) {
        below += count[std::size_t(level)];
        sumBelow += level * count[std::size_t(level)];
        const double above = total - below;
        if (below == 0 || above == 0) continue;
        const double difference = sumBelow / below - (sum - sumBelow) / above;
        const double variance = below * above * difference * difference;
        if (variance > best) {
            best = variance;
            first = level;
        }
        if (variance == best) last = level;
    }
    if (first < 0) return std::nullopt;
    return (first + last) / 2;
}

bool isShapedByOpacity(const GreyPicture& picture) {
    return std::ranges::any_of(picture.opacity, [](std::uint8_t opacity) { return opacity < 128; });
}

Mask targetMask(const GreyPicture& picture, std::optional<int> threshold, Polarity polarity) {
    Mask mask = emptyMask(picture.width, picture.height);
    const bool byOpacity = isShapedByOpacity(picture);
    const std::optional<int> level = threshold   ? threshold
                                     : byOpacity ? std::optional(127)
                                                 : otsuThreshold(picture.grey);
    if (!level) return mask;
    for (std::size_t i = 0; i < mask.cells.size(); ++i) {
        const int shade = byOpacity ? 255 - picture.opacity[i] : picture.grey[i];
        mask.cells[i] = (shade <= *level) == (polarity == Polarity::Shape);
    }
    return mask;
}

} // namespace collage
