// SPDX-License-Identifier: MIT
#include "canvas/maps_tool.h"

#include "canvas/canvas_note.h"
#include "ifs/map_handles.h"
#include "panels/maps_edits.h"

#include <QKeyEvent>

#include <algorithm>
#include <numeric>

namespace view {

namespace {

using Kind = CanvasPart::Kind;
using Mode = PolygonDrag::Mode;

std::vector<ifs::AffineMap<2>> activeMaps(const document::Fractal& fractal) {
    return ifs::activeMaps(*document::system2(fractal)).maps;
}

} // namespace

void MapsTool::start() {
    scene().setTaken(CanvasScene::Taken::Maps);
    if (scene().areMapsThinnedOut())
        emit message(tr("Of so many maps only some are shown. Zoom in to see the others."));
}

void MapsTool::stop() {
    PolygonTool::stop();
    ended();
    scene().setTaken(CanvasScene::Taken::Cage);
}

void MapsTool::selectOnly(int place) {
    scene().setSelectedPlaces({std::size_t(place)});
}

void MapsTool::taken(const CanvasPart& part, Qt::KeyboardModifiers modifiers) {
    if (part.map >= 0 && !scene().isSelected(part.map) && !(modifiers & adding)) selectOnly(part.map);
}

void MapsTool::clicked(const CanvasPart& part, const Pointer& pointer) {
    if (part.map >= 0) selectClicked(std::size_t(part.map), pointer.modifiers);
}

std::optional<std::vector<std::size_t>> MapsTool::selection() const {
    if (scene().taken() != CanvasScene::Taken::Maps) return std::nullopt; // one branch, by its point
    return scene().selectedPlaces();
}

void MapsTool::setSelection(const std::vector<std::size_t>& places) {
    scene().setSelectedPlaces(places);
}

std::vector<std::size_t> MapsTool::enclosedBy(const QRectF& band) const {
    return scene().placesWithin(band);
}

MapsTool::Taken MapsTool::take(const CanvasPart& part) {
    if (part.map >= 0 && !scene().isSelected(part.map)) selectOnly(part.map);
    return {document::MapHandles(scene().document().currentEntry().fractal, *scene().cage()),
            scene().selectedPlaces()};
}

QString MapsTool::stepText(Mode mode, std::optional<std::size_t> corner) const {
    const bool one = m_places.size() == 1;
    const auto number = one ? m_places.front() + 1 : m_places.size();
    if (corner) return tr("Move corner %1 of map %2").arg(*corner + 1).arg(number);
    if (mode == Mode::Move) return (one ? tr("Move map %1") : tr("Move %1 maps")).arg(number);
    if (mode == Mode::Rotate) return (one ? tr("Rotate map %1") : tr("Rotate %1 maps")).arg(number);
    return (one ? tr("Scale map %1") : tr("Scale %1 maps")).arg(number);
}

std::optional<PolygonTool::Grip> MapsTool::grip(const CanvasPart& part, Mode mode) {
    Taken taken = take(part);
    if (!taken.handles || taken.places.empty()) return std::nullopt;
    m_handles = std::move(taken.handles);
    m_places = std::move(taken.places);
    if (!m_handles->canBeTaken()) {
        emit message(tr("What is flat on the screen cannot be taken. Open the cage, or the maps, first."));
        return std::nullopt;
    }
    m_corner.reset();
    if (part.kind == Kind::Vertex && mode == Mode::Move) {
        m_corner = std::size_t(part.index);
        if (m_places.size() > 1) m_places = {std::size_t(part.map)};
        return Grip{stepText(mode, m_corner), m_handles->corners(m_places.front()), {part.index}};
    }
    Grip grip;
    for (const std::size_t place : m_places)
        for (const ifs::Vector<2>& corner : m_handles->corners(place))
            grip.points.push_back(corner);
    grip.vertices.resize(grip.points.size());
    std::iota(grip.vertices.begin(), grip.vertices.end(), 0);
    grip.text = stepText(mode, m_corner);
    return grip;
}

document::Fractal MapsTool::after(const DragResult& result) const {
    if (result.points == drag().points) return gesture().before();
    if (m_corner)
        return m_handles->withCornerMoved(m_places.front(), *m_corner,
                                          result.points[*m_corner] - drag().points[*m_corner]);
    if (drag().mode == Mode::Move) return m_handles->withMapsMoved(m_places, result.change.translation);
    return m_handles->withMapsChanged(m_places, result.change);
}

double MapsTool::shareToShow(const std::function<document::Fractal(double)>& after) {
    ifs::SafeWay way;
    if (!m_allowsNoAttractor) way = ifs::safeWay([&](double share) { return activeMaps(after(share)); });
    scene().setPrompt(way.share < 1 ? stopNote(*document::system2(after(way.share)), way) : QString());
    return way.share;
}

double MapsTool::preview(const std::function<DragResult(double)>& resultAt) {
    const double share = shareToShow([&](double part) { return after(resultAt(part)); });
    gesture().preview(after(resultAt(share)));
    return share;
}

void MapsTool::ended() {
    scene().setPrompt({});
}

// The selection goes with the focus.
void MapsTool::walk(int step) {
    PolygonTool::walk(step);
    const CanvasPart part = scene().focused();
    if (part.map >= 0 && !scene().isSelected(part.map)) selectOnly(part.map);
}

bool MapsTool::keyPress(const QKeyEvent& event) {
    if (isBareKey(event, Qt::Key_Delete) || isBareKey(event, Qt::Key_Insert)) {
        const std::vector<std::size_t> places = scene().selectedPlaces();
        const Rows rows(places.begin(), places.end());
        document::Document& document = scene().document();
        if (rows.empty())
            emit message(tr("Select a map first."));
        else
            scene().setSelectedMaps(event.key() == Qt::Key_Delete ? deleteMaps(document, rows)
                                                                  : duplicateMaps(document, rows));
        return true;
    }
    const int digit = event.key() - Qt::Key_1;
    if (event.modifiers() == Qt::AltModifier && digit >= 0 && digit < 9) {
        if (digit < scene().mapCount()) {
            selectOnly(digit);
            scene().setFocused({Kind::Inside, 0, digit});
        }
        return true;
    }
    if (event.modifiers() == Qt::ControlModifier && event.key() == Qt::Key_A) {
        std::vector<std::size_t> all(std::size_t(scene().mapCount()));
        std::iota(all.begin(), all.end(), std::size_t(0));
        scene().setSelectedPlaces(all);
        return true;
    }
    return PolygonTool::keyPress(event);
}

} // namespace view
