// SPDX-License-Identifier: MIT
#include "dialogs/export/start_export.h"

#include <utility>

namespace view {

std::unique_ptr<io::ExportJob> startExport(io::Export what, const QString& path, QObject* receiver,
                                           std::function<void(double)> progress,
                                           std::function<void(const io::ExportOutcome&)> finished) {
    return std::make_unique<io::ExportJob>(
        std::move(what), path,
        [receiver, progress = std::move(progress)](double fraction) {
            QMetaObject::invokeMethod(
                receiver, [progress, fraction] { progress(fraction); }, Qt::QueuedConnection);
        },
        [receiver, finished = std::move(finished)](const io::ExportOutcome& outcome) {
            QMetaObject::invokeMethod(
                receiver, [finished, outcome] { finished(outcome); }, Qt::QueuedConnection);
        });
}

} // namespace view
