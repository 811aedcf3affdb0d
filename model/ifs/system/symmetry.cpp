// SPDX-License-Identifier: MIT
#include "ifs/system/symmetry.h"

#include "ifs/linear/decompositions.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace ifs {

namespace {

constexpr double rounding = 1e-12;

struct Turn {
    double cosine = 1;
    double sine = 0;
};

// The turn by 360°·k/n for 0 ≤ k ≤ n. Turns that are mirror images of each other in the axes and in their
// bisectors have the same digits, so that the group is one to the last bit but for products.
Turn turn(int k, int n) {
    if (2 * k > n) {
        const Turn other = turn(n - k, n);
        return {other.cosine, -other.sine};
    }
    if (4 * k > n) { // supplement to 180°
        const Turn other = turn(n - 2 * k, 2 * n);
        return {-other.cosine, other.sine};
    }
    if (8 * k > n) { // complement to 90°
        const Turn other = turn(n - 4 * k, 4 * n);
        return {other.sine, other.cosine};
    }
    if (8 * k == n) return {std::numbers::sqrt2 / 2, std::numbers::sqrt2 / 2};
    if (12 * k == n) return {std::numbers::sqrt3 / 2, 0.5};
    const double angle = 2 * std::numbers::pi * double(k) / double(n);
    return {std::cos(angle), std::sin(angle)};
}

Matrix<2> rotationBy(Turn turn) {
    Matrix<2> result;
    result << turn.cosine, -turn.sine, turn.sine, turn.cosine;
    return result;
}

// Exact at whole degrees in the sense of turn().
Matrix<2> rotationBy(double degrees) {
    degrees = std::fmod(degrees, 360);
    if (degrees < 0) degrees += 360;
    if (degrees == std::floor(degrees)) return rotationBy(turn(int(degrees), 360));
    const double angle = degrees * std::numbers::pi / 180;
    return rotationBy(Turn{std::cos(angle), std::sin(angle)});
}

template <int Dim> Matrix<Dim> onFloor(const Matrix<2>& flat) {
    Matrix<Dim> result = Matrix<Dim>::Identity();
    result.template topLeftCorner<2, 2>() = flat;
    return result;
}

template <int Dim> std::vector<Matrix<Dim>> flatGroup(int order, bool hasMirrors) {
    std::vector<Matrix<Dim>> result;
    for (int k = 0; k < order; ++k)
        result.push_back(onFloor<Dim>(rotationBy(turn(k, order))));
    const Matrix<2> mirror = Eigen::DiagonalMatrix<double, 2>(1, -1);
    for (int k = 0; hasMirrors && k < order; ++k)
        result.push_back(onFloor<Dim>(rotationBy(turn(k, order)) * mirror));
    return result;
}

// The signed permutations of the axes with determinant 1; the even permutations are the tetrahedral group.
std::vector<Matrix<3>> signedPermutations(bool onlyEven) {
    std::vector<Matrix<3>> result;
    constexpr int permutations[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}};
    for (int p = 0; p < (onlyEven ? 3 : 6); ++p)
        for (int signs = 0; signs < 8; ++signs) {
            const auto sign = [&](int row) { return ((signs >> row) & 1) != 0 ? -1.0 : 1.0; };
            if (sign(0) * sign(1) * sign(2) * (p < 3 ? 1 : -1) < 0) continue;
            Matrix<3> matrix = Matrix<3>::Zero();
            for (int row = 0; row < 3; ++row)
                matrix(row, permutations[p][row]) = sign(row);
            result.push_back(matrix);
        }
    return result;
}

// The tetrahedral group times the powers of a turn by 72° about (0, 1, φ), an axis of the icosahedron with
// corners (0, ±1, ±φ) and their cyclic permutations.
std::vector<Matrix<3>> icosahedralGroup() {
    constexpr double phi = std::numbers::phi;
    Matrix<3> fifth; // entries are ±½, ±φ/2 and ±1/2φ
    fifth << 1 / phi, -phi, 1, phi, 1, 1 / phi, -1, 1 / phi, phi;
    fifth /= 2;
    std::vector<Matrix<3>> result;
    Matrix<3> power = Matrix<3>::Identity();
    for (int k = 0; k < 5; ++k) {
        for (const Matrix<3>& even : signedPermutations(true))
            result.push_back(even * power);
        power *= fifth;
    }
    return result;
}

