// SPDX-License-Identifier: MIT
#include "ifs/separation/neighbour_graph.h"

#include "ifs/existence/invariant_form.h"
#include "ifs/linear/decompositions.h"
#include "ifs/linear/inverse.h"
#include "ifs/linear/rounding.h"
#include "ifs/linear/symmetric_matrices.h"
#include "ifs/separation/affine_hull.h"
#include "ifs/separation/stored_rounding.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace ifs {

namespace {

constexpr double tolerance = 1e-9; // relative size of errors that enlarge a set
constexpr std::size_t maxNeighbourMaps = 64;
constexpr std::size_t maxEdges = 60'000;

// Products of three numbers like that, and their sums, are doubles without rounding.
bool isShort(long double value) {
    constexpr long double steps = 256, maxSize = 256;
    return std::abs(value) <= maxSize && value * steps == std::round(value * steps);
}

template <class Map> bool hasShortNumbers(const Map& map) {
    return std::ranges::all_of(map.linear.reshaped(), [](auto value) { return isShort(value); }) &&
           std::ranges::all_of(map.translation, [](auto value) { return isShort(value); });
}

template <int Dim> std::vector<AffineMap<Dim>> inversesOf(std::span<const AffineMap<Dim>> maps) {
    std::vector<AffineMap<Dim>> result;
    for (const auto& map : maps) {
        const Matrix<Dim> inverse = map.linear.inverse();
        result.push_back({inverse, -(inverse * map.translation)});
    }
    return result;
}

// Returns true if the inverses are exact, and everything made of them is short.
template <int Dim>
bool areShort(std::span<const AffineMap<Dim>> maps, const std::vector<AffineMap<Dim>>& inverses) {
    for (std::size_t i = 0; i < maps.size(); ++i)
        if (!hasShortNumbers(maps[i]) || !hasShortNumbers(inverses[i]) ||
            !(maps[i] * inverses[i] == AffineMap<Dim>{}))
            return false;
    return true;
}

// A map in numbers whose own rounding hides little of what that of the stored coefficients makes of it.
template <int Dim> struct LongMap {
    using Linear = Eigen::Matrix<long double, Dim, Dim>;
    using Shift = Eigen::Matrix<long double, Dim, 1>;

    LongMap() = default;
    LongMap(const Linear& matrix, const Shift& vector) : linear(matrix), translation(vector) {}
    explicit LongMap(const AffineMap<Dim>& map)
        : linear(map.linear.template cast<long double>()),
          translation(map.translation.template cast<long double>()) {}

    LongMap operator*(const LongMap& inner) const {
        return {linear * inner.linear, linear * inner.translation + translation};
    }
    AffineMap<Dim> rounded() const {
        return {linear.template cast<double>(), translation.template cast<double>()};
    }

    Linear linear = Linear::Identity();
    Shift translation = Shift::Zero();
};

// A map with its error, which arises because the maps it is made of are stored as doubles.
template <int Dim> struct Rounded {
    LongMap<Dim> map{};
    double linear = 0, shift = 0; // in the norms of a frame
};

// Coordinates x ↦ U x in which maps are similarities, so that errors do not grow with the condition of each.
template <int Dim> class Frame {
public:
    explicit Frame(const Matrix<Dim>& root)
        : m_root(root),
          m_unroot(root.inverse()),
          m_rootSize(m_root.cwiseAbs()),
          m_unrootSize(m_unroot.cwiseAbs()),
          m_size(root.norm()),
          m_condition(m_size * m_unroot.norm()) {}

    Rounded<Dim> stored(const AffineMap<Dim>& map) const {
        const auto rounding = StoredRounding<Dim>::of(map);
        return {LongMap<Dim>(map), spectralNorm<Dim>(m_rootSize * rounding.linear * m_unrootSize),
                (m_rootSize * rounding.translation).norm()};
    }

    // A change δ of A changes A⁻¹ by A⁻¹δA⁻¹.
    Rounded<Dim> inverse(const AffineMap<Dim>& map) const {
        const Rounded<Dim> known = stored(map);
        const typename LongMap<Dim>::Linear back = inverseOf<Dim>(known.map.linear);
        const double stretch = norm(back);
        const double linear = stretch * stretch * (known.linear + few * m_condition * map.linear.norm());
        return {{back, -(back * known.map.translation)},
                linear,
                linear * length(known.map.translation) +
                    stretch * (known.shift + few * m_size * map.translation.norm())};
    }

    Rounded<Dim> product(const Rounded<Dim>& a, const Rounded<Dim>& b) const {
        const AffineMap<Dim> outer = a.map.rounded(), inner = b.map.rounded();
        const double stretch = norm(a.map.linear), size = outer.linear.norm();
        return {a.map * b.map,
                a.linear * norm(b.map.linear) + stretch * b.linear +
                    few * m_condition * size * inner.linear.norm(),
                a.shift + a.linear * length(b.map.translation) + stretch * b.shift +
                    few * m_size * (size * inner.translation.norm() + outer.translation.norm())};
    }

    // Returns true if all maps that a may be are among those that b may be.
    bool isWithin(const Rounded<Dim>& a, const Rounded<Dim>& b) const {
        constexpr double sure = 1 + 0x1p-20; // more than the norms are off
        return sure * (length(a.map.translation - b.map.translation) + a.shift) <= b.shift &&
               sure * (norm(a.map.linear - b.map.linear) + a.linear) <= b.linear;
    }

    // Distance by which the image of a point of this norm may be off.
    double off(const Rounded<Dim>& h, double reach) const {
        return m_unrootSize.norm() * (h.shift + h.linear * m_size * reach);
    }

    bool isSame(const Rounded<Dim>& a, const Rounded<Dim>& b) const {
        return length(a.map.translation - b.map.translation) <= a.shift + b.shift &&
               norm(a.map.linear - b.map.linear) <= a.linear + b.linear;
    }

    // Returns true if rounding is small enough to identify maps that agree up to rounding error.
    bool isTelling(const Rounded<Dim>& h, const Vector<Dim>& size) const {
        constexpr double most = 0x1p-36;
        return h.linear <= most && h.shift <= most * (m_root * size).norm();
    }

private:
    static constexpr double few = 2 * double(std::numeric_limits<long double>::epsilon());

    double norm(const typename LongMap<Dim>::Linear& linear) const {
        return spectralNorm<Dim>(m_root * linear.template cast<double>() * m_unroot);
    }
    double length(const typename LongMap<Dim>::Shift& v) const {
        return (m_root * v.template cast<double>()).norm();
    }

    Matrix<Dim> m_root, m_unroot, m_rootSize, m_unrootSize;
    double m_size, m_condition;
};

template <int Dim> Vector<Dim> sizeOf(const BoundingBox<Dim>& box) {
    return box.max - box.min + Vector<Dim>::Constant(2 * box.error);
}

// The U with P = UᵀU for which all AᵀPA = s²P with the same s, to rounding error.
template <int Dim>
std::optional<Matrix<Dim>> rootOfOneRatio(std::span<const AffineMap<Dim>> maps, double& ratio) {
    const double first = std::abs(determinant<Dim>(maps[0].linear));
    if (!(first > 0) || !std::isfinite(first)) return std::nullopt;
    ratio = std::pow(first, 1.0 / Dim);
    if (!(ratio < 1)) return std::nullopt;
    for (const auto& map : maps) {
        const double apart = std::abs(determinant<Dim>(map.linear)) - first;
        if (!(std::abs(apart) <= offDeterminant<Dim>(map.linear) + offDeterminant<Dim>(maps[0].linear)))
            return std::nullopt;
    }
    const auto form = invariantForm<Dim>(maps);
    if (!form) return std::nullopt;
    // Lower bound, since the largest is 1 up to a factor.
    const double least = singularValues<Dim>(*form)[Dim - 1];
    constexpr double few = 64 * roundingUnit, flat = 1e-12;
    if (!(least > flat)) return std::nullopt;
    for (const auto& map : maps) {
        const Matrix<Dim> image = map.linear.transpose() * *form * map.linear / (ratio * ratio);
        if (!((image - *form).cwiseAbs().maxCoeff() <= few / least)) return std::nullopt;
    }
    return choleskyFactor<Dim>(*form);
}

// The maps as they are on the affine hull of the attractor, and upright across it, where that does not
// matter. nullopt where the hull is flat and not parallel to the axes, or nearly flat.
template <int Dim>
std::optional<std::vector<AffineMap<Dim>>> spanning(std::span<const AffineMap<Dim>> maps,
                                                    const BoundingBox<Dim>& box, std::vector<int>& axes) {
    std::vector<AffineMap<Dim>> result(maps.begin(), maps.end());
    const auto hull = affineHull<Dim>(maps);
    if (!hull || hull->dimension == 0) return std::nullopt;
    if (hull->dimension == Dim) {
        // Widely spaced points of the attractor: far from a plane or line, too, if the attractor is.
        constexpr double flat = 1e-6;
        Matrix<Dim> spread = Matrix<Dim>::Zero();
        for (const auto& outer : maps)
            for (const auto& inner : maps) {
                const Vector<Dim> x =
                    outer(inner((box.min + box.max) / 2)) - maps[0](maps[0]((box.min + box.max) / 2));
                spread += x * x.transpose();
            }
        const auto values = symmetricEigenvalues<Dim>(spread).values;
        if (!(values[0] > flat * flat * values[Dim - 1])) return std::nullopt;
        return result;
    }
    if (!hull->axes) return std::nullopt;
    axes.assign(hull->axes->begin(), hull->axes->end());
    const auto isAlong = [&](int axis) { return std::ranges::find(*hull->axes, axis) != hull->axes->end(); };
    const int first = hull->axes->front();
    for (auto& map : result)
        for (int i = 0; i < Dim; ++i) {
            if (isAlong(i)) continue;
            const double upright =
                std::abs(hull->dimension == 1 ? map.linear(first, first) : map.linear(i, i));
            for (const int axis : *hull->axes)
                if (map.linear(axis, i) != 0 || map.linear(i, axis) != 0) return std::nullopt;
            map.linear.row(i).setZero();
            map.linear(i, i) = upright;
            map.translation[i] = 0;
        }
    return result;
}

} // namespace

