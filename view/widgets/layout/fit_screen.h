// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QSize>

class QCoreApplication;
class QWidget;

namespace view {

// The room on the screen of a window for its content, without its frame.
QSize roomOnScreen(const QWidget& window);

// Keeps every dialog of the application within its screen as long as this object lives. A dialog whose
// contents need more room scrolls them above its buttons.
class FitScreen : public QObject {
public:
    explicit FitScreen(QCoreApplication* application);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace view
