// SPDX-License-Identifier: MIT
#pragma once

#include "actions/action_menu.h"

class HelpMenu : public ActionMenu {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    explicit HelpMenu(const MenuContext& context);

private:
    void openPalette();
    void showShortcuts();
    void showAbout();
};
