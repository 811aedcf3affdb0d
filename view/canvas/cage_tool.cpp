// SPDX-License-Identifier: MIT
#include "canvas/cage_tool.h"

#include "cage_edits.h"

#include <numeric>

namespace view {

using Kind = CanvasPart::Kind;

std::optional<PolygonTool::Grip> CageTool::grip(const CanvasPart& part, PolygonDrag::Mode mode) {
    m_cage = *scene().cage();
    Grip grip{tr("Move the cage"), m_cage.current, {}};
    const int count = int(grip.points.size());
    if (mode == PolygonDrag::Mode::Move && part.kind == Kind::Vertex) {
        grip.vertices = {part.index};
        grip.text = tr("Move vertex %1").arg(part.index + 1);
        return grip;
    }
    if (mode == PolygonDrag::Mode::Move && part.kind == Kind::Edge) {
        grip.vertices = {part.index, (part.index + 1) % count};
        grip.text = tr("Move edge %1–%2").arg(grip.vertices[0] + 1).arg(grip.vertices[1] + 1);
        return grip;
    }
    grip.vertices.resize(std::size_t(count));
    std::iota(grip.vertices.begin(), grip.vertices.end(), 0);
    if (mode == PolygonDrag::Mode::Rotate) grip.text = tr("Rotate the cage");
    if (mode == PolygonDrag::Mode::Scale) grip.text = tr("Scale the cage");
    return grip;
}

double CageTool::preview(const std::function<DragResult(double)>& resultAt) {
    document::Fractal fractal = gesture().before();
    ifs::ControlCage<2> cage = m_cage;
    cage.current = resultAt(1).points;
    if (cage != m_cage)
        fractal = withCageMoved(std::move(fractal), std::move(cage), scene().document().cageMode());
    gesture().preview(std::move(fractal));
    return 1;
}

} // namespace view
