// SPDX-License-Identifier: MIT
#include "panels/maps/maps_panel.h"

#include "document/edits/cage/cage_actions.h"
#include "document/edits/cage/cage_edits.h"
#include "document/edits/maps/map_locks.h"
#include "panels/maps/map_shape_editor.h"
#include "panels/maps/map_thumbnails.h"
#include "panels/maps/maps_clipboard.h"
#include "panels/maps/maps_columns.h"
#include "panels/maps/maps_delegate.h"
#include "panels/maps/maps_row_header.h"
#include "panels/maps/maps_table.h"
#include "panels/maps/maps_texts.h"
#include "panels/maps/returned_maps.h"
#include "panels/maps/solo_map.h"
#include "panels/maps/symmetry_row.h"
#include "panels/maps/weight_rule_name.h"
#include "panels/maps/weights_button.h"
#include "widgets/background/background_edit.h"
#include "widgets/focus_shortcuts.h"
#include "widgets/icon.h"
#include "widgets/layout/vertical_scroll_area.h"

#include <QAction>
#include <QColorDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QScrollBar>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <numeric>

namespace view {

MapsPanel::MapsPanel(document::Document* document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_weighing(new BackgroundEdit(document, this)),
      m_model(new MapsModel(document, this)),
      m_clipboard(new MapsClipboard(document, this)),
      m_solo(new SoloMap(document, this)),
      m_thumbnails(new MapThumbnails(document, this)),
      m_table(new MapsTable(this)),
      m_rowHeader(new MapsRowHeader(m_table)),
      m_shape(new MapShapeEditor(document, this)),
      m_pages(new QStackedWidget(this)) {
    setAccessibleName(tr("Maps"));
    makeActions();
    makeLayerActions();
    auto* content = new QWidget(this);
    auto* contentLayout = new QVBoxLayout(content);
    contentLayout->setContentsMargins(0, 0, 0, 0);
    contentLayout->setSpacing(6);
    contentLayout->addWidget(makeTable(), 1);
    m_facts = new QLabel(content);
    m_facts->setAccessibleName(tr("Properties of the map"));
    m_facts->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_facts->setForegroundRole(QPalette::PlaceholderText);
    m_facts->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto* symmetry = new SymmetryRow(document, content);
    connect(symmetry, &SymmetryRow::message, this, &MapsPanel::message);
    connect(symmetry, &SymmetryRow::groupChosen, this, &MapsPanel::symmetryChosen);
    auto* details = VerticalScrollArea::ofRows({symmetry, m_shape, m_facts}, content);
    details->setObjectName(QStringLiteral("details"));
    contentLayout->addWidget(details);
    m_pages->addWidget(content);
    m_pages->addWidget(makeNotice());

    m_bars = new QWidget(this);
    auto* bars = new QVBoxLayout(m_bars);
    bars->setContentsMargins(0, 0, 0, 0);
    bars->setSpacing(4);
    bars->addWidget(makeEditBar());
    bars->addWidget(makeColumnBar());

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->setSpacing(6);
    layout->addWidget(m_bars);
    layout->addWidget(m_pages, 1);

    connect(document, &document::Document::changed, this, &MapsPanel::follow);
    follow({document::Change::Everything, false});
    restoreSelection();
}

MapsPanel::~MapsPanel() {
    hide(); // ends the edit under way, while there is still a panel that follows it
}

QAction* MapsPanel::action(const QString& text, const QString& iconName, const QString& shortcut,
                           const QString& tip, void (MapsPanel::*slot)()) {
    auto* made = new QAction(icon(iconName), text, this);
    made->setObjectName(iconName);
    made->setStatusTip(tip);
    made->setToolTip(shortcut.isEmpty() ? tip : tr("%1 (%2)").arg(tip, shortcut));
    if (!shortcut.isEmpty()) made->setShortcut(QKeySequence(shortcut));
    made->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(made, &QAction::triggered, this, slot);
    m_table->addAction(made);
    return made;
}

void MapsPanel::makeActions() {
    m_add = action(tr("Add"), QStringLiteral("add"), QStringLiteral("Ctrl+Ins"),
                   tr("Add a map of half the size"), &MapsPanel::addMap);
    m_duplicate = action(tr("Duplicate"), QStringLiteral("duplicate"), QStringLiteral("Ins"),
                         tr("Duplicate the selected maps"), &MapsPanel::duplicateMaps);
    m_delete = action(tr("Delete"), QStringLiteral("remove"), QStringLiteral("Del"),
                      tr("Delete the selected maps"), &MapsPanel::deleteMaps);
    m_up = action(tr("Move Up"), QStringLiteral("up"), QStringLiteral("Alt+Up"),
                  tr("Move the selected maps up"), &MapsPanel::moveMapsUp);
    m_down = action(tr("Move Down"), QStringLiteral("down"), QStringLiteral("Alt+Down"),
                    tr("Move the selected maps down"), &MapsPanel::moveMapsDown);
    m_cut = action(tr("Cut"), QStringLiteral("cut"), QStringLiteral("Ctrl+X"),
                   tr("Move the selected maps to the clipboard"), &MapsPanel::cutMaps);
    m_copy = new QAction(icon(QStringLiteral("copy")), tr("Copy Rows"), this);
    m_copy->setShortcut(QKeySequence::Copy);
    m_copy->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(m_copy, &QAction::triggered, this, &MapsPanel::copyMaps);
    m_table->addAction(m_copy);
    m_append = action(tr("Paste as New Maps"), QStringLiteral("paste"), QStringLiteral("Ctrl+V"), {},
                      &MapsPanel::appendPasted);
    m_paste = action(tr("Paste in Place"), QStringLiteral("paste"), QStringLiteral("Ctrl+Shift+V"), {},
                     &MapsPanel::pasteMaps);
    m_bake = action(tr("Bake"), QStringLiteral("bake"), {},
                    tr("Replace the code by the effective code; the cage is then at rest"), &MapsPanel::bake);
}

void MapsPanel::makeLayerActions() {
    m_rename = action(tr("Rename"), QStringLiteral("edit"), QStringLiteral("Shift+F2"),
                      tr("Give the current map a name"), &MapsPanel::renameMap);
    m_lock = action(tr("Lock"), QStringLiteral("lock"), QStringLiteral("Ctrl+L"),
                    tr("Lock the selected maps against editing"), &MapsPanel::toggleLock);
    m_alone = action(tr("Solo"), QStringLiteral("solo"), QStringLiteral("Ctrl+Shift+L"),
                     tr("Show the current map alone; the file does not change"), &MapsPanel::toggleSolo);
    for (QAction* each : {m_lock, m_alone})
        each->setCheckable(true);
    connect(m_solo, &SoloMap::message, this, &MapsPanel::message);
    connect(m_solo, &SoloMap::changed, this, [this] {
        m_model->setSolo(m_solo->map());
        updateActions();
        emit soloChanged(m_solo->map());
    });
    connect(m_clipboard, &MapsClipboard::message, this, &MapsPanel::message);
    connect(m_clipboard, &MapsClipboard::pasted, this, &MapsPanel::selectMaps);
    connect(new ReturnedMaps(m_document, this), &ReturnedMaps::returned, this, &MapsPanel::selectMaps);
    connect(m_thumbnails, &MapThumbnails::ready, this, [this] { m_table->viewport()->update(); });
}

QTableView* MapsPanel::table() const {
    return m_table;
}

QToolButton* MapsPanel::button(QAction* action) {
    auto* made = new QToolButton(this);
    made->setDefaultAction(action);
    made->setAutoRaise(true);
    made->setAccessibleName(action->text());
    return made;
}

QWidget* MapsPanel::makeEditBar() {
    auto* bar = new QWidget(this);
    auto* layout = new QHBoxLayout(bar);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    for (QAction* each : {m_add, m_duplicate, m_delete, m_up, m_down, m_lock, m_alone}) {
        if (each == m_up || each == m_lock) layout->addSpacing(8);
        layout->addWidget(button(each));
    }
    layout->addStretch();
    layout->addWidget(
        makeWeightsButton([this](document::WeightRule rule) { applyWeights(rule); }, this, m_weightActions));
    return bar;
}

QToolButton* MapsPanel::columnToggle(const QString& text, const QString& tip, Columns group, bool shown) {
    auto* toggle = new QToolButton(this);
    toggle->setObjectName(QStringLiteral("columns"));
    toggle->setText(text);
    toggle->setToolTip(tip);
    toggle->setAccessibleName(tr("Show columns: %1").arg(text));
    toggle->setCheckable(true);
    toggle->setChecked(shown);
    connect(toggle, &QToolButton::toggled, this, [this, group](bool on) { showColumns(group, on); });
    m_columnToggles[group] = toggle;
    showColumns(group, shown);
    return toggle;
}

QWidget* MapsPanel::makeColumnBar() {
    auto* bar = new QWidget(this);
    auto* layout = new QHBoxLayout(bar);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(columnToggle(tr("Names"), tr("Show the names of the maps"), Columns::Names, false));
    layout->addWidget(columnToggle(tr("Code"), tr("Show the coefficients of the maps"), Columns::Code, true));
    layout->addWidget(columnToggle(tr("Properties"),
                                   tr("Show determinant, contraction factor and kind of each map"),
                                   Columns::Facts, false));
    layout->addWidget(columnToggle(tr("Effective"),
                                   tr("Show the maps as they act on the picture under the current cage"),
                                   Columns::Effective, false));
    layout->addStretch();
    layout->addWidget(button(m_bake));
    return bar;
}

QWidget* MapsPanel::makeTable() {
    m_table->setAccessibleName(tr("Table of maps"));
    m_rowHeader->setFont(m_table->font());
    m_table->setModel(m_model);
    auto* delegate = new MapsDelegate(m_model, this);
    delegate->setThumbnails(m_thumbnails);
    m_table->setItemDelegate(delegate);
    m_table->setVerticalHeader(m_rowHeader);
    m_columns = new MapsColumns(m_table, m_model);

    connect(delegate, &MapsDelegate::refused, this, &MapsPanel::message);
    connect(delegate, &MapsDelegate::colourRequested, this, &MapsPanel::chooseColour);
    connect(delegate, &MapsDelegate::soloRequested, this,
            [this](const QModelIndex& cell) { m_solo->toggle(m_model->idAt(cell.row())); });
    connect(m_table, &MapsTable::refused, this, &MapsPanel::message);
    connect(m_rowHeader, &MapsRowHeader::rowDragged, this, &MapsPanel::moveRowTo);
    const auto point = [this](int row) { emit mapPointed(m_model->idAt(row)); };
    connect(m_table, &MapsTable::rowPointed, this, point);
    connect(m_rowHeader, &MapsRowHeader::rowPointed, this, point);
    connect(m_model, &QAbstractItemModel::modelAboutToBeReset, this, &MapsPanel::keepSelection);
    connect(m_model, &QAbstractItemModel::modelReset, this, &MapsPanel::restoreSelection);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        m_selectedRows.reset();
        updateActions();
        showDetails();
        emit selectionChanged();
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this, &MapsPanel::showDetails);
    connect(m_table, &QWidget::customContextMenuRequested, this, &MapsPanel::showMenu);
    new FocusShortcuts(m_table);
    return m_table;
}

void MapsPanel::showMenu(const QPoint& position) {
    QMenu menu(this);
    menu.addActions({m_rename, m_lock, m_alone});
    menu.addSeparator();
    menu.addActions({m_add, m_duplicate, m_delete});
    menu.addSeparator();
    menu.addActions({m_up, m_down});
    menu.addSeparator();
    menu.addActions({m_cut, m_copy, m_append, m_paste});
    menu.addMenu(tr("Weights"))->addActions(m_weightActions);
    menu.addSeparator();
    menu.addAction(m_bake);
    menu.exec(m_table->viewport()->mapToGlobal(position));
}

QWidget* MapsPanel::makeNotice() {
    auto* page = new QWidget(this);
    m_notice = new QLabel(page);
    m_notice->setAlignment(Qt::AlignCenter);
    m_notice->setWordWrap(true);
    m_notice->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_noticeAdd = new QToolButton(page);
    m_noticeAdd->setDefaultAction(m_add);
    m_noticeAdd->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    auto* layout = new QVBoxLayout(page);
    layout->addStretch();
    layout->addWidget(m_notice);
    layout->addWidget(m_noticeAdd, 0, Qt::AlignHCenter);
    layout->addStretch();
    return page;
}

std::pair<int, int> MapsPanel::columnsOf(Columns group) const {
    switch (group) {
    case Columns::Names:
        return {MapsModel::Name, MapsModel::Name};
    case Columns::Code:
        return {MapsModel::A, m_model->columnOf(MapsModel::Weight) - 1};
    case Columns::Facts:
        return {m_model->columnOf(MapsModel::Determinant), m_model->columnOf(MapsModel::Kind)};
    case Columns::Effective:
        break;
    }
    return {m_model->columnOf(MapsModel::EffectiveA), m_model->columnCount() - 1};
}

void MapsPanel::hideColumns(Columns group, bool hidden) {
    const auto [first, last] = columnsOf(group);
    for (int column = first; column <= last; ++column)
        m_table->setColumnHidden(column, hidden);
}

void MapsPanel::showColumns(Columns group, bool shown) {
    m_columnToggles[group]->setChecked(shown);
    hideColumns(group, !shown);
    const auto [first, last] = columnsOf(group);
    // Scrolls to the shown columns, above all to the first of them.
    if (shown && m_table->isVisible()) {
        m_table->doItemsLayout(); // updates the scroll range
        const int row = std::max(0, m_table->currentIndex().row());
        m_table->scrollTo(m_model->index(row, last));
        m_table->scrollTo(m_model->index(row, first));
    }
    m_columns->fit();
}

void MapsPanel::reveal(int column) {
    for (const auto& [group, toggle] : m_columnToggles)
        if (const auto [first, last] = columnsOf(group); column >= first && column <= last)
            toggle->setChecked(true);
    m_table->doItemsLayout();
    m_table->scrollTo(m_model->index(std::max(0, m_table->currentIndex().row()), column));
}

void MapsPanel::follow(const document::Change& change) {
    using document::Change;
    if (change.parts & (Change::Current | Change::File | Change::Entries | Change::System)) updateNotice();
    if (change.parts & (Change::System | Change::Cage | Change::Current | Change::File | Change::Name))
        updateActions();
    followNames(change);
    if (!change.live) m_columns->fit();
    showDetails();
}

// Names are shown where there are any.
void MapsPanel::followNames(const document::Change& change) {
    using document::Change;
    if (change.live || !(change.parts & (Change::Current | Change::File | Change::Name))) return;
    QToolButton* toggle = m_columnToggles[Columns::Names];
    if (m_model->hasNames())
        toggle->setChecked(true);
    else if (change.parts & (Change::Current | Change::File))
        toggle->setChecked(false);
}

// Shows details of the current map if it is selected.
void MapsPanel::showDetails() {
    const document::Rows rows = selectedRows();
    const int current = m_table->currentIndex().row();
    const int shown = rows.empty() ? -1 : std::ranges::binary_search(rows, current) ? current : rows.front();
    m_shape->setMap(m_model->idAt(shown));
    const auto fact = [&](MapsModel::Column column, int role = Qt::DisplayRole) {
        return m_model->index(shown, m_model->columnOf(column)).data(role).toString();
    };
    const std::array facts{fact(MapsModel::Determinant), fact(MapsModel::Contraction), fact(MapsModel::Kind)};
    m_facts->setText(m_model->rowCount() > 0 ? factsText(facts, shown, int(rows.size())) : QString());
    m_facts->setToolTip(fact(MapsModel::Kind, Qt::ToolTipRole));
}

void MapsPanel::updateNotice() {
    const document::Entry& entry = m_document->currentEntry();
    const int dimension = document::dimension(*entry.fractal);
    const bool noMaps = dimension != 0 && m_model->rowCount() == 0;
    m_noticeAdd->setVisible(noMaps);
    m_bars->setVisible(dimension != 0);
    m_pages->setCurrentIndex(dimension != 0 && !noMaps ? 0 : 1);
    if (noMaps) {
        m_notice->setText(dimension == 2 ? tr("No maps: add one, or paste rows of 6 or 7 numbers.")
                                         : tr("No maps: add one."));
    } else if (dimension == 0) {
        QStringList lines{tr("This entry could not be read. It is kept unchanged.")};
        for (const auto& problem : entry.problems)
            lines << (problem.line > 0 ? tr("Line %1, column %2: %3")
                                             .arg(problem.line)
                                             .arg(problem.column)
                                             .arg(problem.message)
                                       : problem.message);
        m_notice->setText(lines.join(QStringLiteral("\n\n")));
    }
}

void MapsPanel::updateActions() {
    const int dimension = document::dimension(m_document->fractal());
    const document::Rows rows = selectedRows();
    const int count = m_model->rowCount();
    m_add->setEnabled(dimension != 0);
    m_append->setEnabled(dimension != 0);
    m_paste->setEnabled(dimension != 0);
    for (QAction* each : {m_duplicate, m_delete, m_cut, m_copy, m_lock})
        each->setEnabled(!rows.empty());
    m_rename->setEnabled(count > 0);
    m_alone->setEnabled(count > 0);
    m_alone->setChecked(m_solo->map() != ifs::MapId::None);
    const document::MapLabels& labels = m_document->fractal().mapLabels;
    m_lock->setChecked(!rows.empty() && std::ranges::all_of(rows, [&](int row) {
        return labels.of(m_model->idAt(row)).isLocked;
    }));
    const auto size = static_cast<int>(rows.size());
    m_up->setEnabled(size > 0 && rows.back() >= size); // not yet a block at the top
    m_down->setEnabled(size > 0 && rows.front() < count - size);
    for (QAction* each : std::as_const(m_weightActions))
        each->setEnabled(count > 0);
    const QString obstacle = bakeObstacle(*m_document);
    m_bake->setEnabled(obstacle.isEmpty());
    m_bake->setToolTip(obstacle.isEmpty() ? m_bake->statusTip() : obstacle);
}

document::Rows MapsPanel::selectedRows() const {
    if (!m_selectedRows) m_selectedRows = rowsIn(m_table->selectionModel()->selection());
    return *m_selectedRows;
}

std::vector<ifs::MapId> MapsPanel::selectedMaps() const {
    std::vector<ifs::MapId> ids;
    for (const int row : selectedRows())
        ids.push_back(m_model->idAt(row));
    return ids;
}

void MapsPanel::selectMaps(const std::vector<ifs::MapId>& ids) {
    selectRows(m_model->rowsOf(ids));
}

void MapsPanel::selectRows(document::Rows rows) {
    const QModelIndex first = rows.empty() ? QModelIndex() : m_model->index(rows.front(), m_keptColumn);
    const QItemSelection selection = m_table->selectionOf(std::move(rows));
    auto* model = m_table->selectionModel();
    if (first.isValid()) model->setCurrentIndex(first, QItemSelectionModel::NoUpdate);
    model->select(selection, QItemSelectionModel::ClearAndSelect);
    if (!first.isValid()) return;
    const int sideways = m_table->horizontalScrollBar()->value();
    m_table->scrollTo(first);
    m_table->horizontalScrollBar()->setValue(sideways);
}

void MapsPanel::keepSelection() {
    m_kept = selectedMaps();
    const QModelIndex current = m_table->currentIndex();
    m_keptColumn = current.isValid() ? current.column() : int(MapsModel::A);
}

void MapsPanel::restoreSelection() {
    m_selectedRows.reset();
    m_shape->setMap(ifs::MapId::None);
    followDimension();
    document::Rows rows = m_model->rowsOf(m_kept);
    if (rows.empty() && m_model->rowCount() > 0) rows = {0};
    selectRows(std::move(rows));
    updateActions();
}

// The table has other columns in space than in the plane.
void MapsPanel::followDimension() {
    if (m_dimension == m_model->dimension()) return;
    m_dimension = m_model->dimension();
    m_keptColumn = MapsModel::A;
    for (int column = 0; column < m_model->columnCount(); ++column)
        m_table->setColumnHidden(column, false);
    for (const auto& [group, toggle] : m_columnToggles)
        hideColumns(group, !toggle->isChecked());
    m_columns->fit();
    m_table->horizontalScrollBar()->setValue(0);
    const bool plane = m_dimension == 2;
    m_copy->setStatusTip(
        plane ? tr("Copy the selected maps as rows a b c d e f p, separated by tabs")
              : tr("Copy the selected maps as rows a b c d e f g h i j k l p, separated by tabs"));
    m_append->setStatusTip(plane ? tr("Add rows of 6 or 7 numbers from the clipboard as new maps")
                                 : tr("Add rows of 12 or 13 numbers from the clipboard as new maps"));
    m_paste->setStatusTip(
        plane ? tr("Replace the selected maps by rows of 6 or 7 numbers from the clipboard")
              : tr("Replace the selected maps by rows of 12 or 13 numbers from the clipboard"));
    for (QAction* each : {m_copy, m_append, m_paste})
        each->setToolTip(each->statusTip());
    m_weightActions.front()->setToolTip(
        plane ? tr("Weights in proportion to the areas of the images, for an even picture")
              : tr("Weights in proportion to the volumes of the images, for an even picture"));
    m_weightActions.front()->setStatusTip(m_weightActions.front()->toolTip());
    m_columnToggles[Columns::Code]->setToolTip(plane ? tr("Show the coefficients a … f")
                                                     : tr("Show the coefficients a … l"));
    m_table->setWhatsThis(tableWhatsThis(m_dimension));
}

void MapsPanel::applyEdit(const QString& text, document::MapsEdit edit) {
    m_document->edit(text, std::move(edit.fractal));
    selectMaps(edit.touched);
}

void MapsPanel::addMap() {
    if (document::dimension(m_document->fractal()) != 0)
        applyEdit(tr("Add a map"), withNewMap(m_document->fractal()));
}

void MapsPanel::duplicateMaps() {
    const document::Rows rows = selectedRows();
    if (!rows.empty()) selectMaps(document::duplicateMaps(*m_document, rows));
}

void MapsPanel::deleteMaps() {
    const document::Rows rows = selectedRows();
    if (const QString locked = document::lockObstacle(m_document->fractal(), rows); !locked.isEmpty())
        return emit message(locked);
    if (!rows.empty()) selectMaps(document::deleteMaps(*m_document, rows));
}

void MapsPanel::moveSelection(int before) {
    applyEdit(tr("Reorder maps"), withMapsMoved(m_document->fractal(), selectedRows(), before));
}

void MapsPanel::moveMapsUp() {
    if (m_up->isEnabled()) moveSelection(std::max(0, selectedRows().front() - 1));
}

void MapsPanel::moveMapsDown() {
    if (m_down->isEnabled()) moveSelection(std::min(m_model->rowCount(), selectedRows().back() + 2));
}

void MapsPanel::moveRowTo(int from, int to) {
    document::Rows rows = selectedRows();
    if (std::find(rows.begin(), rows.end(), from) == rows.end()) rows = {from};
    applyEdit(tr("Reorder maps"), withMapsMoved(m_document->fractal(), rows, to > from ? to + 1 : to));
}

void MapsPanel::cutMaps() {
    const document::Rows rows = selectedRows();
    if (const QString locked = document::lockObstacle(m_document->fractal(), rows); !locked.isEmpty())
        return emit message(locked);
    if (m_clipboard->copy(rows))
        applyEdit(rows.size() == 1 ? tr("Cut a map") : tr("Cut %1 maps").arg(rows.size()),
                  withoutMaps(m_document->fractal(), rows));
}

void MapsPanel::copyMaps() const {
    m_clipboard->copy(selectedRows());
}

void MapsPanel::pasteMaps() {
    m_clipboard->paste(selectedRows());
}

void MapsPanel::appendPasted() {
    m_clipboard->paste({});
}

void MapsPanel::selectAllMaps() {
    m_table->selectAll();
}

void MapsPanel::renameMap() {
    const int row = m_table->currentIndex().row();
    if (row < 0) return;
    m_columnToggles[Columns::Names]->setChecked(true);
    const QModelIndex cell = m_model->index(row, MapsModel::Name);
    m_table->setFocus();
    m_table->selectionModel()->setCurrentIndex(cell, QItemSelectionModel::NoUpdate);
    m_table->edit(cell);
}

// Locks all selected maps, or unlocks them if all of them are locked.
void MapsPanel::toggleLock() {
    const std::vector<ifs::MapId> maps = selectedMaps();
    const document::MapLabels& labels = m_document->fractal().mapLabels;
    if (!maps.empty())
        document::lockMaps(*m_document, maps, !std::ranges::all_of(maps, [&](ifs::MapId map) {
            return labels.of(map).isLocked;
        }));
}

void MapsPanel::toggleSolo() {
    m_solo->toggle(m_solo->map() != ifs::MapId::None ? m_solo->map()
                                                     : m_model->idAt(m_table->currentIndex().row()));
    updateActions(); // updates the pressed button
}

void MapsPanel::applyWeights(document::WeightRule rule) {
    if (m_model->rowCount() == 0) return;
    document::Rows rows(std::size_t(m_model->rowCount()));
    std::iota(rows.begin(), rows.end(), 0);
    if (document::lockedMaps(m_document->fractal()).size() == rows.size())
        return emit message(document::lockObstacle(m_document->fractal(), rows));
    m_weighing->start([rule](const document::Fractal& fractal) { return withWeights(fractal, rule); },
                      [this, rule](std::optional<document::Fractal> weighed) {
                          m_document->edit(tr("Weights: %1").arg(ruleName(rule)), *std::move(weighed));
                      });
}

void MapsPanel::bake() {
    if (const QString obstacle = bakeObstacle(*m_document); !obstacle.isEmpty())
        emit message(obstacle);
    else if (auto after = baked(m_document->fractal()))
        m_document->edit(tr("Bake the cage into the code"), std::move(*after));
}

void MapsPanel::chooseColour(const QModelIndex& index) {
    const QPersistentModelIndex cell = index;
    const auto chosen = QColorDialog::getColor(index.data(Qt::DecorationRole).value<QColor>(), this,
                                               tr("Colour of map %1").arg(index.row() + 1));
    if (chosen.isValid() && cell.isValid()) m_model->setData(cell, chosen, Qt::DecorationRole);
}

} // namespace view
