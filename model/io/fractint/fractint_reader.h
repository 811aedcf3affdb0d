// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"

#include <QByteArray>

namespace io {

// Reads a Fractint .ifs collection leniently (docs/formats.md): what Iterated Dynamics or Fractint 20 accept
// and more, saying what was bent. A broken entry becomes an entry without a system, with its problem; the
// others load. Concatenating the head, before + text of every entry, and the tail gives `bytes` back. Never
// fails: a file that is no Fractint collection at all has no entries and an error that names what it looks
// like. `bareName`, made legal, is what the entry of a file of bare rows is called: the file's base name.
document::FractalFile readFractint(const QByteArray& bytes, const QString& bareName = {});

} // namespace io
