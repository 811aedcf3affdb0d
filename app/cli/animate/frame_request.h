// SPDX-License-Identifier: MIT
#pragma once

#include "render/render_arguments.h"

#include "document/fractal/fractal.h"

#include <QByteArray>

#include <optional>

namespace cli {

// SHA-256, in hexadecimal digits, of everything that the bytes of a frame depend on: the entry, the frame,
// the options and the version of the pixels. The same however an option is spelled, and whatever the threads
// and the instruction set. Without a frame, the hash shared by all frames of the animation.
QByteArray requestHash(const document::Fractal& entry, std::optional<int> frame,
                       const RenderArguments& options);

} // namespace cli