bool areShort(std::span<const AffineMap<2>> maps) {
    return areShort<2>(maps, inversesOf<2>(maps));
}

template <int Dim> class NeighbourSearch {
public:
    NeighbourSearch(std::span<const AffineMap<Dim>> maps, const Matrix<Dim>& root,
                    const BoundingBox<Dim>& box)
        : m_frame(root), m_centre((box.min + box.max) / 2), m_size(sizeOf<Dim>(box)) {
        const auto inverses = inversesOf<Dim>(maps);
        m_isExact = areShort<Dim>(maps, inverses);
        for (std::size_t i = 0; i < maps.size(); ++i) {
            m_maps.push_back(m_frame.stored(maps[i]));
            m_inverses.push_back(m_frame.inverse(maps[i]));
            if (m_isExact) m_inverses.back().map = LongMap<Dim>(inverses[i]);
        }
        m_found.push_back({});
        m_ways.emplace_back();
    }

    // Returns nullopt if the graph is infinite.
    std::optional<NeighbourGraph> graph(double ratio, std::vector<int> axes) {
        NeighbourGraph result;
        result.m_axes = std::move(axes);
        for (std::size_t k = 0; k < m_found.size(); ++k)
            for (std::size_t i = 0; i < m_maps.size(); ++i)
                for (std::size_t j = 0; j < m_maps.size(); ++j) {
                    if (k == 0 && i == j) {
                        result.m_edges.push_back({0, i, i, 0});
                        continue;
                    }
                    const auto h = m_frame.product(m_inverses[i], m_frame.product(m_found[k], m_maps[j]));
                    const auto to = place(h);
                    if (!to || result.m_edges.size() > maxEdges) return std::nullopt;
                    if (*to == none) continue;
                    if (*to == m_ways.size()) m_ways.push_back({k, i, j});
                    if (*to == 0 && !result.m_overlap) result.m_overlap = words(k, i, j);
                    result.m_edges.push_back({k, i, j, *to});
                }
        result.m_certainty = m_isExact ? Certainty::Exact : Certainty::ToRounding;
        result.m_ratio = ratio;
        result.m_maps = m_maps.size();
        keepMeeting(result);
        return result;
    }

private:
    static constexpr std::size_t none = ~std::size_t{0};
    struct Way {
        std::size_t from = 0, i = 0, j = 0;
    };

    // Keeps the maps with h(A) ∩ A ≠ ∅: those from which an infinite walk starts.
    void keepMeeting(NeighbourGraph& result) const {
        ContactGraph contacts(m_found.size());
        for (const auto& edge : result.m_edges)
            contacts.join(edge.from, edge.to);
        const auto kept = contacts.prune();
        std::vector<std::size_t> index(m_found.size(), none);
        for (std::size_t k = 0; k < kept.size(); ++k)
            index[kept[k]] = k;
        std::vector<NeighbourGraph::Edge> edges;
        result.m_meet.assign(m_maps.size() * m_maps.size(), 0);
        for (const auto& [from, i, j, to] : result.m_edges) {
            if (index[from] == none || index[to] == none) continue;
            edges.push_back({index[from], i, j, index[to]});
            if (from == 0) result.m_meet[i * m_maps.size() + j] = 1;
        }
        result.m_found = m_found.size();
        result.m_steps = std::exchange(result.m_edges, std::move(edges));
        result.m_count = kept.size();
    }

    std::pair<Word, Word> words(std::size_t k, std::size_t i, std::size_t j) const {
        std::pair<Word, Word> result{{int(i)}, {int(j)}};
        for (; k != 0; k = m_ways[k].from) {
            result.first.insert(result.first.begin(), int(m_ways[k].i));
            result.second.insert(result.second.begin(), int(m_ways[k].j));
        }
        return result;
    }

    bool isSame(const Rounded<Dim>& a, const Rounded<Dim>& b) const {
        if (m_isExact) return a.map.linear == b.map.linear && a.map.translation == b.map.translation;
        return m_frame.isSame(a, b);
    }

    // Index of a map; `none` if the pieces are too far apart. Returns nullopt if there are too many maps.
    std::optional<std::size_t> place(const Rounded<Dim>& h) {
        const AffineMap<Dim> seen = h.map.rounded();
        const Vector<Dim> reach = (m_size + seen.linear.cwiseAbs() * m_size) / 2;
        const Vector<Dim> apart = (seen(m_centre) - m_centre).cwiseAbs();
        const double slack = tolerance * m_size.maxCoeff();
        if (((1 + tolerance) * reach - apart).minCoeff() < -slack) return none;
        m_isExact = m_isExact && hasShortNumbers(h.map);
        if (!m_isExact && !m_frame.isTelling(h, m_size)) return std::nullopt;
        for (std::size_t k = 0; k < m_found.size(); ++k)
            if (isSame(m_found[k], h)) return k;
        if (m_found.size() == ContactGraph::maxVertices) return std::nullopt;
        m_found.push_back(h);
        return m_found.size() - 1;
    }

    Frame<Dim> m_frame;
    std::vector<Rounded<Dim>> m_maps, m_inverses;
    Vector<Dim> m_centre, m_size;
    bool m_isExact = false;
    std::vector<Rounded<Dim>> m_found; // identity first
    std::vector<Way> m_ways;           // origin of each map
};

