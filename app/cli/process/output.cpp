// SPDX-License-Identifier: MIT
#include "process/output.h"

#include "options/tr.h"
#include "process/files_read.h"
#include "process/messages.h"

#include "io/file/hard_links.h"
#include "io/file/save_file.h"
#include "io/file/standard_output.h"

#include <cerrno>

namespace cli {

namespace {

int otherNames(const QString& output) {
    return isStandardOutput(output) ? 0 : io::otherNames(output);
}

// Warns of other names of the file that was there before.
void warnAboutLinks(const QString& output, int otherNames) {
    if (otherNames == 0) return;
    reportWarning(output, tr("Other names of the file (hard links) keep the old contents."));
}

} // namespace

ExitStatus writeOutput(const QString& output, const QByteArray& bytes, MayReplace what) {
    if (what != MayReplace::Inputs) refuseToReplaceInput(output);
    refuseToReplaceOutput(output);
    const int linked = otherNames(output);
    io::Failure failure;
    if (!isStandardOutput(output))
        failure = io::saveFile(output, bytes);
    else if (!print(bytes))
        failure = io::cannotPrint(errno);
    if (!failure) {
        noteWritten(output);
        warnAboutLinks(output, linked);
        return ExitStatus::Done;
    }
    reportError(output, *failure);
    return ExitStatus::CannotReadOrWrite;
}

io::ExportOutcome exportOutput(const io::Export& what, const QString& output, const io::Progress& progress,
                               std::stop_token stop, MayReplace replaced) {
    return exportBy([&](const QString& path) { return io::exportTo(what, path, progress, stop); }, output,
                    replaced);
}

io::ExportOutcome exportBy(const std::function<io::ExportOutcome(const QString& path)>& write,
                           const QString& output, MayReplace replaced) {
    if (replaced != MayReplace::Inputs) refuseToReplaceInput(output);
    refuseToReplaceOutput(output);
    const int linked = otherNames(output);
    io::ExportOutcome outcome = write(isStandardOutput(output) ? io::standardOutputPath() : output);
    if (outcome.failure || outcome.stopped) return outcome;
    noteWritten(output);
    warnAboutLinks(output, linked);
    return outcome;
}

} // namespace cli
