// SPDX-License-Identifier: MIT
#include "ifs/dimension/common_eigendirections.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ifs {

namespace {

constexpr double rounding = 0x1p-46; // relative error of coefficients

bool isScalar(const Matrix<2>& a) {
    const double most = rounding * a.cwiseAbs().maxCoeff();
    return std::abs(a(0, 0) - a(1, 1)) <= most && std::abs(a(0, 1)) <= most && std::abs(a(1, 0)) <= most;
}

bool isTelling(const AffineMap<2>& map) {
    return !isScalar(map.linear);
}

bool isMultiple(const Matrix<2>& a, const Matrix<2>& b) {
    const double product = (a.array() * b.array()).sum();
    return std::abs(product * product / (a.squaredNorm() * b.squaredNorm()) - 1) <= rounding;
}

// The directions that a matrix keeps, unless it keeps all: none, one or two.
std::vector<Vector<2>> keptDirections(const Matrix<2>& a) {
    const Matrix<2> rest = a - a.trace() / 2 * Matrix<2>::Identity(); // rest² = discriminant·I
    const double discriminant = -rest.determinant();
    const bool isDouble = std::abs(discriminant) <= 8 * 0x1p-53 * a.norm() * rest.norm();
    if (discriminant < 0 && !isDouble) return {};
    const double root = isDouble ? 0 : std::sqrt(discriminant);
    std::vector<Vector<2>> directions;
    for (const double sign : {1.0, -1.0}) {
        const Matrix<2> onto = rest + sign * root * Matrix<2>::Identity(); // (rest − sign·root·I)·onto = 0
        const int column = onto.col(0).squaredNorm() > onto.col(1).squaredNorm() ? 0 : 1;
        directions.emplace_back(onto.col(column).normalized());
        if (isDouble) break;
    }
    return directions;
}

// An entry, with 0 for nothing but rounding.
double entry(double value, double size) {
    return std::abs(value) <= rounding * size ? 0 : std::abs(value);
}

double power(double base, double exponent) {
    return base > 0 ? std::pow(base, exponent) : 0;
}

// Entries of the linear parts in coordinates along one or two directions, absolute.
struct Entries {
    double a = 0, b = 0, c = 0, d = 0;
};

// Entries on the diagonal of triangular matrices; nullopt when some matrix does not keep the direction.
std::optional<std::vector<Entries>> triangular(std::span<const AffineMap<2>> maps, const Vector<2>& kept) {
    const Vector<2> across(-kept.y(), kept.x());
    std::vector<Entries> result;
    for (const auto& map : maps) {
        const Vector<2> along = map.linear * kept;
        const double size = map.linear.norm();
        if (std::abs(across.dot(along)) > rounding * size) return std::nullopt;
        result.push_back({entry(kept.dot(along), size), 0, 0, entry(across.dot(map.linear * across), size)});
    }
    return result;
}

// Entries of matrices each of which is diagonal, or the other way round, along the two directions.
std::optional<std::vector<Entries>> exchanging(std::span<const AffineMap<2>> maps, const Vector<2>& one,
                                               const Vector<2>& other) {
    Matrix<2> axes;
    axes << one, other;
    const double spread = std::abs(axes.determinant());
    if (!(spread > 1e-2)) return std::nullopt;
    const Matrix<2> inverse = axes.inverse();
    std::vector<Entries> result;
    for (const auto& map : maps) {
        const Matrix<2> m = inverse * map.linear * axes;
        const double size = map.linear.norm() / spread;
        const Entries entries{entry(m(0, 0), size), entry(m(0, 1), size), entry(m(1, 0), size),
                              entry(m(1, 1), size)};
        if ((entries.a > 0 || entries.d > 0) && (entries.b > 0 || entries.c > 0)) return std::nullopt;
        result.push_back(entries);
    }
    return result;
}

// e^pressure of triangular matrices.
double triangularGrowth(const std::vector<Entries>& maps, double t) {
    double first = 0, second = 0;
    for (const auto& [a, b, c, d] : maps) {
        first += t <= 1 ? power(a, t) : a * power(d, t - 1);
        second += t <= 1 ? power(d, t) : d * power(a, t - 1);
    }
    return std::max(first, second);
}

// The same of diagonal ones and such as exchange the axes: a product has one entry in each row, whose powers
// are those of the products of entries.
double exchangingGrowth(const std::vector<Entries>& maps, double t) {
    double a = 0, b = 0, c = 0, d = 0;
    for (const Entries& m : maps) {
        const double area = t <= 1 ? 1 : power(m.a * m.d + m.b * m.c, t - 1);
        const double exponent = t <= 1 ? t : 2 - t;
        a += area * power(m.a, exponent);
        b += area * power(m.b, exponent);
        c += area * power(m.c, exponent);
        d += area * power(m.d, exponent);
    }
    return (a + d) / 2 + std::sqrt((a - d) * (a - d) / 4 + b * c);
}

// The dimension at which the growth falls to 1.
template <class Growth> double dimensionOf(Growth growth) {
    double low = 0, high = 2;
    constexpr int steps = 60;
    for (int n = 0; n < steps; ++n) {
        const double middle = (low + high) / 2;
        (growth(middle) > 1 ? low : high) = middle;
    }
    return low > 0 ? (low + high) / 2 : 0;
}

} // namespace

std::vector<Vector<2>> commonDirections(std::span<const AffineMap<2>> maps) {
    const auto first = std::ranges::find_if(maps, isTelling);
    auto kept = first == maps.end() ? std::vector{Vector<2>(1, 0)} : keptDirections(first->linear);
    std::erase_if(kept, [maps](const Vector<2>& direction) { return !triangular(maps, direction); });
    return kept;
}

std::optional<double> commonEigendirectionsDimension(std::span<const AffineMap<2>> maps) {
    const auto first = std::ranges::find_if(maps, isTelling);
    if (const auto kept = commonDirections(maps); !kept.empty())
        return dimensionOf(
            [entries = *triangular(maps, kept.front())](double t) { return triangularGrowth(entries, t); });

    // The first map may exchange the directions. Then a map that is no multiple of it keeps them, or the
    // product does.
    const auto second = std::find_if(first, maps.end(), [&](const AffineMap<2>& map) {
        return isTelling(map) && !isMultiple(map.linear, first->linear);
    });
    if (second == maps.end()) return std::nullopt;
    for (const Matrix<2>& m : {first->linear, second->linear, Matrix<2>(first->linear * second->linear)})
        if (const auto lines = keptDirections(m); lines.size() == 2)
            if (const auto entries = exchanging(maps, lines[0], lines[1]))
                return dimensionOf([&entries](double t) { return exchangingGrowth(*entries, t); });
    return std::nullopt;
}

} // namespace ifs
