// SPDX-License-Identifier: MIT
#pragma once

#include "panels/snapshots/snapshot_look.h"

#include <QObject>

class ActionMenu;
class QAction;
class QDockWidget;
struct MenuContext;
namespace view {
class SnapshotsPanel;
}

// Snapshots in a window: the commands, the panel, and the message over the canvas during a look.
class SnapshotCommands : public QObject {
    Q_OBJECT

public:
    SnapshotCommands(const MenuContext& context, view::RenderBridge* render);

    void addTo(ActionMenu& menu);
    view::SnapshotsPanel* makePanel(); // called once; needs the commands in a menu
    void setDock(QDockWidget* dock);   // dock of the panel, shown with the first snapshot
    view::Snapshots* snapshots() { return &m_snapshots; }
    view::SnapshotLook* look() { return &m_look; }

private:
    view::Snapshots m_snapshots;
    view::SnapshotLook m_look;
    QAction* m_take = nullptr;
    QAction* m_compare = nullptr;
};
