// SPDX-License-Identifier: MIT
#include "canvas/scene/canvas_selection.h"

#include "document/fractal/fractal.h"

#include <algorithm>
#include <utility>

namespace view {

const std::vector<ifs::WeightedMap<2>>& CanvasSelection::systemMaps() const {
    static const std::vector<ifs::WeightedMap<2>> none;
    const document::System2* system = document::system2(m_document.fractal());
    return system ? system->maps : none;
}

int CanvasSelection::mapCount() const {
    return int(systemMaps().size());
}

void CanvasSelection::setMaps(const std::vector<ifs::MapId>& maps) {
    if (maps.empty() && m_maps.empty()) return;
    std::vector<ifs::MapId> selected = maps;
    std::ranges::sort(selected);
    std::vector<std::size_t> indices;
    const auto& all = systemMaps();
    for (std::size_t index = 0; index < all.size(); ++index)
        if (std::ranges::binary_search(selected, all[index].id)) indices.push_back(index);
    setMapIndices(indices);
}

void CanvasSelection::setMapIndices(const std::vector<std::size_t>& indices) {
    const auto& all = systemMaps();
    std::vector<bool> isWanted(all.size(), false);
    for (const std::size_t index : indices)
        if (index < isWanted.size()) isWanted[index] = true;
    std::vector<ifs::MapId> selected;
    for (std::size_t index = 0; index < isWanted.size(); ++index)
        if (isWanted[index]) selected.push_back(all[index].id);
    if (selected == m_maps) return;
    m_maps = std::move(selected);
    emit mapsChanged();
}

std::vector<std::size_t> CanvasSelection::mapIndices() const {
    std::vector<std::size_t> indices;
    const auto& all = systemMaps();
    auto next = m_maps.begin(); // both are in the order of the system
    for (std::size_t index = 0; index < all.size() && next != m_maps.end(); ++index)
        if (all[index].id == *next) {
            indices.push_back(index);
            ++next;
        }
    return indices;
}

bool CanvasSelection::isMapSelected(int index) const {
    return index >= 0 && index < mapCount() &&
           std::ranges::find(m_maps, systemMaps()[std::size_t(index)].id) != m_maps.end();
}

void CanvasSelection::setPointed(ifs::MapId map) {
    if (map == m_pointed) return;
    m_pointed = map;
    emit pointedChanged();
}

void CanvasSelection::setVertices(std::vector<std::size_t> vertices) {
    std::ranges::sort(vertices);
    m_vertices = std::move(vertices);
    emit verticesChanged();
}

void CanvasSelection::setHovered(CanvasPart part) {
    if (m_hovered == part) return;
    m_hovered = part;
    emit marksChanged();
}

void CanvasSelection::setPressed(CanvasPart part) {
    m_pressed = part;
    emit marksChanged();
}

void CanvasSelection::setFocused(CanvasPart part) {
    m_focused = part;
    emit marksChanged();
    emit focusChanged();
}

void CanvasSelection::clear() {
    setFocused({});
    setMaps({});
    setVertices({});
}

} // namespace view
