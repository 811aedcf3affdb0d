// SPDX-License-Identifier: MIT
#pragma once

#include "bridges/export_queue.h"

#include <QList>
#include <QWidget>

class QAction;
class QLabel;
class QListView;

namespace view {

class ExportsModel;

// The queue of exports: the progress of each, and the commands for them.
class ExportsPanel : public QWidget {
    Q_OBJECT

public:
    explicit ExportsPanel(ExportQueue* queue, QWidget* parent = nullptr);

    QListView* list() const { return m_list; }

private:
    QAction* addAction(const QString& icon, const QString& text, const QString& tip);
    void createActions();
    QStringList selectedIds() const;
    QList<QueuedExport::State> selectedStates() const;
    void moveSelected(int by);
    void openFolder();
    void updateActions();
    void keepSelection(); // keeps the selection during a change of the list

    ExportQueue* m_queue;
    ExportsModel* m_model;
    QListView* m_list;
    QLabel* m_empty;
    QList<QAction*> m_actions;
    QAction* m_pause = nullptr;
    QAction* m_up = nullptr;
    QAction* m_down = nullptr;
    QAction* m_retry = nullptr;
    QAction* m_folder = nullptr;
    QAction* m_remove = nullptr;
    QAction* m_forget = nullptr;
    QStringList m_selected;
};

} // namespace view
