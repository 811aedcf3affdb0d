// SPDX-License-Identifier: MIT
#include "canvas/tools/map_gestures.h"

#include "document/edits/maps/map_locks.h"
#include "document/edits/maps/maps_edits.h"

#include <QCoreApplication>
#include <QKeyEvent>

namespace view {

namespace {

struct MapTexts {
    Q_DECLARE_TR_FUNCTIONS(view::MapsTool)
};

std::vector<ifs::MapId> idsOf(const document::Fractal& fractal) {
    std::vector<ifs::MapId> ids;
    const auto add = [&](const auto& maps) {
        for (const auto& map : maps)
            ids.push_back(map.id);
    };
    if (const document::System2* system = document::system2(fractal)) add(system->maps);
    if (const document::System3* system = document::system3(fractal)) add(system->maps);
    return ids;
}

} // namespace

QString mapsStepText(DragMode mode, std::size_t count, std::size_t number,
                     std::optional<std::size_t> corner) {
    const bool isOne = count == 1;
    if (mode == DragMode::Move && corner)
        return MapTexts::tr("Move corner %1 of map %2").arg(*corner + 1).arg(number);
    const QString text =
        mode == DragMode::Move     ? (isOne ? MapTexts::tr("Move map %1") : MapTexts::tr("Move %1 maps"))
        : mode == DragMode::Rotate ? (isOne ? MapTexts::tr("Rotate map %1") : MapTexts::tr("Rotate %1 maps"))
                                   : (isOne ? MapTexts::tr("Scale map %1") : MapTexts::tr("Scale %1 maps"));
    return text.arg(isOne ? number : count);
}

MapKey pressMapKey(const QKeyEvent& event, document::Document& document,
                   const std::vector<std::size_t>& selected) {
    const std::vector<ifs::MapId> ids = idsOf(document.fractal());
    const Qt::KeyboardModifiers modifiers = event.modifiers() & ~Qt::KeypadModifier;
    const int digit = event.key() - Qt::Key_1;
    if (modifiers == Qt::AltModifier && digit >= 0 && digit < 9) {
        if (std::size_t(digit) >= ids.size()) return {true};
        return {true, {ids[std::size_t(digit)]}};
    }
    if (modifiers == Qt::ControlModifier && event.key() == Qt::Key_A) return {true, ids};
    const bool deletes = event.key() == Qt::Key_Delete;
    if (modifiers != Qt::NoModifier || (!deletes && event.key() != Qt::Key_Insert)) return {};
    const document::Rows rows(selected.begin(), selected.end());
    if (rows.empty()) return {true, {}, MapTexts::tr("Select a map first.")};
    if (!deletes) return {true, document::duplicateMaps(document, rows)};
    const QString locked = document::lockObstacle(document.fractal(), rows);
    if (!locked.isEmpty()) return {true, {}, locked};
    return {true, document::deleteMaps(document, rows)};
}

} // namespace view
