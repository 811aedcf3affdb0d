// SPDX-License-Identifier: MIT
#pragma once

#include "document/background/background_threads.h"
#include "support/events.h"

#include <chrono>

namespace support {

// Waits until nothing is under way in the background and what it has found has been taken, which may start
// more. False after a minute.
inline bool backgroundRests() {
    do {
        if (!document::backgroundFinishes(std::chrono::minutes(1))) return false;
        handleEvents();
    } while (!document::backgroundFinishes(std::chrono::milliseconds(0)));
    return true;
}

} // namespace support
