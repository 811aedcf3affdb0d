// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"
#include "lessons/lesson_state.h"

#include <QObject>
#include <QPointer>

class QAction;
class QDockWidget;
namespace view {
class LessonCard;
}

// Plays a lesson in the presentation: one step after the other, its text beside the canvas. Every step starts
// from the file as it was when the lesson began, and so does the window when it ends: what others than the
// lesson have changed in between can be had back by Redo. docs/decisions/0024.
class LessonPlayer : public QObject {
    Q_OBJECT

public:
    LessonPlayer(const LessonParts& parts, QAction* presentation);

    void play(const document::Lesson& lesson, int from);
    void stop();
    bool isPlaying() const { return m_isPlaying; }
    int step() const { return m_step; }
    const document::FractalFile& file() const { return m_file; } // at which every step starts
    void showStep(int step);                                     // ignores numbers out of range

signals:
    void playingChanged(bool isPlaying);
    void problem(const QString& sentence); // names parts that a step could not show

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void createCard();
    void showCard();
    void takeBack();
    void forgetOwnSteps(); // removes them from the history
    void showPanels(const QStringList& ids);
    void showConstructionBar(bool shown);
    void keepView();
    bool isViewKept() const;

    LessonParts m_parts;
    QAction* m_presentation;
    QDockWidget* m_dock = nullptr; // null until the first lesson is played
    view::LessonCard* m_card = nullptr;
    document::Lesson m_lesson;
    int m_step = 0;
    bool m_isPlaying = false;
    bool m_wasPresentation = false;
    bool m_wasConstructionShown = false;
    document::LessonState m_before; // state of the window before the lesson
    document::EntryId m_beforeEntry = document::EntryId::None;
    document::FractalFile m_file;
    int m_base = 0;               // index in the history at which every step starts
    int m_shown = 0;              // index in the history at which the present step is shown
    bool m_hasOwnSteps = false;   // a step of the lesson has edited the file
    bool m_hasOthersEdit = false; // somebody else has edited the file since
    bool m_isShowing = false;     // true while a step is being shown
    attractor::Camera m_camera;   // camera set by the step
    attractor::OrbitCamera m_orbit;
};
