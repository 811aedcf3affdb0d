// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QSize>

class QCoreApplication;
class QWidget;

namespace view {

// The room that the screen of a window leaves to what is inside its frame.
QSize roomOnScreen(const QWidget& window);

// No dialog is larger than its screen. One whose contents need more room scrolls them above its buttons. For
// all dialogs of the application, as long as this lives.
class FitScreen : public QObject {
public:
    explicit FitScreen(QCoreApplication* application);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace view
