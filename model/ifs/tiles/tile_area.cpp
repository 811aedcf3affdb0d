// SPDX-License-Identifier: MIT
#include "ifs/tiles/tile_area.h"

#include "ifs/separation/contact_graph.h"
#include "ifs/separation/stored_rounding.h"
#include "ifs/tiles/copies_at_a_point.h"
#include "ifs/tiles/lattice.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

namespace ifs {

namespace {

constexpr double tolerance = 1e-9; // of the size of things that may be taken for larger

// A system x ↦ M⁻¹(x + d) in coordinates in which M and the digits d are integers.
struct DigitSystem {
    std::array<Integers, 2> matrix{}; // by rows
    std::vector<Integers> digits;
    Matrix<2> basis; // of the lattice that the differences of digits and M generate

    Integers product(const Integers& v) const {
        return {matrix[0][0] * v[0] + matrix[0][1] * v[1], matrix[1][0] * v[0] + matrix[1][1] * v[1]};
    }
    std::int64_t determinant() const { return matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0]; }
    // Returns true if there is one digit of every class modulo M: then the area is a multiple of that of the
    // lattice (Lagarias and Wang).
    bool isComplete() const {
        const std::int64_t n = determinant();
        if (std::size_t(std::abs(n)) != digits.size()) return false;
        for (std::size_t i = 0; i < digits.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const std::int64_t x = digits[i][0] - digits[j][0], y = digits[i][1] - digits[j][1];
                if ((matrix[1][1] * x - matrix[0][1] * y) % n == 0 &&
                    (matrix[0][0] * y - matrix[1][0] * x) % n == 0)
                    return false;
            }
        return true;
    }
};

// Returns true if the integers give back the maps, x ↦ A x + b with A = B M⁻¹ B⁻¹ and b = A B d, to rounding
// error.
bool isAsStored(const DigitSystem& system, std::span<const AffineMap<2>> maps) {
    constexpr double few = 8 * StoredRounding<2>::share;
    const Matrix<2>&linear = maps[0].linear, size = linear.cwiseAbs() * system.basis.cwiseAbs();
    Matrix<2> expansion;
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 2; ++column)
            expansion(row, column) = double(system.matrix[std::size_t(row)][std::size_t(column)]);
    const Matrix<2> off = linear * system.basis * expansion - system.basis;
    const Matrix<2> most = size * expansion.cwiseAbs() + system.basis.cwiseAbs();
    if (off.cwiseAbs().maxCoeff() > few * most.maxCoeff()) return false;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const Vector<2> digit(double(system.digits[i][0]), double(system.digits[i][1]));
        const Vector<2>&shift = maps[i].translation, first = maps[0].translation;
        const Vector<2> apart = linear * (system.basis * digit) - (shift - first);
        const Vector<2> terms = size * digit.cwiseAbs() + shift.cwiseAbs() + first.cwiseAbs();
        if (apart.cwiseAbs().maxCoeff() > few * terms.maxCoeff()) return false;
    }
    return true;
}

Surd wholeOf(std::int64_t number) {
    return {number};
}

SurdMap matrixOf(const Integers& first, const Integers& second) { // columns
    return {{{wholeOf(first[0]), wholeOf(second[0])}, {wholeOf(first[1]), wholeOf(second[1])}},
            {Surd(), Surd()}};
}

SurdMap matrixOf(const std::vector<Surd>& first, const std::vector<Surd>& second) {
    return {{{first[0], second[0]}, {first[1], second[1]}}, {Surd(), Surd()}};
}

// The image of a vector, without the translation.
std::vector<Surd> image(const SurdMap& matrix, const std::vector<Surd>& v) {
    return (matrix * SurdMap{identity(2).linear, v}).translation;
}

// An integer vector and the vector v that it stands for: one of A⁻¹(b_i − b_1), or an image of one under A⁻¹.
struct Generator {
    Integers integers;
    std::vector<Surd> v;
};

std::vector<Generator> generatorsOf(const DigitSystem& system, std::span<const SurdMap> typed,
                                    const SurdMap& expansion) {
    std::vector<Generator> result;
    for (std::size_t i = 0; i < typed.size(); ++i) {
        std::vector<Surd> apart;
        for (std::size_t k = 0; k < 2; ++k)
            apart.push_back(typed[i].translation[k] - typed[0].translation[k]);
        const std::vector<Surd> v = image(expansion, apart);
        result.push_back({system.digits[i], v});
        result.push_back({system.product(system.digits[i]), image(expansion, v)});
    }
    return result;
}

// The exact basis of the lattice, from two generators that are not along each other.
std::optional<SurdMap> basisOf(const std::vector<Generator>& generators) {
    for (const Generator& a : generators)
        for (const Generator& b : generators)
            if (a.integers[0] * b.integers[1] != a.integers[1] * b.integers[0])
                return matrixOf(a.v, b.v) * inverse(matrixOf(a.integers, b.integers));
    return std::nullopt;
}

