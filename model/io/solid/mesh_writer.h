// SPDX-License-Identifier: MIT
#pragma once

#include "io/solid/printable_solid.h"

#include <QIODevice>
#include <QString>

#include <optional>

namespace io {

// Surfaces. STL, GLB and PLY are binary. Lengths are millimetres; GLB, whose unit is the metre, says so by a
// scale. Axes are those of the system: y up.
enum class MeshFormat { Stl, Obj, Glb, Ply };

std::optional<MeshFormat> meshFormat(const QString& suffix); // "stl", "obj", "glb", "ply" in any case
QString suffixOf(MeshFormat format);

// False when the device took less, or the mesh is stopped in the middle.
bool writeMesh(const PrintableSolid& solid, MeshFormat format, const QString& name, QIODevice& device,
               const std::stop_token& stop = {});

} // namespace io
