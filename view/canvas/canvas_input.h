// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/canvas_navigation.h"
#include "canvas/items/border_arrows_item.h"
#include "canvas/pointer_position.h"
#include "canvas/tools/toolbox.h"
#include "gestures/viewport_input.h"

namespace view {

// Input of pointer, wheel, fingers and keys on the canvas: works the tool in use, or moves the plane.
class CanvasInput : public ViewportInput {
    Q_OBJECT

public:
    CanvasInput(CanvasScene& scene, Toolbox& tools, CanvasNavigation& navigation, CanvasOptions& options)
        : ViewportInput(navigation),
          m_scene(scene),
          m_tools(tools),
          m_navigation(navigation),
          m_options(options) {}

    bool needsKey(const QKeyEvent& event) const override;
    void cancelDrag() override;
    void reportPointer(); // repeats pointerMoved()
    // Reports the last position again: more is known of it, or the plane has moved under it.
    void reportAgain() {
        if (isOver() && !isHolding()) reportPointer();
    }

signals:
    void pointerMoved(const view::PointerPosition& position);

protected:
    bool pressed(Qt::MouseButton button) override;
    bool doubleClicked() override;
    void moved() override;
    void released() override;
    void left() override;
    bool wheelTurned(const QWheelEvent& event) override;
    bool keyPressed(const QKeyEvent& event) override;
    bool keyReleased(const QKeyEvent& event) override { return m_tools.active().keyRelease(event); }
    bool cancelled() override;
    QCursor cursorOver() const override;

private:
    bool canvasKey(const QKeyEvent& event);
    void endClick();
    std::optional<BorderArrow> arrowUnder() const;
    void markArrow();

    CanvasScene& m_scene;
    Toolbox& m_tools;
    CanvasNavigation& m_navigation;
    CanvasOptions& m_options;
    std::optional<QPointF> m_clicked; // place of a press that has not become a drag
};

} // namespace view