std::optional<DigitSystem> digitSystem(std::span<const AffineMap<2>> maps) {
    const Matrix<2>& linear = maps[0].linear;
    if (std::ranges::any_of(maps, [&](const auto& map) { return map.linear != linear; })) return std::nullopt;
    const Matrix<2> expansion = linear.inverse();
    std::vector<Vector<2>> digits;
    double size = 0;
    for (const auto& map : maps) {
        digits.push_back(expansion * (map.translation - maps[0].translation));
        size = std::max(size, digits.back().norm());
    }
    Lattice lattice(size);
    for (const Vector<2>& digit : digits)
        if (!lattice.add(digit) || !lattice.add(expansion * digit)) return std::nullopt;
    if (!lattice.isFull()) return std::nullopt;
    DigitSystem result{{}, {}, lattice.basis()};
    const Matrix<2> coordinates = result.basis.inverse();
    const Matrix<2> matrix = coordinates * expansion * result.basis;
    for (std::size_t row = 0; row < 2; ++row) {
        const auto entries = integers(matrix.row(Eigen::Index(row)).transpose());
        if (!entries) return std::nullopt;
        result.matrix[row] = *entries;
    }
    for (const Vector<2>& digit : digits) {
        const auto entries = integers(coordinates * digit);
        if (!entries) return std::nullopt;
        result.digits.push_back(*entries);
    }
    return isAsStored(result, maps) ? std::optional(result) : std::nullopt;
}

// The translations by which the attractor can meet itself, and which of those of pieces they are.
std::optional<ContactGraph> translationGraph(const DigitSystem& system, const BoundingBox<2>& box) {
    const Vector<2> size = (1 + tolerance) * (box.max - box.min + Vector<2>::Constant(2 * box.error));
    const Vector<2> most = system.basis.inverse().cwiseAbs() * size;
    if (!(most.prod() < ContactGraph::maxVertices)) return std::nullopt;
    std::map<Integers, std::size_t> number;
    for (auto x = -std::int64_t(most.x()); x <= std::int64_t(most.x()); ++x)
        for (auto y = -std::int64_t(most.y()); y <= std::int64_t(most.y()); ++y) {
            const Vector<2> shift = system.basis * Vector<2>(double(x), double(y));
            if ((x != 0 || y != 0) && (size - shift.cwiseAbs()).minCoeff() >= 0)
                number.emplace(Integers{x, y}, number.size());
        }
    if (number.size() > ContactGraph::maxVertices) return std::nullopt;
    ContactGraph graph(number.size());
    for (const auto& [shift, from] : number) {
        const Integers image = system.product(shift);
        for (const Integers& a : system.digits)
            for (const Integers& b : system.digits)
                if (const auto to = number.find({image[0] + b[0] - a[0], image[1] + b[1] - a[1]});
                    to != number.end())
                    graph.join(from, to->second);
    }
    return graph;
}

std::optional<double> latticeArea(std::span<const AffineMap<2>> maps, const BoundingBox<2>& box) {
    const auto system = digitSystem(maps);
    if (!system || !system->isComplete()) return std::nullopt;
    auto graph = translationGraph(*system, box);
    if (!graph) return std::nullopt;
    graph->prune();
    const auto radius = graph->spectralRadius();
    if (!radius || !(radius->most < (1 - tolerance) * double(maps.size()))) return std::nullopt;
    return std::abs(system->basis.determinant());
}

} // namespace

std::optional<TileArea> tileArea(std::span<const AffineMap<2>> maps, const BoundingBox<2>& box,
                                 const NeighbourGraph* neighbours) {
    auto area = latticeArea(maps, box);
    if (!area) area = areaByCopies(maps, box, neighbours);
    if (!area) return std::nullopt;
    return TileArea{*area, areShort(maps) ? Certainty::Exact : Certainty::ToRounding};
}

bool isAreaOf(std::span<const AffineMap<2>> maps, std::span<const SurdMap> typed) {
    const auto system = digitSystem(maps);
    if (!system || !system->isComplete() || typed.size() != maps.size()) return false;
    if (std::ranges::any_of(typed, [&](const SurdMap& map) { return map.linear != typed[0].linear; }))
        return false;
    const SurdMap expansion = inverse({typed[0].linear, {Surd(), Surd()}});
    const std::vector<Generator> generators = generatorsOf(*system, typed, expansion);
    const auto basis = basisOf(generators);
    return basis && basis->hasValue() && std::ranges::all_of(generators, [&](const Generator& each) {
               return image(*basis, {wholeOf(each.integers[0]), wholeOf(each.integers[1])}) == each.v;
           });
}

} // namespace ifs
