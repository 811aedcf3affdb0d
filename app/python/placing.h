// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "attractor/request/render_request.h"
#include "ifs/extent/extent.h"
#include "notation/value/entry.h"

#include <optional>

// Where what is shown of an entry lies: its attractor, the branches that are shown elsewhere, its cage.
namespace python {

// The figure of an entry of that dimension; throws where it has the other one.
template <int Dim> const notation::Figure<Dim>& figureIn(const notation::Entry& entry);

// Of an attractor in the plane, linked or not; throws std::invalid_argument, which names the witness, where
// the maps have none.
ifs::BoundingBox<2> boxOfAttractor(const ifs::IteratedFunctionSystem<2>& system);
ifs::BoundingBox<3> boxOfAttractor(const ifs::IteratedFunctionSystem<3>& system);

// As the window shows it.
attractor::RenderRequest requestOf(const notation::Entry& entry, int width, int height);

// All of what is shown, with a margin of a twentieth. Certified, except under a cage that bends: there it
// holds many points.
attractor::Camera cameraAround(const notation::Entry& entry, attractor::Camera camera);

// Rest coordinates → displayed coordinates.
ifs::Placement placementOf(const notation::Figure<2>& figure);

// Of maps that are not linked; throws std::invalid_argument where there is no attractor.
template <int Dim> ifs::SupportFunction<Dim> supportOf(const ifs::IteratedFunctionSystem<Dim>& system);
// Throws std::invalid_argument, which names the witness, where it is known that there is none.
template <int Dim> void requireDrawable(const ifs::ActiveMaps<Dim>& active);

} // namespace python
