// SPDX-License-Identifier: MIT
#include "widgets/wheel_needs_focus.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QScrollBar>
#include <QTabBar>

namespace view {

namespace {

QWidget* valueWidget(QObject* object) {
    const bool hasValue = qobject_cast<QComboBox*>(object) || qobject_cast<QAbstractSpinBox*>(object) ||
                          qobject_cast<QTabBar*>(object) ||
                          (qobject_cast<QAbstractSlider*>(object) && !qobject_cast<QScrollBar*>(object));
    return hasValue ? static_cast<QWidget*>(object) : nullptr;
}

} // namespace

WheelNeedsFocus::WheelNeedsFocus(QCoreApplication* application) : QObject(application) {
    application->installEventFilter(this);
}

bool WheelNeedsFocus::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Polish && watched->isWidgetType()) {
        // No focus by the wheel: Qt gives the focus before it sends the wheel, even to a table, whose current
        // number then changes.
        auto* polished = static_cast<QWidget*>(watched);
        if (polished->focusPolicy() == Qt::WheelFocus) polished->setFocusPolicy(Qt::StrongFocus);
        return false;
    }
    if (event->type() != QEvent::Wheel) return false;
    const QWidget* widget = valueWidget(watched);
    if (!widget || widget->hasFocus()) return false;
    event->ignore(); // passed to the parent
    return true;
}

} // namespace view
