// SPDX-License-Identifier: MIT
#pragma once

#include <QList>
#include <QString>

class QAction;
class QToolButton;
class QWidget;

namespace view {

// A small button without a frame. It shows its icon or, if `iconName` is empty, its text.
QToolButton* flatButton(const QString& iconName, const QString& text, const QString& tip, QWidget* parent);

// A row of small buttons without frames, those from `firstAtTheEnd` on at its end.
QWidget* buttonBar(const QList<QAction*>& actions, const QAction* firstAtTheEnd, QWidget* parent);

} // namespace view