// Walks from h to h as above, whose maps are known with error bounds that hold for the stored coefficients
// and for all within their rounding. A map stands for others only if its bounds, which are made a little
// wider, hold theirs, so that every walk of theirs has one here: pieces from which none goes on for ever are
// disjoint.
template <int Dim> class DisjointSearch {
public:
    DisjointSearch(std::span<const AffineMap<Dim>> maps, const Matrix<Dim>& root, const BoundingBox<Dim>& box)
        : m_frame(root), m_centre((box.min + box.max) / 2), m_size(sizeOf<Dim>(box)) {
        for (const auto& map : maps) {
            m_maps.push_back(m_frame.stored(map));
            m_inverses.push_back(m_frame.inverse(map));
        }
    }

    // Marks pairs that do not meet according to the graph, i·N + j with i < j, where they are disjoint.
    std::vector<char> found(const NeighbourGraph& graph) {
        const std::size_t count = m_maps.size();
        std::vector<std::pair<std::size_t, std::size_t>> pairs, edges{{endless, endless}};
        std::vector<std::size_t> starts;
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = i + 1; j < count; ++j) {
                if (graph.meet(i, j)) continue;
                pairs.emplace_back(i, j);
                starts.push_back(place(m_frame.product(m_inverses[i], m_maps[j])));
            }
        std::size_t steps = 0;
        for (std::size_t k = 1; k < m_found.size(); ++k)
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t j = 0; j < count; ++j) {
                    if (++steps > maxEdges || m_found.size() > ContactGraph::maxVertices) return {};
                    const std::size_t to =
                        place(m_frame.product(m_inverses[i], m_frame.product(m_found[k], m_maps[j])));
                    if (to != none) edges.emplace_back(k, to);
                }
        ContactGraph walks(m_found.size());
        for (const auto& [from, to] : edges)
            walks.join(from, to);
        const auto kept = walks.prune();
        std::vector<char> result(count * count, 0);
        for (std::size_t k = 0; k < pairs.size(); ++k)
            if (starts[k] == none || !std::ranges::binary_search(kept, starts[k]))
                result[pairs[k].first * count + pairs[k].second] = 1;
        return result;
    }

