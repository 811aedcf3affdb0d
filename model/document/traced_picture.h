// SPDX-License-Identifier: MIT
#pragma once

#include "collage/target/target.h"
#include "document/fractal/fractal_geometry.h"

#include <optional>
#include <vector>

namespace document {

// Selection of the pixels of a picture that are the target of a collage.
struct TraceOptions {
    enum class Shape { Automatic, Dark, Opaque }; // Automatic: opaque if there is transparency
    Shape shape = Shape::Automatic;
    std::optional<int> threshold; // 0 to 255; nullopt: Otsu's, or 127 for opacity
    collage::Polarity polarity = collage::Polarity::Shape;
    std::optional<collage::PixelBox> crop; // part of the original picture

    friend bool operator==(const TraceOptions&, const TraceOptions&) = default;
};

// Position of a picture in the plane, with y up.
struct PicturePlace {
    ifs::Vector<2> middle = ifs::Vector<2>::Zero();
    double height = 1;

    // The map from a picture that is 1 unit high, with its middle at the origin, to this one.
    ifs::AffineMap<2> map() const { return {height * ifs::Matrix<2>::Identity(), middle}; }

    friend bool operator==(const PicturePlace&, const PicturePlace&) = default;
};

// A picture as the target of a collage. Lengths in pixels are of `mask`.
struct TracedPicture {
    PicturePlace place;
    collage::GreyPicture picture; // cropped picture
    collage::Mask mask;           // same size
    collage::Target target;       // one cell for each pixel of the mask
    // Large shapes also have cells of coarseFactor² pixels, for numbers that keep up with a hand.
    std::optional<collage::Target> coarse;
    int coarseFactor = 1;
    // Closed outlines of the mask, in the plane: holes run the other way round. At most 3/4 of a pixel away
    // from the edges of pixels, and of far fewer corners, so that they are quick to draw.
    std::vector<std::vector<ifs::Vector<2>>> outlines;
};

constexpr int maxTracedPixels = 512; // pixels of the longer side

// The picture, reduced to at most maxTracedPixels by the mean of blocks.
collage::GreyPicture reducedForTracing(const collage::GreyPicture& picture);
// The threshold in force: that of the options, else the automatic one; nullopt with one shade only.
std::optional<int> thresholdOf(const collage::GreyPicture& picture, const TraceOptions& options);
// nullopt when the shape is empty, or fills the picture. The shape lies in the middle of the box `onto` and
// is as large: it touches the box at one pair of sides at least. Without a box, or where that is a point, the
// picture is 1 unit high, with its middle at the origin.
std::optional<TracedPicture> tracedPicture(const collage::GreyPicture& picture, const TraceOptions& options,
                                           const std::optional<Box>& onto = {});
// The same target at the place of the picture; collage::target() lays it on one that is 1 unit high.
collage::Target placed(collage::Target target, const PicturePlace& place);

} // namespace document
