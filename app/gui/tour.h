// SPDX-License-Identifier: MIT
#pragma once

#include <QFrame>
#include <QPointer>

class QLabel;
class QMainWindow;
class QPushButton;

// Six short steps through the window itself: a card that says what to do, a frame around where to do it.
// Nothing is locked meanwhile. Deletes itself when closed; what the tour opened is then as before.
class Tour : public QFrame {
    Q_OBJECT

public:
    // The newest tour of the window, from its first step.
    static void start(QMainWindow* window);
    // Asks once in the life of the settings whether one would like to.
    static void offer(QMainWindow* window);

    int step() const { return m_step; } // -1: asking
    QWidget* target() const { return m_target; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    explicit Tour(QMainWindow* window);
    ~Tour() override;

    void showStep(int step);
    void leaveStep();
    void place();

    QMainWindow* m_window;
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
