// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/render/banded_rendering.h"
#include "io/file/save_file.h"

#include <QIODevice>
#include <QString>

#include <functional>

namespace io {

// Fraction from 0 to 1; called in the thread that works.
using Progress = std::function<void(double fraction)>;

struct ExportOutcome {
    Failure failure;
    bool stopped = false; // true if stopped on request; nothing was written
    attractor::RenderNote note = attractor::RenderNote::None;
    bool isShortOfMemory = false;
    bool isCoarse = false; // true if pieces of a solid overlap so often that parts may be missing
};

// Writes the output of `draw` to a file: `path` appears whole, or not at all if drawing fails or is stopped.
// An obstacle is returned as the outcome before anything is begun.
ExportOutcome writtenWhole(const QString& path, const Failure& obstacle,
                           const std::function<ExportOutcome(QIODevice& device)>& draw);

} // namespace io
