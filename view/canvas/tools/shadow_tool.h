// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/scene/canvas_scene.h"
#include "canvas/tools/canvas_tool.h"
#include "document/edits/shadow_edits.h"
#include "gestures/drag_session.h"

#include <optional>

namespace view {

// Drags the tip of the shadow by its handle, whichever tool is in use.
class ShadowTool : public CanvasTool {
    Q_OBJECT

public:
    explicit ShadowTool(CanvasScene& scene) : m_scene(scene), m_session(scene.document()) {}

    // A press there would take the handle; a vertex under the pointer comes first.
    bool isAt(const Pointer& pointer) const;

    void press(const Pointer& pointer) override;
    void move(const Pointer& pointer) override;
    void release(const Pointer& pointer) override;
    bool cancel() override;
    bool isBusy() const override { return m_stick.has_value(); }
    void stop() override { cancel(); }
    QCursor cursor(const Pointer&) const override;

private:
    void end();

    CanvasScene& m_scene;
    DragSession m_session;
    std::optional<document::ShadowStick> m_stick; // stick at the press
};

} // namespace view
