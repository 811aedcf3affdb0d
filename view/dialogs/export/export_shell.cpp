// SPDX-License-Identifier: MIT
#include "dialogs/export/export_shell.h"

#include "desktop/show_in_folder.h"
#include "dialogs/export/enqueue.h"
#include "dialogs/export/export_progress.h"
#include "document/fractal_file.h"
#include "document/text/text.h"
#include "io/file/slow_disk.h"
#include "widgets/background/save_beside.h"
#include "widgets/file_dialogs.h"
#include "widgets/layout/grow_to_fit.h"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFileInfo>
#include <QFormLayout>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>

#include <utility>

namespace view {

ExportShell::ExportShell(const QString& kind, const QString& entry, QWidget* parent)
    : QDialog(parent),
      m_kind(kind),
      m_entry(entry),
      m_message(new QLabel(this)),
      m_progress(new ExportProgress(this)),
      m_buttons(new QDialogButtonBox(this)) {
    m_message->setWordWrap(true);
    m_message->setTextFormat(Qt::PlainText); // quotes names and paths
    m_message->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_message->setAccessibleName(tr("Result"));
    m_message->hide();
    m_start = m_buttons->addButton(tr("&Export…"), QDialogButtonBox::AcceptRole);
    m_start->setObjectName(QStringLiteral("export"));
    m_close = m_buttons->addButton(QDialogButtonBox::Close);
    m_close->setObjectName(QStringLiteral("close"));
    m_showInFolder =
        addButton(tr("Show in Folder"), tr("Shows the folder of the written file in the file manager."));
    m_showInFolder->setObjectName(QStringLiteral("show-in-folder"));
    m_showInFolder->setEnabled(false); // in its place, so that Export stays in its own
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
    QSizePolicy policy = m_progress->sizePolicy();
    policy.setRetainSizeWhenHidden(true); // the buttons below keep their places
    m_progress->setSizePolicy(policy);
    auto* result = new QGridLayout; // one cell, because a running export has no outcome yet
    result->addWidget(m_message, 0, 0);
    result->addWidget(m_progress, 0, 0);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(top, 1);
    layout->addLayout(result);
    layout->addWidget(m_buttons);
}

void ExportShell::lay(QFormLayout* options, QWidget* preview, Qt::Orientation orientation) {
    auto* widget = new QWidget(this);
    widget->setLayout(options);
    options->setContentsMargins({});
    lay(widget, preview, orientation);
}

void ExportShell::setStartHelp(const QString& text) const {
    m_start->setWhatsThis(text);
}

QPushButton* ExportShell::addButton(const QString& text, const QString& help) const {
    QPushButton* button = m_buttons->addButton(text, QDialogButtonBox::ActionRole);
    button->setWhatsThis(help);
    return button;
}

QPushButton* ExportShell::addQueueButton(const QString& help) {
    m_enqueue = addButton(tr("Add to Queue…"), help);
    m_enqueue->hide();
    connect(m_enqueue, &QPushButton::clicked, this, [this] { addToQueue(chosenFile()); });
    return m_enqueue;
}

void ExportShell::addAnimationButton() {
    m_animation =
        addButton(Text::tr("&Animation…"), Text::tr("Exports the motion instead, as GIF, MP4 and others."));
    m_animation->setObjectName(QStringLiteral("animation"));
}

void ExportShell::setQueue(ExportQueue* queue) {
    m_queue = queue;
    if (m_enqueue != nullptr) m_enqueue->setVisible(queue != nullptr);
}

QString ExportShell::message() const {
    return m_message->text();
}

void ExportShell::suggestFolderOf(const QString& path) {
    const QString folder = QFileInfo(path).absolutePath();
    const auto isWritable = [folder] { return QFileInfo(folder).isWritable(); };
    if (!path.isEmpty() && io::answerSoon(isWritable).value_or(false)) m_folder = folder;
}

QString ExportShell::chooseFile(const WantedFile& wanted) {
    const QString usual = document::uniqueName({}, m_entry) + u'.' + wanted.suffix;
    const QString filter = wanted.filter.isEmpty()
                               ? tr("%1 files (*.%2)").arg(wanted.suffix.toUpper(), wanted.suffix)
                               : wanted.filter;
    return chooseFileToSave(this, wanted.title,
                            suggestedPath(m_kind, wanted.name ? wanted.name(usual) : usual, m_folder), filter,
                            wanted.suffix, wanted.asksToReplace);
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
    if (m_animation != nullptr) m_animation->setEnabled(!isBusy()); // it closes this dialog
    if (m_enqueue != nullptr) m_enqueue->setEnabled(m_start->isEnabled() && isQueueable());
}

void ExportShell::start(io::Export what, const QString& path, const QString& firstStep) {
    start(
        [what = std::move(what), path](const io::Progress& progress, const std::stop_token& stop) {
            return io::exportTo(what, path, progress, stop);
        },
        path, firstStep);
}

void ExportShell::start(Work work, const QString& path, const QString& firstStep) {
    const auto here = [this](auto call) { QMetaObject::invokeMethod(this, call, Qt::QueuedConnection); };
    m_work = std::make_unique<io::ExportWork>(
        [=, this, work = std::move(work)](const std::stop_token& stop, document::Listener& listener) {
            const io::Progress told = [&](double fraction) {
                listener.tell([&] { here([this, fraction] { m_progress->setFraction(fraction); }); });
            };
            const io::ExportOutcome outcome = work(told, stop);
            listener.tell([&] { here([this, outcome, path] { finish(outcome, path); }); });
        });
    say({});
    m_showInFolder->setEnabled(false);
    m_progress->begin(firstStep);
    m_options->setEnabled(false);
    m_close->setText(tr("&Stop"));
    const bool hadFocus = focusWidget() == m_start;
    enableButtons();
    if (hadFocus && focusWidget() != nullptr) focusWidget()->clearFocus(); // Return must do nothing else
}

void ExportShell::writeText(const QByteArray& text, const QString& path) {
    const QPointer self(this);
    const auto [isCancelled, failure] = saveBeside(path, text, this);
    if (!self) return;
    io::ExportOutcome outcome;
    outcome.stopped = isCancelled;
    outcome.failure = failure;
    finish(outcome, path);
}

void ExportShell::finish(const io::ExportOutcome& outcome, const QString& path) {
    m_work.reset();
    if (m_question) m_question->reject();
    m_progress->end();
    m_options->setEnabled(true);
    m_close->setText(tr("&Close"));
    whenFinished();
    enableButtons();
    if (focusWidget() == nullptr || qobject_cast<QPushButton*>(focusWidget()) != nullptr)
        m_start->setFocus(); // for the next export
    say(sentenceFor(outcome, path));
    if (!outcome.failure && !outcome.stopped) offerFolderOf(path);
    if (outcome.failure && !outcome.stopped) emit failed(*outcome.failure);
    if (!outcome.failure && !outcome.stopped) emit exported(path);
}

void ExportShell::offerFolderOf(const QString& path) {
    m_written = path;
    m_showInFolder->setEnabled(true);
}

QString ExportShell::sentenceFor(const io::ExportOutcome& outcome, const QString& path) const {
    if (outcome.stopped) return tr("Export stopped; nothing was written.");
    return outcome.failure ? *outcome.failure : tr("Written to %1.").arg(path);
}

void ExportShell::closeOrStop() {
    m_work ? m_work->stop() : reject();
}

ExportShell::Unfinished ExportShell::unfinished() const {
    return {Text::tr("A file is still being exported."), Text::tr("If you stop now, no file is written.")};
}

bool ExportShell::mayClose() {
    if (!isBusy()) return true;
    const auto [sentence, ifStopped] = unfinished();
    QMessageBox box(QMessageBox::Question, Text::tr("Export is not finished"), sentence,
                    QMessageBox::NoButton, this);
    m_question = &box;
    box.setInformativeText(ifStopped);
    QPushButton* stop = box.addButton(Text::tr("&Stop Export"), QMessageBox::AcceptRole);
    stop->setObjectName(QStringLiteral("stop"));
    QPushButton* goOn = box.addButton(Text::tr("&Continue"), QMessageBox::RejectRole);
    goOn->setObjectName(QStringLiteral("continue"));
    box.setDefaultButton(goOn);
    box.setEscapeButton(goOn);
    box.exec();
    return !isBusy() || box.clickedButton() == stop;
}

} // namespace view
