// SPDX-License-Identifier: MIT
#include "dialogs/toolbar_page.h"

#include "desktop/preferences.h"
#include "widgets/choices.h"
#include "widgets/text/tooltip_text.h"

#include <QComboBox>
#include <QCompleter>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPixmap>
#include <QPushButton>
#include <QSet>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <memory>
#include <utility>

namespace view {

namespace {

// "Discover › Variations…" without its menu.
QString nameInMenu(const NamedAction& command) {
    return command.path.section(QStringLiteral(" › "), -1);
}

constexpr QSize iconSize{22, 22};

// Names are in line, whether or not a command has an icon.
QIcon iconOr(const QIcon& icon) {
    if (!icon.isNull()) return icon;
    QPixmap room(iconSize);
    room.fill(Qt::transparent);
    return room;
}

QString idOf(const QListWidgetItem* item) {
    return item->data(Qt::UserRole).toString();
}

} // namespace

ToolbarPage::ToolbarPage(const QList<NamedAction>& commands, const QStringList& usual, QWidget* parent)
    : QWidget(parent),
      m_usual(usual),
      m_list(new QListWidget(this)),
      m_up(new QPushButton(tr("Move &Up"), this)),
      m_down(new QPushButton(tr("Move &Down"), this)),
      m_remove(new QPushButton(tr("&Remove"), this)),
      m_others(new QComboBox(this)) {
    QSet<const QAction*> seen;
    for (const NamedAction& command : commands) {
        if (command.action->objectName().isEmpty() || command.panel || seen.contains(command.action))
            continue;
        seen.insert(command.action);
        m_commands << command;
    }
    m_list->setAccessibleName(tr("Commands in the toolbar"));
    m_list->setWhatsThis(tr("The toolbar from left to right. Drag a command to move it."));
    m_list->setDragDropMode(QAbstractItemView::InternalMove);
    m_list->setDefaultDropAction(Qt::MoveAction);
    m_list->setIconSize(iconSize);
    m_others->setEditable(true); // typing finds a command
    m_others->setInsertPolicy(QComboBox::NoInsert);
    m_others->completer()->setCompletionMode(QCompleter::PopupCompletion);
    m_others->completer()->setFilterMode(Qt::MatchContains);
    m_others->lineEdit()->setPlaceholderText(tr("Choose a command"));
    m_others->setAccessibleName(tr("Command to add"));
    m_others->setWhatsThis(tr("Adds a command of the menus, or a separator, after the selected one."));
    m_others->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);

    auto* row = new QHBoxLayout;
    row->addWidget(m_list, 1);
    row->addLayout(makeButtons());
    auto* label = new QLabel(tr("&Add:"), this);
    label->setBuddy(m_others);
    auto* adding = new QHBoxLayout;
    adding->addWidget(label);
    adding->addWidget(m_others, 1);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(row, 1);
    layout->addLayout(adding);
    connect(m_list, &QListWidget::currentRowChanged, this, &ToolbarPage::updateButtons);
    connect(m_list->model(), &QAbstractItemModel::rowsMoved, this, &ToolbarPage::changed);
    connect(m_others, &QComboBox::activated, this, &ToolbarPage::add);
    setTools({});
}

QLayout* ToolbarPage::makeButtons() {
    m_up->setWhatsThis(tr("Moves the selected command towards the left end of the toolbar."));
    m_down->setWhatsThis(tr("Moves the selected command towards the right end of the toolbar."));
    m_remove->setWhatsThis(tr("Takes the selected command out of the toolbar. It stays in its menu."));
    m_up->setObjectName(QStringLiteral("up"));
    m_down->setObjectName(QStringLiteral("down"));
    m_remove->setObjectName(QStringLiteral("remove"));
    connect(m_up, &QPushButton::clicked, this, [this] { move(-1); });
    connect(m_down, &QPushButton::clicked, this, [this] { move(1); });
    connect(m_remove, &QPushButton::clicked, this, &ToolbarPage::remove);
    auto* column = new QVBoxLayout;
    for (QPushButton* button : {m_up, m_down, m_remove}) {
        button->setAutoDefault(false);
        column->addWidget(button);
    }
    column->addStretch();
    return column;
}

