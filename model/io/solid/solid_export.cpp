// SPDX-License-Identifier: MIT
#include "io/solid/solid_export.h"

#include "document/text/text.h"
#include "io/file/save_file.h"

#include <QDir>

namespace io {

ExportOutcome exportSolid(const SolidExport& what, const QString& path, const Progress& progress,
                          std::stop_token stop) {
    constexpr double shareOfVoxels = 0.8; // share of the voxels in the progress; the rest is writing
    ExportOutcome outcome;
    const auto onVoxels = [&progress](double share) {
        if (progress) progress(shareOfVoxels * share);
    };
    const PrintableSolid solid = printableSolid(what.fractal, what.options, onVoxels, stop);
    outcome.failure = solid.failure;
    outcome.stopped = solid.stopped;
    if (outcome.failure || outcome.stopped) return outcome;
    if (what.whenMade) what.whenMade(solid.facts);
    NewFile file(path);
    const bool isWritten = !file.failure() && writeMesh(solid, what.format, what.fractal.name, file, stop);
    outcome.stopped = stop.stop_requested();
    if (outcome.stopped) return outcome;
    outcome.failure = isWritten ? file.commit() : file.failure();
    if (!isWritten && !outcome.failure)
        outcome.failure =
            Text::tr("“%1” was not saved: %2.").arg(QDir::toNativeSeparators(path), file.errorString());
    if (progress) progress(1);
    return outcome;
}

} // namespace io
