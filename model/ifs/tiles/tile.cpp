// SPDX-License-Identifier: MIT
#include "ifs/tiles/tile.h"

#include "ifs/dimension/dimension.h"
#include "ifs/existence/exact_matrix.h"
#include "ifs/existence/invariant_form.h"
#include "ifs/linear/decompositions.h"
#include "ifs/linear/symmetric_matrices.h"
#include "ifs/separation/stored_rounding.h"
#include "ifs/tiles/contact_graph.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

namespace ifs {

namespace {

using Maps = std::vector<AffineMap<2>>;

constexpr double tolerance = 1e-9; // of the size of things that may be taken for larger
constexpr double roundingUnit = 0x1p-53;
using Rounding = StoredRounding<2>;
constexpr std::size_t maxMaps = 64;
constexpr std::size_t maxEdges = 60'000;

// Products of three numbers like that, and their sums, are doubles without rounding.
bool isShort(double value) {
    constexpr double steps = 256, maxSize = 256;
    return std::abs(value) <= maxSize && value * steps == std::round(value * steps);
}

bool isShort(const AffineMap<2>& map) {
    const std::array<double, 6> values{map.linear(0, 0), map.linear(0, 1),    map.linear(1, 0),
                                       map.linear(1, 1), map.translation.x(), map.translation.y()};
    return std::ranges::all_of(values, [](double value) { return isShort(value); });
}

Maps inverses(std::span<const AffineMap<2>> maps) {
    Maps result;
    for (const auto& map : maps) {
        const Matrix<2> inverse = map.linear.inverse();
        result.push_back({inverse, -(inverse * map.translation)});
    }
    return result;
}

// Whether the inverses are exact, and all that is made of them short.
bool areShort(std::span<const AffineMap<2>> maps, const Maps& inverses) {
    for (std::size_t i = 0; i < maps.size(); ++i)
        if (!isShort(maps[i]) || !isShort(inverses[i]) || !(maps[i] * inverses[i] == AffineMap<2>{}))
            return false;
    return true;
}

// A map with what it may be off by, because those that it is made of are stored as doubles.
struct Rounded {
    AffineMap<2> map;
    double linear = 0, shift = 0; // in the norms of a frame
};

// Coordinates x ↦ U x in which maps are similarities, so that errors do not grow with the condition of each.
class Frame {
public:
    explicit Frame(const Matrix<2>& root)
        : m_root(root),
          m_unroot(root.inverse()),
          m_size(root.norm()),
          m_condition(m_size * m_unroot.norm()) {}

    double norm(const Matrix<2>& linear) const { return spectralNorm<2>(m_root * linear * m_unroot); }
    double length(const Vector<2>& v) const { return (m_root * v).norm(); }

    Rounded stored(const AffineMap<2>& map) const {
        const Rounding rounding = Rounding::of(map);
        return {map, m_condition * rounding.linear.norm(), m_size * rounding.translation.norm()};
    }

    // A change δ of A changes A⁻¹ by A⁻¹δA⁻¹.
    Rounded inverse(const AffineMap<2>& map, const AffineMap<2>& inverse) const {
        const Rounded known = stored(map);
        const double stretch = norm(inverse.linear);
        const double linear = stretch * stretch * (known.linear + few * m_condition * map.linear.norm());
        return {inverse, linear,
                linear * length(map.translation) +
                    stretch * (known.shift + few * m_size * map.translation.norm())};
    }

    Rounded product(const Rounded& a, const Rounded& b) const {
        const double stretch = norm(a.map.linear);
        const double size = a.map.linear.norm();
        return {a.map * b.map,
                a.linear * norm(b.map.linear) + stretch * b.linear +
                    few * m_condition * size * b.map.linear.norm(),
                a.shift + a.linear * length(b.map.translation) + stretch * b.shift +
                    few * m_size * (size * b.map.translation.norm() + a.map.translation.norm())};
    }

    bool isSame(const Rounded& a, const Rounded& b) const {
        return norm(a.map.linear - b.map.linear) <= a.linear + b.linear &&
               length(a.map.translation - b.map.translation) <= a.shift + b.shift;
    }

