// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/scene/canvas_scene.h"
#include "canvas/tools/canvas_tool.h"

#include <vector>

namespace view {

// Three clicks give the control triangle other vertices. The picture stays where it is.
class DefineTool : public CanvasTool {
    Q_OBJECT

public:
    explicit DefineTool(CanvasScene& scene) : m_scene(scene) {}

    void press(const Pointer& pointer) override;
    void move(const Pointer& pointer) override;
    void release(const Pointer&) override {}
    void leave() override;
    bool keyPress(const QKeyEvent& event) override; // Backspace removes the last point
    bool cancel() override;                         // always leaves the tool
    bool isBusy() const override { return !m_points.empty(); }
    void start() override;
    void stop() override;
    QCursor cursor(const Pointer&) const override { return Qt::CrossCursor; }

private:
    void define();
    void show(const std::optional<ifs::Vector<2>>& pointer);

    CanvasScene& m_scene;
    std::vector<ifs::Vector<2>> m_points; // points in the plane, so that zooming between clicks is possible
};

} // namespace view
