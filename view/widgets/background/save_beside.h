// SPDX-License-Identifier: MIT
#pragma once

#include "io/file/save_file.h"

#include <QByteArray>
#include <QString>

#include <functional>

class QWidget;

namespace view {

struct Saving {
    // True if cancelled by the user or the closing of the window; the file is unchanged.
    bool isCancelled = false;
    io::Failure failure;
};

// io::saveFile() beside the window, whose events are handled meanwhile; when it takes longer than a moment,
// under a dialog over `window` from which it can be cancelled. `window` may be gone afterwards.
// What is handed over is called in the thread that saves, before the file is replaced.
Saving saveBeside(const QString& path, const QByteArray& bytes, QWidget* window,
                  std::function<void()> beforeReplacing = {});

} // namespace view
