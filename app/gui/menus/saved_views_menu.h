// SPDX-License-Identifier: MIT
#pragma once

#include "actions/action_menu.h"
#include "document/saved_views.h"

namespace view {
class ZoomBox;
}

// The views of the entry that have names: go to one, save another, change them. They are kept with the entry.
class SavedViewsMenu : public ActionMenu {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    explicit SavedViewsMenu(const MenuContext& context);

    void serve(view::ZoomBox* zoom); // it lists them, too

private:
    void refresh();
    void goTo(const QString& name);
    void save();
    void openDialog();

    std::vector<document::SavedView> m_views; // listed
    QList<QAction*> m_actions;                // of the views
    QAction* m_end;                           // of their list
    view::ZoomBox* m_zoom = nullptr;
};
