// SPDX-License-Identifier: MIT
#include "ifs/cage/map_handles.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace ifs {

namespace {

double doubleArea(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c) {
    const Vector<2> u = b - a, v = c - a;
    return u.x() * v.y() - u.y() * v.x();
}

// The two vertices that form the largest triangle with this one: where λ falls to 0 most gently.
std::array<std::size_t, 2> anchorsOf(std::span<const Vector<2>> rest, std::size_t vertex) {
    constexpr double clearly = 1 + 1e-9; // prefers the first of equals, whatever the rounding
    std::array<std::size_t, 2> best{(vertex + 1) % rest.size(), (vertex + rest.size() - 1) % rest.size()};
    double most = std::abs(doubleArea(rest[vertex], rest[best[0]], rest[best[1]]));
    for (std::size_t i = 0; i < rest.size(); ++i)
        for (std::size_t k = i + 1; k < rest.size(); ++k) {
            const double area = std::abs(doubleArea(rest[vertex], rest[i], rest[k]));
            if (area <= most * clearly) continue;
            most = area;
            best = {i, k};
        }
    return best;
}

} // namespace

AffineMap<2> withHandleMoved(const AffineMap<2>& map, std::span<const Vector<2>> rest, std::size_t vertex,
                             const Vector<2>& offset) {
    if (offset.isZero(0)) return map;
    const auto [first, second] = anchorsOf(rest, vertex);
    const Vector<2> edge = rest[second] - rest[first];
    const Vector<2> normal(-edge.y(), edge.x());
    const Vector<2> gradient = normal / normal.dot(rest[vertex] - rest[first]);
    return {map.linear + offset * gradient.transpose(), map.translation - gradient.dot(rest[first]) * offset};
}

AffineMap<3> withHandleMoved(const AffineMap<3>& map, const Simplex<3>& rest, std::size_t vertex,
                             const Vector<3>& offset) {
    if (offset.isZero(0)) return map;
    const Vector<3>& a = rest[(vertex + 1) % 4];
    const Vector<3> normal = (rest[(vertex + 2) % 4] - a).cross(rest[(vertex + 3) % 4] - a);
    const Vector<3> gradient = normal / normal.dot(rest[vertex] - a);
    return {map.linear + offset * gradient.transpose(), map.translation - gradient.dot(a) * offset};
}

AffineMap<2> firstOrder(const Placement& placement, const Vector<2>& x) {
    if (placement.bend() == nullptr) return placement.affine();
    const auto expansion = placement.bend()->expansion(x);
    const Matrix<2> linear = expansion ? expansion->linear : placement.affine().linear;
    return {linear, placement(x) - linear * x};
}

std::optional<Vector<2>> preimage(const Placement& placement, const Vector<2>& displayed,
                                  const Vector<2>& start) {
    constexpr int maxSteps = 30;
    constexpr double enough = 1e-12; // relative length of a step
    Vector<2> x = start;
    for (int step = 0; step < maxSteps; ++step) {
        const auto back = inverse(firstOrder(placement, x));
        if (!back) return std::nullopt;
        const Vector<2> next = (*back)(displayed);
        if (placement.bend() == nullptr) return next;
        if (!next.allFinite()) return std::nullopt;
        const double moved = (next - x).norm();
        x = next;
        if (moved <= enough * (1 + x.norm())) return x;
    }
    return std::nullopt;
}

bool hasAttractor(const Existence& existence) {
    return existence.exists();
}

template <int Dim> SafeWay<Dim> safeWay(const std::function<std::vector<AffineMap<Dim>>(double)>& mapsAt) {
    constexpr double precision = 1e-4;
    constexpr int products = 2'000; // products for each verdict, because the user is waiting
    const auto verdictOn = [](std::span<const AffineMap<Dim>> maps) { return classify<Dim>(maps, products); };
    SafeWay<Dim> way{.past = mapsAt(1)};
    way.verdict = verdictOn(way.past);
    if (way.verdict.exists() || !verdictOn(mapsAt(0)).exists()) return {};
    double past = 1;
    way.share = 0;
    while (past - way.share > precision) {
        const double middle = (way.share + past) / 2;
        std::vector<AffineMap<Dim>> maps = mapsAt(middle);
        Existence verdict = verdictOn(maps);
        if (verdict.exists()) {
            way.share = middle;
        } else {
            past = middle;
            way.past = std::move(maps);
            way.verdict = std::move(verdict);
        }
    }
    return way;
}
template SafeWay<2> safeWay<2>(const std::function<std::vector<AffineMap<2>>(double)>&);
template SafeWay<3> safeWay<3>(const std::function<std::vector<AffineMap<3>>(double)>&);

} // namespace ifs
