// SPDX-License-Identifier: MIT
#pragma once

#include "application.h"

#include <QEvent>
#include <QStringList>

#include <ctime>

namespace support {

// Notes what the thread that made it is doing once it has worked for so long.
class Alarm {
public:
    Alarm();
    ~Alarm();
    Alarm(const Alarm&) = delete;
    Alarm& operator=(const Alarm&) = delete;

    void set(double milliseconds);       // of processor time, from now on; what was noted is forgotten
    [[nodiscard]] QString noted() const; // the functions, the innermost first; empty before the time is over

private:
    timer_t m_timer{};
};

// The application of the program, which also measures what each event costs the thread of the window, in
// processor time. An event that the window waits for too long is late: over 16 ms while a button is held,
// over 100 ms otherwise, or as many times more as the machine is slow at that moment. Work that an event
// gives to other threads does not count. Nothing is late in a build that is not optimised or is instrumented.
class WatchedApplication : public Application {
public:
    using Application::Application;

    bool notify(QObject* receiver, QEvent* event) override;

    // What was late since the last call, a line each; what it was doing when its time was over is printed at
    // once. On a busy machine even processor time is stretched: two late events, or one in a thousand
    // during drags, are forgiven, of the others never more than two, when none took twice as long as it may.
    QStringList takeLate();
    void ignoreThisEvent();  // it is a test's own work
    QString summary() const; // how many events, and the slowest of either kind

private:
    struct Running {
        int loopLevel; // of event loops inside each other
        double began;  // milliseconds of processor time
        double inner;  // spent in events of loops inside this event: theirs, not its
        double limit;
        bool ignored = false;
    };
    struct Event {
        QEvent::Type type;
        const char* receiver; // its class
    };
    void judge(const Event& event, bool dragging, double spent);

    Alarm m_alarm;

    QList<Running> m_running;
    struct Tally { // of the events during drags, or of the others
        qint64 count = 0;
        qint64 late = 0;
        double slowest = 0; // milliseconds
    };
    QStringList m_late;
    bool m_unforgivable = false;
    Tally m_tally[2];     // otherwise, while dragging
    Tally m_lastTally[2]; // at the last call
};

} // namespace support