    // Whether so little is lost to rounding that what is the same to rounding error is not another.
    bool isTelling(const Rounded& h, const Vector<2>& size) const {
        constexpr double most = 0x1p-36;
        return h.linear <= most && h.shift <= most * length(size);
    }

private:
    static constexpr double few = 4 * roundingUnit;
    Matrix<2> m_root, m_unroot;
    double m_size, m_condition;
};

Vector<2> sizeOf(const BoundingBox<2>& box) {
    return box.max - box.min + Vector<2>::Constant(2 * box.error);
}

// The isometries h = w_u⁻¹ w_v of neighbours w_u(A), w_v(A), as they arise from one another:
// A ∩ h(A) = ∪ w_i(A ∩ h'(A)) with h' = w_i⁻¹ h w_j.
class Neighbours {
public:
    Neighbours(std::span<const AffineMap<2>> maps, const Matrix<2>& root, const BoundingBox<2>& box)
        : m_frame(root),
          m_centre((box.min + box.max) / 2),
          m_size(sizeOf(box)),
          m_isExact(areShort(maps, inverses(maps))) {
        for (const auto& inverse : inverses(maps)) {
            const AffineMap<2>& map = maps[m_maps.size()];
            m_maps.push_back(m_frame.stored(map));
            m_inverses.push_back(m_frame.inverse(map, inverse));
        }
    }

    bool isExact() const { return m_isExact; }

    // nullopt where there is no end of them, or two words are the same map.
    std::optional<ContactGraph> graph() {
        for (std::size_t i = 0; i < m_maps.size(); ++i)
            for (std::size_t j = 0; j < m_maps.size(); ++j)
                if (i != j && !place(m_frame.product(m_inverses[i], m_maps[j]))) return std::nullopt;
        std::vector<std::pair<std::size_t, std::size_t>> edges;
        for (std::size_t k = 0; k < m_found.size(); ++k)
            for (std::size_t i = 0; i < m_maps.size(); ++i)
                for (std::size_t j = 0; j < m_maps.size(); ++j) {
                    const auto to =
                        place(m_frame.product(m_inverses[i], m_frame.product(m_found[k], m_maps[j])));
                    if (!to || edges.size() > maxEdges) return std::nullopt;
                    if (*to != none) edges.emplace_back(k, *to);
                }
        ContactGraph graph(m_found.size());
        for (const auto& [from, to] : edges)
            graph.join(from, to);
        return graph;
    }

private:
    static constexpr std::size_t none = ~std::size_t{0};

    bool isSame(const Rounded& a, const Rounded& b) const {
        return m_isExact ? a.map == b.map : m_frame.isSame(a, b);
    }

    // Its number; `none` where the tiles are too far from each other. nullopt where there are too many, and
    // where both are one.
    std::optional<std::size_t> place(const Rounded& h) {
        const Vector<2> reach = (m_size + h.map.linear.cwiseAbs() * m_size) / 2;
        const Vector<2> apart = (h.map(m_centre) - m_centre).cwiseAbs();
        if (((1 + tolerance) * reach - apart).minCoeff() < 0) return none;
        m_isExact = m_isExact && isShort(h.map);
        if (isSame(h, {}) || (!m_isExact && !m_frame.isTelling(h, m_size))) return std::nullopt;
        for (std::size_t k = 0; k < m_found.size(); ++k)
            if (isSame(m_found[k], h)) return k;
        if (m_found.size() == ContactGraph::maxVertices) return std::nullopt;
        m_found.push_back(h);
        return m_found.size() - 1;
    }

