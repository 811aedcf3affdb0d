// SPDX-License-Identifier: MIT
#include "open_file.h"

#include "io/fractint_reader.h"
#include "io/fractint_writer.h"
#include "reading.h"
#include "recent_files.h"

#include <QCryptographicHash>
#include <QFileInfo>
#include <QHash>

namespace {

QByteArray digestOf(const QByteArray& bytes) {
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256);
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

OpenFile::OpenFile(document::Document* document, QWidget* window) : m_document(document), m_window(window) {}

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

io::Failure OpenFile::open(const QString& path) {
    m_isReading = true;
    auto [loaded, collection] = readFile(path, m_window);
    m_isReading = false;
    if (loaded.failure) return loaded.failure;
    if (collection.file.entries.isEmpty() && !collection.file.problems.isEmpty())
        return collection.file.problems.first().message;
    m_document->setFile(std::move(collection.file));
    // What was taken out of another format has no .ifs file to be saved to yet.
    if (collection.format == QLatin1String("fractint"))
        remember(path, loaded.bytes);
    else
        remember({}, {});
    recent_files::add(path);
    if (collection.format == QLatin1String("flame")) emit flamesOpened();
    if (collection.isOrderAssumed) emit orderAssumed(QString::fromUtf8(loaded.bytes));
    return std::nullopt;
}

io::Failure OpenFile::recover(const document::Snapshot& snapshot) {
    io::Failure failure;
    if (!snapshot.path.isEmpty()) failure = open(snapshot.path);
    if (snapshot.path.isEmpty() || failure) startNew();
    document::FractalFile recovered =
        io::readFractint(snapshot.bytes, QFileInfo(snapshot.path).completeBaseName());
    keepIds(recovered, m_document->file());
    const bool known = snapshot.current >= 0 && snapshot.current < recovered.entries.size();
    const document::EntryId current =
        known ? recovered.entries[snapshot.current].id : document::EntryId::None;
    m_document->editFile(tr("Recover unsaved work"), std::move(recovered), current);
    if (!snapshot.path.isEmpty()) {
        m_path = snapshot.path;
        m_digest = snapshot.base; // not what somebody else may have written since
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

bool OpenFile::changedOnDisk() const {
    if (m_path.isEmpty() || !QFileInfo::exists(m_path)) return false;
    const io::Loaded now = io::loadFile(m_path);
    return now.failure || digestOf(now.bytes) != m_digest;
}

io::Failure OpenFile::write(const QString& path) {
    const QByteArray bytes = io::writeFractint(m_document->file());
    if (io::Failure failure = io::saveFile(path, bytes)) return failure;
    m_document->markSaved(io::readFractint(bytes, QFileInfo(path).completeBaseName()));
    remember(path, bytes);
    recent_files::add(path);
    return std::nullopt;
}

void OpenFile::remember(const QString& path, const QByteArray& bytes) {
    m_path = path;
    m_digest = digestOf(bytes);
    emit pathChanged();
}