private:
    static constexpr std::size_t none = ~std::size_t{0};
    static constexpr std::size_t endless = 0; // stands for maps that too little is known of

    std::size_t place(Rounded<Dim> h) {
        constexpr double wider = 1.125, much = 0x1p-4, slight = 1e-14;
        const AffineMap<Dim> seen = h.map.rounded();
        const double off =
            m_frame.off(h, m_centre.norm() + m_size.norm()) +
            slight * (seen.linear.norm() * m_centre.norm() + seen.translation.norm() + m_centre.norm());
        const Vector<Dim> reach = (m_size + seen.linear.cwiseAbs() * m_size) * ((1 + 1e-12) / 2);
        const Vector<Dim> apart = (seen(m_centre) - m_centre).cwiseAbs();
        if ((apart - reach).maxCoeff() > off) return none;
        if (!(off <= much * m_size.maxCoeff())) return endless;
        for (std::size_t k = 1; k < m_found.size(); ++k)
            if (m_frame.isWithin(h, m_found[k])) return k;
        h.linear *= wider;
        h.shift *= wider;
        m_found.push_back(h);
        return m_found.size() - 1;
    }

    Frame<Dim> m_frame;
    std::vector<Rounded<Dim>> m_maps, m_inverses;
    Vector<Dim> m_centre, m_size;
    std::vector<Rounded<Dim>> m_found{1};
};

