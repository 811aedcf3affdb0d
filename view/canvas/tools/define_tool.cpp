// SPDX-License-Identifier: MIT
#include "canvas/tools/define_tool.h"

#include "canvas/geometry/canvas_geometry.h"
#include "document/edits/cage/cage_actions.h"

#include <QKeyEvent>

namespace view {

void DefineTool::start() {
    m_points.clear();
    m_scene.setCageVisible(false);
    show(std::nullopt);
}

void DefineTool::stop() {
    m_points.clear();
    m_scene.setCageVisible(true);
    m_scene.marks().showRubber({}, std::nullopt);
    m_scene.marks().showSnap(std::nullopt);
    m_scene.notes().setPrompt({});
}

void DefineTool::press(const Pointer& pointer) {
    constexpr double apart = 4; // pixels; prevents a double click from setting two vertices
    const Snapped point = snapped(m_scene.snapTargets(), worldAt(m_scene.camera(), pointer.position));
    for (const ifs::Vector<2>& other : m_points)
        if ((point.point - other).norm() * m_scene.camera().pixelsPerUnit < apart) return;
    m_points.push_back(point.point);
    if (m_points.size() == 3)
        define();
    else
        show(point.point);
}

void DefineTool::define() {
    const ifs::Simplex<2> triangle{m_points[0], m_points[1], m_points[2]};
    if (const std::optional<QString> failure = defineTriangle(m_scene.document(), triangle)) {
        m_points.pop_back();
        show(std::nullopt);
        m_scene.notes().setPrompt(*failure);
        emit message(*failure);
        return;
    }
    emit finished();
}

void DefineTool::move(const Pointer& pointer) {
    const Snapped point = snapped(m_scene.snapTargets(), worldAt(m_scene.camera(), pointer.position));
    m_scene.marks().showSnap(point);
    m_scene.marks().showRubber(m_points, point.point);
}

void DefineTool::leave() {
    m_scene.marks().showSnap(std::nullopt);
    m_scene.marks().showRubber(m_points, std::nullopt);
}

bool DefineTool::keyPress(const QKeyEvent& event) {
    if (event.key() != Qt::Key_Backspace || m_points.empty()) return false;
    m_points.pop_back();
    show(std::nullopt);
    return true;
}

bool DefineTool::cancel() {
    m_points.clear();
    emit finished();
    return true;
}

void DefineTool::show(const std::optional<ifs::Vector<2>>& pointer) {
    m_scene.marks().showRubber(m_points, pointer);
    switch (m_points.size()) {
    case 0:
        m_scene.notes().setPrompt(
            tr("Click the first of the three corners. The picture stays where it is; Esc cancels."));
        break;
    case 1:
        m_scene.notes().setPrompt(tr("Click the second corner. Backspace removes the last point."));
        break;
    default:
        m_scene.notes().setPrompt(tr("Click the third corner. Backspace removes the last point."));
        break;
    }
}

} // namespace view
