// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>

class QAction;
class QWidget;

namespace view {

// Lets a widget's own actions win their keys while it has the focus, even where the window uses the same
// ones: Ctrl+C in a list copies what is selected there. Owned by the widget.
class FocusShortcuts : public QObject {
    Q_OBJECT

public:
    explicit FocusShortcuts(QWidget* widget);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QAction* actionFor(const QEvent* event) const;

    QWidget* m_widget;
};

} // namespace view
