// SPDX-License-Identifier: MIT
#include "panels/maps_panel.h"

#include "cage_edits.h"
#include "clipboard.h"
#include "dialogs/paste_table_dialog.h"
#include "dialogs/wait_for.h"
#include "icon.h"
#include "io/background.h"
#include "panels/focus_shortcuts.h"
#include "panels/map_shape_editor.h"
#include "panels/maps_delegate.h"
#include "panels/maps_row_header.h"
#include "panels/menu_button.h"

#include <QAction>
#include <QClipboard>
#include <QColorDialog>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHash>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QScrollBar>
#include <QStackedWidget>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace view {

namespace {

constexpr int narrowest = 30; // of a number column

} // namespace

MapsPanel::MapsPanel(document::Document* document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_model(new MapsModel(document, this)),
      m_table(new QTableView(this)),
      m_rowHeader(new MapsRowHeader(m_table)),
      m_shape(new MapShapeEditor(document, this)),
      m_pages(new QStackedWidget(this)) {
    setAccessibleName(tr("Maps"));
    makeActions();
    auto* content = new QWidget(this);
    auto* contentLayout = new QVBoxLayout(content);
    contentLayout->setContentsMargins(0, 0, 0, 0);
    contentLayout->setSpacing(6);
    contentLayout->addWidget(makeTable(), 1);
    contentLayout->addWidget(m_shape);
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

QAction* MapsPanel::action(const QString& text, const QString& iconName, const QString& shortcut,
                           const QString& tip, void (MapsPanel::*slot)()) {
    auto* made = new QAction(icon(iconName), text, this);
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
    m_copy = new QAction(icon(QStringLiteral("copy")), tr("Copy Rows"), this);
    m_copy->setShortcut(QKeySequence::Copy);
    m_copy->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    m_copy->setStatusTip(tr("Copy the selected maps as rows a b c d e f p, separated by tabs"));
    connect(m_copy, &QAction::triggered, this, &MapsPanel::copyMaps);
    m_table->addAction(m_copy);
    m_paste = action(tr("Paste in Place"), QStringLiteral("paste"), QStringLiteral("Ctrl+V"),
                     tr("Replace the selected maps by rows of 6 or 7 numbers from the clipboard"),
                     &MapsPanel::pasteMaps);
    m_append =
        action(tr("Paste as New Maps"), QStringLiteral("paste"), QStringLiteral("Ctrl+Shift+V"),
               tr("Add rows of 6 or 7 numbers from the clipboard as new maps"), &MapsPanel::appendPasted);
    m_bake = action(tr("Bake"), QStringLiteral("bake"), {},
                    tr("Make the effective code the code; the cage then rests"), &MapsPanel::bake);
}

QToolButton* MapsPanel::button(QAction* action) {
    auto* made = new QToolButton(this);
    made->setDefaultAction(action);
    made->setAutoRaise(true);
    made->setAccessibleName(action->text());
    return made;
}

QToolButton* MapsPanel::weightsButton() {
    auto* menu = new QMenu(tr("Weights"), this);
    const auto add = [&](const char* iconName, const QString& text, const QString& tip, WeightRule rule) {
        QAction* rules = menu->addAction(icon(QString::fromLatin1(iconName)), text, this,
                                         [this, rule] { applyWeights(rule); });
        rules->setStatusTip(tip);
        rules->setToolTip(tip);
        m_weightActions.append(rules);
    };
    menu->setToolTipsVisible(true);
    add("weight-det", tr("By |Determinant|"),
        tr("Weights in proportion to the areas of the images, so that the picture is even"),
        WeightRule::Determinant);
    add("weight-equal", tr("Equal"), tr("The same weight for every map"), WeightRule::Equal);
    add("weight-dimension", tr("By Dimension"),
        tr("Weights for an even cover of the attractor at its own dimension"), WeightRule::Dimension);
    menu->addSeparator();
    add("normalise", tr("Normalise"), tr("The same proportions, with the sum 1"), WeightRule::Normalise);
    auto* made = new MenuButton(this);
    made->setText(tr("Weights"));
    made->setIcon(icon(QStringLiteral("weight-equal")));
    made->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    made->setMenu(menu);
    made->setAutoRaise(true);
    made->setToolTip(tr("Weights of all maps that are on, by a rule"));
    made->setAccessibleName(tr("Weights"));
    return made;
}

QWidget* MapsPanel::makeEditBar() {
    auto* bar = new QWidget(this);
    auto* layout = new QHBoxLayout(bar);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    for (QAction* each : {m_add, m_duplicate, m_delete})
        layout->addWidget(button(each));
    layout->addSpacing(8);
    for (QAction* each : {m_up, m_down})
        layout->addWidget(button(each));
    layout->addStretch();
    layout->addWidget(weightsButton());
    return bar;
}

QToolButton* MapsPanel::columnToggle(const QString& text, const QString& tip, Columns group, bool shown) {
    auto* toggle = new QToolButton(this);
    toggle->setText(text);
    toggle->setToolTip(tip);
    toggle->setAccessibleName(tr("Show columns: %1").arg(text));
    toggle->setCheckable(true);
    toggle->setChecked(shown);
    toggle->setAutoRaise(true);
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
    layout->addWidget(columnToggle(tr("Code"), tr("Show the coefficients a … f"), Columns::Code, true));
    layout->addWidget(columnToggle(
        tr("Facts"), tr("Show determinant, contraction factor and kind of each map"), Columns::Facts, true));
    layout->addWidget(columnToggle(tr("Effective code"),
                                   tr("Show the maps as they act on the picture under the current cage"),
                                   Columns::Effective, false));
    layout->addStretch();
    layout->addWidget(button(m_bake));
    return bar;
}

QWidget* MapsPanel::makeTable() {
    m_table->setAccessibleName(tr("Table of maps"));
    m_table->setWhatsThis(tr("Every row is a map: (x, y) goes to (a x + b y + e, c x + d y + f), as often as "
                             "its weight p says. Double-click a number, or begin to type, to change it; the "
                             "picture follows every key. Drag the number of a row to move it."));
    QFont small = m_table->font(); // seven columns of numbers in a narrow panel
    small.setPointSizeF(small.pointSizeF() * 0.92);
    m_table->setFont(small);
    m_table->horizontalHeader()->setFont(small);
    m_rowHeader->setFont(small);
    m_table->setTabKeyNavigation(false); // Tab goes on to the fields below; in an editor, to the next cell
    m_table->setModel(m_model);
    auto* delegate = new MapsDelegate(m_model, this);
    m_table->setItemDelegate(delegate);
    m_table->setVerticalHeader(m_rowHeader);
    m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                             QAbstractItemView::AnyKeyPressed);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setShowGrid(false);
    m_table->setAlternatingRowColors(true);
    m_table->setWordWrap(false);
    m_table->setCornerButtonEnabled(false);
    m_table->setContextMenuPolicy(Qt::CustomContextMenu);
    m_table->setMinimumHeight(120);
    auto* header = m_table->horizontalHeader();
    header->setMinimumSectionSize(24);
    header->setHighlightSections(false);
    header->setResizeContentsPrecision(200); // rows, besides those in sight
    header->setSectionResizeMode(QHeaderView::Interactive);

    connect(delegate, &MapsDelegate::refused, this, &MapsPanel::message);
    connect(delegate, &MapsDelegate::colourRequested, this, &MapsPanel::chooseColour);
    connect(m_rowHeader, &MapsRowHeader::rowDragged, this, &MapsPanel::moveRowTo);
    connect(m_model, &QAbstractItemModel::modelAboutToBeReset, this, &MapsPanel::keepSelection);
    connect(m_model, &QAbstractItemModel::modelReset, this, &MapsPanel::restoreSelection);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        updateActions();
        emit selectionChanged();
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this](const QModelIndex& current) { m_shape->setMap(m_model->idAt(current.row())); });
    connect(m_table, &QWidget::customContextMenuRequested, this, [this](const QPoint& place) {
        QMenu menu(this);
        menu.addActions({m_add, m_duplicate, m_delete});
        menu.addSeparator();
        menu.addActions({m_up, m_down});
        menu.addSeparator();
        menu.addActions({m_copy, m_paste, m_append});
        QMenu* weights = menu.addMenu(tr("Weights"));
        weights->addActions(m_weightActions);
        menu.addSeparator();
        menu.addAction(m_bake);
        menu.exec(m_table->viewport()->mapToGlobal(place));
    });
    new FocusShortcuts(m_table);
    m_table->installEventFilter(this);
    return m_table;
}

