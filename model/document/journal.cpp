// SPDX-License-Identifier: MIT
#include "document/journal.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLockFile>
#include <QSaveFile>
#include <QUuid>

#include <algorithm>

namespace document {

namespace {

const char magic[] = "barycage-journal 1\n";
constexpr qint64 maxJournal = 512LL << 20; // bytes; larger files are not ours

QString lockOf(const QString& journal) {
    return journal + QStringLiteral(".lock");
}

// The owner's process keeps the lock for as long as it lives; its age says nothing.
std::unique_ptr<QLockFile> lock(const QString& journal) {
    auto made = std::make_unique<QLockFile>(lockOf(journal));
    made->setStaleLockTime(0);
    return made->tryLock(0) ? std::move(made) : nullptr;
}

std::optional<Snapshot> readJournal(const QString& path) {
    QFile file(path);
    if (file.size() > maxJournal || !file.open(QIODevice::ReadOnly)) return std::nullopt;
    return snapshotIn(file.readAll());
}

} // namespace

QByteArray recoveryFile(const Snapshot& snapshot) {
    const QJsonObject header{
        {QStringLiteral("path"), snapshot.path},
        {QStringLiteral("title"), snapshot.title},
        {QStringLiteral("current"), snapshot.current},
        {QStringLiteral("when"), snapshot.when.toUTC().toString(Qt::ISODateWithMs)},
        {QStringLiteral("sha256"),
         QString::fromLatin1(QCryptographicHash::hash(snapshot.bytes, QCryptographicHash::Sha256).toHex())},
    };
    return magic + QJsonDocument(header).toJson(QJsonDocument::Compact) + '\n' + snapshot.bytes;
}

std::optional<Snapshot> snapshotIn(const QByteArray& data) {
    if (!data.startsWith(magic)) return std::nullopt;
    const qsizetype start = qsizetype(sizeof magic) - 1;
    const qsizetype end = data.indexOf('\n', start);
    if (end < 0) return std::nullopt;
    const QJsonObject header = QJsonDocument::fromJson(data.mid(start, end - start)).object();
    Snapshot snapshot;
    snapshot.path = header[QLatin1String("path")].toString();
    snapshot.title = header[QLatin1String("title")].toString();
    snapshot.current = header[QLatin1String("current")].toInt();
    snapshot.when = QDateTime::fromString(header[QLatin1String("when")].toString(), Qt::ISODateWithMs);
    snapshot.bytes = data.mid(end + 1);
    const QByteArray digest = QCryptographicHash::hash(snapshot.bytes, QCryptographicHash::Sha256).toHex();
    if (header[QLatin1String("sha256")].toString() != QLatin1String(digest)) return std::nullopt;
    return snapshot;
}

Journal::Journal(const QString& folder) {
    QDir().mkpath(folder);
    QFile::setPermissions(folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    m_path = QDir(folder).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) +
                                   QStringLiteral(".journal"));
    m_lock = lock(m_path);
}

Journal::~Journal() = default;

bool Journal::write(const Snapshot& snapshot) {
    if (!m_lock) return false;
    QSaveFile file(m_path);
    if (!file.open(QIODevice::WriteOnly)) return false;
    file.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
    const QByteArray data = recoveryFile(snapshot);
    return file.write(data) == data.size() && file.commit();
}

void Journal::discard() {
    QFile::remove(m_path);
}

QList<Abandoned> abandonedSnapshots(const QString& folder) {
    QList<Abandoned> found;
    const QDir dir(folder);
    for (const QString& name : dir.entryList({QStringLiteral("*.journal")}, QDir::Files)) {
        const QString path = dir.filePath(name);
        const auto owner = lock(path);
        if (!owner) continue; // its window is alive
        if (auto snapshot = readJournal(path)) found << Abandoned{path, *std::move(snapshot)};
    }
    std::sort(found.begin(), found.end(),
              [](const Abandoned& a, const Abandoned& b) { return a.snapshot.when > b.snapshot.when; });
    return found;
}

void forget(const Abandoned& abandoned) {
    if (lock(abandoned.journal)) QFile::remove(abandoned.journal);
}

} // namespace document