    Frame m_frame;
    std::vector<Rounded> m_maps, m_inverses;
    Vector<2> m_centre, m_size;
    bool m_isExact;
    std::vector<Rounded> m_found;
};

struct Figure {
    double value = 0, error = 0;
};

// What a determinant may be off by, as far as the coefficients are off by their rounding.
double roundingOfDeterminant(const Matrix<2>& linear) {
    const Matrix<2> size = linear.cwiseAbs();
    const double terms = size(0, 0) * size(1, 1) + size(0, 1) * size(1, 0);
    return 2 * (Rounding::share + roundingUnit) * terms;
}

// The U with P = UᵀU for which all AᵀPA = s²P, Ns² = 1, to rounding error.
std::optional<Matrix<2>> rootOfSimilarities(std::span<const AffineMap<2>> maps) {
    const double share = 1 / double(maps.size());
    for (const auto& map : maps)
        if (std::abs(std::abs(determinant<2>(map.linear)) - share) >
            roundingOfDeterminant(map.linear) + roundingUnit * share)
            return std::nullopt;
    const auto form = invariantForm<2>(maps);
    if (!form || !similarityRatios<2>(maps)) return std::nullopt;
    const double least = singularValues<2>(*form)[1]; // the largest is 1, but for a factor
    constexpr double few = 64 * roundingUnit;
    for (const auto& map : maps) {
        const Matrix<2> image = map.linear.transpose() * *form * map.linear / share;
        if (!((image - *form).cwiseAbs().maxCoeff() <= few / least)) return std::nullopt;
    }
    return choleskyFactor<2>(*form);
}

// N similarities of one ratio s with Ns² = 1, whose neighbours are finitely many and none of them the tile
// itself: the open set condition holds, and the attractor has inner points (Bandt; Schief).
std::optional<Figure> boundaryDimension(std::span<const AffineMap<2>> maps, const BoundingBox<2>& box,
                                        bool& isExact) {
    const auto root = rootOfSimilarities(maps);
    if (!root) return std::nullopt;
    Neighbours neighbours(maps, *root, box);
    auto graph = neighbours.graph();
    if (!graph || graph->prune() == 0) return std::nullopt;
    const auto radius = graph->spectralRadius();
    if (!radius || radius->least < 1) return std::nullopt;
    isExact = neighbours.isExact();
    const double rate = std::log(double(maps.size())) / 2, middle = (radius->least + radius->most) / 2;
    Figure result{std::log(middle) / rate};
    result.error = (radius->most - radius->least) / (2 * radius->least * rate) +
                   4 * roundingUnit * (result.value + 1 / rate);
    return result;
}

// The lattice that some vectors generate, if they do.
class Lattice {
public:
    explicit Lattice(double size) : m_tolerance(tolerance * size) {}

    bool isFull() const { return m_rank == 2; }
    const Matrix<2>& basis() const { return m_basis; }

    // False when what is generated is no lattice.
    bool add(Vector<2> v) {
        constexpr int maxRounds = 200;
        for (int round = 0; round < maxRounds; ++round) {
            if (m_rank == 2) v -= m_basis * Vector<2>(m_basis.inverse() * v).array().round().matrix();
            if (v.cwiseAbs().maxCoeff() <= m_tolerance) return true;
            if (m_rank < 2 && (m_rank == 0 || !isAlong(v))) {
                m_basis.col(m_rank++) = v;
                return true;
            }
            v = m_rank == 1 ? reducedAlong(v) : exchanged(v);
            if (m_rank == 2 && std::abs(m_basis.determinant()) <= m_tolerance * m_tolerance) return false;
        }
        return false;
    }

private:
    bool isAlong(const Vector<2>& v) const {
        const Vector<2> b = m_basis.col(0);
        return std::abs(b.x() * v.y() - b.y() * v.x()) <= m_tolerance * b.norm();
    }
    // Euclid's algorithm on a line: the rest that remains.
    Vector<2> reducedAlong(const Vector<2>& v) {
        const Vector<2> b = m_basis.col(0);
        const Vector<2> rest = v - std::round(v.dot(b) / b.squaredNorm()) * b;
        if (rest.cwiseAbs().maxCoeff() > m_tolerance)
            m_basis.col(0) = rest;
        else
            return rest;
        return b;
    }
    // v has coordinates of at most 1/2, so that it spans a finer lattice with one of the basis; the other
    // remains to be added.
    Vector<2> exchanged(const Vector<2>& v) {
        const Vector<2> coordinates = m_basis.inverse() * v;
        const int out = std::abs(coordinates.x()) > std::abs(coordinates.y()) ? 0 : 1;
        const Vector<2> rest = m_basis.col(out);
        m_basis.col(out) = v;
        return rest;
    }

