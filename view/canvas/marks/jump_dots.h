// SPDX-License-Identifier: MIT
#pragma once

#include "bridges/construction.h"
#include "canvas/marks/scene_mark.h"

namespace view {

// The jumps of a chaos game while they are few: discs in the colours of the maps applied, and rings for the
// first jumps, which are not plotted.
class JumpDots : public SceneMark {
public:
    explicit JumpDots(const Construction* construction) : m_construction(construction) {}

protected:
    void paintOver(QPainter& painter, const CanvasScene& canvas, const OverlayStyle& style) override;

private:
    const Construction* m_construction;
};

} // namespace view