// A digit typed on a cell starts its edit, whatever the window does with that key.
bool MapsPanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_table && event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool plain = !(key->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier));
        if (plain && key->text().size() == 1 && QStringLiteral("0123456789+-.,").contains(key->text()))
            event->accept();
    }
    return QWidget::eventFilter(watched, event);
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

std::pair<int, int> MapsPanel::columnsOf(Columns group) {
    switch (group) {
    case Columns::Code:
        return {MapsModel::A, MapsModel::F};
    case Columns::Facts:
        return {MapsModel::Determinant, MapsModel::Kind};
    case Columns::Effective:
        break;
    }
    return {MapsModel::EffectiveA, MapsModel::EffectiveF};
}

void MapsPanel::showColumns(Columns group, bool shown) {
    const auto [first, last] = columnsOf(group);
    for (int column = first; column <= last; ++column)
        m_table->setColumnHidden(column, !shown);
    // What was asked for is seen, and its first column first of all.
    if (shown && m_table->isVisible()) {
        m_table->doItemsLayout(); // the new width is there to scroll in
        const int row = std::max(0, m_table->currentIndex().row());
        m_table->scrollTo(m_model->index(row, last));
        m_table->scrollTo(m_model->index(row, first));
    }
    fitColumns();
}

void MapsPanel::reveal(int column) {
    for (const auto& [group, toggle] : m_columnToggles)
        if (const auto [first, last] = columnsOf(group); column >= first && column <= last)
            toggle->setChecked(true);
    m_table->doItemsLayout();
    m_table->scrollTo(m_model->index(std::max(0, m_table->currentIndex().row()), column));
}

