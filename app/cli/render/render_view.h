// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "io/animation/frames_view.h"

// Default views of pictures.
namespace cli {

using io::boxOfAttractor;
using io::ViewBox;

// The box of Wⁿ(rest cage), as displayed. Throws UsageError when n asks for more than 10 million copies.
ViewBox boxOfIterate(const document::Fractal& fractal, int n);

} // namespace cli
