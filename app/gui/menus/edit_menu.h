// SPDX-License-Identifier: MIT
#pragma once

#include "actions/action_menu.h"

class SnapshotCommands;

class EditMenu : public ActionMenu {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    EditMenu(const MenuContext& context, SnapshotCommands& snapshots);

private:
    void addHistory();
    void addClipboard();
    void addFractal();
    void addShadow(ActionMenu& menu);
    void addDimensions(ActionMenu& menu);
    void openTransform();
    void showPreferences();
};
