// SPDX-License-Identifier: MIT
#include "dialogs/command_palette.h"

#include "dialogs/command_delegate.h"
#include "dialogs/command_synonyms.h"
#include "widgets/icon.h"
#include "widgets/menus/menu_placeholder.h"
#include "widgets/text/tooltip_text.h"

#include <QAction>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QPainter>
#include <QPixmap>
#include <QPointer>
#include <QRegularExpression>
#include <QSet>
#include <QStandardItemModel>
#include <QStyleOptionFrame>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace view {

namespace {

constexpr int actionRole = Qt::UserRole;
constexpr int guideRow = -1; // replacement for the index of an action

// The text of the action, unless the name of the command is another: that of Undo is not the step's.
QString nameOf(const QAction* action) {
    const QVariant name = action->property(commandName);
    return (name.isValid() ? name.toString() : action->text()).remove(u'&').remove(u'…');
}

QString below(const QString& path, const QString& name) {
    return path.isEmpty() ? name : path + QStringLiteral(" › ") + name;
}

void collect(const QList<QAction*>& actions, const QString& path, QList<NamedAction>& found,
             QWidget* panel = nullptr) {
    for (QAction* action : actions) {
        const QString name = nameOf(action);
        if (action->isSeparator() || isPlaceholder(*action) || !action->isVisible() || name.isEmpty())
            continue;
        if (const QMenu* menu = action->menu())
            collect(menu->actions(), below(path, name), found, panel);
        else
            found << NamedAction{action, below(path, name), panel};
    }
}

// The content of a panel or a bar that contains the widget, or is it.
const QWidget* contentOf(const QWidget* panel, const QWidget* widget) {
    while (widget->parentWidget() != panel)
        widget = widget->parentWidget();
    return widget;
}

// The panel, and the parts of its content with names of their own that the widget is in.
QString pathOf(const QWidget* widget, const QWidget* panel) {
    QStringList names;
    const QWidget* content = contentOf(panel, widget);
    const QStringList ofAll{QString(), panel->windowTitle(), content->accessibleName()};
    for (const QWidget* at = widget; at != content; at = at->parentWidget())
        if (at != widget && !ofAll.contains(at->accessibleName())) names.prepend(at->accessibleName());
    names.prepend(panel->windowTitle());
    return names.join(QStringLiteral(" › "));
}

// Made once, and each time as the widget is now.
template <typename Run>
QAction* actionOf(QWidget* widget, const QString& doing, const QString& text, Run run) {
    auto* action = widget->findChild<QAction*>(doing, Qt::FindDirectChildrenOnly);
    if (!action) {
        action = new QAction(widget);
        action->setObjectName(doing);
        QObject::connect(action, &QAction::triggered, widget, run);
    }
    action->setText(text);
    action->setEnabled(widget->isEnabled());
    action->setStatusTip(plainText(widget->toolTip()));
    action->setWhatsThis(widget->whatsThis());
    return action;
}

QAction* clickOf(QAbstractButton* button) {
    const QString name = button->accessibleName().isEmpty() ? button->text() : button->accessibleName();
    QAction* action = actionOf(button, QStringLiteral("clicking"), name, [button] { button->click(); });
    action->setIcon(button->icon());
    return action;
}

// Goes to the field that a label names, or to the first part of it that takes the focus.
QAction* entryOf(const QLabel& label) {
    QWidget* field = label.buddy();
    return actionOf(field, QStringLiteral("entering"), label.text().remove(u':'), [field] {
        QWidgetList parts{field};
        parts << field->findChildren<QWidget*>();
        const auto first = std::ranges::find_if(parts, [](const QWidget* part) {
            return part->isVisible() && part->focusPolicy() & Qt::TabFocus;
        });
        if (first != parts.end()) (*first)->setFocus(Qt::TabFocusReason); // also selects its text
    });
}

// Actions of the widgets in a panel: their own, in the menu of a button, as buttons or as fields.
QList<NamedAction> actionsIn(QWidget* panel) {
    QList<NamedAction> found;
    for (QWidget* widget : panel->findChildren<QWidget*>()) {
        if (widget->window() != panel->window()) continue; // menus are represented by their buttons
        const QString path = pathOf(widget, panel);
        const QWidget* content = contentOf(panel, widget);
        const bool isThere = widget != content && widget->isVisibleTo(content);
        const auto* tool = qobject_cast<const QToolButton*>(widget);
        auto* button = qobject_cast<QAbstractButton*>(widget);
        const auto* label = qobject_cast<const QLabel*>(widget);
        if (tool && tool->menu() && tool->menu()->title().isEmpty())
            collect(tool->menu()->actions(), below(path, tool->text()), found, panel);
        else if (!widget->actions().isEmpty())
            collect(widget->actions(), path, found, panel);
        else if (button && isThere)
            collect({clickOf(button)}, path, found, panel);
        else if (label && isThere && label->buddy() && !qobject_cast<QAbstractButton*>(label->buddy()))
            collect({entryOf(*label)}, path, found, panel);
    }
    return found;
}

QStringList wordsOf(const QString& text) {
    static const QRegularExpression separators(QStringLiteral("[^\\w]+"),
                                               QRegularExpression::UseUnicodePropertiesOption);
    return text.split(separators, Qt::SkipEmptyParts);
}

// The names of commands have British spelling.
QString british(QString word) {
    constexpr std::pair<const char*, const char*> spellings[] = {
        {"color", "colour"},      {"center", "centre"},         {"gray", "grey"},
        {"analyz", "analys"},     {"maximiz", "maximis"},       {"minimiz", "minimis"},
        {"normaliz", "normalis"}, {"millimeter", "millimetre"}, {"favor", "favour"},
    };
    for (const auto& [american, here] : spellings)
        if (word.startsWith(QLatin1String(american), Qt::CaseInsensitive))
            word.replace(0, qsizetype(qstrlen(american)), QLatin1String(here));
    return word;
}

template <typename Fits> bool hasEach(const QStringList& words, const QStringList& wanted, Fits fits) {
    return std::all_of(wanted.begin(), wanted.end(), [&](const QString& want) {
        return std::any_of(words.begin(), words.end(), [&, other = british(want)](const QString& word) {
            return fits(word, want) || fits(word, other);
        });
    });
}

// Returns true if the words mean this command before those that have them in their names.
bool meansFirst(const QString& title, const QString& text) {
    const QString first = firstSynonymsOf(title.section(QStringLiteral(" › "), -1));
    return !first.isEmpty() && !text.trimmed().isEmpty() && namesCommand(first, text);
}

} // namespace

