// SPDX-License-Identifier: MIT
#include "files/open_file.h"

#include "document/fractal/fractal_geometry.h"
#include "document/text/text.h"
#include "document/tops/picture_paths.h"
#include "files/recent_files.h"
#include "io/collection_reader.h"
#include "io/file/background.h"
#include "io/file/hard_links.h"
#include "io/fractint/fractint_reader.h"
#include "io/fractint/fractint_writer.h"
#include "io/table/listed_maps.h"
#include "io/text/encoding.h"
#include "widgets/background/wait_for.h"

#include <QCryptographicHash>
#include <QFileInfo>
#include <QFutureWatcher>
#include <QHash>
#include <QProgressDialog>
#include <QScopedValueRollback>

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <utility>

namespace {

QByteArray digestOf(const QByteArray& bytes) {
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256);
}

// State shared by writing and cancelling, which may coincide; the first one decides.
struct Writing {
    std::atomic<bool> isDecided = false;
    io::Failure failure;
    document::FractalFile file; // contents after the next opening
    QByteArray digest;
    int otherNames = 0; // number of other names of the replaced file
    KeptVersions::Wish wish;
    io::KeptVersion kept;
};

QFuture<void> writeBeside(const std::shared_ptr<Writing>& writing, const document::FractalFile& file,
                          const QString& path) {
    return QFuture<void>(
        io::inBackground<bool>(io::Lane::Saving, [writing, file, path](QPromise<bool>& promise) {
            constexpr qsizetype piece = 1 << 20;
            const QByteArray bytes = io::writeFractint(file);
            writing->file = io::readFractint(bytes, QFileInfo(path).completeBaseName());
            writing->digest = digestOf(bytes);
            writing->otherNames = io::otherNames(path);
            io::NewFile target(path);
            for (qsizetype at = 0; at < bytes.size() && !target.failure(); at += piece) {
                if (promise.isCanceled()) return;
                target.write(bytes.constData() + at, std::min(piece, bytes.size() - at));
            }
            if (!target.failure() && !promise.isCanceled()) writing->kept = writing->wish.fulfilled(path);
            if (!writing->isDecided.exchange(true)) writing->failure = target.commit();
        }));
}

OpenFile::OnDisk now(const QString& path, const QByteArray& known) {
    using enum OpenFile::OnDisk;
    if (!QFileInfo::exists(path)) return Gone;
    const io::Loaded loaded = io::loadFile(path);
    return loaded.failure || digestOf(loaded.bytes) != known ? Changed : Same;
}

// Entries of one name are one entry: those that nobody touched are not shown as changed.
void keepIds(document::FractalFile& recovered, const document::FractalFile& before) {
    QHash<QString, document::EntryId> known;
    for (const document::Entry& entry : before.entries)
        if (!known.contains(entry.fractal->name)) known.insert(entry.fractal->name, entry.id);
    auto fresh = static_cast<std::uint32_t>(document::freshId(before));
    for (document::Entry& entry : recovered.entries) {
        entry.id = known.take(entry.fractal->name);
        if (entry.id == document::EntryId::None) entry.id = static_cast<document::EntryId>(fresh++);
    }
}

} // namespace

FileReading startReading(const QString& path) {
    return io::inBackground<ReadFile>(io::Lane::Reading, [path](QPromise<ReadFile>& promise) {
        ReadFile reading{io::loadFile(path), {}, {}, {}};
        if (!reading.loaded.failure) {
            reading.collection = io::readCollection(reading.loaded.bytes, path);
            reading.digest = digestOf(reading.loaded.bytes);
            if (reading.collection.isOrderAssumed)
                reading.table = io::tableIn(
                    QString::fromUtf8(io::fromUtf16(reading.loaded.bytes).value_or(reading.loaded.bytes)));
            // Loads the first entry now, which takes some time; the result is kept.
            const auto& entries = reading.collection.file.entries;
            const auto shown = std::ranges::find_if(
                entries, [](const auto& entry) { return document::system2(*entry.fractal) != nullptr; });
            if (shown != entries.end()) document::supportFunction(*shown->fractal);
        }
        promise.addResult(std::move(reading));
    });
}

OpenFile::OpenFile(document::Document* document, QWidget* window) : m_document(document), m_window(window) {}

