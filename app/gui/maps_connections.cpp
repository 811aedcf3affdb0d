// SPDX-License-Identifier: MIT
#include "maps_connections.h"

#include "bridges/solo_switch.h"
#include "canvas/canvas_view.h"
#include "panels/maps/maps_model.h"
#include "panels/maps/maps_panel.h"
#include "space/four_views.h"
#include "stage.h"
#include "window_messages.h"

void connectMaps(view::MapsPanel* maps, view::CanvasView* canvas, Stage* stage,
                 const document::Document& document, WindowMessages* messages) {
    QObject::connect(maps, &view::MapsPanel::selectionChanged, canvas,
                     [canvas, maps] { canvas->selectMaps(maps->selectedMaps()); });
    QObject::connect(canvas, &view::CanvasView::selectedMapsChanged, maps, [canvas, maps, &document] {
        const bool isPlane = document::plane(document.fractal()) != nullptr; // it shows no maps of space
        if (isPlane && maps->selectedMaps() != canvas->selectedMaps())
            maps->selectMaps(canvas->selectedMaps());
    });
    canvas->selectMaps(maps->selectedMaps());
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
