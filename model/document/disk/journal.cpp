// SPDX-License-Identifier: MIT
#include "document/disk/journal.h"

#include "document/disk/process_lock.h"
#include "document/disk/regular_file.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMap>
#include <QRegularExpression>
#include <QSaveFile>
#include <QUuid>

#include <algorithm>

namespace document {

namespace {

const char magic[] = "barycage-journal 1\n";
constexpr qint64 maxJournal = 512LL << 20; // bytes; larger files are no journals

// The digest of the fractals and the lesson alone, as earlier versions wrote it.
QByteArray digestOf(const Snapshot& snapshot) {
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(snapshot.bytes);
    hash.addData(snapshot.lesson);
    return hash.result().toHex();
}

constexpr char digestMark[] = "\"digest\":\""; // unique, because quotes in texts are escaped
constexpr qsizetype digestSize = 64;

// The digest of the whole file: the text of its header, with zeros in the place of the digest, and the bytes
// behind.
QByteArray digestOf(QByteArray header, qsizetype place, const QByteArray& bytes) {
    header.replace(place, digestSize, QByteArray(digestSize, '0'));
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(header);
    hash.addData(bytes);
    return hash.result().toHex();
}

// Offset of the digest; -1 in files of earlier versions.
qsizetype placeOfDigest(const QByteArray& header) {
    const qsizetype mark = header.indexOf(digestMark);
    return mark < 0 ? -1 : mark + qsizetype(sizeof digestMark) - 1;
}

std::optional<Snapshot> readJournal(const QString& path) {
    QFile file;
    if (!openRegular(file, QFile::encodeName(path)).isOpen() || file.size() > maxJournal) return std::nullopt;
    if (file.peek(sizeof magic - 1) != magic) return std::nullopt;
    return snapshotIn(file.readAll());
}

} // namespace

QByteArray recoveryFile(const Snapshot& snapshot) {
    QJsonObject header{
        {QStringLiteral("path"), snapshot.path},
        {QStringLiteral("title"), snapshot.title},
        {QStringLiteral("current"), snapshot.current},
        {QStringLiteral("when"), snapshot.when.toUTC().toString(Qt::ISODateWithMs)},
        {QStringLiteral("base"), QString::fromLatin1(snapshot.base.toHex())},
        {QStringLiteral("sha256"), QString::fromLatin1(digestOf(snapshot))},
    };
    if (!snapshot.lesson.isEmpty()) {
        header[QStringLiteral("lesson")] = QString::fromUtf8(snapshot.lesson);
        header[QStringLiteral("lesson-path")] = snapshot.lessonPath;
    }
    header[QStringLiteral("digest")] = QString(digestSize, u'0');
    QByteArray text = QJsonDocument(header).toJson(QJsonDocument::Compact);
    const qsizetype place = placeOfDigest(text);
    text.replace(place, digestSize, digestOf(text, place, snapshot.bytes));
    return magic + text + '\n' + snapshot.bytes;
}

std::optional<Snapshot> snapshotIn(const QByteArray& data) {
    if (!data.startsWith(magic)) return std::nullopt;
    const qsizetype start = qsizetype(sizeof magic) - 1;
    const qsizetype end = data.indexOf('\n', start);
    if (end < 0) return std::nullopt;
    const QByteArray text = data.mid(start, end - start);
    const QJsonObject header = QJsonDocument::fromJson(text).object();
    Snapshot snapshot;
    snapshot.path = header[QLatin1String("path")].toString();
    snapshot.title = header[QLatin1String("title")].toString();
    snapshot.current = header[QLatin1String("current")].toInt();
    snapshot.when = QDateTime::fromString(header[QLatin1String("when")].toString(), Qt::ISODateWithMs);
    snapshot.base = QByteArray::fromHex(header[QLatin1String("base")].toString().toLatin1());
    snapshot.bytes = data.mid(end + 1);
    snapshot.lesson = header[QLatin1String("lesson")].toString().toUtf8();
    snapshot.lessonPath = header[QLatin1String("lesson-path")].toString();
    if (header[QLatin1String("sha256")].toString() != QLatin1String(digestOf(snapshot))) return std::nullopt;
    const qsizetype place = placeOfDigest(text);
    if (place >= 0 && text.mid(place, digestSize) != digestOf(text, place, snapshot.bytes))
        return std::nullopt;
    return snapshot;
}

Journal::Journal(const QString& folder)
    : m_path(QDir(folder).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) +
                                   QStringLiteral(".journal"))) {}

