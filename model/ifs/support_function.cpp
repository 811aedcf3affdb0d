// SPDX-License-Identifier: MIT
#include "ifs/support_function.h"

#include "ifs/attractor_existence.h"
#include "ifs/direction_fan.h"
#include "ifs/outline.h"
#include "ifs/polygon.h"
#include "ifs/sandwich.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <numeric>
#include <queue>

namespace ifs {

namespace {

constexpr double RoundingUnit = 0x1p-53;
constexpr int ExactMerging = 43;             // bits of a state that must agree; the rest is rounding
constexpr std::size_t ConsideredPerNode = 8; // children that are dropped at once cost less than nodes
constexpr std::size_t ConsideredPerMap = 40;
constexpr int TableDepth = 4;
constexpr std::size_t TableWork = 60'000; // bounds evaluated at most while the container is shrunk …
constexpr std::size_t LeastSweeps = 2;    // … but for maps that are too many for that
constexpr std::size_t FewMaps = 256;      // not worth asking which of them matter

template <int Dim> Vector<Dim> solveFixedPoint(const AffineMap<Dim>& contraction) {
    return (Matrix<Dim>::Identity() - contraction.linear).inverse() * contraction.translation;
}

template <int Dim> AffineMap<Dim> meanMap(std::span<const AffineMap<Dim>> maps) {
    AffineMap<Dim> mean{Matrix<Dim>::Zero(), Vector<Dim>::Zero()};
    for (const auto& map : maps) {
        mean.linear += map.linear / double(maps.size());
        mean.translation += map.translation / double(maps.size());
    }
    return mean;
}

// {centre + shape·y : |y| ≤ 1}
template <int Dim> struct Ellipsoid {
    Vector<Dim> centre;
    Matrix<Dim> shape;

    double bound(const Vector<Dim>& v) const { return v.dot(centre) + (shape.transpose() * v).norm(); }
};

// An ellipsoid about the attractor: a ball of the norm, of radius max_i ‖w_i(c) − c‖ / (1 − s_i) about any c.
// A slow map does not widen it when c is its fixed point.
template <int Dim>
Ellipsoid<Dim> enclosingEllipsoid(std::span<const AffineMap<Dim>> maps, const ContractingNorm<Dim>& norm) {
    const Matrix<Dim> unroot = norm.root.inverse();
    std::vector<double> reach;
    for (const auto& map : maps)
        reach.push_back(1 / (1 - spectralNorm<Dim>(norm.root * map.linear * unroot)));
    if (std::ranges::any_of(reach, [](double r) { return !(r > 0 && std::isfinite(r)); })) // longer words
        std::ranges::fill(reach, norm.equivalence / (1 - norm.contractivity));
    const auto radius = [&](const Vector<Dim>& centre) {
        double result = 0;
        for (std::size_t i = 0; i < maps.size(); ++i)
            result = std::max(result, (norm.root * (maps[i](centre) - centre)).norm() * reach[i]);
        return result * (1 + 1e-12 * norm.equivalence);
    };
    const Vector<Dim> middle = solveFixedPoint<Dim>(meanMap<Dim>(maps));
    const auto slowest = std::size_t(std::ranges::max_element(reach) - reach.begin());
    const Vector<Dim> aside = solveFixedPoint<Dim>(maps[slowest]);
    const Vector<Dim>& centre = radius(aside) < radius(middle) ? aside : middle;
    return {centre, radius(centre) * unroot};
}

// Points of the attractor far out in some directions, of those that the maps leave where they are.
std::vector<Vector<2>> outerFixedPoints(std::span<const AffineMap<2>> maps) {
    constexpr int Directions = 32;
    std::vector<Vector<2>> fixed;
    for (const auto& map : maps)
        if (const Vector<2> point = solveFixedPoint<2>(map); point.allFinite()) fixed.push_back(point);
    std::vector<Vector<2>> outer;
    for (int k = 0; k < Directions && !fixed.empty(); ++k) {
        const double angle = 2 * std::numbers::pi * k / Directions;
        const Vector<2> u(std::cos(angle), std::sin(angle));
        outer.push_back(*std::ranges::max_element(fixed, {}, [&u](const auto& x) { return u.dot(x); }));
    }
    return outer;
}

// Of the maps at `places` those that can lead to the hull of the attractor. One that takes all of a container
// into the hull of some `points` of the attractor does not: without it the hull solves the same equation
// h(u) = max_i ⟨u, t_i⟩ + h(A_iᵀu), which has one solution. `bound` is that of the container seen from
// `centre`.
template <class Bound>
std::vector<std::size_t> outerMaps(std::span<const AffineMap<2>> maps, std::vector<std::size_t> places,
                                   const Vector<2>& centre, double radius, Bound bound,
                                   const std::vector<Vector<2>>& points) {
    const Polygon hull = convexHull(points, 0);
    if (hull.size() < 3) return places;
    const double margin = 1e-9 * (radius + centre.norm());
    std::vector<Vector<2>> outwards;
    for (std::size_t k = 0; k < hull.size(); ++k) {
        const Vector<2> edge = hull[(k + 1) % hull.size()] - hull[k];
        outwards.push_back(Vector<2>(edge.y(), -edge.x()).normalized());
    }
    std::erase_if(places, [&](std::size_t i) {
        const Vector<2> image = maps[i](centre);
        for (std::size_t k = 0; k < hull.size(); ++k)
            if (outwards[k].dot(image - hull[k]) + bound(maps[i].linear.transpose() * outwards[k]) > -margin)
                return false;
        return true;
    });
    return places;
}

} // namespace

// The attractor seen from its centre, inside both an ellipsoid and the polytope {x : ⟨g,x⟩ ≤ H_g} over the
// directions g of a fan, with a point of it for each direction. The maps are x ↦ A x + offset there; vectors
// u travel by the transposed matrices.
template <int Dim> struct SupportFunction<Dim>::Container {
    std::vector<std::size_t> places; // of these maps among all
    std::vector<Matrix<Dim>> transposed;
    std::vector<Vector<Dim>> offsets;
    Vector<Dim> anchor; // a point of the attractor
    Ellipsoid<Dim> ellipsoid;
    double radius = 0; // about the centre
    DirectionFan<Dim> fan;
    std::vector<double> heights;
    std::vector<Vector<Dim>> points;            // of the attractor, far out in each direction
    std::vector<std::size_t> symbol, successor; // each point is that map of that of another direction
    double mergeLimit = 0; // states this close, relative to |v|, can never be one below the other
    mutable std::once_flag isOutlined;
    mutable std::optional<Outline> outline; // in the plane, once somebody has asked

    explicit Container(int depth) : fan(depth) {}

    double bound(const Vector<Dim>& v) const { return std::min(fan.bound(v, heights), ellipsoid.bound(v)); }
    Outline::Bracket bracket(const Vector<Dim>& v) const {
        const auto parts = fan.combination(v);
        Outline::Bracket result{0, -std::numeric_limits<double>::infinity(), 0};
        for (int k = 0; k < Dim; ++k) {
            const std::size_t direction = parts.index[std::size_t(k)];
            result.upper += parts.factor[k] * heights[direction];
            if (const double height = v.dot(points[direction]); height > result.lower) {
                result.lower = height;
                result.point = direction;
            }
        }
        result.upper = std::min(result.upper, ellipsoid.bound(v));
        return result;
    }
    const Vector<Dim>& point(std::size_t direction) const { return points[direction]; }
    void lengthen(std::vector<int>& address, std::size_t direction) const;
    AffineMap<Dim> map(std::size_t i) const { return {transposed[i].transpose(), offsets[i]}; }

    double rounding() const { return 16 * RoundingUnit * radius; }
    template <class Constant> std::vector<double> solved(Constant constant, double tie) const;
    bool solve();
    void shrink();
    Vector<Dim> recentre();
    void findPoints();
};

// The H with H_g = max_i constant(g, i) + H(A_iᵀg): linear equations once the maximising maps are known,
// which a few rounds of choosing them find (Howard's policy iteration), however slowly the maps contract. Not
// verified.
template <int Dim>
template <class Constant>
std::vector<double> SupportFunction<Dim>::Container::solved(Constant constant, double tie) const {
    constexpr int Rounds = 20;
    const auto& directions = fan.directions();
    const auto count = Eigen::Index(directions.size());
    std::vector<double> solution(directions.size());
    std::vector<std::size_t> chosen(directions.size(), offsets.size());
    for (int round = 0; round < Rounds; ++round) {
        Eigen::MatrixXd equations = Eigen::MatrixXd::Identity(count, count);
        Eigen::VectorXd constants(count);
        bool changed = false;
        for (std::size_t g = 0; g < directions.size(); ++g) {
            double most = -std::numeric_limits<double>::infinity();
            std::size_t best = 0;
            for (std::size_t i = 0; i < offsets.size(); ++i) {
                const double height = constant(g, i) + fan.bound(transposed[i] * directions[g], solution);
                if (height > most + (best == chosen[g] ? tie : 0)) {
                    most = height;
                    best = i;
                }
            }
            changed = changed || best != chosen[g];
            chosen[g] = best;
            const auto parts = fan.combination(transposed[best] * directions[g]);
            for (int k = 0; k < Dim; ++k)
                equations(Eigen::Index(g), parts.index[std::size_t(k)]) -= parts.factor[k];
            constants[Eigen::Index(g)] = constant(g, best);
        }
        if (!changed) break;
        const Eigen::VectorXd next = equations.partialPivLu().solve(constants);
        solution.assign(next.begin(), next.end());
    }
    return solution;
}

// The smallest polytope with these normals that every map takes into itself, a little widened and then
// verified; false when the fan is too coarse for maps that hardly contract.
template <int Dim> bool SupportFunction<Dim>::Container::solve() {
    const auto& directions = fan.directions();
    if (20 * directions.size() * offsets.size() > TableWork) return false;
    const auto offset = [&](std::size_t g, std::size_t i) { return directions[g].dot(offsets[i]); };
    std::vector<double> solution = solved(offset, rounding());
    const std::vector<double> margin = solved([](std::size_t, std::size_t) { return 1.0; }, 1e-9);
    const double widest = std::ranges::max(margin);
    if (!(widest > 0 && std::isfinite(widest))) return false;
    const double widening = std::max(1e-9 * radius, 2 * rounding() * widest); // as much as rounding costs
    for (std::size_t g = 0; g < directions.size(); ++g)
        solution[g] += widening * margin[g] / widest;
    for (std::size_t g = 0; g < directions.size(); ++g)
        for (std::size_t i = 0; i < offsets.size(); ++i)
            if (!(offset(g, i) + fan.bound(transposed[i] * directions[g], solution) + rounding() <=
                  solution[g]))
                return false;
    for (std::size_t g = 0; g < directions.size(); ++g)
        heights[g] = std::min(heights[g], solution[g]);
    return true;
}

// H_g ← max_i ⟨g,offset_i⟩ + H(A_iᵀg) as long as it lowers the H: from any container to the smallest polytope
// with these normals that every map takes into itself.
template <int Dim> void SupportFunction<Dim>::Container::shrink() {
    const auto& directions = fan.directions();
    const std::size_t sweepWork = directions.size() * offsets.size();
    double progress = radius;
    const std::size_t mostWork = std::max(TableWork, LeastSweeps * sweepWork);
    for (std::size_t work = 0; work < mostWork && progress > 1e-6 * radius; work += sweepWork) {
        progress = 0;
        for (std::size_t g = 0; g < directions.size(); ++g) {
            double height = -std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < offsets.size(); ++i)
                height =
                    std::max(height, directions[g].dot(offsets[i]) + bound(transposed[i] * directions[g]));
            height += rounding();
            progress = std::max(progress, heights[g] - height);
            heights[g] = std::min(heights[g], height);
        }
    }
}

