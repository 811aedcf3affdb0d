// SPDX-License-Identifier: MIT
#include "lessons/lesson_player.h"

#include "document/document.h"
#include "panels/lesson/lesson_card.h"
#include "stage/stage.h"

#include <QAction>
#include <QDockWidget>
#include <QEvent>
#include <QScopedValueRollback>
#include <QToolBar>
#include <QUndoCommand>

#include <algorithm>
#include <utility>

namespace {

constexpr double cardShare = 0.3; // share of the window's width
constexpr int minCardWidth = 300;
constexpr int maxCardWidth = 760;

bool isConstruction(const document::LessonStep& step) {
    return step.state.construction.mode != document::LessonConstruction::Mode::Density;
}

} // namespace

LessonPlayer::LessonPlayer(const LessonParts& parts, QAction* presentation)
    : QObject(parts.window), m_parts(parts), m_presentation(presentation) {
    connect(presentation, &QAction::toggled, this, [this](bool on) {
        if (!on) stop();
    });
    connect(parts.document, &document::Document::changed, this, [this](const document::Change& change) {
        if (m_isPlaying && change.parts & document::Change::File) { // another file, without these steps
            m_base = 0;
            stop();
        }
    });
    connect(parts.document->undoStack(), &QUndoStack::indexChanged, this, [this](int index) {
        m_base = std::min(m_base, std::max(0, m_parts.document->undoStack()->count() - 1));
        if (m_isPlaying && !m_isShowing && index > m_shown) m_hasOthersEdit = true;
    });
    parts.stage->plane()->viewport()->installEventFilter(this);
    parts.stage->space()->viewport()->installEventFilter(this);
}

void LessonPlayer::createCard() {
    m_dock = new QDockWidget(m_parts.window);
    m_dock->setObjectName(QStringLiteral("lesson-text"));
    m_dock->setTitleBarWidget(new QWidget(m_dock));
    m_dock->setFeatures(QDockWidget::NoDockWidgetFeatures);
    m_dock->hide();
    m_card = new view::LessonCard(m_dock);
    m_dock->setWidget(m_card);
    m_parts.window->addDockWidget(Qt::LeftDockWidgetArea, m_dock);
    connect(m_card, &view::LessonCard::nextRequested, this, [this] { showStep(m_step + 1); });
    connect(m_card, &view::LessonCard::backRequested, this, [this] { showStep(m_step - 1); });
    connect(m_card, &view::LessonCard::endRequested, this, &LessonPlayer::stop);
}

void LessonPlayer::play(const document::Lesson& lesson, int from) {
    if (lesson.steps.isEmpty()) return;
    stop();
    m_parts.stage->cancelGesture(); // a gesture would add a step to the history
    m_lesson = lesson;
    m_before = lessonState(m_parts);
    m_before.cage = {}; // the history restores what belongs to the fractal
    m_before.colourBy.reset();
    m_before.entry.clear();
    m_beforeEntry = m_parts.document->currentId();
    m_base = m_parts.document->undoStack()->index();
    m_file = m_parts.document->file();
    m_wasPresentation = m_presentation->isChecked();
    const auto* bar = m_parts.window->findChild<QToolBar*>(QStringLiteral("construction"));
    m_wasConstructionShown = bar && !bar->isHidden();
    if (!m_dock) createCard();
    m_presentation->setChecked(true);
    showConstructionBar(std::ranges::any_of(lesson.steps, isConstruction)); // all the time: it moves the card
    m_isPlaying = true;
    m_hasOwnSteps = m_hasOthersEdit = false;
    showStep(std::clamp(from, 0, int(lesson.steps.size()) - 1));
    showCard();
    emit playingChanged(true);
}

void LessonPlayer::showCard() {
    m_dock->show();
    const int wanted = std::clamp(int(cardShare * m_parts.window->width()), minCardWidth, maxCardWidth);
    m_parts.window->resizeDocks({m_dock}, {wanted}, Qt::Horizontal);
    m_card->takeFocus();
}

