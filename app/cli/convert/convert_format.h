// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "io/exchange/point_format.h"
#include "io/exchange/text_formats.h"
#include "io/solid/mesh_writer.h"

#include <QString>

#include <string>
#include <variant>
#include <vector>

// The formats that `convert` writes.
namespace cli {

struct PdfFormat {
    friend bool operator==(const PdfFormat&, const PdfFormat&) = default;
};
struct ScadFormat {
    friend bool operator==(const ScadFormat&, const ScadFormat&) = default;
};
using ConvertFormat = std::variant<io::TextFormat, io::PointFormat, PdfFormat, io::MeshFormat, ScadFormat>;

// The words of --to, in the order of lists.
std::vector<std::string> convertFormats();

bool isFractint(const ConvertFormat& format);
bool isTable(const ConvertFormat& format);
bool holdsOneEntry(const ConvertFormat& format);
QString suffixOf(const ConvertFormat& format);

// The format with this suffix or name, given whether points or voxels were asked for. Throws UsageError.
ConvertFormat formatOf(const QString& name, bool hasPoints, bool hasVoxels);

// Why the format cannot store an entry of this dimension; empty where it can.
QString dimensionObstacle(const ConvertFormat& format, const document::Fractal& fractal);

} // namespace cli
