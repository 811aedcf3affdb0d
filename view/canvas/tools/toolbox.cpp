// SPDX-License-Identifier: MIT
#include "canvas/tools/toolbox.h"

#include "document/edits/cage/cage_actions.h"
#include "document/fractal/fractal.h"

namespace view {

Toolbox::Toolbox(CanvasScene& scene, CanvasOptions& options)
    : m_document(&scene.document()),
      m_scene(scene),
      m_options(options),
      m_cageTool(scene),
      m_mapsTool(scene),
      m_branchTool(scene),
      m_defineTool(scene),
      m_symmetryTool(scene),
      m_shadowTool(scene) {
    for (CanvasTool* tool :
         {static_cast<CanvasTool*>(&m_cageTool), static_cast<CanvasTool*>(&m_mapsTool),
          static_cast<CanvasTool*>(&m_branchTool), static_cast<CanvasTool*>(&m_defineTool),
          static_cast<CanvasTool*>(&m_symmetryTool), static_cast<CanvasTool*>(&m_shadowTool)}) {
        connect(tool, &CanvasTool::message, this, &Toolbox::message);
        connect(tool, &CanvasTool::cursorChanged, this, &Toolbox::cursorChanged);
        connect(tool, &CanvasTool::finished, this, [this] { setTool(Tool::Cage); });
    }
    for (PolygonTool* tool : {static_cast<PolygonTool*>(&m_cageTool), static_cast<PolygonTool*>(&m_mapsTool),
                              static_cast<PolygonTool*>(&m_branchTool)})
        connect(tool, &PolygonTool::dragStarted, this, &Toolbox::used);
}

void Toolbox::stop() {
    m_symmetryTool.stop();
    m_shadowTool.stop();
    if (m_document) active().stop();
}

CanvasTool& Toolbox::active() {
    if (m_symmetryTool.isBusy()) return m_symmetryTool;
    if (m_shadowTool.isBusy()) return m_shadowTool;
    if (PolygonTool* tool = polygonTool()) return *tool;
    return m_defineTool;
}

CanvasTool& Toolbox::toolAt(const Pointer& pointer) {
    if (m_tool == Tool::DefineTriangle || active().isBusy()) return active();
    if (m_symmetryTool.isAt(pointer)) return m_symmetryTool;
    return m_shadowTool.isAt(pointer) ? m_shadowTool : active();
}

PolygonTool* Toolbox::polygonTool() {
    if (m_tool == Tool::Maps) return &m_mapsTool;
    if (m_tool == Tool::Branch) return &m_branchTool;
    return m_tool == Tool::Cage ? &m_cageTool : nullptr;
}

void Toolbox::setTool(Tool tool) {
    if (tool == m_tool) return;
    const bool isInSpace = document::space(m_document->fractal()); // such entries have their own tools
    if (tool != Tool::Cage && !isInSpace && !document::system2(m_document->fractal())) {
        emit message(m_scene.notes().note());
        emit toolChanged(m_tool); // restores a pressed button
        return;
    }
    if (tool == Tool::DefineTriangle && !isInSpace && !isPlacementInvertible(m_document->fractal())) {
        emit definingRefused();
        emit toolChanged(m_tool);
        return;
    }
    if (tool != Tool::Cage) m_options.setOverlaysVisible(true);
    emit used();
    m_symmetryTool.stop();
    m_shadowTool.stop();
    active().stop();
    m_tool = tool;
    active().start();
    emit cursorChanged();
    emit toolChanged(tool);
}

void Toolbox::setAllowsNoAttractor(bool allows) {
    m_mapsTool.setAllowsNoAttractor(allows);
    m_branchTool.setAllowsNoAttractor(allows);
}

} // namespace view
