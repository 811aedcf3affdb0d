// SPDX-License-Identifier: MIT
#pragma once

#include "card.h"

#include <QPointer>

class QPushButton;

// Six short steps through the window itself: a card that says what to do, a frame around where to do it.
// Nothing is locked meanwhile. Deletes itself when closed; what the tour opened is then as before.
class Tour : public Card {
    Q_OBJECT

public:
    // The newest tour of the window, from its first step.
    static void start(QMainWindow* window);
    // Asks once in the life of the settings whether one would like to; false afterwards.
    static bool offer(QMainWindow* window);

    int step() const { return m_step; } // -1: asking
    QWidget* target() const { return m_target; }

protected:
    QPoint corner() override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    explicit Tour(QMainWindow* host);
    ~Tour() override;

    void showStep(int step);
    void leaveStep();

    QPointer<QWidget> m_mark; // the frame around the target
    QPointer<QWidget> m_target;
    int m_step = -1;
    bool m_barWasHidden = false;
    QLabel* m_place;
    QLabel* m_title;
    QLabel* m_text;
    QPushButton* m_back;
    QPushButton* m_next;
    QPushButton* m_close;
};