template <int Dim> std::vector<Matrix<Dim>> standardGroup(SymmetryGroup group, int order) {
    switch (group) {
    case SymmetryGroup::None:
        return {Matrix<Dim>::Identity()};
    case SymmetryGroup::Mirror:
        return flatGroup<Dim>(1, true);
    case SymmetryGroup::Rotation:
        return flatGroup<Dim>(order, false);
    case SymmetryGroup::Dihedral:
        return flatGroup<Dim>(order, true);
    default:
        break;
    }
    if constexpr (Dim == 3) {
        if (group == SymmetryGroup::Icosahedral) return icosahedralGroup();
        return signedPermutations(group == SymmetryGroup::Tetrahedral);
    }
    return {Matrix<Dim>::Identity()};
}

bool hasOrder(SymmetryGroup group) {
    return group == SymmetryGroup::Rotation || group == SymmetryGroup::Dihedral;
}

bool isPolyhedral(SymmetryGroup group) {
    return group >= SymmetryGroup::Tetrahedral;
}

// The multiple of an orthogonal matrix that it is, without the factor; nullopt when it is none.
template <int Dim> std::optional<Matrix<Dim>> isometryOf(const Matrix<Dim>& linear) {
    const double square = linear.squaredNorm() / Dim;
    const Matrix<Dim> product = linear.transpose() * linear / square;
    if (!((product - Matrix<Dim>::Identity()).norm() < rounding)) return std::nullopt;
    return linear / std::sqrt(square);
}

double foldedAngle(double degrees, double period) {
    const double result = degrees - period * std::floor(degrees / period);
    return result < period ? result : 0;
}

// The isometry as a turn of the floor, perhaps after a mirror image along x; nullopt when it tilts the floor.
template <int Dim> std::optional<double> turnOfFloor(const Matrix<Dim>& isometry) {
    if constexpr (Dim == 3)
        if (std::abs(std::abs(isometry(2, 2)) - 1) > rounding) return std::nullopt;
    return std::atan2(isometry(1, 0), isometry(0, 0)) * 180 / std::numbers::pi;
}

bool isNear(const AffineMap<2>& a, const AffineMap<2>& b, double tolerance) {
    return (a.linear - b.linear).cwiseAbs().maxCoeff() <= tolerance &&
           (a.translation - b.translation).cwiseAbs().maxCoeff() <= tolerance;
}

// The point that all of them fix, by least squares; for mirrors alone the one nearest to the origin.
Vector<2> commonFixedPoint(const std::vector<AffineMap<2>>& maps) {
    Matrix<2> normal = Matrix<2>::Zero();
    Vector<2> right = Vector<2>::Zero();
    for (const AffineMap<2>& map : maps) {
        const Matrix<2> away = Matrix<2>::Identity() - map.linear;
        normal += away.transpose() * away;
        right += away.transpose() * map.translation;
    }
    return shortestSolution(normal, right);
}

} // namespace

template <int Dim> bool isValid(const Symmetry<Dim>& symmetry) {
    const bool orderFits = hasOrder(symmetry.group)
                               ? symmetry.order >= minSymmetryOrder && symmetry.order <= maxSymmetryOrder
                               : symmetry.order == 1;
    return orderFits && (Dim == 3 || !isPolyhedral(symmetry.group)) && std::isfinite(symmetry.angle) &&
           symmetry.centre.allFinite() && symmetry.frame.allFinite() &&
           inverse<Dim>({symmetry.frame, Vector<Dim>::Zero()}).has_value();
}

std::size_t groupOrder(SymmetryGroup group, int order) {
    switch (group) {
    case SymmetryGroup::None:
        return 1;
    case SymmetryGroup::Mirror:
        return 2;
    case SymmetryGroup::Rotation:
        return std::size_t(order);
    case SymmetryGroup::Dihedral:
        return 2 * std::size_t(order);
    case SymmetryGroup::Tetrahedral:
        return 12;
    case SymmetryGroup::Octahedral:
        return 24;
    case SymmetryGroup::Icosahedral:
        return 60;
    }
    return 1;
}