void MapsPanel::fitColumns() {
    for (int column = 0; column < MapsModel::ColumnCount; ++column) {
        if (m_table->isColumnHidden(column)) continue;
        if (column == MapsModel::Enabled || column == MapsModel::Colour) {
            m_table->setColumnWidth(column, 26);
            continue;
        }
        m_table->setColumnWidth(column, std::max(narrowest, widthOf(column)));
    }
}

// In the middle of a gesture, for the rows in sight: no column becomes narrower under the hand.
void MapsPanel::widenColumns() {
    if (!m_table->isVisible()) return;
    QHeaderView* header = m_table->horizontalHeader();
    const int precision = header->resizeContentsPrecision();
    header->setResizeContentsPrecision(0);
    for (int column = MapsModel::A; column < MapsModel::ColumnCount; ++column)
        if (!m_table->isColumnHidden(column))
            m_table->setColumnWidth(column, std::max(m_table->columnWidth(column), widthOf(column)));
    header->setResizeContentsPrecision(precision);
}

// What the numbers need, and the letter over them.
int MapsPanel::widthOf(int column) const {
    const QString name = m_model->headerData(column, Qt::Horizontal).toString();
    const QAbstractItemView* view = m_table; // where the hint is public
    return std::max(view->sizeHintForColumn(column),
                    m_table->horizontalHeader()->fontMetrics().horizontalAdvance(name) + 12);
}

void MapsPanel::follow(const document::Change& change) {
    using document::Change;
    if (change.parts & (Change::Current | Change::File | Change::Entries | Change::System)) updateNotice();
    if (change.parts & (Change::System | Change::Cage | Change::Current | Change::File)) updateActions();
    if (change.live)
        widenColumns();
    else
        fitColumns();
}

