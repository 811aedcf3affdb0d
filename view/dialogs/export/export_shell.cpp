// SPDX-License-Identifier: MIT
#include "dialogs/export/export_shell.h"

#include "desktop/show_in_folder.h"
#include "dialogs/export/enqueue.h"
#include "dialogs/export/export_progress.h"
#include "dialogs/export/start_export.h"
#include "widgets/layout/grow_to_fit.h"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>

#include <utility>

namespace view {

ExportShell::ExportShell(QWidget* parent)
    : QDialog(parent),
      m_message(new QLabel(this)),
      m_progress(new ExportProgress(this)),
      m_buttons(new QDialogButtonBox(this)) {
    m_message->setWordWrap(true);
    m_message->setTextFormat(Qt::PlainText); // it quotes names and paths
    m_message->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_message->setAccessibleName(tr("Result"));
    m_message->hide();
    m_start = m_buttons->addButton(tr("&Export…"), QDialogButtonBox::AcceptRole);
    m_close = m_buttons->addButton(QDialogButtonBox::Close);
    m_showInFolder =
        addButton(tr("Show in Folder"), tr("Shows the folder of the written file in the file manager."));
    m_showInFolder->hide();
    connect(m_showInFolder, &QPushButton::clicked, this, [this] { showInFolder(m_written); });
    connect(m_buttons, &QDialogButtonBox::accepted, this, [this] {
        if (const QString path = chosenFile(); !path.isEmpty()) exportTo(path);
    });
    connect(m_buttons, &QDialogButtonBox::rejected, this, &ExportShell::closeOrStop);
}

void ExportShell::escape() {
    m_close->click();
}

// Closing the window stops and closes at once. A shortcut would take the key from an open list, too.
void ExportShell::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Cancel))
        escape();
    else
        QDialog::keyPressEvent(event);
}

// Rows that come with another format have their room, rather than that of the others.
bool ExportShell::event(QEvent* event) {
    const bool isHandled = QDialog::event(event);
    if (event->type() == QEvent::LayoutRequest) growToFit(*this);
    return isHandled;
}

ExportShell::~ExportShell() = default;

void ExportShell::lay(QWidget* options, QWidget* preview, Qt::Orientation orientation) {
    m_options = options;
    auto* top =
        new QBoxLayout(orientation == Qt::Horizontal ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    top->addWidget(options);
    if (preview != nullptr) top->addWidget(preview, 1);
    auto* result = new QGridLayout; // in one place: of an export that has begun nothing is said yet
    result->addWidget(m_message, 0, 0);
    result->addWidget(m_progress, 0, 0);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(top, 1);
    layout->addLayout(result);
    layout->addWidget(m_buttons);
}

void ExportShell::setStartHelp(const QString& text) const {
    m_start->setWhatsThis(text);
}

QPushButton* ExportShell::addButton(const QString& text, const QString& help) const {
    QPushButton* button = m_buttons->addButton(text, QDialogButtonBox::ActionRole);
    button->setWhatsThis(help);
    if (m_showInFolder != nullptr) m_showInFolder->hide(); // the box shows all buttons when it gets one more
    return button;
}

QPushButton* ExportShell::addQueueButton(const QString& help) {
    m_enqueue = addButton(tr("Add to Queue…"), help);
    m_enqueue->hide();
    connect(m_enqueue, &QPushButton::clicked, this, [this] { addToQueue(chosenFile()); });
    return m_enqueue;
}

void ExportShell::setQueue(ExportQueue* queue) {
    m_queue = queue;
    if (m_enqueue != nullptr) m_enqueue->setVisible(queue != nullptr);
}

QString ExportShell::message() const {
    return m_message->text();
}

bool ExportShell::canExport() const {
    return m_start->isEnabled();
}

std::optional<io::ExportRecipe> ExportShell::recipeFor(const QString&) {
    return std::nullopt;
}

void ExportShell::addToQueue(const QString& path) {
    if (m_queue == nullptr || path.isEmpty() || !isPossible()) return;
    const std::optional<io::ExportRecipe> recipe = recipeFor(path);
    if (!recipe) return;
    const Enqueued added = enqueue(*m_queue, *queuedFractal(), *recipe, path);
    say(added.sentence);
    if (added.isAdded) emit queued();
}

void ExportShell::say(const QString& sentence) {
    m_message->setText(sentence);
    m_message->setVisible(!sentence.isEmpty());
    if (!sentence.isEmpty()) growToFit(*this);
}

void ExportShell::enableButtons() {
    m_start->setEnabled(isPossible() && !isBusy());
    if (m_enqueue != nullptr) m_enqueue->setEnabled(m_start->isEnabled() && isQueueable());
}

void ExportShell::start(io::Export what, const QString& path, const QString& firstStep) {
    begin([this] { m_job->stop(); }, firstStep);
    m_job = startExport(
        std::move(what), path, this, [this](double fraction) { setFraction(fraction); },
        [this, path](const io::ExportOutcome& outcome) { finish(outcome, path); });
}

void ExportShell::begin(std::function<void()> stop, const QString& firstStep) {
    m_stop = std::move(stop);
    say({});
    m_showInFolder->hide();
    m_progress->begin(firstStep);
    m_options->setEnabled(false);
    m_close->setText(tr("&Stop"));
    enableButtons();
}

void ExportShell::setFraction(double fraction) {
    m_progress->setFraction(fraction);
}

void ExportShell::finish(const io::ExportOutcome& outcome, const QString& path) {
    m_job.reset();
    m_stop = nullptr;
    m_progress->end();
    m_options->setEnabled(true);
    m_close->setText(tr("&Close"));
    whenFinished();
    enableButtons();
    say(sentenceFor(outcome, path));
    if (!outcome.failure && !outcome.stopped) offerFolderOf(path);
    if (outcome.failure && !outcome.stopped) emit failed(*outcome.failure);
    if (!outcome.failure && !outcome.stopped) emit exported(path);
}

void ExportShell::offerFolderOf(const QString& path) {
    m_written = path;
    m_showInFolder->show();
}

QString ExportShell::sentenceFor(const io::ExportOutcome& outcome, const QString& path) const {
    if (outcome.stopped) return tr("Export stopped; nothing was written.");
    return outcome.failure ? *outcome.failure : tr("Written to %1.").arg(path);
}

void ExportShell::closeOrStop() {
    m_stop ? m_stop() : reject();
}

} // namespace view