Journal::~Journal() = default;

bool Journal::write(const Snapshot& snapshot) {
    // Creates the folder the first time, if there was no room for the lock, or if the folder has been
    // emptied.
    if (!m_lock || !QFileInfo::exists(lockFileOf(m_path))) {
        makePrivateFolder(QFileInfo(m_path).path());
        m_lock.reset();
        m_lock = processLock(m_path);
    }
    if (!m_lock) return false;
    QSaveFile file(m_path);
    if (!file.open(QIODevice::WriteOnly)) return false;
    file.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
    const QByteArray data = recoveryFile(snapshot);
    // Flushes first, because commit() would not notice that buffered bytes find no room.
    return file.write(data) == data.size() && file.flush() && file.commit();
}

void Journal::discard() {
    QFile::remove(m_path);
}

void Journal::letGo() {
    m_lock.reset();
}

QList<Abandoned> abandonedSnapshots(const QString& folder) {
    QList<Abandoned> found;
    const QDir dir(folder);
    // Name of a journal, its lock, or a temporary file of QSaveFile whose process was killed.
    static const QRegularExpression name(QStringLiteral("^(.*\\.journal)(\\..*)?$"));
    QMap<QString, QStringList> leftovers; // other files of each journal
    for (const QString& file : dir.entryList(QDir::Files))
        if (const auto match = name.match(file); match.hasMatch())
            leftovers[match.captured(1)] << match.captured(2);
    for (const auto& [journal, endings] : leftovers.asKeyValueRange()) {
        const QString path = dir.filePath(journal);
        std::shared_ptr<ProcessLock> owned = processLock(path);
        if (!owned) continue; // its window still exists, or another process offers it
        for (const QString& ending : endings)
            if (!ending.isEmpty() && path + ending != lockFileOf(path)) QFile::remove(path + ending);
        if (auto snapshot = readJournal(path))
            found << Abandoned{path, *std::move(snapshot), std::move(owned)};
    }
    std::sort(found.begin(), found.end(),
              [](const Abandoned& a, const Abandoned& b) { return a.snapshot.when > b.snapshot.when; });
    // Duplicates remain if a process that took over a journal was killed before it removed the first copy.
    for (qsizetype i = found.size(); i-- > 1;)
        if (std::any_of(found.begin(), found.begin() + i, [&](const Abandoned& newer) {
                return newer.snapshot.path == found[i].snapshot.path &&
                       newer.snapshot.bytes == found[i].snapshot.bytes &&
                       newer.snapshot.lesson == found[i].snapshot.lesson;
            })) {
            forget(found[i]);
            found.removeAt(i);
        }
    return found;
}

void forget(const Abandoned& abandoned) {
    QFile::remove(abandoned.journal);
}

QStringList setDamagedAside(const QString& folder) {
    QStringList aside;
    const QDir dir(folder);
    for (const QString& name : dir.entryList({QStringLiteral("*.journal")}, QDir::Files)) {
        const QString path = dir.filePath(name);
        const auto owned = processLock(path);
        if (!owned || readJournal(path)) continue;
        const QString kept = dir.filePath(QFileInfo(name).completeBaseName() + QStringLiteral(".damaged"));
        if (QFile::rename(path, kept)) aside << kept;
    }
    return aside;
}

} // namespace document
