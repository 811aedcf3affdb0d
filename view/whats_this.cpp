// SPDX-License-Identifier: MIT
#include "whats_this.h"

#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
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
         {std::pair{QDialogButtonBox::Ok, WhatsThis::tr("Takes what the dialog shows, and closes it.")},
          {QDialogButtonBox::Cancel, WhatsThis::tr("Closes the dialog and changes nothing.")},
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
    if (button->whatsThis().isEmpty()) button->setWhatsThis(field.whatsThis());
}

} // namespace

void explainByTips(QWidget* root) {
    for (QAction* action : root->findChildren<QAction*>())
        if (action->whatsThis().isEmpty())
            action->setWhatsThis(action->statusTip().isEmpty() ? action->toolTip() : action->statusTip());
    for (auto* box : root->findChildren<QDialogButtonBox*>())
        explain(box);
    for (auto* combo : root->findChildren<QComboBox*>()) // the list that pops up is a window of its own
        if (combo->view()->accessibleName().isEmpty())
            combo->view()->setAccessibleName(combo->accessibleName());
    for (const auto* field : root->findChildren<QLineEdit*>())
        for (auto* button : field->findChildren<QToolButton*>())
            explainPart(button, *field);
    for (auto* widget : root->findChildren<QWidget*>()) {
        if (!widget->whatsThis().isEmpty()) continue;
        const auto* button = qobject_cast<QToolButton*>(widget);
        const bool acts = button && button->defaultAction();
        widget->setWhatsThis(acts ? button->defaultAction()->whatsThis() : widget->toolTip());
    }
}

} // namespace view
