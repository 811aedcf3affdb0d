// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/cage/cage_edits.h"
#include "document/edits/cage/space_cage_edits.h"
#include "ifs/extent/extent.h"

#include <functional>
#include <optional>

class QMenu;
class QWidget;

namespace view {

// The cages that can be fitted to a picture, and what choosing one does.
struct PlaneFits {
    std::function<void(document::SimplexChoice)> simplex;
    std::function<void(document::PolygonChoice, int corners)> polygon;
};
struct SpaceFits {
    // Nullopt: smallest of all orientations.
    std::function<void(const std::optional<ifs::Orientation<3>>&)> tetrahedron;
    std::function<void()> box;
    std::function<void(document::SpacePolyhedron, int corners)> polyhedron;
};
QMenu* makeFitMenu(QWidget* parent, const PlaneFits& fits);
QMenu* makeFitMenu(QWidget* parent, const SpaceFits& fits);

} // namespace view
