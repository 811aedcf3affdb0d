// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/tools/polygon_tool.h"

namespace view {

// Drags the cage.
class CageTool : public PolygonTool {
    Q_OBJECT

public:
    using PolygonTool::PolygonTool;

    void press(const Pointer& pointer) override;
    void move(const Pointer& pointer) override;
    bool keyPress(const QKeyEvent& event) override;
    void insertVertexAt(int edge, const QPointF& position); // pixels

protected:
    std::optional<DragSubject> dragSubject(const CanvasPart& part, PolygonDrag::Mode mode) override;
    Shown preview(const std::function<DragResult(double)>& resultAt) override;
    void pressed(const CanvasPart& part, Qt::KeyboardModifiers modifiers) override;
    void clicked(const CanvasPart& part, const Pointer& pointer) override;
    std::optional<std::vector<std::size_t>> selectedItems() const override;
    void selectItems(const std::vector<std::size_t>& vertices) override;
    std::vector<std::size_t> enclosedBy(const QRectF& band) const override;

private:
    // A vertex and those selected with it; of another part those that are selected.
    std::vector<std::size_t> together(const CanvasPart& part) const;
    void insertVertex();

    ifs::ControlCage<2> m_cage; // cage at the press
    CanvasPart m_focusedBefore; // focus before the press
    QPointF m_pointer;          // pixels
};

} // namespace view