// Moves the origin to the middle of the box if that lessens the radius; returns by how much it moved.
template <int Dim> Vector<Dim> SupportFunction<Dim>::Container::recentre() {
    Vector<Dim> middle, half;
    for (int k = 0; k < Dim; ++k) {
        const double high = heights[2 * std::size_t(k)], low = -heights[2 * std::size_t(k) + 1];
        middle[k] = (low + high) / 2;
        half[k] = (high - low) / 2;
    }
    const double moved = rounding();
    if (half.norm() + moved >= radius) return Vector<Dim>::Zero();
    for (std::size_t g = 0; g < heights.size(); ++g)
        heights[g] += moved - fan.directions()[g].dot(middle);
    ellipsoid.centre -= middle;
    ellipsoid.shape *= 1 + 1e-12;
    radius = half.norm() + moved;
    return middle;
}

// The map that the heights say leads farthest in a direction g takes it to another, and so on, round and
// round in the end: a cycle gives a point that its maps leave where it is, and the way there the images of
// that.
template <int Dim> void SupportFunction<Dim>::Container::findPoints() {
    const auto& directions = fan.directions();
    points.assign(directions.size(), anchor);
    symbol.assign(directions.size(), 0);
    successor.assign(directions.size(), 0);
    for (std::size_t g = 0; g < directions.size(); ++g) {
        double most = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < offsets.size(); ++i)
            if (const double height =
                    directions[g].dot(offsets[i]) + fan.bound(transposed[i] * directions[g], heights);
                height > most) {
                most = height;
                symbol[g] = i;
            }
        const auto parts = fan.combination(transposed[symbol[g]] * directions[g]);
        Eigen::Index nearest = 0;
        parts.factor.maxCoeff(&nearest);
        successor[g] = parts.index[std::size_t(nearest)];
    }
    std::vector<char> isKnown(directions.size(), 0);
    for (std::size_t g = 0; g < directions.size(); ++g) {
        std::vector<std::size_t> way;
        std::size_t end = g;
        for (; !isKnown[end] && std::ranges::find(way, end) == way.end(); end = successor[end])
            way.push_back(end);
        if (!isKnown[end]) {
            AffineMap<Dim> cycle = map(symbol[end]);
            for (std::size_t k = successor[end]; k != end; k = successor[k])
                cycle = cycle * map(symbol[k]);
            if (const Vector<Dim> fixed = solveFixedPoint<Dim>(cycle); fixed.allFinite()) points[end] = fixed;
            isKnown[end] = 1;
        }
        for (; !way.empty(); way.pop_back())
            if (const std::size_t k = way.back(); !isKnown[k]) {
                points[k] = map(symbol[k])(points[successor[k]]);
                isKnown[k] = 1;
            }
    }
}

