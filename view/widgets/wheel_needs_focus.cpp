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
    if (event->type() != QEvent::Polish && event->type() != QEvent::Wheel) return false;
    QWidget* widget = valueWidget(watched);
    if (!widget) return false;
    if (event->type() == QEvent::Polish) {
        // Qt gives the focus before it sends the wheel.
        if (widget->focusPolicy() == Qt::WheelFocus) widget->setFocusPolicy(Qt::StrongFocus);
        return false;
    }
    if (widget->hasFocus()) return false;
    event->ignore(); // the parent gets it
    return true;
}

} // namespace view