ContactGraph NeighbourGraph::contacts() const {
    ContactGraph result(m_count - 1);
    for (const auto& [from, i, j, to] : m_edges)
        if (from != 0 && to != 0) result.join(from - 1, to - 1);
    return result;
}

// The type of a piece is the set of the maps to its neighbours of the same size, each taken once however many
// words it has. A piece of the next size that m pairs of a neighbour and a letter lead to counts 1/m with
// each.
std::optional<ContactGraph::Radius> NeighbourGraph::growth() const {
    constexpr std::size_t maxTypes = 20'000, maxTypeWork = 8'000'000;
    if (!m_overlap) return ContactGraph::Radius{double(m_maps), double(m_maps)};
    std::vector<std::vector<std::vector<std::size_t>>> next(m_count,
                                                            std::vector<std::vector<std::size_t>>(m_maps));
    for (const auto& [from, i, j, to] : m_edges)
        next[from][i].push_back(to);
    using Type = std::vector<std::size_t>;
    std::map<Type, std::size_t> number{{{0}, 0}};
    std::vector<Type> types{{0}};
    struct Step {
        std::size_t from, to;
        double weight;
    };
    std::vector<Step> steps;
    std::size_t work = 0;
    for (std::size_t k = 0; k < types.size(); ++k)
        for (std::size_t i = 0; i < m_maps; ++i) {
            Type child;
            for (const std::size_t h : types[k])
                child.insert(child.end(), next[h][i].begin(), next[h][i].end());
            std::ranges::sort(child);
            const auto same = std::ranges::count(child, std::size_t(0));
            child.erase(std::unique(child.begin(), child.end()), child.end());
            work += child.size() + types[k].size();
            const auto [at, isNew] = number.try_emplace(child, types.size());
            if (isNew) types.push_back(child);
            if (types.size() > maxTypes || work > maxTypeWork) return std::nullopt;
            steps.push_back({k, at->second, 1 / double(same)});
        }
    ContactGraph graph(types.size());
    for (const auto& [from, to, weight] : steps)
        graph.join(from, to, weight);
    return graph.spectralRadius();
}

template <int Dim>
std::optional<NeighbourGraph> neighbourGraph(std::span<const AffineMap<Dim>> maps,
                                             const BoundingBox<Dim>& box) {
    if (maps.size() < 2 || maps.size() > maxNeighbourMaps) return std::nullopt;
    if (!box.min.allFinite() || !box.max.allFinite() || !std::isfinite(box.error)) return std::nullopt;
    if (!(sizeOf<Dim>(box).maxCoeff() > 0)) return std::nullopt;
    double ratio = 0;
    if (!std::ranges::all_of(maps, isFinite<Dim>) || !rootOfOneRatio<Dim>(maps, ratio)) return std::nullopt;
    std::vector<int> axes;
    const auto upright = spanning<Dim>(maps, box, axes);
    if (!upright) return std::nullopt;
    const auto root = rootOfOneRatio<Dim>(*upright, ratio);
    if (!root) return std::nullopt;
    auto graph = NeighbourSearch<Dim>(*upright, *root, box).graph(ratio, std::move(axes));
    if (graph && graph->certainty() == Certainty::ToRounding)
        graph->m_apart = DisjointSearch<Dim>(*upright, *root, box).found(*graph);
    return graph;
}

template std::optional<NeighbourGraph> neighbourGraph<2>(std::span<const AffineMap<2>>,
                                                         const BoundingBox<2>&);
template std::optional<NeighbourGraph> neighbourGraph<3>(std::span<const AffineMap<3>>,
                                                         const BoundingBox<3>&);

} // namespace ifs
