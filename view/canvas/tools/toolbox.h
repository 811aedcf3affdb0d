// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/scene/canvas_options.h"
#include "canvas/tools/branch_tool.h"
#include "canvas/tools/cage_tool.h"
#include "canvas/tools/define_tool.h"
#include "canvas/tools/shadow_tool.h"
#include "canvas/tools/symmetry_tool.h"

#include <QPointer>

namespace view {

// The tools of the canvas, one of which is in use.
class Toolbox : public QObject {
    Q_OBJECT

public:
    enum class Tool { Cage, Maps, Branch, DefineTriangle };

    Toolbox(CanvasScene& scene, CanvasOptions& options);

    // A tool that cannot be used now is refused: message() or definingRefused() says why.
    void setTool(Tool tool);
    Tool tool() const { return m_tool; }
    void stop(); // also releases the held part
    CanvasTool& active();
    // The tool that a press there goes to: the one in use, or that of the handle of a symmetry or a shadow.
    CanvasTool& toolAt(const Pointer& pointer);
    PolygonTool* polygonTool(); // tool in use if it edits polygons, else nullptr

    CageTool& cageTool() { return m_cageTool; }
    MapsTool& mapsTool() { return m_mapsTool; }
    BranchTool& branchTool() { return m_branchTool; }

    // Lets drags of maps pass where there is no attractor; else the drag stops there.
    void setAllowsNoAttractor(bool allows);

signals:
    void toolChanged(view::Toolbox::Tool tool); // also sent when a tool is refused
    void used();                                // sent for another tool and for the beginning of a gesture
    void definingRefused();                     // sent because the placement is flat
    void message(const QString& sentence);      // sentence for the status bar
    void cursorChanged();

private:
    QPointer<document::Document> m_document;
    CanvasScene& m_scene;
    CanvasOptions& m_options;
    CageTool m_cageTool;
    MapsTool m_mapsTool;
    BranchTool m_branchTool;
    DefineTool m_defineTool;
    SymmetryTool m_symmetryTool;
    ShadowTool m_shadowTool;
    Tool m_tool = Tool::Cage;
};

} // namespace view
