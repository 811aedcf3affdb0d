// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/scene/canvas_scene.h"
#include "canvas/tools/canvas_tool.h"
#include "gestures/drag_session.h"

#include <optional>

namespace view {

// Drags the centre of a symmetry by its handle, whichever tool is in use.
class SymmetryTool : public CanvasTool {
    Q_OBJECT

public:
    explicit SymmetryTool(CanvasScene& scene) : m_scene(scene), m_session(scene.document()) {}

    bool isAt(const Pointer& pointer) const; // true if a press there would take the handle

    void press(const Pointer& pointer) override;
    void move(const Pointer& pointer) override;
    void release(const Pointer& pointer) override;
    bool cancel() override;
    bool isBusy() const override { return m_displayed.has_value(); }
    void stop() override { cancel(); }
    QCursor cursor(const Pointer&) const override;

private:
    void end();

    CanvasScene& m_scene;
    DragSession m_session;
    std::optional<ifs::Vector<2>> m_displayed; // centre at the press
};

} // namespace view
