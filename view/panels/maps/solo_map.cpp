// SPDX-License-Identifier: MIT
#include "panels/maps/solo_map.h"

#include "document/maps/map_solo.h"

#include <utility>

namespace view {

SoloMap::SoloMap(document::Document* document, QObject* parent) : QObject(parent), m_document(document) {
    connect(document, &document::Document::changed, this, &SoloMap::follow);
}

void SoloMap::toggle(ifs::MapId map) {
    if (map == m_map) return set(ifs::MapId::None);
    const QString obstacle = document::soloObstacle(m_document->fractal(), map);
    if (!obstacle.isEmpty()) return emit message(obstacle);
    set(map);
    emit message(tr("One map is shown alone. Choose Solo again to show all; the file does not change."));
}

void SoloMap::set(ifs::MapId map) {
    if (std::exchange(m_map, map) != map) emit changed();
}

void SoloMap::follow(const document::Change& change) {
    using document::Change;
    if (m_map == ifs::MapId::None) return;
    if (change.parts & (Change::Current | Change::File)) return set(ifs::MapId::None);
    if (!(change.parts & (Change::System | Change::Cage))) return;
    if (!document::soloObstacle(m_document->fractal(), m_map).isEmpty()) set(ifs::MapId::None);
}

} // namespace view
