// SPDX-License-Identifier: MIT
#include "dialogs/shortcuts_page.h"

#include "widgets/icon.h"
#include "widgets/text/tooltip_text.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSet>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace view {

namespace {

enum Column { Command, Keys };

QAction* actionOfItem(const QTreeWidgetItem* item) {
    return item ? item->data(Command, Qt::UserRole).value<QAction*>() : nullptr;
}

QString keysText(const Shortcuts& keys) {
    return QKeySequence::listToString(keys, QKeySequence::NativeText);
}

QString titleOf(const QAction& action) {
    return action.text().remove(u'&').remove(u'…');
}

} // namespace

ShortcutsPage::ShortcutsPage(const QList<NamedAction>& commands, QWidget* parent)
    : QWidget(parent),
      m_search(new QLineEdit(this)),
      m_tree(new QTreeWidget(this)),
      m_edit(new QKeySequenceEdit(this)),
      m_clear(new QPushButton(tr("Cl&ear"), this)),
      m_default(new QPushButton(tr("&Default"), this)),
      m_note(new QLabel(this)),
      m_swap(new QPushButton(tr("S&wap"), this)) {
    m_clear->setObjectName(QStringLiteral("clear"));
    m_default->setObjectName(QStringLiteral("default"));
    m_swap->setObjectName(QStringLiteral("swap"));
    m_note->setObjectName(QStringLiteral("note"));
    m_search->setPlaceholderText(tr("Find a command or keys"));
    m_search->setAccessibleName(tr("Find a command or keys"));
    m_search->setWhatsThis(tr("Show only the commands whose name, synonyms or keys begin with these words."));
    m_search->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    m_tree->setAccessibleName(tr("Commands"));
    m_tree->setWhatsThis(
        tr("The commands of the menus and their keys; your own are bold. Select one to change its keys."));
    m_tree->setHeaderLabels({tr("Command"), tr("Shortcut")});
    m_tree->setUniformRowHeights(true);
    m_tree->setRootIsDecorated(false);
    m_tree->setMinimumSize(56 * m_tree->fontMetrics().averageCharWidth(),
                           16 * m_tree->fontMetrics().lineSpacing());
    addCommands(commands);
    m_tree->header()->setStretchLastSection(false);
    m_tree->header()->setSectionResizeMode(Command, QHeaderView::Stretch);
    m_tree->header()->setSectionResizeMode(Keys, QHeaderView::ResizeToContents);

    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_search);
    layout->addWidget(m_tree, 1);
    layout->addLayout(editorRow());
    layout->addLayout(noteRow());

    connect(m_search, &QLineEdit::textChanged, this, &ShortcutsPage::filter);
    connect(m_tree, &QTreeWidget::currentItemChanged, this, &ShortcutsPage::showCurrent);
    connect(m_edit, &QKeySequenceEdit::keySequenceChanged, this, [this](const QKeySequence& typed) {
        if (typed.count() > 1) { // one key at a time: the last one counts
            m_edit->setKeySequence(QKeySequence(typed[uint(typed.count() - 1)]));
            return;
        }
        take(typed.isEmpty() ? Shortcuts() : Shortcuts{typed});
    });
    connect(m_clear, &QPushButton::clicked, this, [this] { take({}); });
    connect(m_default, &QPushButton::clicked, this, [this] { take(usualShortcuts(*current())); });
    connect(m_swap, &QPushButton::clicked, this, &ShortcutsPage::swap);
    m_tree->setCurrentItem(m_items.value(0));
    showCurrent();
}

QLayout* ShortcutsPage::editorRow() {
    auto* label = new QLabel(tr("&Shortcut:"), this);
    label->setBuddy(m_edit);
    m_edit->setAccessibleName(tr("Shortcut"));
    m_edit->setWhatsThis(
        tr("Press the keys that the selected command is to have. Tab goes on to the next field."));
    m_clear->setWhatsThis(tr("Takes the keys from the selected command."));
    m_default->setWhatsThis(tr("Gives the selected command the keys that it has without your choice."));
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(m_edit, 1);
    for (QPushButton* button : {m_clear, m_default}) {
        button->setAutoDefault(false);
        row->addWidget(button);
    }
    return row;
}

QLayout* ShortcutsPage::noteRow() {
    m_note->setWordWrap(true);
    m_note->setMinimumHeight(2 * m_note->fontMetrics().lineSpacing()); // constant height
    m_note->setTextFormat(Qt::PlainText);
    m_swap->setAutoDefault(false);
    m_swap->setWhatsThis(tr("Gives these keys to the selected command, and its present ones to the other."));
    QSizePolicy place = m_swap->sizePolicy();
    place.setRetainSizeWhenHidden(true);
    m_swap->setSizePolicy(place);
    auto* row = new QHBoxLayout;
    row->addWidget(m_note, 1);
    row->addWidget(m_swap);
    return row;
}

