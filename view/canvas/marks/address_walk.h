// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/marks/scene_mark.h"
#include "document/fractal/fractal.h"
#include "ifs/system/branch.h"

#include <vector>

namespace view {

// The branch that was clicked as a walk along its address: the image of the cage under w₁, in it that under
// w₁w₂, and so on, each in the colour of its last map and with its word, the last one filled. Shown while the
// branch tool has a branch; with other tools, the cylinder that was clicked, as images of the hull.
class AddressWalk : public SceneMark {
protected:
    void paintOver(QPainter& painter, const CanvasScene& canvas, const OverlayStyle& style) override;
};

// The images of the cage under the beginnings of a word of indices, the longest last, as they are displayed;
// branches that are shown elsewhere stay where their maps put them. Empty unless the entry is a system of the
// plane.
std::vector<std::vector<ifs::Vector<2>>> addressWalk(const document::Fractal& fractal, const ifs::Word& word);

} // namespace view
