// SPDX-License-Identifier: MIT
#pragma once

#include "document/lesson/lesson.h"

#include <QHash>
#include <QObject>
#include <QUndoStack>

namespace view {

// The lesson of a window, while it is written: its steps, one of which is current, and a history of its own.
// No part of the document: writing a lesson changes no fractal.
class LessonNotebook : public QObject {
    Q_OBJECT

public:
    explicit LessonNotebook(QObject* parent = nullptr);
    ~LessonNotebook() override;

    const document::Lesson& lesson() const { return m_lesson; }
    bool isEmpty() const { return m_lesson.steps.isEmpty() && m_lesson.title.isEmpty(); }
    int current() const { return m_current; }                      // −1 if there is no step
    void setCurrent(int step);                                     // step chosen by the user
    int firstToPlay() const { return m_isChosen ? m_current : 0; } // chosen step, or the first
    const document::LessonStep* currentStep() const;               // nullptr if there is none

    QString path() const { return m_path; } // empty before the first save
    bool isModified() const { return !m_history.isClean(); }
    void open(document::Lesson lesson, const QString& path); // clears the history
    void markSaved(const QString& path);
    void setFile(const QString& name); // .ifs file of the lesson; no step of the history
    void moveTo(const QString& name);  // other .ifs file, not saved yet
    // Entries have other names now: so have steps that show them, of all times. No step of the history.
    void followRenamed(const QHash<QString, QString>& renamed);

    QUndoStack* history() { return &m_history; }
    // Edits of one undo step each; typing in one field is one step.
    void setTitle(const QString& title);
    // After the current one or, while none of an opened lesson was chosen, at the end; it becomes current.
    void addStep(const document::LessonState& state);
    void setState(const document::LessonState& state);
    void setStepTitle(const QString& title);
    void setText(const QString& text);
    void removeStep();
    void moveStep(int by);

signals:
    void changed(); // sent for the lesson, its path, the current step, and saving

private:
    friend class LessonCommand;
    enum class Field { None, Title, StepTitle, Text };
    struct Page {
        document::Lesson lesson;
        int current = -1;
    };

    void push(const QString& text, Page after, Field field = Field::None);
    void show(const Page& page);
    Page page() const { return {m_lesson, m_current}; }

    document::Lesson m_lesson;
    int m_current = -1;
    bool m_isChosen = false;   // it is not only where the last step was added
    bool m_isAsOpened = false; // the lesson: nobody has said which step is current
    QString m_path;
    QUndoStack m_history;
};

} // namespace view
