// SPDX-License-Identifier: MIT
#include "desktop/settings.h"

#include "io/file/background.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QFuture>
#include <QHash>
#include <QMutex>
#include <QSettings>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace view {

namespace {

// Files of settings hold everything as text.
bool isSame(const QVariant& found, const QVariant& value) {
    if (found.isValid() != value.isValid()) return false;
    if (value.typeId() == QMetaType::QStringList) return found.toStringList() == value.toStringList();
    if (value.typeId() == QMetaType::QByteArray) return found == value;
    return found.toString() == value.toString();
}

// The names of files and folders that the settings hold are nobody else's business. QSettings would make them
// as the umask says; it writes into the folder a file that takes over the permissions of the one before.
void makePrivate(const QString& file) {
    constexpr auto owner = QFile::ReadOwner | QFile::WriteOwner;
    const QString folder = QFileInfo(file).path();
    QDir().mkpath(folder);
    QFile::setPermissions(folder, owner | QFile::ExeOwner);
    QFile settings(file);
    if (!settings.exists() && !settings.open(QIODevice::WriteOnly | QIODevice::NewOnly)) return;
    settings.setPermissions(owner);
}

// A value that another thread reads.
class Answer {
public:
    explicit Answer(const QString& key) : m_shared(std::make_shared<Shared>()) {
        document::startInLane(document::Lane::Reading, [shared = m_shared, key] {
            const QVariant found = QSettings().value(key);
            const std::scoped_lock lock(shared->mutex);
            shared->value = found;
            shared->came.notify_all();
        });
    }
    std::optional<QVariant> within(std::chrono::milliseconds patience) const {
        std::unique_lock lock(m_shared->mutex);
        m_shared->came.wait_for(lock, patience, [this] { return m_shared->value.has_value(); });
        return m_shared->value;
    }

private:
    struct Shared {
        std::mutex mutex;
        std::condition_variable came;
        std::optional<QVariant> value;
    };
    std::shared_ptr<Shared> m_shared;
};

// Values on their way to the disk. Meanwhile nothing is read from there: Qt's reader would write what the
// writer has not yet written.
class Storing {
public:
    void add(const QString& key, const QVariant& value) {
        if (isSame(find(key), value)) return;
        const QMutexLocker locker(&m_mutex);
        m_known[key] = value;
        m_values[key] = {value, ++m_calls};
        if (std::exchange(m_isStarted, true)) return;
        m_last =
            QFuture<void>(io::inBackground<bool>(io::Lane::Saving, [this](QPromise<bool>&) { write(); }));
    }
    QVariant find(const QString& key) {
        {
            const QMutexLocker locker(&m_mutex);
            if (!m_values.isEmpty() && m_known.contains(key)) return m_known[key];
        }
        const std::optional<QVariant> found = read(key);
        const QMutexLocker locker(&m_mutex);
        if (found) m_known[key] = *found;
        return m_known.value(key);
    }
    bool finish(std::chrono::milliseconds patience) {
        if (!io::finishesWithin(patience, m_last)) return false;
        const QMutexLocker locker(&m_mutex);
        m_known.clear();
        return true;
    }

private:
    using Values = QHash<QString, std::pair<QVariant, int>>; // values with the number of the call

    // Waits once: after a failure to answer, later reads return at once until the disk has answered.
    std::optional<QVariant> read(const QString& key) {
        constexpr std::chrono::seconds patience(2);
        if (m_late && !m_late->within(std::chrono::milliseconds(0))) return std::nullopt;
        m_late.reset();
        const Answer answer(key);
        std::optional<QVariant> found = answer.within(patience);
        if (!found) m_late = answer;
        return found;
    }

    void write() {
        const QMutexLocker writing(&m_writing); // later values are written in another call
        const Values values = [this] {
            const QMutexLocker locker(&m_mutex);
            m_isStarted = false;
            return m_values;
        }();
        { // separate scope: QSettings keeps what it cannot write, and tries again with the next values
            QSettings settings;
            makePrivate(settings.fileName());
            for (const auto& [key, value] : values.asKeyValueRange())
                if (value.first.isValid())
                    settings.setValue(key, value.first);
                else
                    settings.remove(key);
            settings.sync();
            report(settings.status() == QSettings::NoError, settings.fileName());
        }
        const QMutexLocker locker(&m_mutex);
        m_values.removeIf([&](const auto& entry) { return values.value(entry.key()) == entry.value(); });
    }

    // Reports in the GUI thread.
    void report(bool isWritten, const QString& file) {
        if (!std::exchange(m_isWritten, isWritten) || isWritten) return;
        const QString sentence =
            StoringReport::tr("The settings cannot be saved: “%1” is not writable, or the disk is full.")
                .arg(QDir::toNativeSeparators(file));
        QMetaObject::invokeMethod(
            storingReport(), [sentence] { emit storingReport()->cannotStore(sentence); },
            Qt::QueuedConnection);
    }

    QMutex m_mutex;
    Values m_values; // values not yet written
    QHash<QString, QVariant> m_known;
    int m_calls = 0;
    bool m_isStarted = false; // true: a pending write will include new values
    QMutex m_writing;
    bool m_isWritten = true; // result of the last write
    QFuture<void> m_last;
    std::optional<Answer> m_late;
};

Storing& storing() {
    storingReport();                      // creates the object in the GUI thread
    static auto* const all = new Storing; // never destroyed, because a thread may use it to the end
    return *all;
}

} // namespace

StoringReport* storingReport() {
    static auto* const report = new StoringReport; // never destroyed
    return report;
}

void store(const QString& key, const QVariant& value) {
    storing().add(key, value);
}

QVariant stored(const QString& key, const QVariant& otherwise) {
    const QVariant value = storing().find(key);
    return value.isValid() ? value : otherwise;
}

bool finishStoring(std::chrono::milliseconds patience) {
    return storing().finish(patience);
}

} // namespace view
