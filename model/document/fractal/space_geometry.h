// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/light/solid_appearance.h"
#include "attractor/request/space_request.h"
#include "document/fractal/fractal.h"
#include "ifs/cage/control_cage.h"
#include "ifs/extent/support_function.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

// Geometry derived from a fractal in space; fractal_geometry.h has the same for the plane.
namespace document {

// Why nothing that is meant for systems in space can be done; empty for those.
QString spaceObstacle(const Fractal& fractal);

// The extent of the code's attractor; nullptr when it has none, or the entry is not in space. Any thread.
std::shared_ptr<const ifs::SupportFunction<3>> spaceSupport(const Fractal& fractal);

// The cage in force: the stored one, else the lasting one, else the minimal canonical simplex of the code at
// rest; without an attractor, a unit tetrahedron. nullopt when the entry is not in space.
std::optional<ifs::ControlCage<3>> spaceCage(const Fractal& fractal);

// Returns true if anything that depends on the extent of an entry in space is available at once. With very
// many maps the window first finds the extent in the background (view::ExtentFinder). True for other entries.
bool isSpaceExtentKnown(const Fractal& fractal);
// The cage in force if it is stored, lasts or its extent is known.
std::optional<ifs::ControlCage<3>> knownSpaceCage(const Fractal& fractal);

// max ⟨u, x⟩ over the vertices: what a cage that bends displays is within their hull.
std::function<double(const ifs::Vector<3>&)> reachOfVertices(std::vector<ifs::Vector<3>> vertices);

// Range of the displayed picture of a fractal in space along a unit vector: low ≤ ⟨u, x⟩ ≤ high. Without an
// attractor, that of its cage.
struct Extent {
    double low = 0;
    double high = 0;
};
Extent extentAlong(const Fractal& fractal, const ifs::Vector<3>& u);

// The middle of the box around the displayed picture of a fractal in space, without its cage; nullopt without
// an attractor. If a cage bends the picture, the point that shows the middle of the straight one.
std::optional<ifs::Vector<3>> centreOfPicture(const Fractal& fractal);

// Fits the displayed picture of a fractal in space, and its cage, into the view with a margin.
attractor::OrbitCamera fittedTo(const Fractal& fractal, attractor::OrbitCamera camera, double margin);

// The same without the cage.
attractor::OrbitCamera fittedToPicture(const Fractal& fractal, attractor::OrbitCamera camera, double margin);

// The request that draws a fractal in space through the camera.
attractor::SpaceRequest spaceRequest(const Fractal& fractal, const attractor::OrbitCamera& camera);

// The quantity that the colours of its solid show.
attractor::SolidColour solidColour(const Fractal& fractal);

// The appearance of its solid. Ink is on paper and numbers are on black until a background is chosen.
attractor::SolidAppearance solidAppearance(const Fractal& fractal);

// The colour around the picture.
attractor::Rgba backgroundInSpace(const Fractal& fractal);

} // namespace document
