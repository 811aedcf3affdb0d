// SPDX-License-Identifier: MIT
#pragma once

#include "action_menu.h"

// Copies the entry in hand for a paper or a task sheet.
class LatexMenu : public ActionMenu {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    explicit LatexMenu(const MenuContext& context);

private:
    void copy(const QByteArray& text);
};