OpenFile::~OpenFile() {
    if (m_isReading) m_reading.cancel(); // stops waiting for the result
    document::startInLane(document::Lane::Asking, [claim = std::move(m_claim)] {});
}

QString OpenFile::name() const {
    return m_path.isEmpty() ? tr("Untitled") : QFileInfo(m_path).fileName();
}

void OpenFile::startNew() {
    startFrom(document::fileOf(document::sierpinskiTriangle()), document::EntryId::None);
}

void OpenFile::startFrom(document::FractalFile file, document::EntryId current) {
    m_document->setFile(std::move(file), current);
    remember({}, {});
}

bool OpenFile::hasRead(const QFuture<void>& reading, const QString& label) {
    m_reading = reading;
    m_isReading = true;
    const bool isRead = !reading.isCanceled() && view::waitFor(reading, label, m_window);
    m_isReading = false;
    m_reading = {};
    if (m_isStopped) emit stopped();
    return isRead && !m_isStopped;
}

void OpenFile::stopReading() {
    if (!m_isReading) return;
    m_isStopped = true;
    m_reading.cancel();
}

void OpenFile::await(const QString& path, const QFuture<void>& reading) {
    m_isStopped = false;
    m_reading = reading;
    m_isBusy = m_isReading = m_isAwaiting = true;
    m_progress = new QProgressDialog(tr("Reading “%1”…").arg(QFileInfo(path).fileName()), Text::tr("Cancel"),
                                     0, 0, m_window);
    m_progress->setWindowModality(Qt::WindowModal);
    connect(m_progress, &QProgressDialog::canceled, this, [this] { m_reading.cancel(); });
    m_progress->show();
}

void OpenFile::endAwaiting() {
    if (!std::exchange(m_isAwaiting, false)) {
        m_isStopped = false;
        return;
    }
    m_isBusy = false;
    delete m_progress;
}

void OpenFile::giveUpAwaiting() {
    endAwaiting();
    m_isReading = false;
    m_reading = {};
}

io::Failure OpenFile::open(const QString& path) {
    return open(path, startReading(path));
}

io::Failure OpenFile::open(const QString& path, FileReading reading) {
    endAwaiting();
    const QScopedValueRollback<bool> busy(m_isBusy, true);
    const auto file = QFileInfo(path).fileName();
    if (!hasRead(QFuture<void>(reading), tr("Reading “%1”…").arg(file)))
        return tr("Reading “%1” was cancelled.").arg(file);
    auto [loaded, collection, digest, table] = reading.takeResult();
    if (loaded.failure) return loaded.failure;
    if (collection.file.entries.isEmpty() && !collection.file.problems.isEmpty())
        return collection.file.problems.first().message;
    document::FractalFile before = m_document->file();
    m_document->setFile(std::move(collection.file));
    io::freeInBackground(std::move(before));
    m_versions.clear();
    // A system from another format has no .ifs file yet.
    if (collection.format == QLatin1String("fractint"))
        remember(path, digest);
    else
        remember({}, {});
    recent_files::add(path);
    if (collection.format == QLatin1String("flame")) emit flamesOpened();
    if (collection.isOrderAssumed) emit orderAssumed(table);
    return std::nullopt;
}

std::optional<io::Failure> OpenFile::recover(const document::Snapshot& snapshot) {
    return recover(snapshot, snapshot.path.isEmpty() ? FileReading() : startReading(snapshot.path));
}

