// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/names.h"
#include "io/solid/printable_solid.h"

#include <QIODevice>
#include <QString>

#include <optional>

namespace io {

// Surfaces. STL, GLB and PLY are binary. Lengths are millimetres; GLB, whose unit is the metre, says so by a
// scale. Axes are those of the system: y up.
enum class MeshFormat { Stl, Obj, Glb, Ply };

std::optional<MeshFormat> meshFormat(const QString& suffix); // ignores case
QString suffixOf(MeshFormat format);
const char* titleOf(MeshFormat format); // title in lists, for Text::tr()

// False when the device took less, or the mesh is stopped in the middle.
bool writeMesh(const PrintableSolid& solid, MeshFormat format, const QString& name, QIODevice& device,
               const std::stop_token& stop = {});

} // namespace io

// Suffixes of file names, in the order of lists.
template <>
inline constexpr auto ifs::names<io::MeshFormat> = std::to_array<ifs::Named<io::MeshFormat>>({
    {io::MeshFormat::Stl, "stl"},
    {io::MeshFormat::Obj, "obj"},
    {io::MeshFormat::Glb, "glb"},
    {io::MeshFormat::Ply, "ply"},
});
