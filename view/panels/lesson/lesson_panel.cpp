// SPDX-License-Identifier: MIT
#include "panels/lesson/lesson_panel.h"

#include "panels/lesson/lesson_notebook.h"
#include "widgets/flat_buttons.h"
#include "widgets/icon.h"
#include "widgets/menus/menu_button.h"
#include "widgets/text/text_edit_workarounds.h"
#include "widgets/whats_this.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace view {

namespace {

constexpr int linesOfHint = 6; // in the longest language

} // namespace

LessonPanel::LessonPanel(LessonNotebook* notebook, QWidget* parent)
    : QWidget(parent),
      m_notebook(notebook),
      m_title(new QLineEdit(this)),
      m_steps(new QListWidget(this)),
      m_hint(new QLabel(tr("Arrange the window as you want to show it, and press Add Step. Then write the "
                           "text of the step."),
                        this)),
      m_fields(new QWidget(this)),
      m_stepTitle(new QLineEdit(m_fields)),
      m_text(new TextEditWithWorkarounds<QPlainTextEdit>(m_fields)),
      m_panels(new QMenu(this)),
      m_play(new QPushButton(icon(QStringLiteral("play")), tr("&Play"), this)),
      m_save(new QPushButton(icon(QStringLiteral("save")), tr("Save &Lesson…"), this)) {
    setAccessibleName(tr("Lesson"));
    createActions();
    createFields();
    layOut();
    explainByTips(this);
    connect(notebook, &LessonNotebook::changed, this, &LessonPanel::follow);
    follow();
}

void LessonPanel::createActions() {
    const auto make = [this](const char* name, const QString& text, const QString& tip, auto operation) {
        auto* action = new QAction(icon(QLatin1String(name)), text, this);
        action->setObjectName(QStringLiteral("lesson-") + QLatin1String(name));
        action->setToolTip(tip);
        action->setStatusTip(tip);
        action->setWhatsThis(
            tr("%1. A lesson is a list of steps. Each has a text, and the state of the window "
               "that belongs to it: the entry, the view, the tool, colours and outlines.")
                .arg(tip));
        connect(action, &QAction::triggered, this, operation);
        return action;
    };
    m_add = make("add", tr("Add Step"), tr("Add a step with the current state of the window"),
                 [this] { emit addRequested(); });
    m_update = make("reset", tr("Update Step"),
                    tr("Replace the state of the selected step by the current state of the window"),
                    [this] { emit updateRequested(); });
    m_show = make("fit", tr("Show Step"), tr("Restore the window to the state of the selected step"),
                  [this] { emit showRequested(); });
    m_remove = make("remove", tr("Remove Step"), tr("Remove the selected step"),
                    [this] { m_notebook->removeStep(); });
    m_up =
        make("up", tr("Move Up"), tr("Show the selected step earlier"), [this] { m_notebook->moveStep(-1); });
    m_down = make("down", tr("Move Down"), tr("Show the selected step later"),
                  [this] { m_notebook->moveStep(1); });
    m_undo = make("undo", tr("Undo in the Lesson"), tr("Undo the last change of the lesson"),
                  [this] { m_notebook->history()->undo(); });
    m_redo = make("redo", tr("Redo in the Lesson"), tr("Redo the change of the lesson"),
                  [this] { m_notebook->history()->redo(); });
}

void LessonPanel::createFields() {
    m_title->setPlaceholderText(tr("Title of the lesson"));
    m_title->setAccessibleName(m_title->placeholderText());
    m_title->setToolTip(tr("Shown above every step while the lesson is played"));
    m_title->setMaxLength(document::maxLessonTitle);
    m_steps->setAccessibleName(tr("Steps of the lesson"));
    m_steps->setToolTip(tr("Double-click a step to restore its state of the window"));
    m_steps->setTextElideMode(Qt::ElideRight);
    m_hint->setWordWrap(true);
    m_hint->setForegroundRole(QPalette::PlaceholderText);
    m_hint->setAttribute(Qt::WA_TransparentForMouseEvents); // the list is below it
    m_stepTitle->setPlaceholderText(tr("Title of the step"));
    m_stepTitle->setAccessibleName(m_stepTitle->placeholderText());
    m_stepTitle->setToolTip(tr("Shown in large letters above the text"));
    m_stepTitle->setMaxLength(document::maxLessonTitle);
    m_text->setPlaceholderText(tr("Text of the step"));
    m_text->setAccessibleName(m_text->placeholderText());
    m_text->setToolTip(tr("Shown beside the picture; leave a line empty to begin a paragraph"));
    m_text->setTabChangesFocus(true);
    m_play->setToolTip(
        tr("Play the lesson in full screen, from the beginning or from the step you clicked in the list"));
    m_save->setToolTip(tr("Save the lesson as a text that refers to its fractals"));
    connect(m_title, &QLineEdit::textEdited, m_notebook, &LessonNotebook::setTitle);
    connect(m_stepTitle, &QLineEdit::textEdited, m_notebook, &LessonNotebook::setStepTitle);
    connect(m_text, &QPlainTextEdit::textChanged, this, &LessonPanel::takeText);
    connect(m_steps, &QListWidget::currentRowChanged, m_notebook, &LessonNotebook::setCurrent);
    connect(m_steps, &QListWidget::itemClicked, m_notebook, // also for the current step
            [this](const QListWidgetItem* item) { m_notebook->setCurrent(m_steps->row(item)); });
    connect(m_steps, &QListWidget::itemActivated, this, &LessonPanel::showRequested);
    connect(m_play, &QPushButton::clicked, this, &LessonPanel::playRequested);
    connect(m_save, &QPushButton::clicked, this, &LessonPanel::saveRequested);
}

