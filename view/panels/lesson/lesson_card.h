// SPDX-License-Identifier: MIT
#pragma once

#include <QFrame>

class QLabel;
class QPushButton;
class QScrollArea;

namespace document {
struct Lesson;
}

namespace view {

// The step of a lesson as the class reads it: title and text in letters that grow with the window, and the
// buttons that lead on and back. It stands beside the canvas, so that it covers nothing.
class LessonCard : public QFrame {
    Q_OBJECT

public:
    explicit LessonCard(QWidget* parent = nullptr);

    void showStep(const document::Lesson& lesson, int step);
    void takeFocus(); // puts the focus on the button that leads on

signals:
    void nextRequested(); // not sent on the last step
    void backRequested();
    void endRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void adaptLetters();
    bool takeKey(int key);

    QLabel* m_lesson;
    QLabel* m_progress;
    QLabel* m_title;
    QLabel* m_text;
    QScrollArea* m_scroll;
    QPushButton* m_back;
    QPushButton* m_next;
    QPushButton* m_end;
    bool m_isFirst = true;
    bool m_isLast = false;
};

} // namespace view