// The whole name, without the menus and panels that lead to it.
bool isCommand(const QString& path, const QString& text) {
    const QStringList words = wordsOf(path.section(QStringLiteral(" › "), -1));
    return words.join(u' ').compare(wordsOf(text).join(u' '), Qt::CaseInsensitive) == 0;
}

bool matchesCommand(const QString& title, const QString& text) {
    return hasEach(wordsOf(title), wordsOf(text), [](const QString& word, const QString& wanted) {
        return word.startsWith(wanted, Qt::CaseInsensitive);
    });
}

bool meansCommand(const QString& title, const QString& text) {
    const QString synonyms = synonymsOf(title.section(QStringLiteral(" › "), -1));
    return !synonyms.isEmpty() && matchesCommand(title + u' ' + synonyms, text);
}

bool namesCommand(const QString& title, const QString& text) {
    return hasEach(wordsOf(title), wordsOf(text), [](const QString& word, const QString& wanted) {
        return word.compare(wanted, Qt::CaseInsensitive) == 0;
    });
}

QList<NamedAction> actionsOf(const QWidget* menuBar) {
    QList<NamedAction> found;
    collect(menuBar->actions(), {}, found);
    return found;
}

QList<NamedAction> actionsOf(const QMainWindow& window) {
    QList<NamedAction> found = actionsOf(window.menuWidget());
    QSet<QString> paths;
    QSet<const QAction*> actions;
    for (const NamedAction& action : std::as_const(found)) {
        paths.insert(action.path);
        actions.insert(action.action);
    }
    const auto add = [&](QWidget* panel) {
        for (const NamedAction& action : actionsIn(panel)) {
            if (paths.contains(action.path) || actions.contains(action.action)) continue;
            paths.insert(action.path);
            actions.insert(action.action);
            found << action;
        }
    };
    for (QDockWidget* panel : window.findChildren<QDockWidget*>())
        add(panel);
    for (QToolBar* bar : window.findChildren<QToolBar*>())
        add(bar);
    return found;
}

CommandPalette::CommandPalette(const QList<NamedAction>& actions, QWidget* parent)
    : QDialog(parent, Qt::Popup),
      m_actions(actions),
      m_model(new QStandardItemModel(this)),
      m_search(new QLineEdit),
      m_list(new QListView) {
    setAccessibleName(tr("Command palette"));
    m_search->setPlaceholderText(tr("Type what you want to do"));
    m_search->setAccessibleName(tr("Command"));
    m_search->setWhatsThis(
        tr("Type some letters of what you want to do. The arrow keys select a command, Enter runs it."));
    m_search->setClearButtonEnabled(true);
    m_search->installEventFilter(this);
    m_list->setModel(m_model);
    m_list->setItemDelegate(new CommandDelegate(m_list));
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setIconSize({18, 18});
    m_list->setSpacing(1);
    QPixmap empty(m_list->iconSize());
    empty.fill(Qt::transparent);
    m_noIcon = QIcon(empty);
    m_list->setAccessibleName(tr("Matching commands"));
    m_list->setWhatsThis(
        tr("Commands whose names contain these words come first, then those whose descriptions do."));
    m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_list->setUniformItemSizes(true);
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setFrameShape(QFrame::NoFrame);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->addWidget(m_search);
    column->addWidget(m_list);
    resize(520, 380);
    m_search->setFocus();

    connect(m_search, &QLineEdit::textChanged, this, &CommandPalette::filter);
    connect(m_search, &QLineEdit::returnPressed, this, &CommandPalette::run);
    connect(m_list, &QListView::clicked, this, &CommandPalette::run);
    filter({});
}

