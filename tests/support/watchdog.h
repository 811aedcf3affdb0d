// SPDX-License-Identifier: MIT
#pragma once

#include "application.h"

#include <QEvent>
#include <QStringList>

namespace support {

// The application of the program, which also measures what each event costs the thread of the window, in
// processor time. An event that the window waits for too long is late: over 16 ms while a button is held,
// over 100 ms otherwise. Work that an event gives to other threads does not count. Nothing is late in a build
// that is not optimised or is instrumented.
class WatchedApplication : public Application {
public:
    using Application::Application;

    bool notify(QObject* receiver, QEvent* event) override;

    // What was late since the last call, a line each. On a busy machine even processor time is stretched: two
    // late events, or one in a thousand during drags, are forgiven when none took twice as long as it may.
    QStringList takeLate();
    void ignoreThisEvent();  // it is a test's own work
    QString summary() const; // how many events, and the slowest of either kind

private:
    struct Running {
        int loopLevel; // of event loops inside each other
        double began;  // milliseconds of processor time
        double inner;  // spent in events of loops inside this event: theirs, not its
        bool ignored = false;
    };
    struct Event {
        QEvent::Type type;
        const char* receiver; // its class
    };
    void judge(const Event& event, bool dragging, double spent);

    QList<Running> m_running;
    QStringList m_late;
    bool m_unforgivable = false;
    qint64 m_forgivable = 0;      // events of drags since the last call
    double m_slowest[2] = {0, 0}; // otherwise, while dragging
    qint64 m_lateCount[2] = {0, 0};
    qint64 m_count[2] = {0, 0};
};

} // namespace support
