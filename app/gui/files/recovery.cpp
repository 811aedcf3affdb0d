// SPDX-License-Identifier: MIT
#include "files/recovery.h"

#include "io/file/background.h"
#include "io/fractint/fractint_writer.h"
#include "io/lesson/lesson_writer.h"
#include "panels/lesson/lesson_notebook.h"
#include "widgets/background/wait_for.h"

#include <QDir>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

#include <algorithm>
#include <utility>

using namespace std::chrono_literals;

Recovery::Recovery(document::Document* document, const OpenFile* file, QObject* parent)
    : QObject(parent),
      m_document(document),
      m_file(file),
      m_journal(std::make_shared<document::Journal>(folder())),
      m_writer(document::Lane::Saving) {
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, [this] {
        if (!m_writing.isEmpty())
            m_isAgain = true; // slow disk: the newest state is written next, none between
        else
            keepNow();
    });
    m_watch.setSingleShot(true);
    connect(&m_watch, &QTimer::timeout, this, &Recovery::watch);
    connect(document, &document::Document::changed, this, [this](const document::Change& change) {
        using document::Change;
        if (change.parts & Change::Time && !(change.parts & Change::File)) return; // not an edit
        noteChange();
    });
    connect(document->undoStack(), &QUndoStack::cleanChanged, this, [this](bool clean) {
        m_wasModified = isModified();
        if (!clean) return;
        if (m_wasModified) // the lesson is still modified
            noteChange();
        else
            discard();
    });
}

Recovery::~Recovery() {
    m_listener->leave();
    letGo();
}

void Recovery::follow(const view::LessonNotebook* lesson) {
    m_lesson = lesson;
    connect(lesson, &view::LessonNotebook::changed, this, [this] {
        if (isModified() || m_wasModified) noteChange();
    });
}

bool Recovery::isModified() const {
    return m_document->isModified() || (m_lesson && m_lesson->isModified() && !m_lesson->isEmpty());
}

void Recovery::noteChange() {
    const Time now = std::chrono::steady_clock::now();
    m_oldest = m_wasModified ? std::min(m_oldest, now) : now;
    m_wasModified = isModified();
    keepSoon();
    watch();
}

// Keeps work soon and is not put off by further changes: a long drag is kept along the way. Slow writing
// begins early.
void Recovery::keepSoon() {
    if (!m_timer.isActive()) m_timer.start(std::clamp(1800ms - 3 * m_lastTook / 2, 100ms, 1000ms));
}

void Recovery::keepNow() {
    if (m_isGivenUp || !isModified()) return discard();
    document::Snapshot snapshot{m_file->path(),
                                m_file->name(),
                                int(document::indexOf(m_document->file(), m_document->currentId())),
                                QDateTime::currentDateTimeUtc(),
                                {},
                                m_file->digest()};
    if (m_lesson && m_lesson->isModified() && !m_lesson->isEmpty()) {
        snapshot.lesson = io::writeLesson(m_lesson->lesson());
        snapshot.lessonPath = m_lesson->path();
    }
    m_writing << std::exchange(m_oldest, never);
    m_writer.start([this, journal = m_journal, listener = m_listener, snapshot, file = m_document->file(),
                    old = m_takenOver]() mutable {
        const auto began = std::chrono::steady_clock::now();
        snapshot.bytes = io::writeFractint(file);
        const bool kept = journal->write(snapshot);
        if (kept && old) document::forget(*old);
        const auto took =
            std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - began);
        listener->tell([this, kept, took] {
            QMetaObject::invokeMethod(
                this,
                [this, kept, took] {
                    m_lastTook = took;
                    finish(kept);
                },
                Qt::QueuedConnection);
        });
    });
}

void Recovery::finish(bool kept) {
    const Time oldest = m_writing.takeFirst();
    if (kept)
        m_takenOver.reset();
    else
        m_oldest = std::min(m_oldest, oldest);
    report(kept);
    if (std::exchange(m_isAgain, false)) keepNow();
    watch();
}

void Recovery::watch() {
    constexpr auto promised = 2s;
    const Time oldest = m_writing.isEmpty() ? m_oldest : std::min(m_oldest, m_writing.first());
    const auto left = oldest == never ? promised : promised - (std::chrono::steady_clock::now() - oldest);
    const bool isLate = left <= 0s && isModified();
    if (left > 0s && oldest != never)
        m_watch.start(std::chrono::ceil<std::chrono::milliseconds>(left));
    else
        m_watch.stop();
    if (std::exchange(m_isLate, isLate) != isLate) emit lateChanged(isLate);
}

