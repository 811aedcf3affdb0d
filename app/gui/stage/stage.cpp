// SPDX-License-Identifier: MIT
#include "stage/stage.h"

#include "stage/fitted_views.h"

Stage::Stage(document::Document* document, view::RenderBridge* render, view::SolidBridge* solid,
             QWidget* parent)
    : QSplitter(Qt::Horizontal, parent),
      m_extentFinder(document),
      m_views(new QStackedWidget(this)),
      m_plane(new view::CanvasView(document, render, this)),
      m_transformation(new view::TransformationView(document, render, m_plane, this)),
      m_space(new view::FourViews(document, solid, this)),
      m_compare(new view::ComparePane(document, render, m_plane, m_space->main(), this)) {
    m_views->addWidget(m_transformation);
    m_views->addWidget(m_space);
    setChildrenCollapsible(false);
    addWidget(m_views);
    addWidget(m_compare);
    for (int part = 0; part < count(); ++part)
        setStretchFactor(part, 1); // equal shares
    connect(document, &document::Document::changed, this, [this, document](const document::Change& change) {
        using document::Change;
        if (change.parts & (Change::System | Change::Current | Change::File)) follow(*document);
    });
    new FittedViews(document, m_plane->navigation(), m_space->main()->navigation(), this);
    connect(&m_plane->options(), &view::CanvasOptions::overlaysVisibleChanged, m_space,
            &view::FourViews::setOverlaysVisible);
    connect(m_plane, &view::CanvasView::toolChanged, m_space, [this](view::CanvasView::Tool tool) {
        using Tool = view::CanvasView::Tool;
        using Target = view::SpaceView::Target;
        m_space->setTarget(tool == Tool::Maps             ? Target::Maps
                           : tool == Tool::Branch         ? Target::Branch
                           : tool == Tool::DefineTriangle ? Target::Definition
                                                          : Target::Cage);
    });
    m_space->setBranchChoice(&m_plane->tools().branchTool().choice());
    connect(m_space, &view::FourViews::defined, m_plane,
            [this] { m_plane->setTool(view::CanvasView::Tool::Cage); });
    follow(*document);
}

void Stage::follow(const document::Document& document) {
    QWidget* wanted = m_transformation;
    if (document::space(document.fractal())) wanted = m_space;
    if (wanted == m_views->currentWidget()) return;
    const bool hadFocus = (showsSpace() ? static_cast<QWidget*>(m_space) : m_plane)->hasFocus();
    m_views->setCurrentWidget(wanted);
    setFocusProxy(wanted);
    if (hadFocus) wanted->setFocus();
    emit switched();
}

void Stage::setCompared(bool compared) {
    m_compare->setCompared(compared);
    if (compared) setSizes({width() / 2, width() / 2});
}

void Stage::fit() {
    if (showsSpace())
        m_space->fit();
    else
        m_plane->fit();
}

view::ViewNavigation& Stage::navigation() {
    if (showsSpace()) return m_space->main()->navigation();
    return m_plane->navigation();
}

void Stage::zoomBy(double factor) {
    navigation().zoomAt(navigation().middle(), factor);
}

QImage Stage::picture() const {
    return showsSpace() ? m_space->main()->picture() : m_plane->picture();
}

document::SavedView::Camera Stage::camera() const {
    if (showsSpace()) return m_space->main()->navigation().camera();
    return attractor::viewOf(m_plane->camera());
}

void Stage::lookAt(const document::SavedView::Camera& camera) {
    view::SpaceNavigation& space = m_space->main()->navigation();
    if (const auto* view = std::get_if<attractor::View>(&camera); view && !showsSpace()) {
        const attractor::Camera& now = m_plane->camera();
        m_plane->navigation().moveTo(attractor::cameraOf(*view, {now.width, now.height}));
    } else if (const auto* orbit = std::get_if<attractor::OrbitCamera>(&camera); orbit && showsSpace()) {
        attractor::OrbitCamera to = *orbit;
        to.size = space.camera().size;
        space.setPerspective(to.projection == attractor::OrbitCamera::Projection::Perspective);
        space.glideTo(to);
    }
}

bool Stage::cancelGesture() {
    if (m_compare->cancelGesture()) return true;
    if (showsSpace()) return m_space->cancelGesture();
    return m_plane->cancelGesture() || m_transformation->cancelGesture();
}

void Stage::takeFocus(Qt::FocusReason reason) {
    m_views->currentWidget()->setFocus(reason);
}
