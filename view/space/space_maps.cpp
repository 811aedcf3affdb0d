// SPDX-License-Identifier: MIT
#include "space/space_maps.h"

#include "canvas/geometry/canvas_geometry.h"
#include "canvas/geometry/canvas_note.h"
#include "canvas/tools/map_gestures.h"
#include "document/branches/shown_branch.h"
#include "document/edits/maps/map_locks.h"
#include "document/fractal/space_geometry.h"

#include <QLineF>

#include <algorithm>
#include <cmath>
#include <utility>

namespace view {

namespace {

using document::SpaceMapHandles;

constexpr double cornerGrip = 12;     // pixels around a corner
constexpr std::size_t maxShown = 300; // tetrahedra; more could not be told apart

ifs::Vector<3> middleOf(const SpaceMapHandles::Corners& corners) {
    return (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
}

} // namespace

document::SpaceOutline tetrahedron(const SpaceMapHandles::Corners& corners, const attractor::Rgba& colour) {
    document::SpaceOutline outline;
    outline.points.assign(corners.begin(), corners.end());
    outline.edges = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
    outline.colour = colour;
    return outline;
}

std::vector<ifs::Vector<3>> handlesOf(const SpaceMapHandles::Corners& corners) {
    std::vector<ifs::Vector<3>> handles(corners.begin(), corners.end());
    handles.push_back(middleOf(corners));
    return handles;
}

SpaceCageItem::Faces facesOfTetrahedron() {
    return {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
}

void SpaceMaps::setActive(bool active) {
    m_isActive = active;
    m_all.setVisible(active);
    m_held.setVisible(active);
}

std::size_t SpaceMaps::count() const {
    const document::System3* system = document::system3(m_document->fractal());
    return system ? system->maps.size() : 0;
}

std::optional<std::size_t> SpaceMaps::selected() const {
    if (!m_isActive || !m_selected || count() == 0) return std::nullopt;
    return std::min(*m_selected, count() - 1);
}

bool SpaceMaps::select(std::optional<std::size_t> index, std::vector<ifs::MapId> among) {
    std::ranges::sort(among);
    const bool isAnother = std::exchange(m_selected, index) != index;
    return std::exchange(m_among, among) != among || isAnother;
}

std::vector<std::size_t> SpaceMaps::selection() const {
    const auto held = selected();
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; held && i < count(); ++i)
        if (i == *held ||
            std::ranges::binary_search(m_among, document::system3(m_document->fractal())->maps[i].id))
            indices.push_back(i);
    return indices;
}

std::vector<ifs::MapId> SpaceMaps::selectedIds() const {
    std::vector<ifs::MapId> ids;
    for (const std::size_t index : selection())
        ids.push_back(document::system3(m_document->fractal())->maps[index].id);
    return ids;
}

bool SpaceMaps::selectIds(const std::vector<ifs::MapId>& ids) {
    const auto& maps = document::system3(m_document->fractal())->maps;
    const auto held = selected();
    if (held && std::ranges::find(ids, maps[*held].id) != ids.end()) return select(held, ids);
    const auto first = std::ranges::find(maps, ids.front(), &ifs::WeightedMap<3>::id);
    return select(std::size_t(first - maps.begin()), ids);
}

void SpaceMaps::pick(std::size_t index, bool adds) {
    std::vector<ifs::MapId> ids = selectedIds();
    const ifs::MapId id = document::system3(m_document->fractal())->maps[index].id;
    const bool isSelected = std::erase(ids, id) > 0;
    if (isSelected && adds) return void(select(*selected(), ids));
    if (!isSelected && !adds) ids.clear();
    ids.push_back(id);
    select(index, std::move(ids));
}

void SpaceMaps::layOut(const attractor::OrbitCamera& camera, const std::optional<ifs::ControlCage<3>>& cage,
                       const SpaceCageItem::Hidden& isHidden) {
    m_dots.clear();
    std::vector<document::SpaceOutline> shapes;
    std::vector<ifs::Vector<3>> held;
    const auto handles = m_isActive && cage
                             ? std::optional(SpaceMapHandles(m_document->sharedFractal(), *cage))
                             : std::nullopt;
    const document::Fractal& fractal = m_document->fractal();
    const std::vector<std::size_t> chosen = selection();
    for (std::size_t i = 0; handles && i < handles->count(); ++i) {
        const bool isHeld = i == selected();
        if (i >= maxShown && !isHeld) continue;
        const SpaceMapHandles::Corners corners = handles->corners(i);
        if (isHeld) {
            held = handlesOf(corners);
            continue;
        }
        shapes.push_back(tetrahedron(
            corners, attractor::mapColour(fractal.appearance, document::system3(fractal)->maps[i].id, i)));
        shapes.back().isSelected = std::ranges::binary_search(chosen, i);
        for (const ifs::Vector<3>& corner : corners) {
            const attractor::ScreenPoint seen = toScreen(camera, corner);
            if (seen.pixel.allFinite()) m_dots.push_back({toPoint(seen.pixel), seen.depth, i});
        }
    }
    m_all.setShapes(std::move(shapes));
    m_all.layOut(camera);
    m_held.layOut(camera, held, facesOfTetrahedron(), isHidden);
}

std::optional<std::size_t> SpaceMaps::mapAt(const QPointF& position) const {
    const Dot* nearest = nullptr;
    for (const Dot& dot : m_dots)
        if (QLineF(dot.pixel, position).length() <= cornerGrip && (!nearest || dot.depth < nearest->depth))
            nearest = &dot;
    return nearest ? std::optional(nearest->map) : std::nullopt;
}

std::optional<SpaceMapDrag> SpaceMaps::drag(QString& obstacle) const {
    const auto map = selected();
    const auto before = m_document->sharedFractal();
    if (map) obstacle = document::lockObstacle(*before, std::vector{*map});
    if (!obstacle.isEmpty()) return std::nullopt;
    const auto cage = map ? document::knownSpaceCage(*before) : std::nullopt;
    auto drag = cage ? SpaceMapDrag::of({before, *cage}, moving()) : std::nullopt;
    if (!drag) obstacle = tr("Maps cannot be dragged while the cage is flat. First open or reset the cage.");
    return drag;
}

std::vector<std::size_t> SpaceMaps::moving() const {
    const std::size_t held = *selected();
    std::vector<std::size_t> maps = selection();
    std::erase_if(
        maps, [&](std::size_t map) { return map == held || document::isLocked(m_document->fractal(), map); });
    maps.insert(maps.begin(), held);
    return maps;
}

QString SpaceMaps::stepText(DragMode mode, std::optional<std::size_t> corner) const {
    return mapsStepText(mode, moving().size(), *selected() + 1, corner);
}

SpaceMapDrag::SpaceMapDrag(SpaceMapHandles handles, std::vector<std::size_t> maps, ifs::Word inside)
    : m_handles(std::move(handles)), m_maps(std::move(maps)), m_inside(std::move(inside)) {
    for (const std::size_t map : m_maps)
        m_corners.push_back(m_handles.corners(map));
}

std::optional<SpaceMapDrag> SpaceMapDrag::of(SpaceMapHandles handles, std::vector<std::size_t> maps,
                                             ifs::Word inside) {
    const auto isThere = [&](std::size_t map) { return map < handles.count(); };
    if (!handles.canBeMoved() || !std::ranges::all_of(maps, isThere)) return std::nullopt;
    return SpaceMapDrag(std::move(handles), std::move(maps), std::move(inside));
}

std::vector<ifs::Vector<3>> SpaceMapDrag::vertices() const {
    std::vector<ifs::Vector<3>> result;
    for (const SpaceMapHandles::Corners& corners : m_corners)
        for (const ifs::Vector<3>& handle : handlesOf(corners))
            result.push_back(handle);
    return result;
}

std::vector<SpaceMapHandles::Corners>
SpaceMapDrag::offsets(const std::vector<ifs::Vector<3>>& vertices) const {
    std::vector<SpaceMapHandles::Corners> result(m_maps.size());
    bool isByMiddle = true;
    for (std::size_t k = 0; k < m_maps.size(); ++k)
        for (std::size_t i = 0; i < result[k].size(); ++i) {
            result[k][i] = vertices[(SpaceMaps::middle + 1) * k + i] - m_corners[k][i];
            isByMiddle &= result[k][i].isZero(0);
        }
    if (isByMiddle)
        for (SpaceMapHandles::Corners& offsets : result)
            offsets.fill(vertices[SpaceMaps::middle] - middleOf(m_corners.front()));
    return result;
}

SpaceMapDrag::Moved SpaceMapDrag::at(const std::vector<ifs::Vector<3>>& vertices, Safety safety) const {
    const std::vector<SpaceMapHandles::Corners> whole = offsets(vertices);
    document::Fractal fractal;
    const auto after = [&](double share) -> const document::Fractal& {
        std::vector<SpaceMapHandles::Corners> part = whole;
        for (SpaceMapHandles::Corners& offsets : part)
            for (ifs::Vector<3>& offset : offsets)
                offset *= share;
        return fractal = m_handles.withCornersMoved(m_maps, part);
    };
    const auto inside = [&](double share) {
        return std::vector{document::recurringMap(*document::space(after(share)), m_inside)};
    };
    ifs::SafeWay<3> way;
    if (safety == Safety::StopAtAttractor)
        way = m_inside.empty() ? wayWithAttractor<3>(after) : ifs::safeWay<3>(inside);
    after(way.share);
    if (way.share == 1) return {std::move(fractal), {}};
    const QString stop = m_inside.empty()
                             ? stopNote<3>(*document::system3(fractal), way)
                             : tr("Stopped: beyond this, the branch would not become smaller inside itself.");
    return {std::move(fractal), stop};
}

} // namespace view
