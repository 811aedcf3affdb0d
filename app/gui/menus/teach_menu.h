// SPDX-License-Identifier: MIT
#pragma once

#include "actions/action_menu.h"

class OpenFile;

// Commands that explain a fractal to others: on the screen, step by step, and on paper.
class TeachMenu : public ActionMenu {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    // `present` starts and ends the presentation.
    TeachMenu(const MenuContext& context, const std::function<void(bool)>& present);

    void addHandout(const OpenFile* file); // the handout is named after the file
    QAction* presentation() const { return m_presentation; }

private:
    QAction* m_presentation = nullptr;
};
