// SPDX-License-Identifier: MIT
#include "files/file_commands.h"

#include "document/edits/cage/placements.h"
#include "document/tops/picture_paths.h"
#include "io/file/background.h"
#include "io/fractint/fractint_writer.h"
#include "messages/placement_banner.h"
#include "messages/save_question.h"
#include "messages/written_banner.h"
#include "panels/collage/collage_panel.h"
#include "panels/collage/target_box.h"
#include "panels/snapshots/snapshots.h"
#include "session/session.h"
#include "widgets/background/save_beside.h"
#include "widgets/background/wait_for.h"
#include "widgets/file_dialogs.h"

#include <QAbstractButton>
#include <QFileInfo>
#include <QMainWindow>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>

namespace {

constexpr qsizetype maxNamed = 6; // snapshots named in a question

QString fileFilter() {
    return FileCommands::tr(
        "Files with fractals (*.ifs *.par *.lesson *.flame *.flam3 *.csv *.tsv *.txt *.png *.svg);;"
        "Fractint collections (*.ifs *.par);;Flames (*.flame *.flam3);;Tables of numbers (*.csv *.tsv "
        "*.txt);;Pictures with an embedded fractal (*.png *.svg);;Lessons (*.lesson);;All files (*)");
}

QString list(const QStringList& names) {
    QStringList some = names.mid(0, maxNamed);
    if (some.size() < names.size()) some << QStringLiteral("…");
    return some.join(QStringLiteral(", "));
}

} // namespace

bool isLesson(const QString& path) {
    return path.endsWith(QLatin1String(".lesson"), Qt::CaseInsensitive);
}

FileCommands::FileCommands(const MenuContext& context, OpenFile* file)
    : QObject(context.window), m_context(context), m_file(file) {}

QString FileCommands::lostSnapshots() const {
    const QStringList names = m_snapshots ? m_snapshots->unsaved() : QStringList();
    if (names.isEmpty()) return {};
    return tr("Snapshots are not saved with the file and will be lost: %1. To keep one, cancel and choose "
              "Add as Entry in the Snapshots panel.")
        .arg(list(names));
}

QString FileCommands::discardedSnapshots() const {
    const QStringList names = m_snapshots ? m_snapshots->lostByDiscarding() : QStringList();
    if (names.isEmpty()) return {};
    return tr("If you discard the changes, the snapshots of them will be lost, too: %1.").arg(list(names));
}

bool FileCommands::maybeSave() {
    if (m_lessons.maybeSave && !m_lessons.maybeSave()) return false;
    m_context.canvas->cancelGesture();
    if (!m_context.document->isModified()) {
        const QString lost = lostSnapshots();
        return lost.isEmpty() ||
               askToDiscard(m_context.window, tr("Unsaved snapshots"),
                            tr("“%1” has snapshots that are not saved.").arg(m_file->name()), lost);
    }
    switch (askToSave(m_context.window, tr("Unsaved changes"),
                      tr("“%1” has unsaved changes.").arg(m_file->name()),
                      {targetRemark(), lostSnapshots(), discardedSnapshots()})) {
    case QMessageBox::Save:
        return save();
    case QMessageBox::Discard:
        return true;
    default:
        return false;
    }
}

bool FileCommands::open(const QString& path) {
    return m_lessons.open && isLesson(path) ? m_lessons.open(path) : open(path, startReading(path));
}

bool FileCommands::open(const QString& path, const FileReading& reading) {
    if (const io::Failure failure = m_file->open(path, reading)) {
        if (m_file->isStopped()) return false;
        m_context.messages->fail(tr("%1 could not be opened").arg(QFileInfo(path).fileName()), *failure);
        return false;
    }
    reportOpened();
    return true;
}

void FileCommands::reportOpened() {
    const document::FractalFile& file = m_context.document->file();
    qsizetype broken = 0;
    qsizetype bent = 0;
    for (const document::Entry& entry : file.entries) {
        if (document::dimension(*entry.fractal) == 0)
            ++broken;
        else if (document::callsForAttention(entry.problems))
            ++bent;
    }
    QString sentence = tr("%n entries", nullptr, int(file.entries.size()));
    if (broken > 0)
        sentence += tr(", %n of them could not be read and are kept unchanged", nullptr, int(broken));
    if (bent > 0) sentence += tr(", %n read with warnings", nullptr, int(bent));
    m_context.messages->say(sentence + u'.');
}