// By the address of the point of a direction, as far as a double can tell.
template <int Dim>
void SupportFunction<Dim>::Container::lengthen(std::vector<int>& address, std::size_t direction) const {
    constexpr int MostSymbols = 4'000;
    Matrix<Dim> rest = Matrix<Dim>::Identity();
    for (int n = 0; n < MostSymbols && rest.cwiseAbs().maxCoeff() > 0x1p-60; ++n) {
        address.push_back(int(places[symbol[direction]]));
        rest = transposed[symbol[direction]] * rest;
        direction = successor[direction];
    }
}

template <int Dim>
std::optional<SupportFunction<Dim>> SupportFunction<Dim>::of(std::span<const AffineMap<Dim>> maps) {
    const Existence existence = classify(maps);
    if (existence.verdict != Verdict::Hyperbolic && existence.verdict != Verdict::EventuallyContractive)
        return std::nullopt;
    const ContractingNorm<Dim> norm = contractingNorm(maps, existence);
    const Ellipsoid<Dim> ellipsoid = enclosingEllipsoid(maps, norm);
    const Vector<Dim> anchor = solveFixedPoint<Dim>(maps.front());
    const double radius = spectralNorm<Dim>(ellipsoid.shape);
    if (!std::isfinite(radius) || !ellipsoid.centre.allFinite() || !anchor.allFinite()) return std::nullopt;

    SupportFunction result;
    result.m_centre = ellipsoid.centre;
    // `finer` than the work for so many maps allows; inside what is `known`.
    const auto contain = [&](std::vector<std::size_t> places, int finer, const Container* known) {
        int depth = TableDepth;
        while (depth > 0 && (std::size_t(4) << depth) * places.size() > TableWork)
            --depth;
        depth = std::min(depth + finer, TableDepth);
        auto container = std::make_shared<Container>(depth);
        container->places = std::move(places);
        for (const std::size_t i : container->places)
            container->transposed.push_back(maps[i].linear.transpose());
        container->ellipsoid =
            known ? known->ellipsoid : Ellipsoid<Dim>{Vector<Dim>::Zero(), ellipsoid.shape};
        container->radius = known ? known->radius : radius;
        for (const auto& direction : container->fan.directions())
            container->heights.push_back(known ? known->bound(direction) + known->rounding()
                                               : container->ellipsoid.bound(direction) * (1 + 1e-15));
        container->mergeLimit = (1 - norm.contractivity) / norm.equivalence;
        const auto centreOn = [&](const Vector<Dim>& centre) {
            result.m_centre = centre;
            container->offsets.clear();
            for (const std::size_t i : container->places)
                container->offsets.push_back(maps[i](centre) - centre);
            container->anchor = anchor - centre;
        };
        centreOn(result.m_centre);
        if (!container->solve()) container->shrink();
        centreOn(result.m_centre + container->recentre());
        container->findPoints();
        return container;
    };
    std::vector<std::size_t> all(maps.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    std::shared_ptr<const Container> container;
    if constexpr (Dim == 2) {
        if (all.size() > FewMaps) {
            std::vector<Vector<2>> points = outerFixedPoints(maps);
            const auto ofEllipsoid = [&](const Vector<2>& v) {
                return (ellipsoid.shape.transpose() * v).norm();
            };
            container =
                contain(outerMaps(maps, all, ellipsoid.centre, radius, ofEllipsoid, points), 0, nullptr);
            // Where that leaves as many, more directions may tell more.
            for (int finer = 0; container->places.size() > FewMaps;) {
                for (const Vector<2>& point : container->points)
                    points.push_back(result.m_centre + point);
                auto fewer = outerMaps(
                    maps, container->places, result.m_centre, container->radius,
                    [&](const Vector<2>& v) { return container->bound(v); }, points);
                if (finer == TableDepth && 10 * fewer.size() > 9 * container->places.size()) break;
                if (2 * fewer.size() > container->places.size()) finer = std::min(finer + 2, TableDepth);
                container = contain(std::move(fewer), finer, container.get());
            }
        }
    }
    if (!container) container = contain(std::move(all), 0, nullptr);

    result.m_maps.assign(maps.begin(), maps.end());
    result.m_radius = container->radius;
    result.m_contractivity = norm.contractivity;
    result.m_normEquivalence = norm.equivalence;
    result.m_container = std::move(container);
    return result;
}

// Finer and finer: each outline makes the next one cheap. Where the hull is round the lines run out before
// the tolerance is reached, and finer ones would cost as much as no outline at all.
template <int Dim> const Outline* SupportFunction<Dim>::outline() const {
    if constexpr (Dim != 2) {
        return nullptr;
    } else {
        std::call_once(m_container->isOutlined, [this] {
            constexpr int MostLines = 64;
            for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-6, 1e-8}) {
                const auto& known = m_container->outline;
                const Sandwich finer(*this, tolerance * m_radius, known ? &*known : nullptr, MostLines);
                m_container->outline = finer.outline();
                if (!(finer.error() <= tolerance * m_radius)) break;
            }
        });
        return &*m_container->outline;
    }
}

