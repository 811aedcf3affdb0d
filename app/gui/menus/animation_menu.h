// SPDX-License-Identifier: MIT
#pragma once

#include "actions/action_menu.h"

class QDockWidget;

namespace view {
class TimelinePanel;
}

// The commands of the timeline, for the whole window.
class AnimationMenu : public ActionMenu {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    AnimationMenu(const MenuContext& context, view::TimelinePanel* panel);

    void setDock(QDockWidget* dock); // dock of the timeline panel
    void showDock();

private:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void addPlaying();
    void addKeys();

    view::TimelinePanel* m_panel;
    QDockWidget* m_dock = nullptr;
    QAction* m_animate = nullptr;
};
