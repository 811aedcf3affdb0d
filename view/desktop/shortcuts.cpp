// SPDX-License-Identifier: MIT
#include "desktop/shortcuts.h"

#include "desktop/settings.h"

#include <QAction>
#include <QApplication>
#include <QCoreApplication>
#include <QWidget>

#include <algorithm>
#include <iterator>

namespace view {

namespace {

struct ShortcutText {
    Q_DECLARE_TR_FUNCTIONS(view::Shortcuts)
};

constexpr const char* usualProperty = "usualShortcuts";

QString settingOf(const QString& command) {
    return QStringLiteral("shortcuts/") + command;
}

std::optional<Shortcuts> storedShortcuts(const QString& command) {
    const QVariant text = stored(settingOf(command));
    if (!text.isValid()) return std::nullopt;
    Shortcuts keys = QKeySequence::listFromString(text.toString(), QKeySequence::PortableText);
    keys.removeAll(QKeySequence()); // result of an empty text
    return keys;
}

} // namespace

void adoptShortcuts(QAction& action) {
    action.setProperty(usualProperty, QVariant::fromValue(action.shortcuts()));
    if (const auto keys = storedShortcuts(action.objectName())) action.setShortcuts(*keys);
}

Shortcuts usualShortcuts(const QAction& action) {
    return action.property(usualProperty).value<Shortcuts>();
}

void setShortcuts(const QString& command, const std::optional<Shortcuts>& keys) {
    store(settingOf(command),
          keys ? QVariant(QKeySequence::listToString(*keys, QKeySequence::PortableText)) : QVariant());
    for (const QWidget* window : QApplication::topLevelWidgets())
        for (QAction* action : window->actions())
            if (action->objectName() == command) action->setShortcuts(keys.value_or(usualShortcuts(*action)));
}

QString toPress(const QString& command, const QKeySequence& usual) {
    for (const QWidget* window : QApplication::topLevelWidgets())
        for (const QAction* action : window->actions())
            if (action->objectName() == command)
                return action->shortcut().isEmpty()
                           ? ShortcutText::tr("“%1”").arg(action->text().remove(u'&').remove(u'…'))
                           : action->shortcut().toString(QKeySequence::NativeText);
    return usual.toString(QKeySequence::NativeText);
}

QString shortcutObstacle(const QKeySequence& keys) {
    if (keys.isEmpty()) return {};
    constexpr Qt::Key ours[] = {Qt::Key_Left,  Qt::Key_Right,     Qt::Key_Up,    Qt::Key_Down,   Qt::Key_Tab,
                                Qt::Key_Space, Qt::Key_Return,    Qt::Key_Enter, Qt::Key_Escape, Qt::Key_Home,
                                Qt::Key_End,   Qt::Key_Backspace, Qt::Key_F6};
    const QKeyCombination first = keys[0];
    const bool isPlain = (first.keyboardModifiers() & ~Qt::ShiftModifier) == 0;
    if (!isPlain || std::ranges::find(ours, first.key()) == std::end(ours)) return {};
    return ShortcutText::tr("“%1” is used on the canvas and in fields. Choose other keys.")
        .arg(QKeySequence(first).toString(QKeySequence::NativeText));
}

} // namespace view
