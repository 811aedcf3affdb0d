// SPDX-License-Identifier: MIT
#pragma once

#include "actions/action_menu.h"

#include <optional>

class QActionGroup;

// The tools of the canvas, the operations on the cage, and what moving it does.
class CageMenu : public ActionMenu {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    explicit CageMenu(const MenuContext& context);

private:
    using Tool = view::CanvasView::Tool;
    // Returns why nothing was done, if so.
    using Operation = std::optional<QString> (*)(document::Document&);

    void addTools();
    void addOperations();
    void addMore(); // adds rarely needed commands
    void addModes(ActionMenu& menu);
    QAction* addTool(QActionGroup* group, Tool tool, const ActionSpec& spec);
    QAction* addOperation(ActionMenu& menu, Operation operation, const ActionSpec& spec);
    void showInvariantForm();
};
