// SPDX-License-Identifier: MIT
#include "io/file/slow_disk.h"

#include "document/background/background_threads.h"

#include <QFileInfo>
#include <QHash>
#include <QSet>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <utility>

namespace io {

namespace {

// Known existence of paths, and the questions under way.
class Presence {
public:
    void ask(const QString& path) {
        {
            const std::scoped_lock lock(m_mutex);
            if (m_asked.contains(path)) return;
            m_asked.insert(path);
        }
        document::startInLane(document::Lane::Asking, [this, path] {
            const bool isGone = !QFileInfo::exists(path);
            const std::scoped_lock lock(m_mutex);
            m_isGone[path] = isGone;
            m_asked.remove(path);
            m_answered.notify_all();
        });
    }
    bool isAsked(const QString& path) {
        const std::scoped_lock lock(m_mutex);
        return m_asked.contains(path);
    }
    // Waits for answers about all paths, up to the limit.
    void wait(const QStringList& paths, std::chrono::milliseconds patience) {
        std::unique_lock lock(m_mutex);
        m_answered.wait_for(lock, patience, [&] {
            return !m_asked.intersects({paths.begin(), paths.end()});
        });
    }
    bool isGone(const QString& path) {
        const std::scoped_lock lock(m_mutex);
        return m_isGone.value(path, false);
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_answered;
    QHash<QString, bool> m_isGone;
    QSet<QString> m_asked;
};

} // namespace

std::optional<bool> answerSoon(std::function<bool()> question, std::chrono::milliseconds patience) {
    struct Shared {
        std::mutex mutex;
        std::condition_variable answered;
        std::optional<bool> answer;
    };
    const auto shared = std::make_shared<Shared>();
    document::startInLane(document::Lane::Asking, [shared, question = std::move(question)] {
        const bool answer = question();
        const std::scoped_lock lock(shared->mutex);
        shared->answer = answer;
        shared->answered.notify_all();
    });
    std::unique_lock lock(shared->mutex);
    shared->answered.wait_for(lock, patience, [&] { return shared->answer.has_value(); });
    return shared->answer;
}

QStringList withoutGone(const QStringList& paths, std::chrono::milliseconds patience) {
    static auto* const presence = new Presence; // never destroyed, because threads may use it to the end
    QStringList asked;
    for (const QString& path : paths) {
        if (presence->isAsked(path)) continue; // still unanswered
        presence->ask(path);
        asked << path;
    }
    presence->wait(asked, patience);
    QStringList left = paths;
    left.removeIf([](const QString& path) { return presence->isGone(path); });
    return left;
}

} // namespace io
