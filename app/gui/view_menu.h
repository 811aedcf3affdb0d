// SPDX-License-Identifier: MIT
#pragma once

#include "action_menu.h"

class ViewMenu : public ActionMenu {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    // `present` starts and ends the presentation.
    ViewMenu(const MenuContext& context, const std::function<void(bool)>& present);

    QMenu* panels() const { return m_panels; } // filled by the window
    QAction* fullScreen() const { return m_fullScreen; }
    QAction* presentation() const { return m_presentation; }
    void showTransformation() { m_transformation->setChecked(true); } // where the entry allows it

private:
    void addZoom();
    void addCamera();
    void addStereo(ActionMenu& menu);
    void addOverlays();
    void addSnapping();
    void addTransformation();
    void addCompare();
    void addScreens(const std::function<void(bool)>& present);

    QMenu* m_panels = nullptr;
    QAction* m_fullScreen = nullptr;
    QAction* m_presentation = nullptr;
    QAction* m_transformation = nullptr;
};