void FileCommands::startNew() {
    if (!maybeSave()) return;
    m_file->startNew();
    m_context.canvas->fit();
}

void FileCommands::chooseAndOpen() {
    if (!maybeSave()) return;
    const QString folder = m_file->path().isEmpty() ? QString() : QFileInfo(m_file->path()).path();
    const QString path = view::chooseFileToOpen(m_context.window, tr("Open"), fileFilter(), folder);
    if (!path.isEmpty() && !session::showOther(path, m_context.window)) open(path);
}

void FileCommands::openRecent(const QString& path) {
    if (!session::showOther(path, m_context.window) && maybeSave()) open(path);
}

// Another program has changed the file, or taken it away.
FileCommands::Answer FileCommands::askAboutDisk(OpenFile::OnDisk found) {
    const bool isGone = found == OpenFile::OnDisk::Gone;
    QMessageBox box(
        QMessageBox::Warning, isGone ? tr("Missing on disk") : tr("Changed on disk"),
        isGone ? tr("“%1” has been deleted, renamed or moved since you opened it.").arg(m_file->name())
               : tr("Another program has changed “%1” since you opened it.").arg(m_file->name()),
        QMessageBox::Cancel, m_context.window);
    box.setInformativeText(isGone ? tr("Saving creates it again in its old location.")
                                  : tr("Saving overwrites the changes made by the other program."));
    QPushButton* here = isGone ? box.addButton(QMessageBox::Save)
                               : box.addButton(tr("Replace"), QMessageBox::DestructiveRole);
    here->setObjectName(QStringLiteral("here"));
    const QPushButton* elsewhere = box.addButton(tr("Save As…"), QMessageBox::AcceptRole);
    box.exec();
    const QAbstractButton* clicked = box.clickedButton();
    return clicked == here ? Answer::Save : clicked == elsewhere ? Answer::SaveAs : Answer::Cancel;
}

bool FileCommands::save() {
    if (m_lessons.refusesSaving && m_lessons.refusesSaving()) return false;
    if (m_file->path().isEmpty()) return saveAs();
    const std::optional<OpenFile::OnDisk> found = m_file->onDisk();
    if (!found) return false;
    const Answer answer = *found == OpenFile::OnDisk::Same ? Answer::Save : askAboutDisk(*found);
    if (answer == Answer::SaveAs) return saveAs();
    if (answer == Answer::Cancel) return false;
    if (const io::Failure failure = m_file->save()) {
        m_context.messages->fail(tr("%1 was not saved").arg(m_file->name()), *failure);
        return false;
    }
    followFile(reportSaved());
    return true;
}

void FileCommands::followFile(const QString& sentence) {
    if (m_lessons.follow) m_lessons.follow(sentence);
}

QString FileCommands::targetRemark() const {
    const auto* collage = m_context.window->findChild<view::CollagePanel*>();
    return collage != nullptr && collage->target()->hasTargets()
               ? tr("The target in the Collage panel is not saved with the file.")
               : QString();
}

QString FileCommands::reportSaved() {
    QString sentence = tr("Saved %1.").arg(m_file->name());
    if (m_file->otherNames() > 0)
        sentence += u' ' + tr("Other names of the file (hard links) keep the old contents.");
    const QString previous = remarkOn(m_file->previousVersion(), m_file->name());
    if (!previous.isEmpty()) sentence += u' ' + previous;
    if (const QString remark = targetRemark(); !remark.isEmpty() && !m_hasRemarkedOnTarget) {
        sentence += u' ' + remark;
        m_hasRemarkedOnTarget = true;
    }
    m_context.messages->say(sentence);
    if (!m_hasRemarkedOnPlacement)
        m_hasRemarkedOnPlacement =
            PlacementBanner::offer(m_context.window, *m_context.document, *m_context.messages);
    return sentence;
}

