// SPDX-License-Identifier: MIT
#include "panels/problems/problems_panel.h"

#include "panels/problems/problems_model.h"
#include "widgets/focus_shortcuts.h"
#include "widgets/icon.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>
#include <numeric>

namespace view {

ProblemsPanel::ProblemsPanel(document::Document* document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_model(new ProblemsModel(document, this)),
      m_list(new QTreeView(this)),
      m_summary(new QLabel(this)),
      m_fileName(tr("file")) {
    setAccessibleName(tr("Problems found while reading"));
    m_list->setModel(m_model);
    m_list->setAccessibleName(tr("Problems"));
    m_list->setWhatsThis(tr("The problems found while reading the file, with line and column. Double-click a "
                            "line to go to its entry."));
    m_list->setStatusTip(tr("Select a line to show its entry."));
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setAllColumnsShowFocus(true);
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setContextMenuPolicy(Qt::ActionsContextMenu);
    m_list->header()->setSectionResizeMode(ProblemsModel::Place, QHeaderView::ResizeToContents);
    m_list->header()->setResizeContentsPrecision(200);
    m_summary->setWordWrap(true);
    m_summary->setAccessibleName(tr("Number of problems"));
    createActions();

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(m_summary);
    layout->addWidget(m_list, 1);

    connect(m_model, &QAbstractItemModel::modelReset, this, &ProblemsPanel::updateCount);
    connect(m_list, &QTreeView::clicked, this, &ProblemsPanel::showEntry);
    connect(m_list, &QTreeView::activated, this, &ProblemsPanel::showEntry);
    updateCount();
}

int ProblemsPanel::count() const {
    return m_model->rowCount();
}

void ProblemsPanel::setFileName(const QString& fileName) {
    m_fileName = fileName;
}

void ProblemsPanel::createActions() {
    auto* copy = new QAction(icon(QStringLiteral("copy")), tr("&Copy"), m_list);
    copy->setStatusTip(tr("Copy the selected problems as text."));
    copy->setShortcuts(QKeySequence::Copy);
    copy->setShortcutContext(Qt::WidgetShortcut);
    connect(copy, &QAction::triggered, this, &ProblemsPanel::copySelected);
    auto* selectAll = new QAction(tr("Select &All"), m_list);
    selectAll->setStatusTip(tr("Select all problems."));
    selectAll->setShortcuts(QKeySequence::SelectAll);
    selectAll->setShortcutContext(Qt::WidgetShortcut);
    connect(selectAll, &QAction::triggered, m_list, &QTreeView::selectAll);
    m_list->addActions({copy, selectAll});
    new FocusShortcuts(m_list);
}

void ProblemsPanel::copySelected() {
    QList<int> rows;
    for (const QModelIndex& index : m_list->selectionModel()->selectedRows())
        rows.append(index.row());
    std::sort(rows.begin(), rows.end());
    if (rows.isEmpty()) {
        rows.resize(count());
        std::iota(rows.begin(), rows.end(), 0);
    }
    QStringList lines;
    for (const int row : std::as_const(rows))
        lines.append(document::toText(m_model->problemAt(row), m_fileName));
    QGuiApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
}

void ProblemsPanel::showEntry(const QModelIndex& index) {
    const document::EntryId entry = m_model->entryAt(index.row());
    if (entry != document::EntryId::None) m_document->setCurrent(entry);
}

void ProblemsPanel::updateCount() {
    m_list->setVisible(count() > 0);
    constexpr int widestName = 24; // characters, which leave room for the problem
    m_list->resizeColumnToContents(ProblemsModel::EntryName);
    m_list->setColumnWidth(ProblemsModel::EntryName, std::min(m_list->columnWidth(ProblemsModel::EntryName),
                                                              widestName * fontMetrics().averageCharWidth()));
    const QString found = count() == 1 ? tr("1 problem was found while reading.")
                                       : tr("%n problems were found while reading.", nullptr, count());
    m_summary->setText(count() > 0
                           ? found + QLatin1Char(' ') + tr("Text that could not be read is kept unchanged.")
                           : tr("No problems: every entry was read."));
    m_summary->setAlignment(count() > 0 ? Qt::AlignLeft | Qt::AlignVCenter : Qt::AlignCenter);
    emit countChanged(m_model->attentionCount());
}

} // namespace view
