// SPDX-License-Identifier: MIT
#include "panels/exports/exports_panel.h"

#include "desktop/show_in_folder.h"
#include "panels/exports/exports_delegate.h"
#include "panels/exports/exports_model.h"
#include "widgets/flat_buttons.h"
#include "widgets/focus_shortcuts.h"
#include "widgets/icon.h"

#include <QAction>
#include <QLabel>
#include <QListView>
#include <QVBoxLayout>

#include <algorithm>

namespace view {

namespace {

using State = QueuedExport::State;

} // namespace

ExportsPanel::ExportsPanel(ExportQueue* queue, QWidget* parent)
    : QWidget(parent),
      m_queue(queue),
      m_model(new ExportsModel(queue, this)),
      m_list(new QListView(this)),
      m_empty(new QLabel(this)) {
    setAccessibleName(tr("Exports"));
    m_list->setModel(m_model);
    m_list->setItemDelegate(new ExportsDelegate(m_list));
    m_list->setResizeMode(QListView::Adjust); // failures are wrapped
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setContextMenuPolicy(Qt::ActionsContextMenu);
    m_list->setAccessibleName(tr("Queue of exports"));
    m_list->setStatusTip(tr("The exports, drawn from top to bottom."));
    m_list->setWhatsThis(
        tr("The exports that you have added to the queue. They are drawn one after another, from top to "
           "bottom, while you continue editing. Exports that are not finished when "
           "you quit continue the next time you start Barycage."));
    m_empty->setText(
        tr("No exports are waiting. Choose Add to Queue in File › Export › Export Picture… to draw "
           "pictures one after another while you continue editing."));
    m_empty->setWordWrap(true);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setMargin(16);
    createActions();
    new FocusShortcuts(m_list);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(buttonBar(m_actions, m_remove, this));
    layout->addWidget(m_list, 1);
    layout->addWidget(m_empty, 1);
    // Records every change of the selection: a reset does not announce it, and replaces the rows first.
    connect(m_list->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            [this] { m_selected = selectedIds(); });
    connect(m_model, &QAbstractItemModel::modelReset, this, &ExportsPanel::keepSelection);
    connect(m_model, &QAbstractItemModel::dataChanged, this, &ExportsPanel::updateActions);
    connect(m_list->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &ExportsPanel::updateActions);
    connect(m_list, &QListView::activated, this, &ExportsPanel::openFolder);
    connect(queue, &ExportQueue::pausedChanged, this, &ExportsPanel::updateActions);
    updateActions();
}

QAction* ExportsPanel::addAction(const QString& iconName, const QString& text, const QString& tip) {
    auto* action = new QAction(icon(iconName), text, m_list);
    action->setStatusTip(tip);
    action->setToolTip(tip);
    action->setShortcutContext(Qt::WidgetShortcut);
    m_list->addAction(action);
    m_actions << action;
    return action;
}

void ExportsPanel::createActions() {
    m_pause = addAction(QStringLiteral("pause"), tr("&Pause"),
                        tr("Pause or resume all exports without losing progress."));
    m_pause->setObjectName(QStringLiteral("pause"));
    connect(m_pause, &QAction::triggered, this, [this] { m_queue->setPaused(!m_queue->isPaused()); });
    m_up = addAction(QStringLiteral("up"), tr("Move &Up"), tr("Draw the selected export earlier."));
    m_up->setObjectName(QStringLiteral("up"));
    m_up->setShortcut(QKeySequence(Qt::ALT | Qt::Key_Up));
    connect(m_up, &QAction::triggered, this, [this] { moveSelected(-1); });
    m_down = addAction(QStringLiteral("down"), tr("Move &Down"), tr("Draw the selected export later."));
    m_down->setObjectName(QStringLiteral("down"));
    m_down->setShortcut(QKeySequence(Qt::ALT | Qt::Key_Down));
    connect(m_down, &QAction::triggered, this, [this] { moveSelected(1); });
    m_retry = addAction(QStringLiteral("restart"), tr("&Try Again"),
                        tr("Try again to draw the selected exports that failed."));
    connect(m_retry, &QAction::triggered, this, [this] {
        for (const QString& id : selectedIds())
            m_queue->retry(id);
    });
    m_folder = addAction(QStringLiteral("open"), tr("Show in Folder"),
                         tr("Show the folder of the selected export in the file manager."));
    connect(m_folder, &QAction::triggered, this, &ExportsPanel::openFolder);
    m_remove = addAction(
        QStringLiteral("remove"), tr("&Cancel Export"),
        tr("Cancel the selected exports and remove them from the list; files already written are kept."));
    m_remove->setObjectName(QStringLiteral("cancel"));
    m_remove->setShortcut(QKeySequence::Delete);
    connect(m_remove, &QAction::triggered, this, [this] {
        for (const QString& id : selectedIds())
            m_queue->cancel(id);
    });
    m_forget = addAction(QStringLiteral("close"), tr("Clear &Finished"),
                         tr("Remove all finished exports from the list; their files are kept."));
    m_forget->setObjectName(QStringLiteral("clear-finished"));
    connect(m_forget, &QAction::triggered, m_queue, &ExportQueue::forgetDone);
}

QStringList ExportsPanel::selectedIds() const {
    QStringList ids;
    for (const QModelIndex& index : m_list->selectionModel()->selectedRows())
        ids << index.data(ExportsModel::IdRole).toString();
    return ids;
}

QList<State> ExportsPanel::selectedStates() const {
    QList<State> states;
    for (const QModelIndex& index : m_list->selectionModel()->selectedRows())
        states << State(index.data(ExportsModel::StateRole).toInt());
    return states;
}

void ExportsPanel::moveSelected(int by) {
    const QStringList ids = selectedIds();
    if (ids.size() == 1) m_queue->move(ids.first(), by);
}

void ExportsPanel::openFolder() {
    const QString path = m_list->currentIndex().data(ExportsModel::PathRole).toString();
    showInFolder(path);
}

void ExportsPanel::keepSelection() {
    const QStringList wanted = m_selected;
    for (int row = 0; row < m_model->rowCount(); ++row) {
        const QModelIndex index = m_model->index(row);
        if (!wanted.contains(index.data(ExportsModel::IdRole).toString())) continue;
        m_list->selectionModel()->select(index, QItemSelectionModel::Select);
        m_list->selectionModel()->setCurrentIndex(index, QItemSelectionModel::NoUpdate);
    }
    updateActions();
}

void ExportsPanel::updateActions() {
    const int count = m_model->rowCount();
    m_list->setVisible(count > 0);
    m_empty->setVisible(count == 0);
    const QList<State> states = selectedStates();
    const QModelIndexList rows = m_list->selectionModel()->selectedRows();
    const int row = rows.size() == 1 ? rows.first().row() : -1;
    m_pause->setText(m_queue->isPaused() ? tr("&Resume") : tr("&Pause"));
    m_pause->setIcon(icon(m_queue->isPaused() ? QStringLiteral("play") : QStringLiteral("pause")));
    m_up->setEnabled(row > 0);
    m_down->setEnabled(row >= 0 && row + 1 < count);
    m_retry->setEnabled(states.contains(State::Failed));
    m_folder->setEnabled(row >= 0);
    m_remove->setEnabled(!states.isEmpty());
    const auto& all = m_queue->exports();
    m_forget->setEnabled(std::ranges::find(all, State::Done, &QueuedExport::state) != all.end());
}

} // namespace view