bool FileCommands::saveAs() {
    if (m_lessons.refusesSaving && m_lessons.refusesSaving()) return false;
    const QString suggestion =
        m_file->path().isEmpty()
            ? view::suggestedName(document::uniqueName({}, m_context.document->fractal().name),
                                  QStringLiteral("ifs"))
            : m_file->path();
    const QString path = view::chooseFileToSave(m_context.window, tr("Save As"), suggestion,
                                                tr("Fractint collections (*.ifs)"), QStringLiteral("ifs"));
    const std::optional<QString> saved = path.isEmpty() ? std::nullopt : saveTo(path);
    if (saved) followFile(*saved);
    return saved.has_value();
}

std::optional<QString> FileCommands::saveTo(const QString& path) {
    if (const io::Failure failure = m_file->saveAs(path)) {
        m_context.messages->fail(tr("%1 was not saved").arg(QFileInfo(path).fileName()), *failure);
        return std::nullopt;
    }
    return reportSaved();
}

void FileCommands::saveForOtherPrograms() {
    if (m_lessons.refusesSaving && m_lessons.refusesSaving()) return;
    const QFileInfo own(m_file->path());
    const QString suggestion =
        m_file->path().isEmpty()
            ? view::suggestedName(document::uniqueName({}, m_context.document->fractal().name) +
                                      QStringLiteral("-copy"),
                                  QStringLiteral("ifs"))
            : own.path() + u'/' + own.completeBaseName() + QStringLiteral("-copy.ifs");
    const QString path =
        view::chooseFileToSave(m_context.window, tr("Save a Copy for Other Programs"), suggestion,
                               tr("Fractint collections (*.ifs)"), QStringLiteral("ifs"));
    if (path.isEmpty()) return;
    const QString name = QFileInfo(path).fileName();
    if (!m_file->path().isEmpty() && QFileInfo(path).absoluteFilePath() == own.absoluteFilePath())
        return m_context.messages->fail(tr("%1 was not saved").arg(name),
                                        tr("A copy needs another name than the file itself."));
    struct Copy {
        QByteArray bytes;
        QStringList left;
    };
    const QString folder = m_file->path().isEmpty() ? QString() : own.path();
    QFuture<Copy> work =
        io::inBackground<Copy>([file = m_context.document->file(), folder,
                                target = QFileInfo(path).absolutePath()](QPromise<Copy>& promise) {
            document::BakedFile copy =
                document::forOtherPrograms(document::withPicturesFoundFrom(file, folder, target));
            promise.addResult(Copy{io::writeFractint(copy.file), copy.left});
        });
    const QPointer<QMainWindow> window(m_context.window);
    if (!view::waitFor(QFuture<void>(work), tr("Saving “%1”…").arg(name), window) || !window) return;
    const Copy copy = work.takeResult();
    const auto [saving, outcome] = saveKeeping(path, copy.bytes, window, m_file->versions());
    const auto& [isCancelled, failure] = saving;
    if (isCancelled || !window) return;
    if (failure) return m_context.messages->fail(tr("%1 was not saved").arg(name), *failure);
    QString sentence = tr("Saved the copy %1.").arg(name);
    if (const QString previous = remarkOn(outcome, name); !previous.isEmpty()) sentence += u' ' + previous;
    if (!copy.left.isEmpty())
        sentence +=
            u' ' + tr("Other programs still draw these entries differently: %1.").arg(list(copy.left));
    m_context.messages->say(sentence);
    WrittenBanner::offer(window, *m_context.document, path, tr("Copy saved"),
                         tr("%1 was saved for other programs."));
}

void FileCommands::revert() {
    QStringList lost{lostSnapshots(), discardedSnapshots()};
    lost.removeAll(QString());
    if (m_context.document->isModified() || !lost.isEmpty()) {
        const QString question =
            m_context.document->isModified()
                ? tr("Revert to “%1” as it is on disk? Your changes since then will be lost.")
                : tr("Revert to “%1” as it is on disk?");
        if (!askToDiscard(m_context.window, tr("Revert"), question.arg(m_file->name()),
                          lost.join(QStringLiteral("\n\n"))))
            return;
    }
    if (const io::Failure failure = m_file->revert(); failure && !m_file->isStopped())
        m_context.messages->fail(tr("%1 could not be reloaded").arg(m_file->name()), *failure);
}
