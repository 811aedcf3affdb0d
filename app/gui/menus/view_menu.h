// SPDX-License-Identifier: MIT
#pragma once

#include "actions/action_menu.h"

class SavedViewsMenu;

class ViewMenu : public ActionMenu {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    explicit ViewMenu(const MenuContext& context);

    QAction* numbers() const { return m_numbers; } // toggle of the map numbers on the canvas
    QMenu* panels() const { return m_panels; }     // filled by the window
    SavedViewsMenu* savedViews() const { return m_savedViews; }
    QAction* fullScreen() const { return m_fullScreen; }

private:
    void addZoom();
    void openGoTo();
    void addRotation(ActionMenu& menu);
    void addCamera(ActionMenu& navigation);
    void addPerspective(ActionMenu& menu);
    void addStereo(ActionMenu& menu);
    void addOverlays();
    void addSnapping(ActionMenu& canvas);
    void addCompare();

    SavedViewsMenu* m_savedViews = nullptr;
    QAction* m_numbers = nullptr;
    QMenu* m_panels = nullptr;
    QAction* m_fullScreen = nullptr;
};
