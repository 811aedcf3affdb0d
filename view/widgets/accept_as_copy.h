// SPDX-License-Identifier: MIT
#pragma once

#include <QDropEvent>

namespace view {

// A file that is dropped is only read: the program that it came from must not take it for moved, and delete
// it.
inline void acceptAsCopy(QDropEvent& event) {
    event.setDropAction(Qt::CopyAction);
    event.accept();
}

} // namespace view
