// SPDX-License-Identifier: MIT
#pragma once

#include "action_menu.h"

class EditMenu : public ActionMenu {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    explicit EditMenu(const MenuContext& context);

    void addRandom(); // a fractal that the user picks out of many

private:
    void addHistory();
    void addClipboard();
    void addFractals();
    void addDimensions();
    void openTransform();
    void openMutate();
    void showPreferences();
};
