// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/canvas_view.h"

#include <QStackedWidget>

namespace view {

class BranchBar;
class SpaceView;

// A row under the canvas with the options of the current tool, or a description of it if it has none. Its
// height is the same for every tool, so that the picture stays where it is.
class ToolOptionsBar : public QStackedWidget {
    Q_OBJECT

public:
    ToolOptionsBar(document::Document* document, CanvasView* canvas, QWidget* parent = nullptr);

    void setSpaceView(SpaceView* space);
    void setSpace(bool isSpace);        // true while the view of space is shown
    void setBeside(CanvasView* canvas); // canvas of another entry, whose branches have the same options
    QString hint() const;               // text of a tool without options; empty for others

private:
    QWidget* addHint(const QString& text);
    void follow();

    CanvasView* m_canvas;
    bool m_isSpace = false;
    const SpaceView* m_spaceView = nullptr;
    BranchBar* m_branches;
    QWidget* m_cage;
    QWidget* m_define;
    QWidget* m_defineInSpace;
    QWidget* m_space;
    QWidget* m_stereo; // options for stereo pairs side by side
};

} // namespace view