void MapsPanel::updateNotice() {
    const document::Entry& entry = m_document->currentEntry();
    const int dimension = document::dimension(*entry.fractal);
    const bool noMaps = dimension == 2 && m_model->maps().empty();
    m_noticeAdd->setVisible(noMaps);
    m_bars->setVisible(dimension == 2);
    m_pages->setCurrentIndex(dimension == 2 && !noMaps ? 0 : 1);
    if (noMaps) {
        m_notice->setText(tr("No maps: add one, or paste rows of 6 or 7 numbers."));
    } else if (dimension == 3) {
        m_notice->setText(tr("3D: not yet shown.\nThe entry is kept as it is."));
    } else if (dimension == 0) {
        QStringList lines{tr("This entry could not be read. It is kept as it is.")};
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
    const bool plane = document::system2(m_document->fractal()) != nullptr;
    const Rows rows = selectedRows();
    const int count = m_model->rowCount();
    m_add->setEnabled(plane);
    m_append->setEnabled(plane);
    m_paste->setEnabled(plane);
    for (QAction* each : {m_duplicate, m_delete, m_copy})
        each->setEnabled(!rows.empty());
    const auto size = static_cast<int>(rows.size());
    m_up->setEnabled(size > 0 && rows.back() >= size); // not yet a block at the top
    m_down->setEnabled(size > 0 && rows.front() < count - size);
    for (QAction* each : std::as_const(m_weightActions))
        each->setEnabled(count > 0);
    const QString obstacle = bakeObstacle(m_document->fractal());
    m_bake->setEnabled(obstacle.isEmpty());
    m_bake->setToolTip(obstacle.isEmpty() ? m_bake->statusTip() : obstacle);
}

Rows MapsPanel::selectedRows() const {
    Rows rows;
    for (const QItemSelectionRange& range : m_table->selectionModel()->selection()) // of whole rows
        for (int row = range.top(); row <= range.bottom(); ++row)
            rows.push_back(row);
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return rows;
}

std::vector<ifs::MapId> MapsPanel::selectedMaps() const {
    std::vector<ifs::MapId> ids;
    for (const int row : selectedRows())
        ids.push_back(m_model->idAt(row));
    return ids;
}

// In the order of the ids; maps that are gone have none.
Rows MapsPanel::rowsOf(const std::vector<ifs::MapId>& ids) const {
    QHash<ifs::MapId, int> order; // of those asked for, which are seldom as many as there are
    order.reserve(qsizetype(ids.size()));
    Rows rows(ids.size(), -1);
    for (int i = 0; i < int(ids.size()); ++i)
        order.insert(ids[std::size_t(i)], i);
    for (int row = 0; row < m_model->rowCount(); ++row)
        if (const auto place = order.constFind(m_model->idAt(row)); place != order.constEnd())
            rows[std::size_t(*place)] = row;
    std::erase(rows, -1);
    return rows;
}

void MapsPanel::selectMaps(const std::vector<ifs::MapId>& ids) {
    selectRows(rowsOf(ids));
}

void MapsPanel::selectRows(Rows rows) {
    const QModelIndex first = rows.empty() ? QModelIndex() : m_model->index(rows.front(), m_keptColumn);
    std::sort(rows.begin(), rows.end());
    QItemSelection selection; // of as few ranges as there are
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const int top = rows[i];
        while (i + 1 < rows.size() && rows[i + 1] <= rows[i] + 1)
            ++i;
        selection.select(m_model->index(top, 0), m_model->index(rows[i], MapsModel::ColumnCount - 1));
    }
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
    m_shape->setMap(ifs::MapId::None);
    Rows rows = rowsOf(m_kept);
    if (rows.empty() && m_model->rowCount() > 0) rows = {0};
    selectRows(std::move(rows));
    updateActions();
}

void MapsPanel::applyEdit(const QString& text, MapsEdit edit) {
    m_document->edit(text, std::move(edit.fractal));
    selectMaps(edit.touched);
}

void MapsPanel::addMap() {
    if (document::system2(m_document->fractal()))
        applyEdit(tr("Add a map"), withNewMap(m_document->fractal()));
}

void MapsPanel::duplicateMaps() {
    const Rows rows = selectedRows();
    if (!rows.empty()) selectMaps(view::duplicateMaps(*m_document, rows));
}

