// SPDX-License-Identifier: MIT
#include "support/watchdog.h"

#include <QMetaEnum>
#include <QMouseEvent>
#include <QThread>

#include <ctime>

namespace support {

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__OPTIMIZE__)
constexpr bool judged = false;
#else
constexpr bool judged = true;
#endif

constexpr double limits[] = {100, 16}; // milliseconds: otherwise, while dragging

double processorTime() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) * 1e3 + double(now.tv_nsec) / 1e6;
}

bool isOfAKey(QEvent::Type type) {
    return type == QEvent::KeyPress || type == QEvent::KeyRelease || type == QEvent::ShortcutOverride ||
           type == QEvent::Shortcut;
}

} // namespace

bool WatchedApplication::notify(QObject* receiver, QEvent* event) {
    if (QThread::currentThread() != thread()) return Application::notify(receiver, event);
    const int level = thread()->loopLevel();
    if (!m_running.isEmpty() && m_running.last().loopLevel == level) // part of the event around it
        return Application::notify(receiver, event);
    // Neither need outlive the event.
    const Event seen{event->type(), receiver->metaObject()->className()};
    // A release ends a drag; sent by a test, it comes before the application knows.
    const Qt::MouseButtons held = seen.type == QEvent::MouseButtonRelease
                                      ? static_cast<QMouseEvent*>(event)->buttons()
                                      : mouseButtons();
    const bool dragging = held != Qt::NoButton && !isOfAKey(seen.type);
    m_running.append({level, processorTime(), 0});
    const bool handled = Application::notify(receiver, event);
    const Running done = m_running.takeLast();
    const double all = processorTime() - done.began;
    if (!m_running.isEmpty()) m_running.last().inner += all;
    if (!done.ignored) judge(seen, dragging, all - done.inner);
    return handled;
}

void WatchedApplication::judge(const Event& event, bool dragging, double spent) {
    ++m_count[dragging];
    m_slowest[dragging] = std::max(m_slowest[dragging], spent);
    if (dragging) ++m_forgivable;
    if (!judged || spent <= limits[dragging]) return;
    ++m_lateCount[dragging];
    m_unforgivable = m_unforgivable || spent > 2 * limits[dragging];
    m_late << QStringLiteral("%1 to %2 took %3 ms%4")
                  .arg(QLatin1String(QMetaEnum::fromType<QEvent::Type>().valueToKey(event.type)),
                       QLatin1String(event.receiver))
                  .arg(spent, 0, 'f', 1)
                  .arg(dragging ? QStringLiteral(" during a drag") : QString());
}

void WatchedApplication::ignoreThisEvent() {
    if (!m_running.isEmpty()) m_running.last().ignored = true;
}

QStringList WatchedApplication::takeLate() {
    const qint64 few = std::max<qint64>(2, std::exchange(m_forgivable, 0) / 1000);
    const bool forgiven = !std::exchange(m_unforgivable, false) && m_late.size() <= few;
    const QStringList late = std::exchange(m_late, {});
    return forgiven ? QStringList() : late;
}

QString WatchedApplication::summary() const {
    return QStringLiteral(
               "%1 events, %2 late, the slowest %3 ms; %4 during drags, %5 late, the slowest %6 ms")
        .arg(m_count[0])
        .arg(m_lateCount[0])
        .arg(m_slowest[0], 0, 'f', 1)
        .arg(m_count[1])
        .arg(m_lateCount[1])
        .arg(m_slowest[1], 0, 'f', 1);
}

} // namespace support
