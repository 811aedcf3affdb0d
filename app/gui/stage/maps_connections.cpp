// SPDX-License-Identifier: MIT
#include "stage/maps_connections.h"

#include "bridges/solo_switch.h"
#include "canvas/canvas_view.h"
#include "messages/window_messages.h"
#include "panels/maps/maps_model.h"
#include "panels/maps/maps_panel.h"
#include "space/four_views.h"
#include "stage/stage.h"

#include <QTableView>

#include <algorithm>
#include <optional>

namespace {

// The selected row that the form shows; nullopt: none is selected.
std::optional<std::size_t> shownRow(const view::MapsPanel& maps, const std::vector<ifs::MapId>& selected) {
    if (selected.empty()) return std::nullopt;
    const ifs::MapId current = maps.model()->idAt(maps.table()->currentIndex().row());
    const bool isCurrent = std::ranges::find(selected, current) != selected.end();
    const auto rows = maps.model()->rowsOf({isCurrent ? current : selected.front()});
    return rows.empty() ? std::nullopt : std::optional(std::size_t(rows.front()));
}

// The window into space holds the map that the form shows, when several are selected; Weave swings all of
// them.
void holdSelected(const view::MapsPanel& maps, Stage* stage) {
    const std::vector<ifs::MapId> selected = maps.selectedMaps();
    const std::optional<std::size_t> row = shownRow(maps, selected);
    stage->space()->holdMap(row, selected);
    for (view::SpaceView* other : stage->views()->others())
        other->holdMap(row, selected);
}

void connectSpace(view::MapsPanel* maps, Stage* stage, const document::Document& document) {
    const auto hold = [maps, stage, &document] {
        if (document::space(document.fractal())) holdSelected(*maps, stage);
    };
    QObject::connect(maps, &view::MapsPanel::selectionChanged, stage, hold);
    QObject::connect(maps->table()->selectionModel(), &QItemSelectionModel::currentChanged, stage, hold);
    QObject::connect(stage->views(), &view::FourViews::fourShown, maps, hold); // includes the new views
    QObject::connect(stage->space(), &view::SpaceView::mapHeld, maps, [maps, stage](std::size_t index) {
        const std::vector<ifs::MapId> selected = stage->space()->selectedIds();
        if (maps->selectedMaps() != selected) maps->selectMaps(selected);
        const QModelIndex current = maps->table()->currentIndex();
        if (current.isValid() && current.row() != int(index)) // keeps the held map in the form
            maps->table()->selectionModel()->setCurrentIndex(current.siblingAtRow(int(index)),
                                                             QItemSelectionModel::NoUpdate);
    });
    hold();
}

} // namespace

void connectMaps(view::MapsPanel* maps, view::CanvasView* canvas, Stage* stage,
                 const document::Document& document, WindowMessages* messages) {
    QObject::connect(maps, &view::MapsPanel::selectionChanged, canvas,
                     [canvas, maps] { canvas->selectMaps(maps->selectedMaps()); });
    QObject::connect(canvas, &view::CanvasView::selectedMapsChanged, maps, [canvas, maps, &document] {
        const bool isPlane = document::plane(document.fractal()) != nullptr; // true: shows no maps in space
        if (isPlane && maps->selectedMaps() != canvas->selectedMaps())
            maps->selectMaps(canvas->selectedMaps());
    });
    canvas->selectMaps(maps->selectedMaps());
    connectSpace(maps, stage, document);
    const auto showAlone = [window = stage->window()](ifs::MapId map) {
        for (auto* solo : window->findChildren<view::SoloSwitch*>())
            solo->set(map);
    };
    QObject::connect(maps, &view::MapsPanel::soloChanged, stage, showAlone);
    QObject::connect(stage->views(), &view::FourViews::fourShown, maps,
                     [maps, showAlone] { showAlone(maps->model()->solo()); });
    QObject::connect(maps, &view::MapsPanel::mapPointed, canvas, &view::CanvasView::pointAt);
    QObject::connect(maps, &view::MapsPanel::symmetryChosen, stage, &Stage::keepFitted);
    QObject::connect(maps, &view::MapsPanel::message, messages, &WindowMessages::say);
}