void MapsPanel::deleteMaps() {
    const Rows rows = selectedRows();
    if (!rows.empty()) selectMaps(view::deleteMaps(*m_document, rows));
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
    Rows rows = selectedRows();
    if (std::find(rows.begin(), rows.end(), from) == rows.end()) rows = {from};
    applyEdit(tr("Reorder maps"), withMapsMoved(m_document->fractal(), rows, to > from ? to + 1 : to));
}

void MapsPanel::copyMaps() const {
    MapRows rows;
    for (const int row : selectedRows())
        rows.push_back(m_model->maps()[static_cast<std::size_t>(row)]);
    if (rows.empty()) return;
    QGuiApplication::clipboard()->setMimeData(mapsMimeData(std::move(rows)).release());
}

void MapsPanel::pasteMaps() {
    paste(selectedRows());
}

void MapsPanel::appendPasted() {
    paste({});
}

void MapsPanel::paste(const Rows& rows) {
    if (!document::system2(m_document->fractal())) return;
    const QMimeData* copied = QGuiApplication::clipboard()->mimeData();
    QString text;
    FoundMaps found;
    if (const auto* ours = copied ? ourMaps(*copied) : nullptr) {
        found.table.rows = *ours;
    } else {
        text = copied ? copied->text() : QString();
        const bool areOurs = copied && holdsOurMaps(*copied);
        auto reading = io::inBackground<FoundMaps>(
            [text, areOurs](QPromise<FoundMaps>& promise) { promise.addResult(mapsIn(text, areOurs)); });
        if (!waitFor(QFuture<void>(reading), tr("Reading what was pasted…"), this)) return;
        found = reading.takeResult();
    }
    const io::Table& table = found.table;
    if (found.isOrderOpen) {
        auto* dialog = new PasteTableDialog(m_document, rows, text, this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        connect(dialog, &PasteTableDialog::pasted, this,
                [this, rows, dialog](const std::vector<ifs::MapId>& touched) {
                    selectMaps(touched);
                    sayPasted(rows, dialog->count());
                });
        dialog->open();
        return;
    }
    for (const auto& problem : table.problems) {
        if (problem.severity != document::Problem::Severity::Error) continue;
        emit message(problem.line > 0 ? tr("Nothing was pasted. Line %1 of the clipboard: %2")
                                            .arg(problem.line)
                                            .arg(problem.message)
                                      : tr("Nothing was pasted. %1").arg(problem.message));
        return;
    }
    if (table.rows.empty()) {
        emit message(tr("Nothing was pasted: the clipboard holds no rows of 6 or 7 numbers."));
        return;
    }
    const auto count = static_cast<int>(table.rows.size());
    applyEdit(count == 1 ? tr("Paste a map") : tr("Paste %1 maps").arg(count),
              withMapsPasted(m_document->fractal(), rows, table.rows));
    sayPasted(rows, count, table.problems.isEmpty() ? QString() : table.problems.front().message);
}

void MapsPanel::sayPasted(const Rows& rows, int count, const QString& remark) {
    const QString text = rows.empty() ? tr("Maps added: %1.").arg(count)
                                      : tr("The selected maps were replaced; maps pasted: %1.").arg(count);
    emit message(remark.isEmpty() ? text : text + u' ' + remark);
}

void MapsPanel::applyWeights(WeightRule rule) {
    if (m_model->rowCount() > 0)
        m_document->edit(tr("Set the weights"), withWeights(m_document->fractal(), rule));
}

void MapsPanel::bake() {
    if (auto after = baked(m_document->fractal()))
        m_document->edit(tr("Bake the cage into the code"), std::move(*after));
    else
        emit message(bakeObstacle(m_document->fractal()));
}

void MapsPanel::chooseColour(const QModelIndex& index) {
    const QPersistentModelIndex cell = index;
    const auto chosen = QColorDialog::getColor(index.data(Qt::DecorationRole).value<QColor>(), this,
                                               tr("Colour of map %1").arg(index.row() + 1));
    if (chosen.isValid() && cell.isValid()) m_model->setData(cell, chosen, Qt::DecorationRole);
}

} // namespace view
