// SPDX-License-Identifier: MIT
#pragma once

#include "actions/action_menu.h"
#include "dialogs/variations/mutate_dialog.h"

#include <map>

class SnapshotCommands;

class EditMenu : public ActionMenu {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    EditMenu(const MenuContext& context, SnapshotCommands& snapshots);

    void addRandom(); // a fractal that the user picks out of many

private:
    void addHistory();
    void addClipboard();
    void addFractals();
    void addShadow();
    void addDimensions();
    void openTransform();
    void openMutate();
    void showPreferences();

    std::map<document::EntryId, view::MutateDialog::Descent> m_descents; // left without using them
};
