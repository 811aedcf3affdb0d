// SPDX-License-Identifier: MIT
#pragma once

#include "messages/message_banner.h"

#include <functional>

class QAction;

// Suggestions of what to try next, as a row of buttons at the bottom of the canvas. They go away by
// themselves: as soon as one is pressed, as soon as the user does anything else, and after a while.
class FirstChips : public MessageBanner {
    Q_OBJECT

public:
    struct Chip {
        QAction* action; // command of the button, with its icon
        QString text;
        std::function<void()> then = {}; // once the action has been triggered
    };
    static constexpr int usualPatience = 20'000; // milliseconds
    FirstChips(QMainWindow* host, const QList<Chip>& chips, int patience = usualPatience);

protected:
    int widthFor(int room) const override;
    QPoint topLeft() override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void paintEvent(QPaintEvent*) override {} // paints nothing but the buttons

private:
    QTimer m_away;
};
