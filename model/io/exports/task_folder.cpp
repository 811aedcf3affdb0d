// SPDX-License-Identifier: MIT
#include "io/exports/task_folder.h"

#include "document/disk/process_lock.h"
#include "document/disk/regular_file.h"
#include "document/text/text.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QUuid>

#include <algorithm>

namespace io {

namespace {

const QString ending = QStringLiteral(".export");
constexpr qint64 maxTask = 256LL << 20; // bytes

ReadTask readTask(const QString& path) {
    QFile file;
    const document::Opened opened = document::openRegular(file, QFile::encodeName(path));
    if (QFileInfo(path).isSymLink() || opened.isSpecial())
        return {std::nullopt, Text::tr("It is not a regular file.")};
    if (!opened.isOpen()) return {std::nullopt, Text::tr("It cannot be read.")};
    if (file.size() > maxTask) return {std::nullopt, Text::tr("It is too large.")};
    return taskIn(file.readAll());
}

} // namespace

TaskFolder::TaskFolder(const QString& folder) : m_folder(folder) {}

TaskFolder::~TaskFolder() = default;

QString TaskFolder::newId() {
    return QUuid::createUuid().toString(QUuid::WithoutBraces);
}

QString TaskFolder::pathOf(const QString& id) const {
    return QDir(m_folder).filePath(id + ending);
}

// Works even if somebody has emptied the folder meanwhile.
bool TaskFolder::own(const QString& id) {
    const QString path = pathOf(id);
    std::unique_ptr<document::ProcessLock>& lock = m_locks[id];
    if (lock && QFileInfo::exists(document::lockFileOf(path))) return true;
    document::makePrivateFolder(m_folder);
    lock.reset();
    lock = document::processLock(path);
    return lock != nullptr;
}

bool TaskFolder::write(const QString& id, const ExportTask& task) {
    if (!own(id)) return false;
    QSaveFile file(pathOf(id));
    if (!file.open(QIODevice::WriteOnly)) return false;
    file.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
    const QByteArray data = taskFile(task);
    // Flushes first, because commit() would not notice that buffered bytes find no room.
    return file.write(data) == data.size() && file.flush() && file.commit();
}

void TaskFolder::remove(const QString& id) {
    QFile::remove(pathOf(id));
    m_locks.erase(id);
}

void TaskFolder::letGo() {
    m_locks.clear();
}

// Two processes that start at the same moment may both find the lock free. Only one of them can rename the
// file, and its new name is locked before anybody else knows it.
void TaskFolder::claim(const QString& path, TakenOver& taken) {
    const std::unique_ptr<document::ProcessLock> gone = document::processLock(path);
    if (!gone) return; // its process still runs
    const QString id = newId();
    if (!own(id)) return;
    if (!QFile::rename(path, pathOf(id))) {
        m_locks.erase(id);
        return;
    }
    ReadTask read = readTask(pathOf(id));
    if (read.task) {
        taken.tasks << Found{id, *std::move(read.task)};
        return;
    }
    const QString aside = QDir(m_folder).filePath(id + QStringLiteral(".damaged"));
    QFile::rename(pathOf(id), aside);
    m_locks.erase(id);
    taken.skipped
        << Text::tr("An export from the last session was skipped. %1 Its damaged file was renamed to %2.")
               .arg(*read.failure, QDir::toNativeSeparators(aside));
}

TaskFolder::TakenOver TaskFolder::takeOver() {
    TakenOver taken;
    const QDir folder(m_folder);
    const auto everything = QDir::Files | QDir::System | QDir::Hidden;
    for (const QString& name : folder.entryList({u'*' + ending}, everything))
        if (!m_locks.contains(name.chopped(ending.size()))) claim(folder.filePath(name), taken);
    // Removes temporary files of killed processes: QSaveFile appends letters to the name.
    for (const QString& name : folder.entryList({u'*' + ending + QStringLiteral(".*")}, everything)) {
        const QString path = folder.filePath(name.left(name.indexOf(ending) + ending.size()));
        const bool isOurs = m_locks.contains(QFileInfo(path).fileName().chopped(ending.size()));
        if (isOurs) continue;
        const auto gone = document::processLock(path); // removes a leftover lock, too
        if (gone && folder.filePath(name) != document::lockFileOf(path)) QFile::remove(folder.filePath(name));
    }
    std::ranges::stable_sort(taken.tasks,
                             [](const Found& a, const Found& b) { return a.task.place < b.task.place; });
    return taken;
}

} // namespace io
