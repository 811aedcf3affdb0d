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
    const auto knob = m_scene.symmetry().knob();
    return knob && QLineF(*knob, pointer.position).length() <= radius;
}

void SymmetryTool::press(const Pointer& pointer) {
    document::Document& document = m_scene.document();
    const document::Fractal& fractal = document.fractal();
    const ifs::Vector<2> centre = document::system2(fractal)->symmetry.centre;
    m_drag.emplace(Drag{document.beginGesture(tr("Move the centre of the symmetry")), pointer.position,
                        document::placement(fractal)(centre)});
    m_scene.symmetry().setHeld(true);
    emit cursorChanged();
}

void SymmetryTool::move(const Pointer& pointer) {
    constexpr double still = 3; // pixels
    if (!m_drag || !m_drag->gesture.isOpen()) return;
    m_drag->hasMoved = m_drag->hasMoved || QLineF(m_drag->press, pointer.position).length() > still;
    if (!m_drag->hasMoved) return;
    document::Fractal fractal = m_drag->gesture.before();
    ifs::Symmetry<2> symmetry = document::system2(fractal)->symmetry;
    const ifs::Vector<2> asked =
        m_drag->displayed + worldOffset(m_scene.camera(), pointer.position - m_drag->press);
    const Snapped point = snapped(m_scene.snapTargets(), asked);
    const auto centre = ifs::preimage(document::placement(fractal), point.point, symmetry.centre);
    if (!centre) return; // under a cage that takes nothing there
    m_scene.marks().showSnap(point);
    symmetry.centre = *centre;
    m_drag->gesture.preview(document::withSymmetry(std::move(fractal), symmetry));
}

void SymmetryTool::release(const Pointer&) {
    if (m_drag) m_drag->gesture.commit();
    end();
}

bool SymmetryTool::cancel() {
    if (!m_drag) return false;
    m_drag->gesture.cancel();
    end();
    return true;
}

void SymmetryTool::end() {
    m_drag.reset();
    m_scene.marks().showSnap(std::nullopt);
    m_scene.symmetry().setHeld(false);
    emit cursorChanged();
}

QCursor SymmetryTool::cursor(const Pointer&) const {
    return isBusy() ? Qt::ClosedHandCursor : Qt::OpenHandCursor;
}

} // namespace view
