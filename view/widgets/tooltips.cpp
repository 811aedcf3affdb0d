// SPDX-License-Identifier: MIT
#include "widgets/tooltips.h"

#include "widgets/numbers/number_box.h"
#include "widgets/numbers/number_field.h"
#include "widgets/numbers/number_text.h"
#include "widgets/text/elided_label.h"
#include "widgets/text/tooltip_text.h"

#include <QAbstractButton>
#include <QAction>
#include <QCoreApplication>
#include <QHelpEvent>
#include <QLabel>
#include <QToolButton>
#include <QToolTip>
#include <QWidget>

namespace view {

namespace {

const QAction* actionOf(const QWidget& widget) {
    const auto* button = qobject_cast<const QToolButton*>(&widget);
    return button ? button->defaultAction() : nullptr;
}

QString plainName(QString text) {
    if (text.endsWith(u'…')) text.chop(1);
    return text.remove(u'&');
}

QString nameOf(const QWidget& widget) {
    if (const QAction* action = actionOf(widget); action && !action->text().isEmpty())
        return plainName(action->text());
    if (!widget.accessibleName().isEmpty()) return widget.accessibleName();
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return plainName(button->text());
    for (const auto* label : widget.window()->findChildren<QLabel*>())
        if (label->buddy() == &widget) return plainName(label->text()).remove(u':');
    return {};
}

QString shortcutOf(const QWidget& widget) {
    if (const QAction* action = actionOf(widget))
        return action->shortcut().toString(QKeySequence::NativeText);
    const auto* button = qobject_cast<const QAbstractButton*>(&widget);
    // Excludes Alt with a letter, which is underlined in the text.
    return button && !button->text().contains(u'&') ? button->shortcut().toString(QKeySequence::NativeText)
                                                    : QString();
}

// The expression and its value for a field that shows one; all of a label that is cut.
QString contentOf(const QWidget& widget) {
    if (const auto* label = dynamic_cast<const ElidedLabel*>(&widget))
        return label->isCut() ? label->text() : QString();
    const auto equation = [](const QString& typed, double value) {
        return typed.isEmpty() ? QString() : typed + QStringLiteral(" = ") + fullNumber(value);
    };
    if (const auto* field = dynamic_cast<const NumberField*>(&widget))
        return equation(field->typedText(), field->value());
    if (const auto* box = dynamic_cast<const NumberBox*>(&widget))
        return equation(box->typedText(), box->value());
    if (const auto* box = dynamic_cast<const WholeNumberBox*>(&widget))
        return equation(box->typedText(), box->value());
    return {};
}

} // namespace

QString composedTip(const QWidget& widget) {
    QString tip = widget.toolTip();
    const QString content = contentOf(widget);
    if (tip.isEmpty()) return tooltipText(content);
    const QString name = nameOf(widget), keys = shortcutOf(widget);
    if (const QAction* action = actionOf(widget); action && tip == name) tip = action->statusTip();
    if (tip.isEmpty()) tip = name;
    if (const QString known = QStringLiteral(" (%1)").arg(keys); !keys.isEmpty() && tip.endsWith(known))
        tip.chop(known.size());                   // shown beside the name
    const bool isRich = Qt::mightBeRichText(tip); // already escaped
    QString head;
    if (!name.isEmpty()) head = QStringLiteral("<b>%1</b>").arg(name.toHtmlEscaped());
    if (!keys.isEmpty()) head += QStringLiteral("&nbsp;&nbsp;") + keys.toHtmlEscaped();
    if (!content.isEmpty())
        head += (head.isEmpty() ? QString() : QStringLiteral("<br>")) + content.toHtmlEscaped();
    if (tip == name) return head;
    const QString body =
        isRich ? tip : asSentence(tip).toHtmlEscaped().replace(u'\n', QStringLiteral("<br>"));
    return head.isEmpty() ? (isRich ? tip : tooltipText(asSentence(tip)))
                          : QStringLiteral("<p>%1<br>%2</p>").arg(head, body);
}

Tooltips::Tooltips(QCoreApplication* application) : QObject(application) {
    application->installEventFilter(this);
}

bool Tooltips::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ToolTip) return false;
    auto* widget = qobject_cast<QWidget*>(watched);
    const QString tip = widget ? composedTip(*widget) : QString();
    if (tip.isEmpty()) return false; // left to the view of the list, or to a parent
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), tip, widget, {},
                       widget->toolTipDuration());
    event->accept();
    return true;
}

} // namespace view
