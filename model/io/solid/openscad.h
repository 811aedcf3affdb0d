// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "io/file/save_file.h"

#include <QByteArray>

#include <cstdint>

namespace io {

// The maps of a fractal in space as an OpenSCAD program: one multmatrix for each, applied `depth` times to
// the certified box of the attractor. The text grows with the number of maps alone.
struct OpenScad {
    static constexpr std::uint64_t maxParts = 100'000; // parts that OpenSCAD would have to join

    QByteArray text;
    Failure failure;
    int depth = 0;
    double bound = 0; // bound of the distance from the parts to the attractor, in units of the system
};

// `detail` > 0: as deep as makes every part at most so large, in units of the system; else as deep as keeps
// the number of parts below a thousand.
OpenScad openScad(const document::Fractal& fractal, double detail = 0);

} // namespace io
