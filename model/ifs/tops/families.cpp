// SPDX-License-Identifier: MIT
#include "ifs/tops/families.h"

#include <algorithm>

namespace ifs {

namespace {

// The map from (0, 0), (1, 0), (0, 1) to these points.
AffineMap<2> onto(const Vector<2>& origin, const Vector<2>& right, const Vector<2>& up) {
    AffineMap<2> map;
    map.linear.col(0) = right - origin;
    map.linear.col(1) = up - origin;
    map.translation = origin;
    return map;
}

bool areInside(std::span<const double> parameters) {
    return std::ranges::all_of(parameters, [](double p) { return p > 0 && p < 1; });
}

bool areAlike(std::span<const AffineMap<2>> a, std::span<const AffineMap<2>> b) {
    constexpr double tolerance = 1e-9;
    return std::ranges::equal(a, b, [](const AffineMap<2>& f, const AffineMap<2>& g) {
        return (f.linear - g.linear).cwiseAbs().maxCoeff() < tolerance &&
               (f.translation - g.translation).cwiseAbs().maxCoeff() < tolerance;
    });
}

} // namespace

std::vector<AffineMap<2>> triangleFamily(const std::array<double, 3>& parameters) {
    const Vector<2> A(0, 0), B(1, 0), C(0, 1);
    const Vector<2> c = A + parameters[0] * (B - A), a = B + parameters[1] * (C - B),
                    b = C + parameters[2] * (A - C);
    return {onto(c, a, B), onto(C, a, b), onto(c, A, b), onto(c, a, b)};
}

std::vector<AffineMap<2>> squareFamily(const std::array<double, 2>& parameters) {
    const Vector<2> middle(parameters[0], parameters[1]);
    std::vector<AffineMap<2>> maps;
    for (const int right : {0, 1})
        for (const int up : {0, 1}) {
            const Vector<2> low(right ? middle.x() : 0, up ? middle.y() : 0);
            const Vector<2> high(right ? 1 : middle.x(), up ? 1 : middle.y());
            maps.push_back(onto(low, {high.x(), low.y()}, {low.x(), high.y()}));
        }
    return maps;
}

std::optional<std::vector<double>> familyParameters(std::span<const AffineMap<2>> maps) {
    if (maps.size() != 4) return std::nullopt;
    const Vector<2> c = maps[0].translation, a = maps[0](Vector<2>(1, 0)), b = maps[2](Vector<2>(0, 1));
    const std::array<double, 3> triangle{c.x(), a.y(), 1 - b.y()};
    if (areInside(triangle) && areAlike(maps, triangleFamily(triangle)))
        return std::vector(triangle.begin(), triangle.end());
    const std::array<double, 2> square{maps[0].linear(0, 0), maps[0].linear(1, 1)};
    if (areInside(square) && areAlike(maps, squareFamily(square)))
        return std::vector(square.begin(), square.end());
    return std::nullopt;
}

} // namespace ifs
