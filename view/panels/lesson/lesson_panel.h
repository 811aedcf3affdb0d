// SPDX-License-Identifier: MIT
#pragma once

#include <QPair>
#include <QWidget>

class QAction;
class QLabel;
class QLineEdit;
class QListWidget;
class QMenu;
class QPlainTextEdit;
class QPushButton;

namespace view {

class LessonNotebook;

// Editor of a lesson: its steps, the text of one of them, and the buttons that take the state of the window,
// play and save.
class LessonPanel : public QWidget {
    Q_OBJECT

public:
    explicit LessonPanel(LessonNotebook* notebook, QWidget* parent = nullptr);

    // The panels that a step may show besides the canvas: ids and names.
    void setPanels(const QList<QPair<QString, QString>>& panels);
    void beginToWrite(); // puts the focus on the title of the current step

signals:
    void addRequested();    // sent to add a step with the present state of the window
    void updateRequested(); // sent to replace the current step by the present state of the window
    void showRequested();   // sent to give the window the state of the current step
    void playRequested();
    void saveRequested();

private:
    void createActions();
    void createFields();
    void takeText();
    void layOut();
    void follow();
    void followSteps();
    void choosePanel(const QString& id, bool shown);

    LessonNotebook* m_notebook;
    QLineEdit* m_title;
    QListWidget* m_steps;
    QLabel* m_hint;
    QWidget* m_fields;
    QLineEdit* m_stepTitle;
    QPlainTextEdit* m_text;
    QMenu* m_panels;
    QPushButton* m_play;
    QPushButton* m_save;
    QAction* m_add = nullptr;
    QAction* m_update = nullptr;
    QAction* m_show = nullptr;
    QAction* m_remove = nullptr;
    QAction* m_up = nullptr;
    QAction* m_down = nullptr;
    QAction* m_undo = nullptr;
    QAction* m_redo = nullptr;
    bool m_isFollowing = false;
};

} // namespace view