std::optional<io::Failure> OpenFile::recover(const document::Snapshot& snapshot, const FileReading& onDisk) {
    io::Failure failure;
    if (snapshot.path.isEmpty())
        m_isStopped = false;
    else
        failure = open(snapshot.path, onDisk);
    if (m_isStopped) return std::nullopt;
    if (snapshot.path.isEmpty() || failure) startNew();
    const QScopedValueRollback<bool> busy(m_isBusy, true);
    QFuture<document::FractalFile> reading = io::inBackground<document::FractalFile>(
        [snapshot, before = m_document->file()](QPromise<document::FractalFile>& promise) {
            document::FractalFile file =
                io::readFractint(snapshot.bytes, QFileInfo(snapshot.path).completeBaseName());
            keepIds(file, before);
            promise.addResult(std::move(file));
        });
    if (!hasRead(QFuture<void>(reading), tr("Reading “%1”…").arg(snapshot.title))) return std::nullopt;
    document::FractalFile recovered = reading.takeResult();
    const bool known = snapshot.current >= 0 && snapshot.current < recovered.entries.size();
    const document::EntryId current =
        known ? recovered.entries[snapshot.current].id : document::EntryId::None;
    if (snapshot.path.isEmpty()) { // no saved state for undo to return to
        m_document->setFile(std::move(recovered), current);
        m_document->undoStack()->resetClean();
    } else {
        m_document->editFile(tr("Recover unsaved work"), std::move(recovered), current);
    }
    if (!snapshot.path.isEmpty()) {
        m_path = snapshot.path;
        m_digest = snapshot.base; // ignores later versions by others
        m_isMissing = failure.has_value();
        claim();
        emit pathChanged();
    }
    return failure;
}

io::Failure OpenFile::save() {
    return write(m_path);
}

io::Failure OpenFile::saveAs(const QString& path) {
    return write(path);
}

io::Failure OpenFile::revert() {
    return open(m_path);
}

std::optional<OpenFile::OnDisk> OpenFile::onDisk() {
    if (m_path.isEmpty()) return OnDisk::Same;
    const QScopedValueRollback<bool> busy(m_isBusy, true);
    QFuture<OnDisk> result = io::inBackground<OnDisk>(
        io::Lane::Saving, [path = m_path, known = m_digest](QPromise<OnDisk>& promise) {
            promise.addResult(now(path, known));
        });
    if (!view::waitFor(QFuture<void>(result), tr("Reading “%1”…").arg(name()), m_window)) return std::nullopt;
    const OnDisk found = result.takeResult();
    return found == OnDisk::Gone && m_isMissing ? OnDisk::Same : found;
}

io::Failure OpenFile::write(const QString& path) {
    const QScopedValueRollback<bool> busy(m_isBusy, true);
    const auto writing = std::make_shared<Writing>();
    writing->wish = m_versions.wishFor(path);
    const auto inFolder = [from = m_path.isEmpty() ? QString() : QFileInfo(m_path).path(),
                           to = QFileInfo(path).absolutePath()](const document::FractalFile& of) {
        return document::withPicturesFoundFrom(of, from, to);
    };
    QFuture<void> work = writeBeside(writing, inFolder(m_document->file()), path);
    const auto file = QFileInfo(path).fileName();
    while (
        // Ends when the file is saved or saving is cancelled.
        !view::waitFor(work, tr("Saving “%1”…").arg(file), m_window))
        if (!writing->isDecided.exchange(true))
            return tr("Saving “%1” was cancelled. The file on disk is unchanged.").arg(file);
    work.waitForFinished(); // rethrows other exceptions
    m_versions.note(path, writing->kept, !writing->failure);
    if (writing->failure) return writing->failure;
    m_previous = writing->kept.outcome;
    m_otherNames = writing->otherNames;
    remember(path, writing->digest);
    m_document->editFile(tr("Adjust Picture Paths"), inFolder(m_document->file()), m_document->currentId());
    m_document->markSaved(writing->file);
    io::freeInBackground(std::move(writing->file));
    recent_files::add(path);
    return std::nullopt;
}

void OpenFile::remember(const QString& path, const QByteArray& digest) {
    // Independent of the current folder.
    m_path = path.isEmpty() ? QString() : QFileInfo(path).absoluteFilePath();
    m_digest = digest;
    m_isMissing = false;
    claim();
    emit pathChanged();
}

void OpenFile::claim() {
    if (m_path == m_claimed) return;
    m_claimed = m_path;
    ClaimLock former = std::exchange(m_claim, nullptr);
    if (m_path.isEmpty()) return document::startInLane(document::Lane::Asking, [former] {});
    auto* watcher = new QFutureWatcher<OpenClaim>(this);
    connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher, path = m_path] {
        watcher->deleteLater();
        const OpenClaim claimed = watcher->future().takeResult();
        if (path != m_claimed) return document::startInLane(document::Lane::Asking, [claimed] {});
        m_claim = claimed.lock;
        if (claimed.isElsewhere) emit isOpenElsewhere();
    });
    watcher->setFuture(claimBeside(m_path, std::move(former)));
}
