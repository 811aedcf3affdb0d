// SPDX-License-Identifier: MIT
#pragma once

#include "action_menu.h"
#include "dialogs/mutate_dialog.h"

class SnapshotCommands;

class EditMenu : public ActionMenu {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    EditMenu(const MenuContext& context, SnapshotCommands& snapshots);

    void addRandom(); // a fractal that the user picks out of many

private:
    void addHistory();
    void addFractals();
    void addDimensions();
    void openTransform();
    void openMutate(view::MutateDialog::Source source);
    void showPreferences();
};
