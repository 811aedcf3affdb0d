// SPDX-License-Identifier: MIT
#include "canvas/tools/symmetry_tool.h"

#include "canvas/geometry/canvas_geometry.h"
#include "canvas/items/symmetry_item.h"
#include "document/edits/maps/symmetry_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "ifs/cage/map_handles.h"

#include <QLineF>

namespace view {

bool SymmetryTool::isAt(const Pointer& pointer) const {
    const double radius = pointer.reach == Reach::Touch ? 20 : 11; // pixels
    const auto knob = m_scene.knobs().symmetry.knob();
    return knob && QLineF(*knob, pointer.position).length() <= radius;
}

void SymmetryTool::press(const Pointer& pointer) {
    const document::Fractal& fractal = m_scene.document().fractal();
    m_displayed = document::placement(fractal)(document::system2(fractal)->symmetry.centre);
    m_session.press(pointer.position);
    m_session.open(tr("Move the centre of the symmetry"));
    m_scene.knobs().symmetry.setHeld(true);
    emit cursorChanged();
}

void SymmetryTool::move(const Pointer& pointer) {
    if (!m_session.isOpen() || !m_session.isDrag(pointer.position)) return;
    document::Fractal fractal = m_session.gesture().before();
    ifs::Symmetry<2> symmetry = document::system2(fractal)->symmetry;
    const ifs::Vector<2> asked =
        *m_displayed + worldOffset(m_scene.camera(), pointer.position - m_session.pressedAt());
    const Snapped point = snapped(m_scene.snapTargets(), asked);
    const auto centre = ifs::preimage(document::placement(fractal), point.point, symmetry.centre);
    if (!centre) return; // no preimage under the cage
    m_scene.marks().showSnap(point);
    symmetry.centre = *centre;
    m_session.gesture().preview(document::withSymmetry(std::move(fractal), symmetry));
}

void SymmetryTool::release(const Pointer&) {
    m_session.finish();
    end();
}

bool SymmetryTool::cancel() {
    if (!isBusy()) return false;
    m_session.cancel();
    end();
    return true;
}

void SymmetryTool::end() {
    m_displayed.reset();
    m_scene.marks().showSnap(std::nullopt);
    m_scene.knobs().symmetry.setHeld(false);
    emit cursorChanged();
}

QCursor SymmetryTool::cursor(const Pointer&) const {
    return isBusy() ? Qt::ClosedHandCursor : Qt::OpenHandCursor;
}

} // namespace view
