// SPDX-License-Identifier: MIT
#pragma once

#include "document/lesson/lesson.h"

#include <QMainWindow>

class Stage;
namespace document {
class Document;
}
namespace view {
class AnalysisBridge;
class Construction;
} // namespace view

// The parts of a window whose state a step of a lesson keeps.
struct LessonParts {
    QMainWindow* window;
    document::Document* document;
    Stage* stage;
    view::AnalysisBridge* analysis;
    view::Construction* construction;
};

// The present state of the window, without its panels.
document::LessonState lessonState(const LessonParts& parts);

// Brings the window into that state, its panels excepted. Colours and cages that differ from the entry are
// one step of the history. Returns what could not be shown, as a sentence; empty when all could.
QString showLessonState(const LessonParts& parts, const document::LessonState& state);
// Restores the view alone, such as after the canvas has changed its size.
void showLessonView(const LessonParts& parts, const document::LessonState& state);
