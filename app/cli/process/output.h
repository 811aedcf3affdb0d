// SPDX-License-Identifier: MIT
#pragma once

#include "options/exit_status.h"
#include "process/same_file.h"

#include "io/export_job.h"

#include <QByteArray>
#include <QString>

#include <functional>

namespace cli {

// What a command may write over. A file that was read is in general not replaced: UsageError is thrown then.
// Only what looks after that itself may do so.
enum class MayReplace { OtherFiles, Inputs };

// What goes wrong has then been reported.
ExitStatus writeOutput(const QString& output, const QByteArray& bytes,
                       MayReplace what = MayReplace::OtherFiles);

// Like io::exportTo(); on standard output appears all or nothing as well.
io::ExportOutcome exportOutput(const io::Export& what, const QString& output, const io::Progress& progress,
                               std::stop_token stop, MayReplace replaced = MayReplace::OtherFiles);

// What writes a file, given to the path behind `output`.
io::ExportOutcome exportBy(const std::function<io::ExportOutcome(const QString& path)>& write,
                           const QString& output, MayReplace replaced = MayReplace::OtherFiles);

} // namespace cli
