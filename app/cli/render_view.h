// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal.h"

// What a picture must show when nobody says.
namespace cli {

struct ViewBox {
    ifs::Vector<2> min;
    ifs::Vector<2> max;
    bool certified = true; // false: where orbits spend most of their time
};

ViewBox boxOfAttractor(const document::Fractal& fractal); // as displayed, under its cage

// Of Wⁿ(rest cage), as displayed. Throws UsageError when n asks for more than 10 million copies.
ViewBox boxOfIterate(const document::Fractal& fractal, int n);

} // namespace cli