// Cuts text that is too long where the user can see it.
void LessonPanel::takeText() {
    if (m_isFollowing) return;
    const QString typed = m_text->toPlainText();
    m_notebook->setText(typed);
    const QString kept = document::lessonText(typed);
    if (document::lessonText(typed, int(typed.size())) == kept) return;
    const QScopedValueRollback<bool> following(m_isFollowing, true);
    m_text->setPlainText(kept);
    m_text->moveCursor(QTextCursor::End);
}

void LessonPanel::layOut() {
    auto* panels = new MenuButton(m_fields);
    panels->setText(tr("Panels"));
    panels->setToolTip(tr("The panels that this step shows beside the canvas; all others are hidden"));
    panels->setAccessibleName(tr("Panels of the step"));
    panels->setMenu(m_panels);
    panels->setAutoRaise(true);
    auto* fields = new QVBoxLayout(m_fields);
    fields->setContentsMargins(0, 0, 0, 0);
    fields->setSpacing(4);
    fields->addWidget(m_stepTitle);
    fields->addWidget(m_text, 1);
    fields->addWidget(panels, 0, Qt::AlignLeft);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_save);
    buttons->addStretch();
    buttons->addWidget(m_play);
    // In the list as long as that is empty: a panel on a small screen has no room to spare.
    (new QVBoxLayout(m_steps->viewport()))->addWidget(m_hint, 0, Qt::AlignTop);
    m_steps->setMinimumHeight(linesOfHint * fontMetrics().lineSpacing());
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addWidget(m_title);
    layout->addWidget(m_steps, 2);
    layout->addWidget(
        buttonBar({m_add, m_update, m_show, m_remove, m_up, m_down, m_undo, m_redo}, m_undo, this));
    layout->addWidget(m_fields, 3);
    layout->addLayout(buttons);
}

void LessonPanel::setPanels(const QList<QPair<QString, QString>>& panels) {
    m_panels->clear();
    for (const auto& [id, name] : panels) {
        QAction* action = m_panels->addAction(QString(name).replace(u'&', QLatin1String("&&")));
        action->setCheckable(true);
        action->setData(id);
        connect(action, &QAction::triggered, this, [this, id = id](bool on) { choosePanel(id, on); });
    }
    follow();
}

void LessonPanel::beginToWrite() {
    m_stepTitle->setFocus();
}

void LessonPanel::choosePanel(const QString& id, bool shown) {
    const document::LessonStep* step = m_notebook->currentStep();
    if (!step) return;
    document::LessonState state = step->state;
    state.panels.removeAll(id);
    if (shown) state.panels << id;
    m_notebook->setState(state);
}

void LessonPanel::followSteps() {
    const QSignalBlocker quiet(m_steps);
    const QList<document::LessonStep>& steps = m_notebook->lesson().steps;
    while (m_steps->count() > steps.size())
        delete m_steps->takeItem(m_steps->count() - 1);
    while (m_steps->count() < steps.size())
        m_steps->addItem(QString());
    for (int i = 0; i < steps.size(); ++i) {
        const QString title = steps[i].title.isEmpty() ? tr("Untitled") : steps[i].title;
        m_steps->item(i)->setText(
            tr("%1. %2", "number and title of a step").arg(QString::number(i + 1), title));
    }
    m_steps->setCurrentRow(m_notebook->current());
}

// Leaves the field being typed in as it is: the notebook keeps its text without blanks at the ends.
void LessonPanel::follow() {
    const QScopedValueRollback<bool> following(m_isFollowing, true);
    const document::Lesson& lesson = m_notebook->lesson();
    const document::LessonStep* step = m_notebook->currentStep();
    followSteps();
    if (document::lessonLine(m_title->text()) != lesson.title) m_title->setText(lesson.title);
    const QString title = step ? step->title : QString();
    const QString text = step ? step->text : QString();
    if (document::lessonLine(m_stepTitle->text()) != title) m_stepTitle->setText(title);
    if (document::lessonText(m_text->toPlainText()) != text) m_text->setPlainText(text);
    for (QAction* panel : m_panels->actions()) {
        panel->setEnabled(step);
        panel->setChecked(step && step->state.panels.contains(panel->data().toString()));
    }
    m_fields->setEnabled(step);
    m_hint->setVisible(!step);
    const int last = int(lesson.steps.size()) - 1;
    m_add->setEnabled(lesson.steps.size() < document::maxLessonSteps);
    for (QAction* action : {m_update, m_show, m_remove})
        action->setEnabled(step);
    m_up->setEnabled(m_notebook->current() > 0);
    m_down->setEnabled(step && m_notebook->current() < last);
    m_undo->setEnabled(m_notebook->history()->canUndo());
    m_redo->setEnabled(m_notebook->history()->canRedo());
    m_play->setEnabled(step);
    m_save->setEnabled(!m_notebook->isEmpty());
}

} // namespace view
