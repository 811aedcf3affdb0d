// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/appearance.h"
#include "document/fractal/fractal.h"

#include <QImage>

#include <cstddef>
#include <functional>
#include <vector>

namespace document {

// The attractor as points, from which small pictures of its maps are made: the image w_i(A) of a map in its
// colour, in its place in the faint whole. In space as seen from where thumbnails look.
class MapPoints {
public:
    // Thread-safe. `width` and `height` are those of the pictures in pixels.
    MapPoints(const Fractal& fractal, int width, int height);
    MapPoints(const MapPoints&) = delete;
    MapPoints& operator=(const MapPoints&) = delete;

    // Transparent; null where there is nothing to show. `faint` is the colour of the whole.
    QImage picture(std::size_t index, const attractor::Rgba& faint) const;

private:
    using Counts = std::vector<float>; // number of points in each pixel

    template <int Dim, class Display>
    void take(const ifs::IteratedFunctionSystem<Dim>& system, std::vector<ifs::Vector<Dim>> points,
              Display display);
    void frame(const std::vector<ifs::Vector<2>>& shown);
    void count(Counts& counts, const ifs::Vector<2>& shown) const;

    int m_width;
    int m_height;
    double m_scale = 0; // pixels per displayed unit; 0: nothing is displayed
    ifs::Vector<2> m_middle = ifs::Vector<2>::Zero();
    Counts m_whole;
    std::vector<attractor::Rgba> m_colours;                              // indexed by map
    std::function<void(std::size_t index, Counts& counts)> m_countImage; // counter for the image of one map
};

} // namespace document
