// SPDX-License-Identifier: MIT
#include "widgets/flat_buttons.h"

#include "widgets/icon.h"

#include <QAction>
#include <QHBoxLayout>
#include <QToolButton>

namespace view {

namespace {

constexpr QSize iconSize(18, 18);

} // namespace

QToolButton* flatButton(const QString& iconName, const QString& text, const QString& tip, QWidget* parent) {
    auto* made = new QToolButton(parent);
    if (iconName.isEmpty())
        made->setText(text);
    else
        made->setIcon(icon(iconName));
    made->setIconSize(iconSize);
    made->setAutoRaise(true);
    made->setAccessibleName(text);
    made->setToolTip(tip);
    return made;
}

QWidget* buttonBar(const QList<QAction*>& actions, const QAction* firstAtTheEnd, QWidget* parent) {
    auto* bar = new QWidget(parent);
    auto* layout = new QHBoxLayout(bar);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(1);
    for (QAction* action : actions) {
        if (action == firstAtTheEnd) layout->addStretch();
        auto* button = new QToolButton(bar);
        button->setDefaultAction(action);
        button->setAutoRaise(true);
        button->setIconSize(iconSize);
        button->setAccessibleName(action->text().remove(QLatin1Char('&')));
        layout->addWidget(button);
    }
    return bar;
}

} // namespace view