void ShortcutsPage::addCommands(const QList<NamedAction>& commands) {
    QSet<const QAction*> seen;
    QTreeWidgetItem* group = nullptr;
    for (const auto& [action, path, panel] : commands) {
        if (action->objectName().isEmpty() || panel || seen.contains(action)) continue;
        seen.insert(action);
        const QString menu = path.section(QStringLiteral(" › "), 0, 0);
        if (!group || group->text(Command) != menu) {
            group = new QTreeWidgetItem(m_tree, {menu});
            group->setFirstColumnSpanned(true);
            group->setFlags(Qt::ItemIsEnabled);
            QFont bold = m_tree->font();
            bold.setBold(true);
            group->setFont(Command, bold);
        }
        auto* item = new QTreeWidgetItem(group, {path.section(QStringLiteral(" › "), 1)});
        item->setToolTip(Command, tooltipText(item->text(Command)));
        item->setData(Command, Qt::UserRole, QVariant::fromValue(action));
        m_items << item;
        showKeys(item);
    }
    m_tree->expandAll();
}

void ShortcutsPage::filter(const QString& text) {
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
        QTreeWidgetItem* group = m_tree->topLevelItem(i);
        bool isAny = false;
        for (int k = 0; k < group->childCount(); ++k) {
            QTreeWidgetItem* item = group->child(k);
            const bool isFound = matchesCommand(item->text(Command) + u' ' + item->text(Keys), text) ||
                                 meansCommand(item->text(Command), text);
            item->setHidden(!isFound);
            isAny = isAny || isFound;
        }
        group->setHidden(!isAny);
    }
}

QAction* ShortcutsPage::current() const {
    return actionOfItem(m_tree->currentItem());
}

void ShortcutsPage::showCurrent() {
    const QAction* command = current();
    const QSignalBlocker quiet(m_edit);
    m_edit->setKeySequence(command ? command->shortcut() : QKeySequence());
    m_edit->setEnabled(command);
    m_clear->setEnabled(command && !command->shortcuts().isEmpty());
    m_default->setEnabled(command && command->shortcuts() != usualShortcuts(*command));
    say({});
}

void ShortcutsPage::showKeys(QTreeWidgetItem* item) {
    const QAction& command = *actionOfItem(item);
    item->setText(Keys, keysText(command.shortcuts()));
    QFont font = m_tree->font();
    font.setBold(command.shortcuts() != usualShortcuts(command)); // changed by the user
    item->setFont(Keys, font);
}

QAction* ShortcutsPage::ownerOf(const Shortcuts& keys) const {
    for (const QTreeWidgetItem* item : m_items) {
        QAction* other = actionOfItem(item);
        if (other == current()) continue;
        for (const QKeySequence& key : other->shortcuts())
            if (keys.contains(key)) return other;
    }
    return nullptr;
}

void ShortcutsPage::take(const Shortcuts& keys) {
    for (const QKeySequence& key : keys)
        if (const QString why = shortcutObstacle(key); !why.isEmpty()) return say(why);
    if (QAction* other = ownerOf(keys))
        return say(tr("“%1” belongs to “%2”.").arg(keysText(keys), titleOf(*other)), Clash{other, keys});
    give(*current(), keys);
    showCurrent();
}

void ShortcutsPage::give(const QAction& command, const Shortcuts& keys) {
    setShortcuts(command.objectName(), keys == usualShortcuts(command) ? std::nullopt : std::optional(keys));
    for (QTreeWidgetItem* item : std::as_const(m_items))
        if (actionOfItem(item) == &command) showKeys(item);
}

void ShortcutsPage::swap() {
    const auto [other, keys] = m_clash.value();
    const Shortcuts mine = current()->shortcuts();
    give(*other, mine);
    give(*current(), keys);
    const QString said = mine.isEmpty() ? tr("“%1” has no keys now.").arg(titleOf(*other))
                                        : tr("“%1” has “%2” now.").arg(titleOf(*other), keysText(mine));
    showCurrent();
    say(said);
}

void ShortcutsPage::say(const QString& sentence, const std::optional<Clash>& clash) {
    m_clash = clash;
    m_note->setText(sentence);
    m_swap->setVisible(clash.has_value());
}

void ShortcutsPage::restoreDefaults() {
    for (QTreeWidgetItem* item : std::as_const(m_items))
        give(*actionOfItem(item), usualShortcuts(*actionOfItem(item)));
    showCurrent();
}

} // namespace view
