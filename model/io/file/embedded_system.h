// SPDX-License-Identifier: MIT
#pragma once

#include "io/file/save_file.h"

#include <QByteArray>

namespace io {

// The `.ifs` text that a picture carries.
struct EmbeddedSystem {
    QByteArray text;
    Failure failure; // reason why there is no text
};

} // namespace io
