// SPDX-License-Identifier: MIT
#include "canvas/tools/maps_tool.h"

#include "canvas/geometry/canvas_note.h"
#include "canvas/tools/map_gestures.h"
#include "document/edits/maps/map_locks.h"
#include "ifs/cage/map_handles.h"

#include <QKeyEvent>

#include <algorithm>
#include <numeric>
#include <utility>

namespace view {

namespace {

using Kind = CanvasPart::Kind;

} // namespace

void MapsTool::start() {
    handles().setTarget(HandleTarget::Maps);
    if (scene().areMapsThinnedOut())
        emit message(tr("There are too many maps to show them all. Zoom in to see the others."));
}

void MapsTool::stop() {
    PolygonTool::stop();
    ended();
    handles().setTarget(HandleTarget::Cage);
}

void MapsTool::selectOnly(int index) {
    selection().setMapIndices({std::size_t(index)});
}

void MapsTool::pressed(const CanvasPart& part, Qt::KeyboardModifiers modifiers) {
    if (part.map >= 0 && !selection().isMapSelected(part.map) && !(modifiers & adding)) selectOnly(part.map);
}

void MapsTool::clicked(const CanvasPart& part, const Pointer& pointer) {
    if (part.map >= 0) selectClicked(std::size_t(part.map), pointer.modifiers);
}

std::optional<std::vector<std::size_t>> MapsTool::selectedItems() const {
    // A single branch, dragged by its point.
    if (handles().target() != HandleTarget::Maps) return std::nullopt;
    return selection().mapIndices();
}

void MapsTool::selectItems(const std::vector<std::size_t>& indices) {
    selection().setMapIndices(indices);
}

std::vector<std::size_t> MapsTool::enclosedBy(const QRectF& band) const {
    return scene().hitTester().mapsWithin(band);
}

MapsTool::HeldMaps MapsTool::hold(const CanvasPart& part) {
    if (part.map >= 0 && !selection().isMapSelected(part.map)) selectOnly(part.map);
    const auto fractal = scene().document().sharedFractal();
    std::vector<std::size_t> indices = selection().mapIndices();
    const std::vector<std::size_t> pressed(part.map >= 0 ? 1 : 0, std::size_t(std::max(part.map, 0)));
    QString locked = document::lockObstacle(*fractal, pressed);
    const auto isLocked = [&](std::size_t index) { return document::isLocked(*fractal, index); };
    if (std::ranges::all_of(indices, isLocked) && locked.isEmpty())
        locked = document::lockObstacle(*fractal, indices);
    if (!locked.isEmpty()) {
        emit message(locked);
        return {};
    }
    std::erase_if(indices, isLocked); // keeps the unlocked maps of a selection
    return {document::MapHandles(fractal, *handles().cage()), std::move(indices)};
}

QString MapsTool::stepText(DragMode mode, std::optional<std::size_t> corner) const {
    return mapsStepText(mode, m_held.indices.size(), m_held.indices.front() + 1, corner);
}

std::optional<PolygonTool::DragSubject> MapsTool::dragSubject(const CanvasPart& part, DragMode mode) {
    HeldMaps held = hold(part);
    if (!held.maps || held.indices.empty()) return std::nullopt;
    m_held = std::move(held);
    if (!m_held.maps->canBeMoved()) {
        emit message(
            tr("Maps that are flat on the screen cannot be dragged. First open the cage or the maps."));
        return std::nullopt;
    }
    m_corner.reset();
    if (part.kind == Kind::Vertex && mode == DragMode::Move) {
        m_corner = std::size_t(part.index);
        if (m_held.indices.size() > 1) m_held.indices = {std::size_t(part.map)};
        return DragSubject{
            stepText(mode, m_corner), m_held.maps->corners(m_held.indices.front()), {part.index}};
    }
    DragSubject subject;
    for (const std::size_t index : m_held.indices)
        for (const ifs::Vector<2>& corner : m_held.maps->corners(index))
            subject.points.push_back(corner);
    subject.vertices.resize(subject.points.size());
    std::iota(subject.vertices.begin(), subject.vertices.end(), 0);
    subject.text = stepText(mode, m_corner);
    return subject;
}

document::Fractal MapsTool::after(const DragResult& result) const {
    if (result.points == drag().points) return gesture().before();
    if (m_corner)
        return m_held.maps->withCornerMoved(m_held.indices.front(), *m_corner,
                                            result.points[*m_corner] - drag().points[*m_corner]);
    if (drag().mode == DragMode::Move)
        return m_held.maps->withMapsMoved(m_held.indices, result.change.translation);
    return m_held.maps->withMapsChanged(m_held.indices, result.change);
}

double MapsTool::shareToShow(const std::function<const document::Fractal&(double)>& after) {
    const ifs::SafeWay<2> way = m_allowsNoAttractor ? ifs::SafeWay<2>() : wayWithAttractor<2>(after);
    scene().notes().setPrompt(way.share < 1 ? stopNote(*document::system2(after(way.share)), way)
                                            : QString());
    return way.share;
}

void MapsTool::dismissStop() {
    scene().notes().setPrompt({});
}

PolygonTool::Shown MapsTool::preview(const std::function<DragResult(double)>& resultAt) {
    std::optional<Shown> shown; // result of the last call, usually the one to show
    document::Fractal fractal;
    const auto at = [&](double share) -> const document::Fractal& {
        if (!shown || shown->share != share) {
            shown = {share, resultAt(share)};
            fractal = after(shown->result);
        }
        return fractal;
    };
    at(shareToShow(at));
    gesture().preview(std::move(fractal));
    return *std::move(shown);
}

void MapsTool::ended() {
    dismissStop();
}

// The selection goes with the focus.
bool MapsTool::walk(int step) {
    const bool isThere = PolygonTool::walk(step);
    const CanvasPart part = selection().focused();
    if (part.map >= 0 && !selection().isMapSelected(part.map)) selectOnly(part.map);
    return isThere;
}

bool MapsTool::keyPress(const QKeyEvent& event) {
    const MapKey key = isBusy() ? MapKey() : pressMapKey(event, scene().document(), selection().mapIndices());
    if (!key.message.isEmpty()) emit message(key.message);
    if (!key.selected.empty()) selection().setMaps(key.selected);
    if (event.modifiers() == Qt::AltModifier && !key.selected.empty())
        selection().setFocused({Kind::Inside, 0, int(selection().mapIndices().front())});
    if (key.isTaken) return true;
    return PolygonTool::keyPress(event);
}

} // namespace view
