// SPDX-License-Identifier: MIT
#pragma once

#include "bridges/construction.h"
#include "canvas/marks/scene_mark.h"

namespace view {

// Where the jumps of a chaos game have led while they are few: discs in the colours of the maps that led
// there, and rings for the first jumps, which are not plotted.
class JumpDots : public SceneMark {
public:
    explicit JumpDots(const Construction* construction) : m_construction(construction) {}

protected:
    void paintOver(QPainter& painter, const CanvasScene& canvas, const OverlayStyle& style) override;

private:
    const Construction* m_construction;
};

} // namespace view
