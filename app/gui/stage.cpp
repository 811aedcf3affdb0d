// SPDX-License-Identifier: MIT
#include "stage.h"

Stage::Stage(document::Document* document, view::RenderBridge* render, view::SolidBridge* solid,
             QWidget* parent)
    : QStackedWidget(parent),
      m_plane(new view::CanvasView(document, render, this)),
      m_transformation(new view::TransformationView(document, render, m_plane, this)),
      m_space(new view::SpaceView(document, solid, this)) {
    addWidget(m_transformation);
    addWidget(m_space);
    connect(document, &document::Document::changed, this, [this, document](const document::Change& change) {
        using document::Change;
        if (change.parts & (Change::System | Change::Current | Change::File)) follow(*document);
    });
    connect(&m_plane->options(), &view::CanvasOptions::overlaysVisibleChanged, m_space,
            &view::SpaceView::setOverlaysVisible);
    follow(*document);
}

void Stage::follow(const document::Document& document) {
    QWidget* wanted = m_transformation;
    if (document::space(document.fractal())) wanted = m_space;
    if (wanted == currentWidget()) return;
    const bool hadFocus = (showsSpace() ? static_cast<QWidget*>(m_space) : m_plane)->hasFocus();
    setCurrentWidget(wanted);
    setFocusProxy(wanted);
    if (hadFocus) wanted->setFocus();
    emit switched();
}

void Stage::fit() {
    if (showsSpace())
        m_space->navigation().fit();
    else
        m_plane->fit();
}

void Stage::zoomBy(double factor) {
    view::SpaceNavigation& space = m_space->navigation();
    if (showsSpace())
        space.zoomAt(space.middle(), factor);
    else
        m_plane->navigation().zoomBy(factor);
}

void Stage::resetZoom() {
    if (showsSpace())
        m_space->navigation().resetZoom();
    else
        m_plane->navigation().resetZoom();
}

QImage Stage::picture() const {
    return showsSpace() ? m_space->picture() : m_plane->picture();
}

bool Stage::cancelGesture() {
    return showsSpace() ? m_space->cancelGesture() : m_plane->cancelGesture();
}

void Stage::takeFocus(Qt::FocusReason reason) {
    currentWidget()->setFocus(reason);
}
