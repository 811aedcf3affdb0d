// SPDX-License-Identifier: MIT
#pragma once

#include "io/solid/mesh_writer.h"

#include <functional>

namespace io {

struct SolidExport {
    document::Fractal fractal;
    SolidOptions options;
    MeshFormat format = MeshFormat::Stl;
    // Called in the thread that works, before the file is written; never where there is no such body.
    std::function<void(const SolidFacts&)> whenMade{};
};

// `path` appears whole or not at all.
ExportOutcome exportSolid(const SolidExport& what, const QString& path, const Progress& progress = {},
                          std::stop_token stop = {});

} // namespace io
