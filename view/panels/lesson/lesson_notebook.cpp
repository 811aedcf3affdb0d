// SPDX-License-Identifier: MIT
#include "panels/lesson/lesson_notebook.h"

#include <algorithm>
#include <utility>

namespace view {

// Returns true if a step showed one of them.
static bool renameEntries(document::Lesson& lesson, const QHash<QString, QString>& renamed) {
    bool isShown = false;
    for (document::LessonStep& step : lesson.steps)
        if (const auto now = renamed.constFind(step.state.entry); now != renamed.cend()) {
            step.state.entry = *now;
            isShown = true;
        }
    return isShown;
}

class LessonCommand : public QUndoCommand {
public:
    // Consecutive commands of the same kind merge; −1: never.
    LessonCommand(LessonNotebook& notebook, const QString& text, LessonNotebook::Page before,
                  LessonNotebook::Page after, int kind)
        : QUndoCommand(text),
          m_notebook(notebook),
          m_before(std::move(before)),
          m_after(std::move(after)),
          m_kind(kind) {}

    void undo() override { m_notebook.show(m_before); }
    void redo() override { m_notebook.show(m_after); }
    int id() const override { return m_kind; }
    void followRenamed(const QHash<QString, QString>& renamed) {
        renameEntries(m_before.lesson, renamed);
        renameEntries(m_after.lesson, renamed);
    }
    bool mergeWith(const QUndoCommand* other) override {
        m_after = static_cast<const LessonCommand*>(other)->m_after;
        return true;
    }

private:
    LessonNotebook& m_notebook;
    LessonNotebook::Page m_before;
    LessonNotebook::Page m_after;
    int m_kind;
};

LessonNotebook::LessonNotebook(QObject* parent) : QObject(parent) {
    m_history.setUndoLimit(500);
    connect(&m_history, &QUndoStack::cleanChanged, this, &LessonNotebook::changed);
    connect(&m_history, &QUndoStack::indexChanged, this, &LessonNotebook::changed);
}

LessonNotebook::~LessonNotebook() {
    m_history.disconnect(this); // cleared only after its listeners have gone
}

const document::LessonStep* LessonNotebook::currentStep() const {
    return m_current < 0 ? nullptr : &m_lesson.steps[m_current];
}

void LessonNotebook::setCurrent(int step) {
    if (step < 0 || step >= m_lesson.steps.size()) return;
    m_isChosen = true;
    m_isAsOpened = false;
    if (std::exchange(m_current, step) != step) emit changed();
}

void LessonNotebook::open(document::Lesson lesson, const QString& path) {
    m_path = path;
    m_lesson = std::move(lesson);
    m_current = m_lesson.steps.isEmpty() ? -1 : 0;
    m_isChosen = false;
    m_isAsOpened = true;
    m_history.clear();
    emit changed();
}

void LessonNotebook::markSaved(const QString& path) {
    m_path = path;
    m_history.setClean();
    emit changed();
}

void LessonNotebook::setFile(const QString& name) {
    m_lesson.file = name;
}

void LessonNotebook::followRenamed(const QHash<QString, QString>& renamed) {
    if (!renameEntries(m_lesson, renamed)) return;
    for (int i = 0; i < m_history.count(); ++i) // made here, and not const
        static_cast<LessonCommand*>(const_cast<QUndoCommand*>(m_history.command(i)))->followRenamed(renamed);
    m_history.resetClean(); // the file of the lesson has the old names
    emit changed();
}

void LessonNotebook::moveTo(const QString& name) {
    setFile(name);
    m_history.resetClean();
    emit changed();
}

void LessonNotebook::show(const Page& page) {
    const QString file = m_lesson.file;
    m_lesson = page.lesson;
    m_lesson.file = file;
    m_current = page.current;
    emit changed();
}

void LessonNotebook::push(const QString& text, Page after, Field field) {
    if (after.lesson == m_lesson) return;
    constexpr int fields = 4;
    const int kind = field == Field::None ? -1 : m_current * fields + int(field) + fields;
    m_history.push(new LessonCommand(*this, text, page(), std::move(after), kind));
}

void LessonNotebook::setTitle(const QString& title) {
    Page after = page();
    after.lesson.title = document::lessonLine(title);
    push(tr("Rename lesson"), std::move(after), Field::Title);
}

void LessonNotebook::addStep(const document::LessonState& state) {
    if (m_lesson.steps.size() >= document::maxLessonSteps) return;
    Page after = page();
    after.current = m_isAsOpened ? int(m_lesson.steps.size()) : m_current + 1;
    after.lesson.steps.insert(after.current, document::LessonStep{{}, {}, state, {}});
    push(tr("Add step"), std::move(after));
    m_isChosen = m_isAsOpened = false;
}

void LessonNotebook::setState(const document::LessonState& state) {
    if (m_current < 0) return;
    Page after = page();
    after.lesson.steps[m_current].state = state;
    push(tr("Update step"), std::move(after));
}

void LessonNotebook::setStepTitle(const QString& title) {
    if (m_current < 0) return;
    Page after = page();
    after.lesson.steps[m_current].title = document::lessonLine(title);
    push(tr("Rename step"), std::move(after), Field::StepTitle);
}

void LessonNotebook::setText(const QString& text) {
    if (m_current < 0) return;
    Page after = page();
    after.lesson.steps[m_current].text = document::lessonText(text);
    push(tr("Edit text"), std::move(after), Field::Text);
}

void LessonNotebook::removeStep() {
    if (m_current < 0) return;
    Page after = page();
    after.lesson.steps.removeAt(m_current);
    after.current = std::min(m_current, int(after.lesson.steps.size()) - 1);
    push(tr("Remove step"), std::move(after));
}

void LessonNotebook::moveStep(int by) {
    const int to = m_current + by;
    if (m_current < 0 || to < 0 || to >= m_lesson.steps.size()) return;
    Page after = page();
    after.lesson.steps.move(m_current, to);
    after.current = to;
    push(tr("Move step"), std::move(after));
}

} // namespace view
