// SPDX-License-Identifier: MIT
#pragma once

#include <QAbstractEventDispatcher>
#include <QCoreApplication>
#include <QEvent>

namespace support {

// Handles every event that is due, and those that this causes, until none is left: what was queued, layouts,
// timers that have run out. What has not come then is not on its way in this thread; only painting may be due
// a moment later.
inline void handleEvents() {
    constexpr int tooMany = 1000; // a timer without an interval never ends
    bool isAny = true;
    for (int round = 0; isAny && round < tooMany; ++round) {
        isAny = QAbstractEventDispatcher::instance()->processEvents(QEventLoop::AllEvents);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
}

} // namespace support
