// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "canvas/scene/handle_model.h"

#include <QString>

namespace view {

QString mapName(const HandleModel& handles, std::size_t map); // name with the map's number
QString nameOf(const HandleModel& handles, const CanvasPart& part);
// Coordinates, or what the arrow keys do.
QString valueOf(const HandleModel& handles, const attractor::Camera& camera, const CanvasPart& part);
QString useOf(const CanvasPart& part); // effect of dragging a handle without a number

} // namespace view