void CommandPalette::filter(const QString& text) {
    m_model->clear();
    for (const bool enabled : {true, false})
        for (const SearchIn in : {SearchIn::Whole, SearchIn::Words, SearchIn::Names, SearchIn::Synonyms})
            if (enabled || !text.isEmpty()) add(text, in, enabled);
    for (const bool enabled : {true, false})
        if (!text.isEmpty()) add(text, SearchIn::Descriptions, enabled);
    if (m_model->rowCount() == 0) {
        auto* none = new QStandardItem(m_noIcon, tr("No matching commands"));
        none->setEnabled(false);
        m_model->appendRow(none);
    }
    if (!text.trimmed().isEmpty()) addGuide(text.simplified());
    const bool hasNone = m_model->item(0) && !m_model->item(0)->data(actionRole).isValid();
    int chosen = hasNone && m_model->rowCount() > 1 ? 1 : 0;
    // A command that can be chosen, though another has more of the words in its name: Return does something.
    for (int row = m_model->rowCount() - 1; row >= 0; --row)
        if (m_model->item(row)->isEnabled() && m_model->item(row)->data(actionRole).toInt() != guideRow)
            chosen = row;
    m_list->setCurrentIndex(m_model->index(chosen, 0));
}

// Adds the last row, which always leads to the guide: it may explain words that name no command.
void CommandPalette::addGuide(const QString& text) {
    const QString name = tr("Search the guide for “%1”").arg(text);
    auto* item = new QStandardItem(icon(QStringLiteral("help")), name);
    item->setData(name, CommandDelegate::NameRole);
    item->setData(guideRow, actionRole);
    item->setToolTip(tooltipText(name));
    m_model->appendRow(item);
}

// Adds matching commands; disabled ones are shown too, if they are asked for by name.
void CommandPalette::add(const QString& text, SearchIn in, bool enabled) {
    for (qsizetype i = 0; i < m_actions.size(); ++i) {
        const auto& [action, title, panel] = m_actions[i];
        if (action->isEnabled() != enabled) continue;
        const SearchIn found = isCommand(title, text) || meansFirst(title, text) ? SearchIn::Whole
                               : namesCommand(title, text)                       ? SearchIn::Words
                               : matchesCommand(title, text)                     ? SearchIn::Names
                               : meansCommand(title, text)                       ? SearchIn::Synonyms
                                                                                 : SearchIn::Descriptions;
        if (found != in) continue;
        if (in == SearchIn::Descriptions && !matchesCommand(title + u' ' + action->statusTip(), text))
            continue;
        const QString keys = action->shortcut().toString(QKeySequence::NativeText);
        const QString name =
            action->isCheckable() && action->isChecked() ? title + QStringLiteral(" ✓") : title;
        auto* item = new QStandardItem(action->icon().isNull() ? m_noIcon : action->icon(),
                                       keys.isEmpty() ? name : name + QStringLiteral("    ") + keys);
        item->setData(name, CommandDelegate::NameRole);
        item->setData(keys, CommandDelegate::KeysRole);
        item->setData(int(i), actionRole);
        item->setToolTip(tooltipText(action->statusTip())); // may be the path of a file
        item->setEnabled(enabled);
        m_model->appendRow(item);
    }
}

void CommandPalette::run() {
    const QModelIndex index = m_list->currentIndex();
    if (!(index.flags() & Qt::ItemIsEnabled)) return;
    const int row = index.data(actionRole).toInt();
    if (row == guideRow) {
        const QString words = m_search->text().simplified();
        accept();
        emit guideRequested(words);
        return;
    }
    const auto [action, path, panel] = m_actions[row];
    auto* dock = qobject_cast<QDockWidget*>(action->parent());
    const bool isPanel = dock && dock->toggleViewAction() == action;
    accept();
    if (QWidget* shown = isPanel ? dock : panel) { // shows the effect of the command
        shown->show();
        shown->raise();
    }
    const QPointer<QAction> alive(action);
    action->setProperty(searchedWords, m_search->text().simplified());
    if (!isPanel || !action->isChecked()) action->trigger(); // nobody asks for a panel to close it
    if (alive) action->setProperty(searchedWords, {});
}

// The frame is that of a menu, because the colour is that of the window behind.
void CommandPalette::paintEvent(QPaintEvent* event) {
    QDialog::paintEvent(event);
    QPainter painter(this);
    QStyleOptionFrame frame;
    frame.initFrom(this);
    frame.lineWidth = style()->pixelMetric(QStyle::PM_MenuPanelWidth, &frame, this);
    style()->drawPrimitive(QStyle::PE_FrameMenu, &frame, &painter, this);
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    if (watched != m_search || event->type() != QEvent::KeyPress) return QDialog::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    const int step = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
    if (step == 0) return false;
    const int row = qBound(0, m_list->currentIndex().row() + step, m_model->rowCount() - 1);
    m_list->setCurrentIndex(m_model->index(row, 0));
    return true;
}

} // namespace view
