// SPDX-License-Identifier: MIT
#include "document/fractal.h"

#include <cmath>

namespace document {

int dimension(const Fractal& fractal) {
    if (std::holds_alternative<System2>(fractal.system)) return 2;
    return std::holds_alternative<System3>(fractal.system) ? 3 : 0;
}

Fractal sierpinskiTriangle() {
    const double height = std::sqrt(3.0) / 4;
    System2 system;
    for (const ifs::Vector<2>& corner :
         {ifs::Vector<2>(0, 0), ifs::Vector<2>(0.5, 0), ifs::Vector<2>(0.25, height)})
        ifs::append(system, ifs::affineMap(0.5, 0, 0, 0.5, corner.x(), corner.y()), 1.0 / 3);
    Fractal fractal;
    fractal.name = QStringLiteral("sierpinski");
    fractal.system = std::move(system);
    return fractal;
}

} // namespace document
