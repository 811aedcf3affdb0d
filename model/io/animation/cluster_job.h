// SPDX-License-Identifier: MIT
#pragma once

#include "io/animation/animation_export.h"

namespace io {

// A folder from which Slurm draws an animation: the entry, the scripts, and how to use them. It is one that
// several machines share, and can be carried to another one.
struct ClusterJob {
    AnimationExport animation;
    int tasks = 8; // most tasks that share the frames
};

struct WrittenJob {
    QString folder;
    Failure failure;
};
// A new folder in `parent`, which is named after the entry. What was begun goes when it fails.
WrittenJob writeClusterJob(const QString& parent, const ClusterJob& job);

// Name of the script that submits the job, within the folder.
inline constexpr const char* submitScript = "submit.sh";

} // namespace io
