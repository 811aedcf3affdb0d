// SPDX-License-Identifier: MIT
#pragma once

#include <QList>
#include <QWidget>

class QAction;

namespace view {

// Instead of an empty table: loops that one click makes, as large buttons with names, and how to make keys.
class MotionPage : public QWidget {
    Q_OBJECT

public:
    // A button for each action; those with a menu open it.
    explicit MotionPage(const QList<QAction*>& actions, QWidget* parent = nullptr);

signals:
    void tableWanted(); // the rows, to make keys
};

} // namespace view
