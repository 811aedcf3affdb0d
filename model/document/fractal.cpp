// SPDX-License-Identifier: MIT
#include "document/fractal.h"

#include <cmath>

namespace document {

namespace {

template <class Value> bool areSame(const Value* a, const Value* b) {
    return a && b ? *a == *b : a == b;
}

} // namespace

int dimension(const Fractal& fractal) {
    if (plane(fractal)) return 2;
    return space(fractal) ? 3 : 0;
}

bool isSameSystem(const Fractal& a, const Fractal& b) {
    return areSame(system2(a), system2(b)) && areSame(system3(a), system3(b));
}

Fractal sierpinskiTriangle() {
    const double height = std::sqrt(3.0) / 4;
    System2 system;
    for (const ifs::Vector<2>& corner :
         {ifs::Vector<2>(0, 0), ifs::Vector<2>(0.5, 0), ifs::Vector<2>(0.25, height)})
        ifs::append(system, ifs::affineMap(0.5, 0, 0, 0.5, corner.x(), corner.y()), 1.0 / 3);
    Fractal fractal;
    fractal.name = QStringLiteral("sierpinski");
    fractal.shape = Shape<2>{std::move(system)};
    return fractal;
}

} // namespace document
