// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "canvas/scene/handle_model.h"

#include <QString>

namespace view {

QString mapName(const HandleModel& handles, std::size_t map); // by its number
QString nameOf(const HandleModel& handles, const CanvasPart& part);
// Coordinates, or what the arrow keys do.
QString valueOf(const HandleModel& handles, const attractor::Camera& camera, const CanvasPart& part);
QString useOf(const CanvasPart& part); // of a handle without a number: what dragging it does

} // namespace view