template <int Dim> Vector<Dim> SupportFunction<Dim>::pointOfAttractor() const {
    return m_centre + m_container->anchor;
}

template <int Dim> const std::vector<std::size_t>& SupportFunction<Dim>::mapsToTheHull() const {
    return m_container->places;
}

template <int Dim> double SupportFunction<Dim>::roundingError(int depth) const {
    const double size = m_centre.norm() + m_radius;
    return std::max(1e-12 * m_radius,
                    RoundingUnit * size * (8 * depth + 4 * m_normEquivalence / (1 - m_contractivity)));
}

namespace {

// The state of an address σ: v = A_σᵀu and o = ⟨u, w_σ(0)⟩, so that h_A(u) = max over all σ of one length of
// o + h_A(v).
template <int Dim> struct State {
    Vector<Dim> v;
    double o = 0;
    int parent = -1;
    int symbol = -1;
    int depth = 0;
};

// A container with a known outline, which alone bounds better once it has more lines than the fan.
template <class Container> struct OutlinedContainer {
    const Container& container;
    const Outline& outline;

    Outline::Bracket bracket(const Vector<2>& v) const {
        Outline::Bracket result = outline.bracket(v);
        if (outline.lines().size() < container.heights.size())
            result.upper = std::min(result.upper, container.bound(v));
        return result;
    }
    const Vector<2>& point(std::size_t k) const { return outline.points()[k]; }
    void lengthen(std::vector<int>&, std::size_t) const {} // how those points were found is forgotten
};

// The places of states by their v, rounded to `bits` bits of its largest component. The grid is shifted, for
// dyadic numbers with an error of one ulp would fall to either side of a grid point. Two states may share a
// key by chance: who looks one up compares the states themselves.
template <int Dim> class StateTable {
public:
    explicit StateTable(int bits) : m_bits(bits), m_slots(1 << 10) {}

    // The slot of the key: the state there, or Free.
    std::int32_t& operator[](const Vector<Dim>& v) {
        if (2 * ++m_used > m_slots.size()) grow();
        return slot(key(v));
    }

    static constexpr std::int32_t Free = -1;

private:
    struct Slot {
        std::uint64_t key = 0;
        std::int32_t state = Free;
    };

    std::uint64_t key(const Vector<Dim>& v) const {
        int exponent = 0;
        std::frexp(1.1 * v.cwiseAbs().maxCoeff(), &exponent);
        const double scale = std::ldexp(1, m_bits - exponent);
        std::uint64_t hash = std::uint64_t(exponent);
        for (int k = 0; k < Dim; ++k) {
            hash = (hash ^ std::uint64_t(std::int64_t(std::floor(v[k] * scale + 0.3)))) * 0x9E3779B97F4A7C15u;
            hash ^= hash >> 29;
        }
        return hash;
    }

    std::int32_t& slot(std::uint64_t wanted) {
        std::size_t place = wanted & (m_slots.size() - 1);
        while (m_slots[place].state != Free && m_slots[place].key != wanted)
            place = (place + 1) & (m_slots.size() - 1);
        m_slots[place].key = wanted;
        return m_slots[place].state;
    }

    void grow() {
        std::vector<Slot> old(2 * m_slots.size());
        old.swap(m_slots);
        for (const Slot& entry : old)
            if (entry.state != Free) slot(entry.key) = entry.state;
    }

    int m_bits;
    std::size_t m_used = 0;
    std::vector<Slot> m_slots;
};

// Best first over addresses. Whatever leaves the frontier without being followed is accounted for: in
// `ceiling` when it cannot beat the best value by more than the tolerance, in `slack` when an equal state
// stands for it.
template <int Dim, class Container, class Known> class AddressSearch {
public:
    AddressSearch(const Container& container, const Known& known, const Vector<Dim>& u, double tolerance,
                  int mergeBits)
        : m_container(container),
          m_brackets(known),
          m_tolerance(tolerance),
          m_known(mergeBits),
          m_cell(mergeBits == ExactMerging ? 0 : std::ldexp(4, -mergeBits)),
          m_length(u.norm()) {
        consider({.v = u});
    }

    void run(int maxNodes) {
        const std::size_t maxStates = std::size_t(std::max(maxNodes, 1));
        const std::size_t maxConsidered =
            ConsideredPerNode * maxStates + ConsideredPerMap * m_container.offsets.size();
        while (!isFinished() && m_states.size() < maxStates && m_considered < maxConsidered) {
            const State<Dim> state = m_states[m_frontier.top().state];
            const int parent = int(m_frontier.top().state);
            m_frontier.pop();
            for (std::size_t i = 0; i < m_container.offsets.size(); ++i)
                consider({.v = m_container.transposed[i] * state.v,
                          .o = state.o + state.v.dot(m_container.offsets[i]),
                          .parent = parent,
                          .symbol = int(i),
                          .depth = state.depth + 1});
        }
    }

    double upperBound() const {
        const double open = m_frontier.empty() ? m_ceiling : std::max(m_ceiling, m_frontier.top().bound);
        return std::max(open, m_best) + slack();
    }

    bool isFinished() const { return m_frontier.empty() || m_frontier.top().bound <= m_best + m_tolerance; }

    std::vector<int> bestAddress() const {
        std::vector<int> address;
        for (int state = int(m_bestState); m_states[std::size_t(state)].parent >= 0;
             state = m_states[std::size_t(state)].parent)
            address.push_back(int(m_container.places[std::size_t(m_states[std::size_t(state)].symbol)]));
        std::ranges::reverse(address);
        return address;
    }

    // Where on the attractor, as known before, the best address begins.
    const Vector<Dim>& bestStart() const { return m_brackets.point(m_bestPoint); }
    std::size_t bestPoint() const { return m_bestPoint; }

    int depth() const { return m_depth; }

private:
    struct Open {
        double bound;
        std::size_t state;
        bool operator<(const Open& other) const { return bound < other.bound; }
    };

    void consider(const State<Dim>& state) {
        ++m_considered;
        m_depth = std::max(m_depth, state.depth);
        const Outline::Bracket known = m_brackets.bracket(state.v);
        const double attained = state.o + known.lower, bound = state.o + known.upper;
        const bool isBest = attained > m_best;
        if (!isBest && bound <= m_best + m_tolerance) {
            m_ceiling = std::max(m_ceiling, bound);
            return;
        }
        if (isBest) {
            m_best = attained;
            m_bestState = m_states.size();
            m_bestPoint = known.point;
        } else if (isMerged(state)) {
            return;
        }
        m_frontier.push({bound, m_states.size()});
        m_states.push_back(state);
    }

    // What merging may have lost: no more than all costs together, and no more than the costs along one
    // address, where the lengths |v| form a geometric series.
    double slack() const {
        if (m_cell >= m_container.mergeLimit) return m_slack;
        const double alongOneAddress = m_cell * m_length / (m_container.mergeLimit - m_cell);
        return std::min(m_slack, m_container.radius * alongOneAddress + m_merged * rounding());
    }

    // By how much exact ties differ.
    double rounding() const { return 8 * RoundingUnit * m_container.radius * m_length; }

    // Whether an earlier state with nearly the same v and hardly a smaller o stands for this one. Whatever
    // h_A the two differ by, radius·|v − v'| bounds it. A state may not stand for its own descendant: in
    // ‖·‖_* a descendant is shorter by the contractivity, so states that are closer than `mergeLimit` are
    // unrelated.
    bool isMerged(const State<Dim>& state) {
        std::int32_t& place = m_known[state.v];
        if (place == m_known.Free) {
            place = std::int32_t(m_states.size());
            return false;
        }
        const State<Dim>& earlier = m_states[std::size_t(place)];
        const double distance = (state.v - earlier.v).norm(), length = earlier.v.norm();
        const double cost = state.o + m_container.radius * distance - earlier.o;
        if (cost > m_cell * m_container.radius * length + rounding() ||
            distance >= m_container.mergeLimit * length) {
            if (state.o > earlier.o) place = std::int32_t(m_states.size());
            return false;
        }
        m_slack += std::max(cost, 0.0);
        ++m_merged;
        return true;
    }

    const Container& m_container;
    const Known& m_brackets;
    double m_tolerance;
    StateTable<Dim> m_known;
    double m_cell; // how far apart, relative to |v|, states may be merged; 0 for exact ties
    double m_length;
    std::vector<State<Dim>> m_states;
    std::priority_queue<Open> m_frontier;
    double m_best = -std::numeric_limits<double>::infinity();
    std::size_t m_bestState = 0, m_bestPoint = 0;
    double m_ceiling = -std::numeric_limits<double>::infinity();
    double m_slack = 0;
    int m_merged = 0;
    std::size_t m_considered = 0;
    int m_depth = 0;
};

} // namespace

