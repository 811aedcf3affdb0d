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
    void showStep(int step); // if there is one

signals:
    void playingChanged(bool isPlaying);
    void problem(const QString& sentence); // about parts that a step could not show

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void createCard();
    void showCard();
    void takeBack();
    void forgetOwnSteps(); // of the history
    void showPanels(const QStringList& ids);
    void showConstructionBar(bool shown);
    void keepView();
    bool isViewKept() const;

    LessonParts m_parts;
    QAction* m_presentation;
    QDockWidget* m_dock = nullptr; // made when the first lesson is played
    view::LessonCard* m_card = nullptr;
    document::Lesson m_lesson;
    int m_step = 0;
    bool m_isPlaying = false;
    bool m_wasPresentation = false;
    bool m_wasConstructionShown = false;
    document::LessonState m_before; // of the window
    document::EntryId m_beforeEntry = document::EntryId::None;
    int m_base = 0;               // the place in the history at which every step starts
    int m_shown = 0;              // the place at which the present step is shown
    bool m_hasOwnSteps = false;   // a step of the lesson has edited the file
    bool m_hasOthersEdit = false; // and somebody else since
    bool m_isShowing = false;     // a step
    attractor::Camera m_camera;   // as the step has set it
    attractor::OrbitCamera m_orbit;
};
