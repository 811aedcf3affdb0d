// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "attractor/request/render_request.h"
#include "document/fractal/fractal.h"
#include "ifs/cage/control_cage.h"
#include "ifs/extent/support_function.h"
#include "ifs/links/linked_extent.h"
#include "ifs/system/branch.h"

#include <memory>
#include <optional>
#include <vector>

// Geometry derived from a fractal: the extent, the cage in force, and the position of the picture.
namespace document {

// The extent of the code's attractor; nullptr when it has none, or its maps are linked. Any thread. The
// fractal and its copies remember what takes long (SupportCache).
std::shared_ptr<const ifs::SupportFunction<2>> supportFunction(const Fractal& fractal);
// The same of linked maps; nullopt where they are not.
std::optional<ifs::LinkedExtent> linkedExtent(const Fractal& fractal);

// The minimal canonical simplex of the code at rest; when the code has no attractor, a unit triangle.
ifs::ControlCage<2> canonicalCage(const Fractal& fractal);

// The cage in force: the stored one, else the lasting one, else the canonical one, which costs a certified
// simplex.
ifs::ControlCage<2> effectiveCage(const Fractal& fractal);

// Coordinates of the code → displayed ones.
ifs::Placement placement(const Fractal& fractal);

// The branches that are moved, as words over indices into the system. Those with a map that is gone are left
// out.
template <int Dim> std::vector<ifs::MovedBranch<Dim>> movedBranches(const Shape<Dim>& shape);
// Branches of an entry in the plane; others have none here.
std::vector<ifs::MovedBranch<2>> movedBranches(const Fractal& fractal);
// The pieces shown in place of the attractor: ifs::pieces over the active maps of the code. Empty if no
// branch is moved.
template <int Dim>
std::vector<ifs::MovedBranch<Dim>> shownBranches(const Shape<Dim>& shape, const ifs::ActiveMaps<Dim>& active);
// The maps of these, in coordinates of the code: the attractor alone where no branch is moved.
template <int Dim> std::vector<ifs::AffineMap<Dim>> shownPieces(const Shape<Dim>& shape);

// The code becomes M∘w∘M⁻¹, and so does what moves its branches; nullopt unless it is a system of that
// dimension and M can be inverted. The cage stays.
template <int Dim>
std::optional<Fractal> conjugated(const Fractal& fractal, const ifs::AffineMap<Dim>& transformation);

// The maps of the code as they act on the displayed picture, M_c∘w∘M_c⁻¹; nullopt while the placement is flat
// or bent, and for an entry of another dimension.
template <int Dim = 2>
std::optional<ifs::IteratedFunctionSystem<Dim>> effectiveSystem(const Fractal& fractal);
// The extent of its attractor, without the branches that are moved; nullopt where it has none.
template <int Dim> std::optional<ifs::SupportFunction<Dim>> displayedSupport(const Fractal& fractal);

// The map from the displayed picture to its shadow, whose ground is the lowest line of the picture under this
// y axis; nullopt if it has none, or the attractor has no certified box.
std::optional<ifs::AffineMap<2>> shadowMap(const Fractal& fractal, attractor::YAxis yAxis);
// The request that draws the fractal through the camera with default quality.
attractor::RenderRequest renderRequest(const Fractal& fractal, const attractor::Camera& camera);

// Certified box of the displayed picture (the attractor under its cage), under a bend to a hundredth of its
// size; nullopt when there is none. It includes its error, unlike ifs::BoundingBox.
struct Box {
    ifs::Vector<2> min;
    ifs::Vector<2> max;
};
std::optional<Box> displayedBox(const Fractal& fractal);
// The same with the shadow.
std::optional<Box> boxWithShadow(const Fractal& fractal, attractor::YAxis yAxis);

} // namespace document