void ToolbarPage::setTools(const QStringList& tools) {
    if (const QStringList shown = tools.isEmpty() ? m_usual : tools; shown != ids()) {
        m_list->clear();
        for (const QString& id : shown)
            insert(m_list->count(), id);
        m_list->setCurrentRow(0);
    }
    listOthers();
    updateButtons();
}

QStringList ToolbarPage::tools() const {
    return ids() == m_usual ? QStringList() : ids();
}

QStringList ToolbarPage::ids() const {
    QStringList all;
    for (int row = 0; row < m_list->count(); ++row)
        all << idOf(m_list->item(row));
    return all;
}

// Does nothing for an id without a command.
void ToolbarPage::insert(int row, const QString& id) {
    auto item = std::make_unique<QListWidgetItem>();
    const auto found = std::ranges::find(
        m_commands, id, [](const NamedAction& command) { return command.action->objectName(); });
    if (id == separatorId()) {
        item->setIcon(iconOr({}));
        item->setText(tr("Separator"));
        item->setForeground(palette().placeholderText());
    } else if (found != m_commands.end()) {
        item->setText(nameInMenu(*found));
        item->setToolTip(tooltipText(found->path));
        item->setIcon(iconOr(found->action->icon()));
    } else {
        return;
    }
    item->setData(Qt::UserRole, id);
    item->setFlags(item->flags() & ~Qt::ItemIsDropEnabled);
    m_list->insertItem(row, item.release());
}

void ToolbarPage::move(int by) {
    const int row = m_list->currentRow();
    {
        const QSignalBlocker quiet(m_list);
        m_list->insertItem(row + by, m_list->takeItem(row));
        m_list->setCurrentRow(row + by);
    }
    updateButtons();
    emit changed();
}

void ToolbarPage::remove() {
    delete m_list->takeItem(m_list->currentRow());
    listOthers();
    updateButtons();
    emit changed();
}

void ToolbarPage::add() {
    const int row = m_list->currentRow() + 1;
    insert(row, chosenValue<QString>(m_others));
    m_list->setCurrentRow(row);
    listOthers();
    // Queued, because the completer then writes the chosen text into the field.
    QMetaObject::invokeMethod(m_others, &QComboBox::clearEditText, Qt::QueuedConnection);
    emit changed();
}

// Enter in the field adds the first command that is found, and does not close the dialog.
void ToolbarPage::keyPressEvent(QKeyEvent* event) {
    const QWidget* focused = focusWidget();
    const bool isField = focused == m_others || focused == m_others->lineEdit();
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (!isField || !isEnter) return QWidget::keyPressEvent(event);
    const QString typed = m_others->currentText();
    const int found = typed.isEmpty() ? -1 : m_others->findText(typed, Qt::MatchContains);
    if (found < 0) return;
    m_others->setCurrentIndex(found);
    add();
}

void ToolbarPage::listOthers() {
    m_others->clear();
    const QStringList present = ids();
    addChoice(m_others, tr("Separator"), separatorId());
    m_others->setItemIcon(0, iconOr({}));
    for (const NamedAction& command : std::as_const(m_commands)) {
        if (present.contains(command.action->objectName())) continue;
        addChoice(m_others, command.path, command.action->objectName());
        m_others->setItemIcon(m_others->count() - 1, iconOr(command.action->icon()));
    }
    m_others->setCurrentIndex(-1);
    m_others->clearEditText();
}

// The last command stays, since an empty list stands for the usual ones.
void ToolbarPage::updateButtons() {
    const int row = m_list->currentRow();
    m_up->setEnabled(row > 0);
    m_down->setEnabled(row >= 0 && row + 1 < m_list->count());
    m_remove->setEnabled(row >= 0 && m_list->count() > 1);
}

} // namespace view
