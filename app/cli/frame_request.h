// SPDX-License-Identifier: MIT
#pragma once

#include "render_arguments.h"

#include "document/fractal.h"

#include <QByteArray>

namespace cli {

// SHA-256, in hexadecimal digits, of everything that the bytes of a frame depend on: the entry, the frame,
// the options and the version of the pixels. The same however an option is spelled, and whatever the threads
// and the instruction set.
QByteArray requestHash(const document::Fractal& entry, int frame, const RenderArguments& options);

} // namespace cli
