// SPDX-License-Identifier: MIT
#include "io/picture/export_outcome.h"

namespace io {

ExportOutcome writtenWhole(const QString& path, const Failure& obstacle,
                           const std::function<ExportOutcome(QIODevice& device)>& draw) {
    ExportOutcome outcome;
    outcome.failure = obstacle;
    if (outcome.failure) return outcome;
    NewFile file(path);
    outcome.failure = file.failure();
    if (outcome.failure) return outcome;
    outcome = draw(file);
    if (file.failure())
        outcome.failure = file.failure();
    else if (!outcome.failure && !outcome.stopped)
        outcome.failure = file.commit();
    return outcome;
}

} // namespace io
