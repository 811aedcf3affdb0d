// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/polygon_tool.h"

namespace view {

// Takes the cage.
class CageTool : public PolygonTool {
    Q_OBJECT

public:
    using PolygonTool::PolygonTool;

protected:
    std::optional<Grip> grip(const CanvasPart& part, PolygonDrag::Mode mode) override;
    double preview(const std::function<DragResult(double)>& resultAt) override;

private:
    ifs::ControlCage<2> m_cage; // at the press
};

} // namespace view
