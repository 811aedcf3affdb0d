// SPDX-License-Identifier: MIT
#pragma once

#include "document/background/background_threads.h"

#include <QCoreApplication>

#include <utility>

namespace document {

// What is large takes a while to be freed: beside the window, if this is the last of it and the program goes
// on.
template <class Value> void freeInBackground(Value value) {
    if (QCoreApplication::instance()) startInLane(Lane::Computing, [held = std::move(value)] {});
}

} // namespace document
