// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/render_request.h"
#include "io/exchange/point_format.h"

#include <QByteArray>

#include <memory>
#include <stop_token>

namespace io {

// A point cloud of a fractal in space, without a point yet: `add` appends the next ones. CSV: x, y, z and the
// number of the last map, from 1. PLY: binary, doubles x y z, floats nx ny nz, the colour, the number of the
// last map and the address as a number from 0 to 1, its newest map first. A normal points away from the
// voxels around the point, 192 of them along the longest side of the attractor; 0 where there is none.
class SpacePoints {
public:
    SpacePoints(const PointCloud& cloud, const std::stop_token& stop);
    ~SpacePoints();
    SpacePoints(const SpacePoints&) = delete;
    SpacePoints& operator=(const SpacePoints&) = delete;

    void add();
    const QByteArray& bytes() const;
    attractor::RenderNote note() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace io
