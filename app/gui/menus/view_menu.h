// SPDX-License-Identifier: MIT
#pragma once

#include "actions/action_menu.h"

class SavedViewsMenu;
namespace view {
class Construction;
}

class ViewMenu : public ActionMenu {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    // `present` starts and ends the presentation.
    ViewMenu(const MenuContext& context, const std::function<void(bool)>& present);

    QAction* numbers() const { return m_numbers; } // of maps, on the canvas
    QMenu* panels() const { return m_panels; }     // filled by the window
    SavedViewsMenu* savedViews() const { return m_savedViews; }
    QAction* fullScreen() const { return m_fullScreen; }
    QAction* presentation() const { return m_presentation; }
    void showTransformation() { m_transformation->setChecked(true); } // where the entry allows it
    // Both draw on the canvas of the plane: a transformation and a construction end each other.
    void alternateWith(view::Construction* construction);

private:
    void addZoom();
    void openGoTo();
    void addRotation();
    void addCamera();
    void addPerspective(ActionMenu& menu);
    void addStereo(ActionMenu& menu);
    void addOverlays();
    void addSnapping();
    void addTransformation();
    void addCompare();
    void addScreens(const std::function<void(bool)>& present);

    SavedViewsMenu* m_savedViews = nullptr;
    QAction* m_numbers = nullptr;
    QMenu* m_panels = nullptr;
    QAction* m_fullScreen = nullptr;
    QAction* m_presentation = nullptr;
    QAction* m_transformation = nullptr;
};
