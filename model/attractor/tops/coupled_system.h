// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "ifs/extent/support_function.h"
#include "ifs/tops/enclosing_polygon.h"

#include <cstddef>
#include <vector>

namespace attractor {

// Two systems F and G whose maps correspond by their indices, the pair on top first.
// docs/mathematics.md, "Fractal tops".
struct CoupledSystem {
    std::vector<ifs::AffineMap<2>> from; // maps of F
    std::vector<ifs::AffineMap<2>> to;   // maps of G
    std::vector<double> probabilities;   // probabilities of the maps of F; their sum is 1
    ifs::EnclosingPolygon around;        // polygon around the attractor of F
    std::vector<double> areaRatios;      // |det v_i / det w_i|; NaN for flat maps
    double wholeRatio;                   // ratio of the areas of the attractors, estimated from their hulls
    // φ_F and φ_G of the top address of all, in which the first map repeats.
    ifs::Vector<2> fromTop, toTop;

    // Both attractors must have equally many maps.
    CoupledSystem(const ifs::SupportFunction<2>& attractor, const ifs::SupportFunction<2>& image,
                  std::vector<double> weights);
};

// The content of a pixel: the point of G that has the top address of the points in the pixel.
struct TopPoint {
    double x = 0, y = 0;
    double stretch = -1; // factor by which T magnifies areas there; negative in empty pixels
    double address = 0;  // Σ σ_k N^−k

    bool isEmpty() const { return stretch < 0; }
};

// The product of the ratios of a word, or that of the squared norms of its maps where it is no number.
double stretchOf(double areaRatio, const ifs::Matrix<2>& to, const ifs::Matrix<2>& from);

// A box in pixels, and whether it meets the rows.
struct PixelBox {
    double left, right, top, bottom;

    double size() const { return right - left > bottom - top ? right - left : bottom - top; }
    bool meets(int width, int firstRow, int endRow) const {
        return right >= 0 && left < width && bottom >= firstRow && top < endRow;
    }
    bool isWithin(int width, int firstRow, int endRow) const {
        return left >= 0 && right < width && top >= firstRow && bottom < endRow;
    }
};
// The box around the image of the attractor of F under a map to pixels.
PixelBox boxOf(const ifs::AffineMap<2>& shown, const ifs::EnclosingPolygon& around);

} // namespace attractor
