// SPDX-License-Identifier: MIT
#pragma once

#include "panels/snapshots/snapshot_look.h"

#include <QKeySequence>
#include <QListWidget>
#include <QWidget>

namespace view {

class Thumbnails;

// The snapshots of the entry in a strip, or in rows where the panel is high. A click restores one. The one
// that is selected is the one to compare with.
class SnapshotsPanel : public QWidget {
    Q_OBJECT

public:
    // `take` and `compare` are the commands of the window.
    SnapshotsPanel(Snapshots* snapshots, SnapshotLook* look, QAction* take, QAction* compare,
                   QWidget* parent = nullptr);

    QListWidget* list() const { return m_list; }

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void createList();
    void createActions();
    QAction* createAction(const QString& text, const QString& tip, const char* icon,
                          const QList<QKeySequence>& keys, const std::function<void(quint64)>& operation);
    void follow();
    void showTile(QListWidgetItem* item, const Snapshot& snapshot);
    void showContextMenu(const QPoint& position);
    void paintEmpty();
    quint64 currentKey() const; // 0 if no tile is current

    Snapshots* m_snapshots;
    SnapshotLook* m_look;
    QAction* m_take;
    QAction* m_compare;
    QListWidget* m_list;
    Thumbnails* m_thumbnails;
    QAction* m_restore = nullptr;
    QAction* m_rename = nullptr;
    QAction* m_add = nullptr;
    QAction* m_remove = nullptr;
    QAction* m_bringBack = nullptr;
    bool m_isFollowing = false; // true while the list follows the snapshots
};

} // namespace view