template <int Dim>
SupportValue<Dim> SupportFunction<Dim>::operator()(const Vector<Dim>& u, double tolerance, int maxNodes,
                                                   const Outline* known) const {
    if constexpr (Dim == 2)
        if (known != nullptr)
            return search(OutlinedContainer<Container>{*m_container, *known}, u, tolerance, maxNodes);
    return search(*m_container, u, tolerance, maxNodes);
}

template <int Dim>
template <class Known>
SupportValue<Dim> SupportFunction<Dim>::search(const Known& known, const Vector<Dim>& u, double tolerance,
                                               int maxNodes) const {
    SupportValue<Dim> result;
    result.point = pointOfAttractor();
    const double size = u.cwiseAbs().maxCoeff();
    if (!u.allFinite() || size == 0) {
        result.error = size == 0 ? 0 : std::numeric_limits<double>::infinity();
        return result;
    }
    // A power of two, so that scaling rounds nothing.
    int exponent = 0;
    std::frexp(size, &exponent);
    Vector<Dim> scaled;
    for (int k = 0; k < Dim; ++k)
        scaled[k] = std::ldexp(u[k], -exponent);
    const double smallest = 8 * RoundingUnit * m_radius * scaled.norm();
    const double wanted = std::max(std::ldexp(tolerance, -exponent), smallest);
    // Codes whose digits were rounded have near ties by the thousand. If merging at a quarter of the
    // tolerance does not settle them within half of the nodes, coarser and coarser merging does, at a price
    // that the error states.
    const double fineness = 16 * m_radius * scaled.norm() / (wanted * m_container->mergeLimit);
    const int withinTolerance = fineness < 0x1p43 ? std::max(14, std::ilogb(fineness) + 1) : ExactMerging;
    double leastError = std::numeric_limits<double>::infinity();
    for (const auto& [mergeBits, share] : {std::pair{withinTolerance, 2}, {26, 4}, {14, 4}}) {
        if (mergeBits > withinTolerance) continue;
        AddressSearch<Dim, Container, Known> search(*m_container, known, scaled, wanted, mergeBits);
        search.run(maxNodes / share);
        auto address = search.bestAddress();
        const Vector<Dim> point = follow(address, search.bestStart());
        const double value = scaled.dot(point);
        const double gap = std::max(0.0, search.upperBound() + scaled.dot(m_centre) - value);
        const double error = gap + roundingError(search.depth()) * scaled.norm();
        if (error < leastError) {
            leastError = error;
            known.lengthen(address, search.bestPoint());
            result = {std::ldexp(value, exponent), std::ldexp(error, exponent), point, std::move(address)};
        }
        if (search.isFinished()) break;
    }
    return result;
}

// φ(σ…) from a point seen from the centre on, innermost map first: every map shrinks what rounding has done
// before.
template <int Dim>
Vector<Dim> SupportFunction<Dim>::follow(const std::vector<int>& address, const Vector<Dim>& start) const {
    Vector<Dim> point = m_centre + start;
    for (auto symbol = address.rbegin(); symbol != address.rend(); ++symbol)
        point = m_maps[std::size_t(*symbol)](point);
    return point;
}

template class SupportFunction<2>;
template class SupportFunction<3>;

} // namespace ifs
