// SPDX-License-Identifier: MIT
#include "stage/fitted_views.h"

#include "canvas/canvas_navigation.h"

#include <utility>

namespace {

// But for where they look and how near.
bool areAlike(const attractor::Camera& a, const attractor::Camera& b) {
    return a.width == b.width && a.height == b.height && a.yAxis == b.yAxis && a.rotation == b.rotation;
}

} // namespace

FittedViews::FittedViews(document::Document* document, view::CanvasNavigation& plane,
                         view::SpaceNavigation& space, QObject* parent)
    : QObject(parent), m_document(document), m_plane(plane), m_space(space) {
    connect(document->undoStack(), &QUndoStack::indexChanged, this, &FittedViews::follow);
    connect(document, &document::Document::changed, this, [this](const document::Change& change) {
        if (!change.live) m_changed |= change.parts;
    });
}

FittedViews::Seen FittedViews::now() const {
    const document::EntryId entry = m_document->currentId();
    if (document::space(m_document->fractal())) return {entry, m_space.camera(), m_space.isFitted()};
    return {entry, m_plane.camera(), m_plane.isFitted()};
}

void FittedViews::follow(int index) {
    const QUndoStack& history = *m_document->undoStack();
    const bool isMoved = movesPicture();
    if (history.count() == 0) { // another file
        m_places.assign(1, {});
        m_index = 0;
        return;
    }
    m_places[std::size_t(m_index)].view = now();
    m_places.resize(std::size_t(history.count()) + 1);
    m_index = index;
    Place& place = m_places[std::size_t(index)];
    const QUndoCommand* step = index > 0 ? history.command(index - 1) : nullptr;
    const bool wasHere = index == 0 || step == place.step;
    place.step = step;
    const bool wasKeyed = std::exchange(m_isKeyed, m_document->view().has_value());
    if (!wasHere || !place.view) return;
    if (wasKeyed && !m_isKeyed)
        restoreUnkeyed(*place.view);
    else if (isMoved)
        restore(*place.view);
}

bool FittedViews::movesPicture() {
    using document::Change;
    const bool hasShadow = m_document->fractal().appearance.shadow > 0;
    const bool hadShadow = std::exchange(m_hasShadow, hasShadow);
    const Change::Parts parts = std::exchange(m_changed, {});
    return hasShadow || hadShadow || (parts & ~Change::Parts(Change::Appearance | Change::Name));
}

void FittedViews::restore(const Seen& before) {
    const Seen present = now();
    if (!before.isFitted || !present.isFitted || present.entry != before.entry ||
        present.camera == before.camera)
        return;
    const auto* camera = std::get_if<attractor::Camera>(&before.camera);
    if (!camera)
        m_space.fit();
    else if (areAlike(*camera, m_plane.camera()))
        m_plane.setCamera(*camera);
    else
        m_plane.fit();
}

// Though it is no longer fitted: that was not the user.
void FittedViews::restoreUnkeyed(const Seen& before) {
    const auto* camera = std::get_if<attractor::Camera>(&before.camera);
    if (!camera || m_document->currentId() != before.entry) return;
    if (before.isFitted)
        m_plane.fit();
    else
        m_plane.moveTo(attractor::cameraOf(attractor::viewOf(*camera),
                                           {m_plane.camera().width, m_plane.camera().height}));
}
