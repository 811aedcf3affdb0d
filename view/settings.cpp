// SPDX-License-Identifier: MIT
#include "settings.h"

#include "io/background.h"

#include <QFuture>
#include <QHash>
#include <QMutex>
#include <QSettings>

#include <optional>
#include <utility>

namespace view {

namespace {

// What is on its way to the disk.
class Storing {
public:
    void add(const QString& key, const QVariant& value) {
        const QMutexLocker locker(&m_mutex);
        m_values[key] = {value, ++m_calls};
        if (std::exchange(m_isStarted, true)) return;
        m_last = QFuture<void>(io::inBackground<bool>([this](QPromise<bool>&) { write(); }));
    }
    std::optional<QVariant> find(const QString& key) {
        const QMutexLocker locker(&m_mutex);
        const auto found = m_values.constFind(key);
        return found == m_values.cend() ? std::nullopt : std::optional(found->first);
    }
    void finish() { m_last.waitForFinished(); }

private:
    using Values = QHash<QString, std::pair<QVariant, int>>; // with the number of the call

    void write() {
        const QMutexLocker writing(&m_writing); // what is newer is written later
        const Values values = [this] {
            const QMutexLocker locker(&m_mutex);
            m_isStarted = false;
            return m_values;
        }();
        {
            QSettings settings;
            for (const auto& [key, value] : values.asKeyValueRange())
                if (value.first.isValid())
                    settings.setValue(key, value.first);
                else
                    settings.remove(key);
        } // and now it is written
        const QMutexLocker locker(&m_mutex);
        m_values.removeIf([&](const auto& entry) { return values.value(entry.key()) == entry.value(); });
    }

    QMutex m_mutex;
    Values m_values;
    int m_calls = 0;
    bool m_isStarted = false; // a write that will find what is added now
    QMutex m_writing;
    QFuture<void> m_last;
};

Storing& storing() {
    static Storing all;
    return all;
}

} // namespace

void store(const QString& key, const QVariant& value) {
    storing().add(key, value);
}

QVariant stored(const QString& key, const QVariant& otherwise) {
    const auto value = storing().find(key);
    if (!value) return QSettings().value(key, otherwise);
    return value->isValid() ? *value : otherwise;
}

void finishStoring() {
    storing().finish();
}

} // namespace view
