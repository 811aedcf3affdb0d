// SPDX-License-Identifier: MIT
#pragma once

#include "options/exit_status.h"
#include "process/same_file.h"

#include "io/export_job.h"

#include <QByteArray>
#include <QString>

#include <functional>

namespace cli {

// Files that a command may overwrite. Input files are in general not replaced: UsageError is thrown then.
// Inputs is for code that takes care of that itself.
enum class MayReplace { OtherFiles, Inputs };

// Reports any failure itself.
ExitStatus writeOutput(const QString& output, const QByteArray& bytes,
                       MayReplace what = MayReplace::OtherFiles);

// Like io::exportTo(); standard output, too, gets all or nothing.
io::ExportOutcome exportOutput(const io::Export& what, const QString& output, const io::Progress& progress,
                               std::stop_token stop, MayReplace replaced = MayReplace::OtherFiles);

// Runs `write` with the path behind `output`.
io::ExportOutcome exportBy(const std::function<io::ExportOutcome(const QString& path)>& write,
                           const QString& output, MayReplace replaced = MayReplace::OtherFiles);

} // namespace cli