template <int Dim> std::vector<AffineMap<Dim>> elements(const Symmetry<Dim>& symmetry) {
    const bool turns = symmetry.angle != 0 && symmetry.group != SymmetryGroup::Rotation;
    const Matrix<Dim> turned = turns ? onFloor<Dim>(rotationBy(symmetry.angle)) : Matrix<Dim>::Identity();
    const bool hasFrame = symmetry.frame != Matrix<Dim>::Identity();
    const Matrix<Dim> back = hasFrame ? Matrix<Dim>(symmetry.frame.inverse()) : symmetry.frame;
    std::vector<AffineMap<Dim>> result;
    for (Matrix<Dim> linear : standardGroup<Dim>(symmetry.group, symmetry.order)) {
        if (result.empty()) {
            result.push_back({});
            continue;
        }
        if (turns) linear = turned * linear * turned.transpose();
        if (hasFrame) linear = symmetry.frame * linear * back;
        result.push_back({linear, symmetry.centre - linear * symmetry.centre});
    }
    return result;
}

template <int Dim> Symmetry<Dim> conjugate(const AffineMap<Dim>& transformation, Symmetry<Dim> symmetry) {
    if (symmetry.group == SymmetryGroup::None) return symmetry;
    symmetry.centre = transformation(symmetry.centre);
    symmetry.frame = transformation.linear * symmetry.frame;
    const auto isometry = isometryOf<Dim>(symmetry.frame);
    if (!isometry) return symmetry;
    symmetry.frame = *isometry;
    if (isPolyhedral(symmetry.group)) {
        const bool isUpright = (*isometry - Matrix<Dim>::Identity()).norm() < rounding;
        if (isUpright) symmetry.frame = Matrix<Dim>::Identity();
        return symmetry;
    }
    const auto angle = turnOfFloor<Dim>(*isometry);
    if (!angle) return symmetry;
    const double sense = isometry->template topLeftCorner<2, 2>().determinant() < 0 ? -1 : 1;
    symmetry.frame = Matrix<Dim>::Identity();
    if (symmetry.group == SymmetryGroup::Rotation)
        symmetry.angle = 0;
    else if (const double turned = *angle; turned != 0 || sense < 0)
        symmetry.angle = foldedAngle(turned + sense * symmetry.angle, 180.0 / std::max(symmetry.order, 1));
    return symmetry;
}

Symmetry<2> flipped(Symmetry<2> symmetry) {
    const Matrix<2> mirror = Eigen::DiagonalMatrix<double, 2>(1, -1);
    symmetry.centre.y() = 0 - symmetry.centre.y();
    if (symmetry.angle != 0) symmetry.angle = -symmetry.angle;
    symmetry.frame = mirror * symmetry.frame * mirror;
    return symmetry;
}

Symmetry<3> lifted(const Symmetry<2>& flat) {
    Symmetry<3> result{flat.group, flat.order, flat.angle};
    result.centre.head<2>() = flat.centre;
    result.frame = onFloor<3>(flat.frame);
    return result;
}

Symmetry<2> symmetryOf(const std::vector<AffineMap<2>>& maps, double tolerance) {
    const auto mirrors =
        std::ranges::count_if(maps, [](const AffineMap<2>& map) { return map.linear.determinant() < 0; });
    const auto turns = std::ptrdiff_t(maps.size()) - mirrors;
    if (maps.size() < 2 || maps.size() > 2 * maxSymmetryOrder || (mirrors != 0 && mirrors != turns))
        return {};
    Symmetry<2> result;
    result.group = mirrors == 0 ? SymmetryGroup::Rotation
                   : turns == 1 ? SymmetryGroup::Mirror
                                : SymmetryGroup::Dihedral;
    result.order = turns == 1 ? 1 : int(turns);
    result.centre = commonFixedPoint(maps);
    const auto mirror =
        std::ranges::find_if(maps, [](const AffineMap<2>& map) { return map.linear.determinant() < 0; });
    if (mirror != maps.end())
        result.angle =
            foldedAngle(std::atan2(mirror->linear(1, 0), mirror->linear(0, 0)) * 90 / std::numbers::pi,
                        180.0 / result.order);
    if (!isValid(result)) return {};
    std::vector<AffineMap<2>> wanted = elements(result);
    for (const AffineMap<2>& map : maps) {
        const auto found = std::ranges::find_if(
            wanted, [&](const AffineMap<2>& element) { return isNear(map, element, tolerance); });
        if (found == wanted.end()) return {};
        wanted.erase(found);
    }
    return result;
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template bool isValid(const Symmetry<Dim>&);                                                             \
    template std::vector<AffineMap<Dim>> elements(const Symmetry<Dim>&);                                     \
    template Symmetry<Dim> conjugate(const AffineMap<Dim>&, Symmetry<Dim>);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace ifs
