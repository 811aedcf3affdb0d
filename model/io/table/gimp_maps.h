// SPDX-License-Identifier: MIT
#pragma once

#include "io/table/written_map.h"

#include <QString>

namespace io {

// The elements that GIMP's plug-in IFS Fractal saves as text, or keeps in its pictures: "iterations …",
// "center_x …", then "element { x … y … theta … scale … asym … shear … flip … prob … }". Its y grows
// downwards; the maps are those that look the same way up here. None of any other text.
WrittenMaps gimpMaps(const QString& text);

} // namespace io
