// SPDX-License-Identifier: MIT
#include "menus/maps_menu.h"

#include "canvas/scene/canvas_scene.h"
#include "document/edits/cage/cage_edits.h"
#include "document/edits/maps/map_locks.h"
#include "document/edits/maps/maps_edits.h"
#include "panels/maps/maps_panel.h"

using Arrangement = document::MapsArrangement;

MapsMenu::MapsMenu(const MenuContext& context) : ActionMenu(context, tr("&Maps")) {
    auto* selected = new ActionMenu(context, tr("&Selected Maps"));
    addList(*selected);
    addLayers();
    addMenu(selected);
    selected->addSeparator();
    addArrangement(selected, Arrangement::FlipLeftRight, "flip-left-right", tr("Flip &Horizontally"),
                   tr("Mirror the selected maps about the vertical line through their centre"));
    addArrangement(selected, Arrangement::FlipUpDown, "flip-up-down", tr("Flip &Vertically"),
                   tr("Mirror the selected maps about the horizontal line through their centre"));
    addArrangement(selected, Arrangement::RotateLeft, "rotate-left", tr("Rotate 90° &Left"),
                   tr("Rotate the selected maps counter-clockwise about their centre"));
    addArrangement(selected, Arrangement::RotateRight, "rotate-right", tr("Rotate 90° &Right"),
                   tr("Rotate the selected maps clockwise about their centre"));
    selected->addSeparator();
    auto* align = new ActionMenu(context, tr("Ali&gn Centres"));
    selected->addMenu(align);
    addArrangement(align, Arrangement::AlignInRow, "align-in-row", tr("In a &Row"),
                   tr("Move the selected maps up or down until their centres are at the same height"));
    addArrangement(align, Arrangement::AlignInColumn, "align-in-column", tr("In a &Column"),
                   tr("Move the selected maps left or right until their centres are one below the other"));
    auto* distribute = new ActionMenu(context, tr("D&istribute Centres"));
    selected->addMenu(distribute);
    addArrangement(distribute, Arrangement::DistributeAcross, "distribute-across", tr("&Horizontally"),
                   tr("Space the centres of the selected maps evenly from left to right"));
    addArrangement(distribute, Arrangement::DistributeUpwards, "distribute-upwards", tr("&Vertically"),
                   tr("Space the centres of the selected maps evenly from bottom to top"));
    addArrangement(selected, Arrangement::FitToCorners, "fit-to-corners", tr("&Fit to Corners"),
                   tr("Move each selected map so that it leaves the nearest corner of the cage fixed"));
}

void MapsMenu::addList(ActionMenu& ofSelected) {
    view::CanvasView* canvas = context().canvas;
    document::Document* document = context().document;
    const auto panel = [window = context().window] { return window->findChild<view::MapsPanel*>(); };
    // Commands in space use the maps that are selected in their panel.
    const auto withSelected = [this, canvas, document, panel](void (view::MapsPanel::*inSpace)(),
                                                              const auto& edit) {
        return [this, canvas, document, panel, inSpace, edit] {
            if (document::space(document->fractal())) {
                if (!panel()->selectedMaps().empty()) return (panel()->*inSpace)();
                return context().messages->say(tr("Select a map first."));
            }
            const std::vector<std::size_t> indices = canvas->canvas().selection().mapIndices();
            if (indices.empty())
                context().messages->say(tr("Select a map first."));
            else
                canvas->selectMaps(edit(document::Rows(indices.begin(), indices.end())));
        };
    };
    QAction* duplicate =
        ofSelected.add({"duplicate-maps",
                        tr("&Duplicate Maps"),
                        {},
                        tr("Duplicate the selected maps"),
                        nullptr,
                        false,
                        "duplicate"},
                       withSelected(&view::MapsPanel::duplicateMaps, [document](const document::Rows& rows) {
                           return duplicateMaps(*document, rows);
                       }));
    QAction* remove = ofSelected.add(
        {"delete-maps", tr("D&elete Maps"), {}, tr("Delete the selected maps"), nullptr, false, "remove"},
        withSelected(&view::MapsPanel::deleteMaps,
                     [document, messages = context().messages](const document::Rows& rows) {
                         const QString locked = document::lockObstacle(document->fractal(), rows);
                         if (locked.isEmpty()) return deleteMaps(*document, rows);
                         messages->say(locked);
                         const document::System2& system = *document::system2(document->fractal());
                         std::vector<ifs::MapId> selected;
                         for (const int row : rows)
                             selected.push_back(system.maps[std::size_t(row)].id);
                         return selected;
                     }));
    QAction* all = add({"select-all-maps", tr("Select &All Maps"), {}, tr("Select all maps")},
                       [canvas, document, panel] {
                           if (document::space(document->fractal())) return panel()->selectAllMaps();
                           std::vector<ifs::MapId> maps;
                           if (const document::System2* system = document::system2(document->fractal()))
                               for (const auto& map : system->maps)
                                   maps.push_back(map.id);
                           canvas->selectMaps(maps);
                       });
    for (QAction* action : {duplicate, remove, all})
        disableWhen(action, &document::cageObstacle);
}

// Adds commands for plane and space, which use the maps that are selected in their panel.
void MapsMenu::addLayers() {
    const auto panel = [window = context().window] { return window->findChild<view::MapsPanel*>(); };
    add({"edit", tr("Re&name Map"), {}, tr("Give the current map a name")},
        [panel] { panel()->renameMap(); });
    add({"lock",
         tr("Loc&k or Unlock Maps"),
         {},
         tr("Lock the selected maps against editing, or unlock them")},
        [panel] { panel()->toggleLock(); });
    add({"solo", tr("Show Map Al&one"), {}, tr("Show the current map alone, or all of them again")},
        [panel] { panel()->toggleSolo(); });
}

void MapsMenu::addArrangement(ActionMenu* menu, Arrangement arrangement, const char* id, const QString& text,
                              const QString& tip) {
    QAction* action = menu->add({id, text, {}, tip}, [this, arrangement] {
        const auto failure = document::arrangeMaps(
            *context().document, context().canvas->canvas().selection().mapIndices(), arrangement);
        if (failure) context().messages->say(*failure);
    });
    disableWhen(action, &document::planeObstacle);
}
