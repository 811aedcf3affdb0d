// SPDX-License-Identifier: MIT
#pragma once

#include "document/background/background_threads.h"

#include <QCoreApplication>

#include <utility>

namespace document {

// Frees a large value beside the window, if this is the last reference and the program goes on.
template <class Value> void freeInBackground(Value value) {
    if (QCoreApplication::instance()) startInLane(Lane::Computing, [held = std::move(value)] {});
}

} // namespace document
