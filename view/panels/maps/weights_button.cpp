// SPDX-License-Identifier: MIT
#include "panels/maps/weights_button.h"

#include "document/text/text.h"
#include "panels/maps/weight_rule_name.h"
#include "widgets/icon.h"
#include "widgets/menus/menu_button.h"

#include <QAction>
#include <QMenu>

namespace view {

QToolButton* makeWeightsButton(const std::function<void(document::WeightRule)>& apply, QWidget* parent,
                               QList<QAction*>& actions) {
    auto* menu = new QMenu(Text::tr("Weights"), parent);
    const auto add = [&](const char* iconName, const QString& text, const QString& tip,
                         document::WeightRule rule) {
        QAction* rules = menu->addAction(icon(QString::fromLatin1(iconName)), text, parent,
                                         [apply, rule] { apply(rule); });
        rules->setStatusTip(tip);
        rules->setToolTip(tip);
        actions.append(rules);
    };
    menu->setToolTipsVisible(true);
    add("weight-det", ruleName(document::WeightRule::Determinant), {}, document::WeightRule::Determinant);
    add("weight-equal", ruleName(document::WeightRule::Equal), Text::tr("The same weight for every map"),
        document::WeightRule::Equal);
    add("weight-dimension", ruleName(document::WeightRule::Dimension),
        Text::tr("Weights that cover the attractor evenly at its own dimension"),
        document::WeightRule::Dimension);
    menu->addSeparator();
    add("normalise", ruleName(document::WeightRule::Normalise),
        Text::tr("Scale all weights so that they sum to 1"), document::WeightRule::Normalise);
    auto* made = new MenuButton(parent);
    made->setText(Text::tr("Weights"));
    made->setIcon(icon(QStringLiteral("weight-equal")));
    made->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    made->setMenu(menu);
    made->setAutoRaise(true);
    made->setToolTip(Text::tr("Set the weights of all maps that are switched on by a rule"));
    made->setAccessibleName(Text::tr("Weights"));
    return made;
}

} // namespace view
