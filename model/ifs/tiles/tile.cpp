// SPDX-License-Identifier: MIT
#include "ifs/tiles/tile.h"

#include "ifs/dimension/dimension.h"
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

constexpr double tolerance = 1e-9; // of the size of things
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

Vector<2> sizeOf(const BoundingBox<2>& box) {
    return box.max - box.min + Vector<2>::Constant(2 * box.error);
}

// The isometries h = w_u⁻¹ w_v of neighbours w_u(A), w_v(A), as they arise from one another:
// A ∩ h(A) = ∪ w_i(A ∩ h'(A)) with h' = w_i⁻¹ h w_j.
class Neighbours {
public:
    Neighbours(std::span<const AffineMap<2>> maps, const BoundingBox<2>& box)
        : m_maps(maps),
          m_inverses(inverses(maps)),
          m_centre((box.min + box.max) / 2),
          m_size(sizeOf(box)),
          m_isExact(areShort(maps, m_inverses)) {}

    bool isExact() const { return m_isExact; }

    // nullopt where there is no end of them, or two words are the same map.
    std::optional<ContactGraph> graph() {
        for (std::size_t i = 0; i < m_maps.size(); ++i)
            for (std::size_t j = 0; j < m_maps.size(); ++j)
                if (i != j && !place(m_inverses[i] * m_maps[j])) return std::nullopt;
        std::vector<std::pair<std::size_t, std::size_t>> edges;
        for (std::size_t k = 0; k < m_found.size(); ++k)
            for (std::size_t i = 0; i < m_maps.size(); ++i)
                for (std::size_t j = 0; j < m_maps.size(); ++j) {
                    const auto to = place(m_inverses[i] * (m_found[k] * m_maps[j]));
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

    bool isSame(const AffineMap<2>& a, const AffineMap<2>& b) const {
        const double off = m_isExact ? 0 : tolerance;
        return (a.translation - b.translation).cwiseAbs().maxCoeff() <= off * m_size.maxCoeff() &&
               (a.linear - b.linear).cwiseAbs().maxCoeff() <= off * a.linear.cwiseAbs().maxCoeff();
    }

    // Its number; `none` where the tiles are too far from each other. nullopt where there are too many, and
    // where both are one.
    std::optional<std::size_t> place(const AffineMap<2>& h) {
        const Vector<2> reach = (m_size + h.linear.cwiseAbs() * m_size) / 2;
        const Vector<2> apart = (h(m_centre) - m_centre).cwiseAbs();
        if (((1 + tolerance) * reach - apart).minCoeff() < 0) return none;
        if (isSame(h, {})) return std::nullopt;
        for (std::size_t k = 0; k < m_found.size(); ++k)
            if (isSame(m_found[k], h)) return k;
        if (m_found.size() == ContactGraph::maxVertices) return std::nullopt;
        m_isExact = m_isExact && isShort(h);
        m_found.push_back(h);
        return m_found.size() - 1;
    }

    std::span<const AffineMap<2>> m_maps;
    Maps m_inverses;
    Vector<2> m_centre, m_size;
    bool m_isExact;
    Maps m_found;
};

// N similarities of one ratio s with Ns² = 1, whose neighbours are finitely many and none of them the tile
// itself: the open set condition holds, and the attractor has inner points (Bandt; Schief).
std::optional<double> boundaryDimension(std::span<const AffineMap<2>> maps, const BoundingBox<2>& box,
                                        bool& isExact) {
    const auto ratios = similarityRatios<2>(maps);
    if (!ratios) return std::nullopt;
    const double ratio = 1 / std::sqrt(double(maps.size()));
    if (std::ranges::any_of(*ratios, [=](double s) { return std::abs(s - ratio) > tolerance * ratio; }))
        return std::nullopt;
    Neighbours neighbours(maps, box);
    auto graph = neighbours.graph();
    if (!graph || graph->prune() == 0) return std::nullopt;
    const auto radius = graph->spectralRadius();
    if (!radius || radius->least < 1) return std::nullopt;
    isExact = neighbours.isExact();
    return std::log((radius->least + radius->most) / 2) / -std::log(ratio);
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
    return result;
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
    double measure = 0;
    for (const auto& map : maps) {
        if (!isFinite(map) || determinant<2>(map.linear) == 0) return std::nullopt;
        measure += std::abs(determinant<2>(map.linear));
    }
    if (std::abs(measure - 1) > tolerance) return std::nullopt;
    bool isAreaExact = true, isDimensionExact = true;
    Tile result;
    result.area = area(maps, box, isAreaExact);
    result.boundaryDimension = boundaryDimension(maps, box, isDimensionExact);
    if (!result.area && !result.boundaryDimension) return std::nullopt;
    result.isExact = isAreaExact && isDimensionExact;
    return result;
}

} // namespace ifs
