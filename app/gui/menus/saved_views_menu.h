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

    void serve(view::ZoomBox* zoom); // lists the views in the zoom box, too

private:
    void refresh();
    void goTo(const QString& name);
    void save();
    void openDialog();

    std::vector<document::SavedView> m_views; // views in the menu
    QList<QAction*> m_actions;                // one action for each view
    QAction* m_end;                           // placeholder behind the views
    view::ZoomBox* m_zoom = nullptr;
};
