// SPDX-License-Identifier: MIT
#include "bars/tool_options_bar.h"

#include "bars/branch_bar.h"
#include "space/space_view.h"
#include "widgets/text/elided_label.h"

#include <QApplication>
#include <QHBoxLayout>

namespace view {

ToolOptionsBar::ToolOptionsBar(document::Document* document, CanvasView* canvas, QWidget* parent)
    : QStackedWidget(parent), m_canvas(canvas), m_branches(new BranchBar(document, canvas, this)) {
    setAccessibleName(tr("Tool options"));
    addWidget(m_branches);
    m_cage = addHint(tr("Drag a corner, an edge or the inside of the cage.  Ctrl rotates  ·  Alt scales  ·  "
                        "Shift keeps directions  ·  double-click an edge for a new corner"));
    m_define = addHint(
        tr("Click the three corners of the new triangle.  Backspace removes the last point  ·  Esc cancels"));
    m_defineInSpace = addHint(tr(
        "Click the four corners of the new tetrahedron, the fourth in front of the others.  The wheel pushes "
        "it away  ·  right-drag turns the view  ·  Backspace removes the last point  ·  Esc cancels"));
    m_space =
        addHint(tr("Drag a corner or a face of the cage.  X, Y, Z keep an axis  ·  Ctrl rotates  ·  Alt "
                   "scales  ·  drag anywhere else to turn the view"));
    m_stereo =
        addHint(tr("Side by side, the fractal can be turned and zoomed.  To change it, switch stereo off."));
    connect(canvas, &CanvasView::toolChanged, this, &ToolOptionsBar::follow);
    follow();
}

QWidget* ToolOptionsBar::addHint(const QString& text) {
    auto* page = new QWidget(this);
    auto* label = new ElidedLabel(page);
    label->setText(text);
    label->setToolTip(text);
    auto* layout = new QHBoxLayout(page);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->addWidget(label);
    addWidget(page);
    return page;
}

QString ToolOptionsBar::hint() const {
    const auto* label = currentWidget()->findChild<ElidedLabel*>();
    return label ? label->text() : QString();
}

void ToolOptionsBar::setSpaceView(SpaceView* space) {
    m_spaceView = space;
    connect(&space->navigation(), &SpaceNavigation::stereoChanged, this, &ToolOptionsBar::follow);
    m_branches->setSpace(
        space,
        tr("Click a corner of a map to select it, Shift+click for more.  Drag its corners or its middle  ·  "
           "X, Y, Z keep an axis  ·  Ctrl rotates  ·  Alt scales  ·  drag anywhere else to turn the view"));
}

void ToolOptionsBar::setBeside(CanvasView* canvas) {
    m_branches->setBeside(canvas);
}

void ToolOptionsBar::setSpace(bool isSpace) {
    m_isSpace = isSpace;
    follow();
}

void ToolOptionsBar::follow() {
    using Tool = CanvasView::Tool;
    const Tool tool = m_canvas->tool();
    QWidget* page = tool == Tool::Cage ? m_cage : tool == Tool::DefineTriangle ? m_define : m_branches;
    if (m_isSpace)
        page = tool == Tool::DefineTriangle ? m_defineInSpace : tool == Tool::Cage ? m_space : m_branches;
    const bool isSideBySide = m_spaceView && picturesAcross(m_spaceView->navigation().stereo()) > 1;
    if (m_isSpace && isSideBySide) page = m_stereo;
    if (page == currentWidget()) return;
    const QWidget* focused = QApplication::focusWidget();
    if (focused && isAncestorOf(focused)) m_canvas->setFocus(); // otherwise any field would get the focus
    setCurrentWidget(page);
}

} // namespace view
