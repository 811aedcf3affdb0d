// SPDX-License-Identifier: MIT
#pragma once

#include "actions/action_menu.h"
#include "document/edits/maps/maps_arrange.h"

// Commands for the selected maps.
class MapsMenu : public ActionMenu {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    explicit MapsMenu(const MenuContext& context);

private:
    void addList(ActionMenu& ofSelected);
    void addLayers();
    void addArrangement(ActionMenu* menu, document::MapsArrangement arrangement, const char* id,
                        const QString& text, const QString& tip);
};
