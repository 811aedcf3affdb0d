// SPDX-License-Identifier: MIT
#pragma once

#include <QCoreApplication>
#include <QThreadPool>

#include <utility>

namespace document {

// What is large takes a while to be freed: beside the window, if this is the last of it and the program goes
// on.
template <class Value> void freeInBackground(Value value) {
    if (QCoreApplication::instance()) QThreadPool::globalInstance()->start([held = std::move(value)] {});
}

} // namespace document
