// SPDX-License-Identifier: MIT
#include "panels/maps/returned_maps.h"

#include <QUndoStack>

#include <algorithm>
#include <iterator>
#include <utility>

namespace view {

namespace {

// The ids of the maps in their order.
std::vector<ifs::MapId> mapsOf(const document::Fractal& fractal) {
    std::vector<ifs::MapId> maps;
    const auto add = [&](const auto* system) {
        for (std::size_t i = 0; system && i < system->maps.size(); ++i)
            maps.push_back(system->maps[i].id);
    };
    add(document::system2(fractal));
    add(document::system3(fractal));
    std::ranges::sort(maps);
    return maps;
}

} // namespace

ReturnedMaps::ReturnedMaps(document::Document* document, QObject* parent)
    : QObject(parent), m_document(document) {
    connect(document->undoStack(), &QUndoStack::indexChanged, this, &ReturnedMaps::look);
    look();
}

void ReturnedMaps::look() {
    const document::EntryId entry = std::exchange(m_entry, m_document->currentId());
    const std::vector<ifs::MapId> before = std::exchange(m_maps, mapsOf(m_document->fractal()));
    const bool isUndone = m_document->undoStack()->canRedo();
    std::vector<ifs::MapId> back;
    std::ranges::set_difference(m_maps, before, std::back_inserter(back));
    const bool isAddition = !before.empty() && m_maps.size() == before.size() + back.size();
    if (isUndone && isAddition && !back.empty() && entry == m_entry) emit returned(back);
}

} // namespace view