    Matrix<2> m_basis = Matrix<2>::Identity();
    int m_rank = 0;
    double m_tolerance;
};

using Integers = std::array<std::int64_t, 2>;

// A system x ↦ M⁻¹(x + d) in coordinates in which M and the digits d are integers.
struct DigitSystem {
    std::array<Integers, 2> matrix{}; // by rows
    std::vector<Integers> digits;
    Matrix<2> basis; // of the lattice that the differences of digits and M generate

    Integers product(const Integers& v) const {
        return {matrix[0][0] * v[0] + matrix[0][1] * v[1], matrix[1][0] * v[0] + matrix[1][1] * v[1]};
    }
    std::int64_t determinant() const { return matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0]; }
    // One digit of every class modulo M: then the area is a multiple of that of the lattice (Lagarias and
    // Wang).
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

std::optional<Integers> integers(const Vector<2>& v) {
    constexpr double maxEntry = 1e6, off = 1e-6;
    const Vector<2> rounded = v.array().round().matrix();
    if (!(rounded.cwiseAbs().maxCoeff() <= maxEntry) || (v - rounded).cwiseAbs().maxCoeff() > off)
        return std::nullopt;
    return Integers{std::int64_t(rounded.x()), std::int64_t(rounded.y())};
}

// Whether the integers give back the maps, x ↦ A x + b with A = B M⁻¹ B⁻¹ and b = A B d, to rounding error.
bool isAsStored(const DigitSystem& system, std::span<const AffineMap<2>> maps) {
    constexpr double few = 8 * Rounding::share;
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

std::optional<DigitSystem> digitSystem(std::span<const AffineMap<2>> maps, bool& isExact) {
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
    isExact = areShort(maps, inverses(maps));
    return isAsStored(result, maps) ? std::optional(result) : std::nullopt;
}

// The translations by which the attractor can meet itself, and which of those of pieces they are.
std::optional<ContactGraph> translationGraph(const DigitSystem& system, const BoundingBox<2>& box) {
    const Vector<2> size = (1 + tolerance) * sizeOf(box);
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

std::optional<double> area(std::span<const AffineMap<2>> maps, const BoundingBox<2>& box, bool& isExact) {
    bool isShortSystem = false;
    const auto system = digitSystem(maps, isShortSystem);
    if (!system || !system->isComplete()) return std::nullopt;
    auto graph = translationGraph(*system, box);
    if (!graph) return std::nullopt;
    graph->prune();
    const auto radius = graph->spectralRadius();
    if (!radius || !(radius->most < (1 - tolerance) * double(maps.size()))) return std::nullopt;
    isExact = isShortSystem;
    return std::abs(system->basis.determinant());
}

} // namespace

std::optional<Tile> tile(std::span<const AffineMap<2>> maps, const BoundingBox<2>& box) {
    if (maps.size() < 2 || maps.size() > maxMaps || !box.min.allFinite() || !box.max.allFinite())
        return std::nullopt;
    Dyadic excess(-1); // of Σ|det A_i|, without rounding
    double rounding = 0;
    for (const auto& map : maps) {
        if (!isFinite(map) || determinant<2>(map.linear) == 0) return std::nullopt;
        const auto m = exactMatrix<2>(map.linear);
        const Dyadic determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
        excess = determinant.sign() < 0 ? excess - determinant : excess + determinant;
        rounding += roundingOfDeterminant(map.linear);
    }
    if (!(std::abs(excess.rounded()) <= rounding)) return std::nullopt;
    bool isAreaExact = true, isDimensionExact = true;
    Tile result;
    result.area = area(maps, box, isAreaExact);
    if (const auto dimension = boundaryDimension(maps, box, isDimensionExact)) {
        result.boundaryDimension = dimension->value;
        result.boundaryDimensionError = dimension->error;
    }
    if (!result.area && !result.boundaryDimension) return std::nullopt;
    result.isExact = isAreaExact && isDimensionExact;
    return result;
}

} // namespace ifs
