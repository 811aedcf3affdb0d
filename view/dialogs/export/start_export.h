// SPDX-License-Identifier: MIT
#pragma once

#include "io/export_job.h"

#include <QObject>

#include <functional>
#include <memory>

namespace view {

// An export in a thread of its own whose progress (0 … 1) and outcome are told in the thread of `receiver`,
// which outlives the job.
std::unique_ptr<io::ExportJob> startExport(io::Export what, const QString& path, QObject* receiver,
                                           std::function<void(double)> progress,
                                           std::function<void(const io::ExportOutcome&)> finished);

} // namespace view