void LessonPlayer::takeBack() {
    m_parts.stage->cancelGesture();
    QUndoStack* history = m_parts.document->undoStack();
    if (history->index() != m_base && m_base <= history->count()) history->setIndex(m_base);
}

// Drops the redo steps of the lesson itself, which would bring back its states and mark the file as changed.
// The history forgets redo steps when a step is added, and an obsolete one when it is undone.
void LessonPlayer::forgetOwnSteps() {
    if (!m_hasOwnSteps || m_hasOthersEdit) return;
    auto* last = new QUndoCommand;
    m_parts.document->undoStack()->push(last);
    last->setObsolete(true);
    m_parts.document->undoStack()->undo();
}

void LessonPlayer::showStep(int step) {
    if (!m_isPlaying || step < 0 || step >= m_lesson.steps.size()) return;
    const QScopedValueRollback<bool> showing(m_isShowing, true);
    m_step = step;
    takeBack();
    const document::LessonState& state = m_lesson.steps[step].state;
    showPanels(state.panels);
    m_card->showStep(m_lesson, step);
    m_parts.stage->plane()->setHint({});
    const QString sentence = showLessonState(m_parts, state);
    keepView();
    m_shown = m_parts.document->undoStack()->index();
    if (m_shown > m_base) {
        m_hasOwnSteps = true;
        m_hasOthersEdit = false;
    }
    if (!sentence.isEmpty()) emit problem(sentence);
}

void LessonPlayer::stop() {
    if (!std::exchange(m_isPlaying, false)) return;
    takeBack();
    forgetOwnSteps();
    m_dock->hide();
    m_file = {};
    if (m_wasPresentation)
        showPanels({});
    else
        m_presentation->setChecked(false);
    m_parts.document->setCurrent(m_beforeEntry);
    showLessonState(m_parts, m_before);
    showConstructionBar(m_wasConstructionShown);
    emit playingChanged(false);
}

void LessonPlayer::showPanels(const QStringList& ids) {
    for (auto* panel : m_parts.window->findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly)) {
        if (panel == m_dock) continue;
        const bool isShown = ids.contains(panel->objectName());
        if (isShown != panel->isHidden()) continue;
        panel->setVisible(isShown);
        if (isShown) panel->raise();
    }
}

void LessonPlayer::showConstructionBar(bool shown) {
    if (auto* bar = m_parts.window->findChild<QToolBar*>(QStringLiteral("construction")))
        bar->setVisible(shown);
}

void LessonPlayer::keepView() {
    m_camera = m_parts.stage->plane()->camera();
    m_orbit = m_parts.stage->space()->navigation().camera();
}

// Returns true if the view is as the step has set it, whatever the size of the canvas.
bool LessonPlayer::isViewKept() const {
    if (m_parts.stage->showsSpace()) {
        const attractor::OrbitCamera& now = m_parts.stage->space()->navigation().camera();
        return now.target == m_orbit.target && now.height == m_orbit.height &&
               now.orientation.coeffs() == m_orbit.orientation.coeffs();
    }
    const attractor::Camera& now = m_parts.stage->plane()->camera();
    return now.centre == m_camera.centre && now.pixelsPerUnit == m_camera.pixelsPerUnit &&
           now.rotation == m_camera.rotation;
}

// The area of a step fills the canvas, also when that gets its size later: once its own handlers are done.
bool LessonPlayer::eventFilter(QObject* watched, QEvent* event) {
    if (m_isPlaying && event->type() == QEvent::Resize && isViewKept())
        QMetaObject::invokeMethod(
            this,
            [this] {
                if (!m_isPlaying || !isViewKept()) return;
                showLessonView(m_parts, m_lesson.steps[m_step].state);
                keepView();
            },
            Qt::QueuedConnection);
    return QObject::eventFilter(watched, event);
}
