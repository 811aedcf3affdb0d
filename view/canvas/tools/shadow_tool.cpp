// SPDX-License-Identifier: MIT
#include "canvas/tools/shadow_tool.h"

#include "canvas/geometry/canvas_geometry.h"
#include "canvas/items/shadow_item.h"

#include <QLineF>

namespace view {

bool ShadowTool::isAt(const Pointer& pointer) const {
    const double radius = pointer.reach == Reach::Touch ? 20 : 11; // pixels
    const auto knob = m_scene.knobs().shadow.knob();
    return knob && QLineF(*knob, pointer.position).length() <= radius &&
           m_scene.partAt(pointer.position, pointer.reach).kind != CanvasPart::Kind::Vertex;
}

void ShadowTool::press(const Pointer& pointer) {
    m_stick = document::shadowStick(m_scene.document().fractal(), m_scene.camera().yAxis);
    if (!m_stick) return;
    m_session.press(pointer.position);
    m_session.open(tr("Turn the shadow"));
    m_scene.knobs().shadow.setHeld(true);
    emit cursorChanged();
}

void ShadowTool::move(const Pointer& pointer) {
    if (!isBusy() || !m_session.isOpen() || !m_session.isDrag(pointer.position)) return;
    const ifs::Vector<2> tip =
        m_stick->tip + worldOffset(m_scene.camera(), pointer.position - m_session.pressedAt());
    m_session.gesture().preview(document::withShadowTip(m_session.gesture().before(), *m_stick, tip));
}

void ShadowTool::release(const Pointer&) {
    m_session.finish();
    end();
}

bool ShadowTool::cancel() {
    if (!isBusy()) return false;
    m_session.cancel();
    end();
    return true;
}

void ShadowTool::end() {
    m_stick.reset();
    m_scene.knobs().shadow.setHeld(false);
    emit cursorChanged();
}

QCursor ShadowTool::cursor(const Pointer&) const {
    return isBusy() ? Qt::ClosedHandCursor : Qt::OpenHandCursor;
}

} // namespace view
