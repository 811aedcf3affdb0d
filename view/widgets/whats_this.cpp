// SPDX-License-Identifier: MIT
#include "widgets/whats_this.h"

#include "widgets/text/tooltip_text.h"

#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>

namespace view {

namespace {

struct WhatsThis {
    Q_DECLARE_TR_FUNCTIONS(WhatsThis)
};

void explain(QDialogButtonBox* box) {
    for (const auto& [which, text] :
         {std::pair{QDialogButtonBox::Ok, WhatsThis::tr("Accepts the settings and closes the dialog.")},
          {QDialogButtonBox::Cancel, WhatsThis::tr("Closes the dialog without changing anything.")},
          {QDialogButtonBox::Close, WhatsThis::tr("Closes the dialog.")}})
        if (QPushButton* button = box->button(which); button && button->whatsThis().isEmpty())
            button->setWhatsThis(text);
}

// The toolkit's own buttons in a field say nothing of themselves.
void explainPart(QToolButton* button, const QLineEdit& field) {
    const QAction* action = button->defaultAction();
    const bool clears = action && action->objectName().startsWith(u"_q_");
    if (button->accessibleName().isEmpty())
        button->setAccessibleName(clears ? WhatsThis::tr("Clear") : field.accessibleName());
    if (button->toolTip().isEmpty()) button->setToolTip(button->accessibleName());
    if (button->whatsThis().isEmpty()) button->setWhatsThis(field.whatsThis());
}

// The text of a widget, followed by that of its panel, bar or dialog.
QString withPanel(const QString& tip, const QWidget* widget) {
    for (; widget; widget = widget->parentWidget())
        if (const auto* panel = qobject_cast<const QDockWidget*>(widget);
            panel && !panel->whatsThis().isEmpty())
            return WhatsThis::tr("%1 Panel “%2”: %3", "what it does, panel, what the panel is for")
                .arg(asSentence(tip), panel->windowTitle(), panel->whatsThis());
        else if (!widget->whatsThis().isEmpty())
            return asSentence(tip) + u' ' + widget->whatsThis();
    return tip;
}

// Returns true if the text is empty, or no more than the tip.
bool saysLittle(const QWidget& widget) {
    const QString text = widget.whatsThis();
    return text.isEmpty() || asSentence(text) == asSentence(widget.toolTip());
}

} // namespace

void explainByTips(QWidget* root) {
    for (QAction* action : root->findChildren<QAction*>())
        if (action->whatsThis().isEmpty())
            action->setWhatsThis(withPanel(action->statusTip().isEmpty() ? action->toolTip()
                                                                         : tooltipText(action->statusTip()),
                                           qobject_cast<const QWidget*>(action->parent())));
    for (auto* box : root->findChildren<QDialogButtonBox*>())
        explain(box);
    for (auto* combo : root->findChildren<QComboBox*>()) // the popup list is a window of its own
        if (combo->view()->accessibleName().isEmpty())
            combo->view()->setAccessibleName(combo->accessibleName());
    for (const auto* field : root->findChildren<QLineEdit*>())
        for (auto* button : field->findChildren<QToolButton*>())
            explainPart(button, *field);
    for (auto* widget : root->findChildren<QWidget*>()) {
        if (!saysLittle(*widget)) continue;
        const auto* button = qobject_cast<QToolButton*>(widget);
        const bool acts = button && button->defaultAction();
        widget->setWhatsThis(acts ? button->defaultAction()->whatsThis()
                             : widget->toolTip().isEmpty()
                                 ? QString()
                                 : withPanel(widget->toolTip(), widget->parentWidget()));
    }
}

} // namespace view
