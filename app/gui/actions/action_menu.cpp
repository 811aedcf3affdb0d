// SPDX-License-Identifier: MIT
#include "actions/action_menu.h"

#include "actions/action_details.h"
#include "desktop/settings.h"
#include "desktop/shortcuts.h"
#include "widgets/icon.h"
#include "widgets/text/tooltip_text.h"

#include <QMenuBar>
#include <QShortcut>
#include <QStatusBar>

#include <utility>

ActionMenu::ActionMenu(const MenuContext& context, const QString& title)
    : QMenu(title, context.window->menuBar()), m_context(context) {
    setToolTipsVisible(true); // show why an action is disabled
}

QAction* ActionMenu::create(const ActionSpec& spec) {
    auto* action = new QAction(spec.text, m_context.window);
    action->setObjectName(QLatin1String(spec.id));
    action->setIcon(view::icon(QLatin1String(spec.icon ? spec.icon : spec.id)));
    action->setShortcut(spec.shortcut);
    action->setStatusTip(spec.tip);
    action->setToolTip(spec.tip); // view::Tooltips appends name and shortcut
    action->setWhatsThis((spec.tip + QStringLiteral(". ") + actionDetails(spec.id)).trimmed());
    addShared(action);
    return action;
}

void ActionMenu::addShared(QAction* action) {
    if (action->whatsThis().isEmpty()) action->setWhatsThis(action->statusTip() + u'.');
    action->setWhatsThis(action->whatsThis() + u' ' + tr("In the menu %1.").arg(title().remove(u'&')));
    view::adoptShortcuts(*action);
    explainShortcut(action);
    addAction(action);
    m_context.window->addAction(action);
}

void ActionMenu::explainShortcut(QAction* action) {
    const auto explain = [action, text = action->whatsThis()] {
        const QString keys = action->shortcut().toString(QKeySequence::NativeText);
        const QString whole = keys.isEmpty() ? text : text + u' ' + tr("Shortcut: %1").arg(keys);
        if (action->whatsThis() != whole) action->setWhatsThis(whole);
    };
    explain();
    connect(action, &QAction::changed, action, explain);
}

QAction* ActionMenu::add(const ActionSpec& spec, const std::function<void()>& operation) {
    QAction* action = create(spec);
    connect(action, &QAction::triggered, this, [operation] { operation(); });
    return action;
}

QAction* ActionMenu::addToggle(const ActionSpec& spec, const std::function<void(bool)>& set) {
    QAction* action = create(spec);
    action->setCheckable(true);
    connect(action, &QAction::toggled, this, [set, setting = spec.setting](bool on) {
        set(on);
        if (setting) view::store(QLatin1String(setting), on);
    });
    if (spec.setting) {
        action->setChecked(view::stored(QLatin1String(spec.setting), spec.initially).toBool());
        set(action->isChecked());
    }
    return action;
}

void ActionMenu::addToolBarGroup(const QList<std::pair<QAction*, QString>>& actions) {
    QList<QAction*> group;
    for (const auto& [action, name] : actions) {
        action->setIconText(name);
        group << action;
    }
    m_toolBarGroups << group;
}

void ActionMenu::disableWhen(QAction* action, QString (*obstacle)(const document::Fractal&)) {
    auto* blocked = new QShortcut(action->shortcut(), m_context.window); // a disabled action has no shortcut
    connect(blocked, &QShortcut::activated, this,
            [this, obstacle] { m_context.messages->say(obstacle(m_context.document->fractal())); });
    auto update = [this, action, blocked, obstacle, toolTip = action->toolTip(),
                   statusTip = action->statusTip(), before = QString()]() mutable {
        const QString why = obstacle(m_context.document->fractal());
        if (const QString said = std::exchange(before, why); !said.isEmpty() && said != why)
            if (m_context.window->statusBar()->currentMessage() == said) // obsolete message
                m_context.window->statusBar()->clearMessage();
        action->setEnabled(why.isEmpty());
        action->setToolTip(why.isEmpty() ? toolTip : view::tooltipText(why));
        action->setStatusTip(why.isEmpty() ? statusTip : why);
        blocked->setEnabled(!why.isEmpty());
    };
    update();
    connect(action, &QAction::changed, blocked, [action, blocked] { blocked->setKey(action->shortcut()); });
    connect(m_context.document, &document::Document::changed, action, update);
}
