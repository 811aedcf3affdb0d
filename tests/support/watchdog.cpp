// SPDX-License-Identifier: MIT
#include "support/watchdog.h"

#include <QMetaEnum>
#include <QMouseEvent>
#include <QThread>

#include <algorithm>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <cxxabi.h>
#include <dlfcn.h>
#include <execinfo.h>
#include <unistd.h>

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

// How many times slower this machine is, at this moment, than one on which the limits hold: from the time for
// work of the kind that events do, to print numbers and to put texts together.
double slowness() {
    constexpr double usual = 4; // milliseconds
    const double began = processorTime();
    std::vector<std::string> texts;
    double value = 0.1;
    for (int i = 0; i < 20'000; ++i) {
        char digits[32];
        const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
        texts.push_back("a number, and its text: " + std::string(digits, end));
        value *= 3.7 * (1 - value);
    }
    std::string all;
    for (const std::string& text : texts)
        all += text;
    volatile char last = all.back();
    Q_UNUSED(last)
    return std::max(1., (processorTime() - began) / usual);
}

bool isOfAKey(QEvent::Type type) {
    return type == QEvent::KeyPress || type == QEvent::KeyRelease || type == QEvent::ShortcutOverride ||
           type == QEvent::Shortcut;
}

void* functions[26];
volatile std::sig_atomic_t functionCount = 0;

void noteFunctions(int /*signal*/) {
    functionCount = backtrace(functions, int(std::size(functions)));
}

QString nameOf(void* address) {
    Dl_info found;
    if (!dladdr(address, &found) || !found.dli_sname) return QStringLiteral("?");
    int status = 0;
    const std::unique_ptr<char, decltype(&free)> plain(
        abi::__cxa_demangle(found.dli_sname, nullptr, nullptr, &status), &free);
    return QLatin1String(status == 0 ? plain.get() : found.dli_sname);
}

} // namespace

Alarm::Alarm() {
    backtrace(functions, 1); // loads what it needs, which a signal's handler must not
    struct sigaction action {};
    action.sa_handler = noteFunctions;
    action.sa_flags = SA_RESTART;
    sigaction(SIGPROF, &action, nullptr);
    sigevent event{};
    event.sigev_notify = SIGEV_THREAD_ID;
    event.sigev_signo = SIGPROF;
    event._sigev_un._tid = gettid();
    if (timer_create(CLOCK_THREAD_CPUTIME_ID, &event, &m_timer) != 0) qFatal("no timer of processor time");
}

Alarm::~Alarm() {
    timer_delete(m_timer);
}

void Alarm::set(double milliseconds) {
    functionCount = 0;
    itimerspec time{};
    time.it_value.tv_nsec = long(milliseconds * 1e6);
    timer_settime(m_timer, 0, &time, nullptr);
}

QString Alarm::noted() const {
    QStringList names;
    for (int i = 2; i < functionCount; ++i) // after the handler and the signal
        names << nameOf(functions[i]).left(100);
    return names.join(QStringLiteral("\n    "));
}

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
    m_running.append({level, processorTime(), 0, limits[dragging]});
    if (judged) m_alarm.set(limits[dragging]);
    const bool handled = Application::notify(receiver, event);
    const Running done = m_running.takeLast();
    const double now = processorTime();
    const double all = now - done.began;
    if (!done.ignored) judge(seen, dragging, all - done.inner);
    if (!m_running.isEmpty()) {
        Running& around = m_running.last();
        around.inner += all;
        const double left = around.limit - (now - around.began - around.inner);
        if (judged && left > 0) m_alarm.set(left);
    }
    return handled;
}

void WatchedApplication::judge(const Event& event, bool dragging, double spent) {
    Tally& tally = m_tally[dragging];
    ++tally.count;
    tally.slowest = std::max(tally.slowest, spent);
    if (!judged || spent <= limits[dragging]) return;
    const double slow = slowness();
    const double limit = limits[dragging] * slow;
    if (spent <= limit) return;
    ++tally.late;
    m_unforgivable = m_unforgivable || spent > 2 * limit;
    m_late << QStringLiteral("%1 to %2 took %3 ms on a machine %4 times as slow as usual%5")
                  .arg(QLatin1String(QMetaEnum::fromType<QEvent::Type>().valueToKey(event.type)),
                       QLatin1String(event.receiver))
                  .arg(spent, 0, 'f', 1)
                  .arg(slow, 0, 'f', 1)
                  .arg(dragging ? QStringLiteral(" during a drag") : QString());
    fprintf(stderr, "late: %s\n    %s\n", qPrintable(m_late.last()), qPrintable(m_alarm.noted()));
}

void WatchedApplication::ignoreThisEvent() {
    if (!m_running.isEmpty()) m_running.last().ignored = true;
}

QStringList WatchedApplication::takeLate() {
    qint64 few = 0, others = 0;
    for (const bool dragging : {false, true}) {
        const Tally before = std::exchange(m_lastTally[dragging], m_tally[dragging]);
        if (dragging)
            few = std::max<qint64>(2, (m_tally[dragging].count - before.count) / 1000);
        else
            others = m_tally[dragging].late - before.late;
    }
    const QStringList late = std::exchange(m_late, {});
    const bool forgiven = !std::exchange(m_unforgivable, false) && late.size() <= few && others <= 2;
    return forgiven ? QStringList() : late;
}

QString WatchedApplication::summary() const {
    const auto textOf = [](const Tally& tally, const QString& which) {
        return QStringLiteral("%1 events %2, %3 late, the slowest %4 ms")
            .arg(tally.count)
            .arg(which)
            .arg(tally.late)
            .arg(tally.slowest, 0, 'f', 1);
    };
    return textOf(m_tally[true], QStringLiteral("during drags")) + QStringLiteral("; ") +
           textOf(m_tally[false], QStringLiteral("otherwise"));
}

} // namespace support
