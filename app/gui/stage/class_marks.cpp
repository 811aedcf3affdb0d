// SPDX-License-Identifier: MIT
#include "stage/class_marks.h"

#include "bridges/construction.h"
#include "canvas/canvas_view.h"
#include "canvas/marks/address_walk.h"
#include "canvas/marks/jump_dots.h"

#include <algorithm>

namespace {

constexpr std::size_t joined = 8; // number of newest jumps joined by lines

} // namespace

void addClassMarks(view::CanvasView& canvas, const view::Construction& construction) {
    canvas.scene()->addItem(new view::AddressWalk); // owned by the scene
    auto* dots = new view::JumpDots(&construction);
    canvas.scene()->addItem(dots);
    QObject::connect(
        &construction, &view::Construction::trailChanged, &canvas, [&canvas, &construction, dots] {
            const auto& jumps = construction.trail();
            std::vector<ifs::Vector<2>> newest;
            for (std::size_t k = jumps.size() - std::min(jumps.size(), joined); k < jumps.size(); ++k)
                newest.push_back(jumps[k].x);
            canvas.showTrail(newest);
            dots->update();
        });
}