void Recovery::takeOver(const document::Abandoned& abandoned) {
    m_takenOver = abandoned;
    keepNow();
}

// Other windows may still ask about their work while this one has been answered for.
void Recovery::giveUp() {
    m_isGivenUp = true;
    discard();
}

void Recovery::store() {
    if (!m_isGivenUp && isModified()) keepNow();
}

void Recovery::letGo() {
    m_writer.start([journal = m_journal, old = std::exchange(m_takenOver, std::nullopt)]() mutable {
        journal->letGo();
        old.reset();
    });
}

void Recovery::report(bool kept) {
    if (!kept && isModified()) keepSoon(); // repeated until it succeeds
    if (std::exchange(m_kept, kept) && !kept)
        emit cannotKeep(tr("Unsaved work cannot be kept for recovery: the folder “%1” is not writable, or "
                           "the disk is full. Save often.")
                            .arg(QDir::toNativeSeparators(folder())));
}

void Recovery::discard() {
    m_timer.stop();
    m_oldest = never;
    m_writing.fill(never);
    watch();
    m_writer.start([journal = m_journal, old = std::exchange(m_takenOver, std::nullopt)] {
        journal->discard();
        if (old) document::forget(*old);
    });
}

QString Recovery::folder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
           QStringLiteral("/recovery");
}

void Recovery::reportDamaged(QStringList paths) {
    if (paths.isEmpty()) return;
    for (QString& path : paths)
        path = QDir::toNativeSeparators(path);
    QMessageBox box(QMessageBox::Warning, tr("Unsaved work was found"),
                    tr("The unsaved work from the last session is damaged and cannot be recovered. What "
                       "remains of it is in:"));
    box.setInformativeText(paths.join(u'\n'));
    box.setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    box.exec();
}

// A line for each; those of files of the same name with their folders, those that read alike together.
QStringList Recovery::lines(const QList<document::Snapshot>& snapshots) {
    QStringList result;
    QList<int> windows; // window of each line
    for (const document::Snapshot& snapshot : snapshots) {
        const bool isAmbiguous = std::ranges::any_of(snapshots, [&](const document::Snapshot& other) {
            return other.title == snapshot.title && other.path != snapshot.path;
        });
        const QString name = isAmbiguous && !snapshot.path.isEmpty() ? QDir::toNativeSeparators(snapshot.path)
                                                                     : snapshot.title;
        const QString when = snapshot.when.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm"));
        const QString line = tr("%1, %2", "file, time").arg(name, when);
        const auto place = result.indexOf(line);
        if (place >= 0) {
            ++windows[place];
        } else {
            result << line;
            windows << 1;
        }
    }
    for (int i = 0; i < result.size(); ++i)
        if (windows[i] > 1) result[i] += u' ' + tr("(%n windows)", nullptr, windows[i]);
    return result;
}

QList<document::Abandoned> Recovery::ask() {
    struct Left {
        QList<document::Abandoned> work;
        QStringList damaged;
    };
    QFuture<Left> looking =
        io::inBackground<Left>(io::Lane::Reading, [folder = folder()](QPromise<Left>& promise) {
            Left left{document::abandonedSnapshots(folder), {}};
            left.damaged = document::setDamagedAside(folder);
            promise.addResult(std::move(left));
        });
    if (!view::waitFor(QFuture<void>(looking), tr("Looking for unsaved work…"), nullptr)) return {};
    auto [found, damaged] = looking.takeResult();
    reportDamaged(damaged);
    if (found.isEmpty()) return {};
    QList<document::Snapshot> snapshots;
    for (const document::Abandoned& abandoned : found)
        snapshots << abandoned.snapshot;
    QMessageBox box(QMessageBox::Question, tr("Unsaved work was found"),
                    tr("In the last session, Barycage ended before this work was saved:"));
    box.setInformativeText(lines(snapshots).join(u'\n'));
    QPushButton* recover = box.addButton(tr("Recover"), QMessageBox::AcceptRole);
    QPushButton* forget = box.addButton(tr("Discard"), QMessageBox::DestructiveRole);
    QPushButton* later = box.addButton(tr("Ask Later"), QMessageBox::RejectRole);
    box.setDefaultButton(recover);
    box.setEscapeButton(later);
    box.exec();
    if (box.clickedButton() == recover) return found;
    // Runs in the lane in which locks are released.
    document::startInLane(document::Lane::Saving,
                          [left = std::move(found), isForgotten = box.clickedButton() == forget]() mutable {
                              for (const document::Abandoned& abandoned : left)
                                  if (isForgotten) document::forget(abandoned);
                              left.clear();
                          });
    return {};
}
