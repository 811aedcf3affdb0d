// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/support_function.h"
#include "ifs/system/affine_map.h"

#include <algorithm>
#include <vector>

// Systems whose fractal transformations are known in closed form.
namespace tops {

using Maps = std::vector<ifs::AffineMap<2>>;

inline ifs::SupportFunction<2> attractorOf(const Maps& maps) {
    return *ifs::SupportFunction<2>::of(maps);
}

// Of the line: a·x + e.
inline ifs::AffineMap<2> onLine(double a, double e) {
    return ifs::affineMap(a, 0, 0, a, e, 0);
}

// [0, 1] divided at α.
inline Maps interval(double alpha) {
    return {onLine(alpha, 0), onLine(1 - alpha, alpha)};
}
inline Maps cantor() {
    return {onLine(1.0 / 3, 0), onLine(1.0 / 3, 2.0 / 3)};
}
inline Maps overlappingInterval() {
    return {onLine(2.0 / 3, 0), onLine(2.0 / 3, 1.0 / 3)};
}

// [0, 1]² divided at (p, q): the maps in the order of (x-bit, y-bit).
inline Maps square(double p, double q) {
    Maps maps;
    for (const int x : {0, 1})
        for (const int y : {0, 1})
            maps.push_back(ifs::affineMap(x ? 1 - p : p, 0, 0, y ? 1 - q : q, x ? p : 0, y ? q : 0));
    return maps;
}

using Corners = std::array<ifs::Vector<2>, 3>;
inline ifs::AffineMap<2> ontoTriangle(const Corners& to) { // from (0,0), (1,0), (0,1)
    const ifs::Vector<2> u = to[1] - to[0], v = to[2] - to[0];
    return ifs::affineMap(u.x(), v.x(), u.y(), v.y(), to[0].x(), to[0].y());
}
// TRI(α, β, γ): c, a, b divide the sides AB, BC, CA of the triangle.
inline Maps triangle(double alpha, double beta, double gamma) {
    const ifs::Vector<2> A(0, 0), B(1, 0), C(0, 1);
    const ifs::Vector<2> c = A + alpha * (B - A), a = B + beta * (C - B), b = C + gamma * (A - C);
    return {ontoTriangle({c, a, B}), ontoTriangle({C, a, b}), ontoTriangle({c, A, b}),
            ontoTriangle({c, a, b})};
}

inline Maps reversed(Maps maps) {
    std::ranges::reverse(maps);
    return maps;
}

// h_α: conjugates the doubling map to the interval divided at α. From the digits of x.
inline double hFunction(double alpha, double x) {
    double low = 0, length = 1;
    for (int k = 0; k < 1074 && x > 0; ++k) {
        x *= 2;
        if (x >= 1) {
            low += alpha * length;
            length *= 1 - alpha;
            x -= 1;
        } else {
            length *= alpha;
        }
    }
    return low;
}

} // namespace tops
