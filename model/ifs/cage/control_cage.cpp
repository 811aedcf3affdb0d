// SPDX-License-Identifier: MIT
#include "ifs/cage/control_cage.h"

#include "ifs/cage/cage_surface.h"
#include "ifs/extent/polygon.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace ifs {

namespace {

constexpr double flatnessLimit = 1e-9;
constexpr double invertibleRatio = 1e-6;
constexpr double affineTolerance = 1e-10; // relative to the size; nearer vertices count as an affine image
constexpr double outsideTolerance = 1e-9; // relative to the size; allows for rounding in a tight cage

template <int Dim> bool allFinite(const std::vector<Vector<Dim>>& points) {
    return std::ranges::all_of(points, [](const Vector<Dim>& p) { return p.allFinite(); });
}

template <int Dim> Simplex<Dim> simplexOf(const std::vector<Vector<Dim>>& vertices) {
    Simplex<Dim> simplex;
    std::copy_n(vertices.begin(), Dim + 1, simplex.begin());
    return simplex;
}

// A corner that points inwards; one that lies on its edge does not.
bool hasNotch(std::span<const Vector<2>> polygon) {
    constexpr double minTurn = 1e-9;
    const double sign = signedArea(polygon) > 0 ? 1 : -1;
    const std::size_t n = polygon.size();
    for (std::size_t j = 0; j < n; ++j) {
        const Vector<2> in = polygon[(j + 1) % n] - polygon[j],
                        out = polygon[(j + 2) % n] - polygon[(j + 1) % n];
        if (sign * cross(in, out) < -minTurn * in.norm() * out.norm()) return true;
    }
    return false;
}

template <int Dim> bool isSimplicial(const ControlCage<Dim>& cage) {
    return cage.rest.size() == Dim + 1 && cage.current.size() == Dim + 1;
}

// Returns true if the points fill all dimensions, none of them twice.
template <int Dim> bool holdsCoordinates(const std::vector<Vector<Dim>>& points) {
    if (points.size() == Dim + 1) return isAffineBasis<Dim>(simplexOf<Dim>(points));
    if constexpr (Dim == 2)
        if (points.size() > maxCorners || !isSimplePolygon(points)) return false;
    if constexpr (Dim == 3) return convexSurface(points).has_value();
    for (std::size_t j = 0; j < points.size(); ++j)
        if (std::find(points.begin() + std::ptrdiff_t(j) + 1, points.end(), points[j]) != points.end())
            return false;
    double extent = 0;
    for (const auto& p : points)
        extent = std::max(extent, (p - points[0]).stableNorm());
    Matrix<Dim> scatter = Matrix<Dim>::Zero();
    for (const auto& p : points) {
        const Vector<Dim> offset = (p - points[0]) / extent;
        scatter += offset * offset.transpose();
    }
    const Vector<Dim> spread = singularValues<Dim>(scatter);
    return spread[Dim - 1] >= flatnessLimit * flatnessLimit * spread[0] && std::isfinite(spread[0]);
}

// Even-odd rule.
bool isInside(const std::vector<Vector<2>>& polygon, const Vector<2>& x) {
    bool inside = false;
    for (std::size_t j = 0; j < polygon.size(); ++j) {
        const Vector<2>& a = polygon[j];
        const Vector<2>& b = polygon[(j + 1) % polygon.size()];
        if ((a.y() <= x.y()) != (b.y() <= x.y()) &&
            x.x() < a.x() + (x.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            inside = !inside;
    }
    return inside;
}

template <int Dim> bool isUndoable(const Matrix<Dim>& linear) {
    const Vector<Dim> stretch = singularValues<Dim>(linear);
    return stretch[Dim - 1] > invertibleRatio * stretch[0];
}

} // namespace

template <int Dim> ControlCage<Dim> polygonAtRest(std::vector<Vector<Dim>> vertices) {
    return {vertices, vertices, Deformation::Bend};
}

template <int Dim> ControlCage<Dim> cageAtRest(const Simplex<Dim>& simplex) {
    return polygonAtRest<Dim>(std::vector<Vector<Dim>>(simplex.begin(), simplex.end()));
}

template <int Dim> bool isValid(const ControlCage<Dim>& cage) {
    return cage.rest.size() >= Dim + 1 && cage.rest.size() == cage.current.size() &&
           allFinite<Dim>(cage.rest) && allFinite<Dim>(cage.current) && holdsCoordinates<Dim>(cage.rest);
}

template <int Dim> AffineMap<Dim> displayMap(const ControlCage<Dim>& cage) {
    if (cage.current == cage.rest) return {};
    return isSimplicial(cage) ? simplexMap<Dim>(simplexOf<Dim>(cage.rest), simplexOf<Dim>(cage.current))
                              : affineFit<Dim>(cage.rest, cage.current);
}

template <int Dim> bool bends(const ControlCage<Dim>& cage) {
    if (isSimplicial(cage) || cage.deformation != Deformation::Bend || cage.current == cage.rest)
        return false;
    const AffineMap<Dim> fit = displayMap(cage);
    double miss = 0;
    double size = 0;
    for (std::size_t j = 0; j < cage.rest.size(); ++j) {
        miss = std::max(miss, (cage.current[j] - fit(cage.rest[j])).cwiseAbs().maxCoeff());
        size = std::max({size, cage.current[j].cwiseAbs().maxCoeff(), cage.rest[j].cwiseAbs().maxCoeff()});
    }
    return miss > affineTolerance * size;
}

template <int Dim> bool isInvertible(const ControlCage<Dim>& cage) {
    return !bends(cage) && isUndoable<Dim>(displayMap(cage).linear);
}

template <int Dim>
std::optional<Baked<Dim>> bake(const IteratedFunctionSystem<Dim>& system, const ControlCage<Dim>& cage) {
    const bool atRest = cage.current == cage.rest;
    if (atRest) return Baked<Dim>{system, cage};
    if (!isValid(cage) || !isInvertible(cage)) return std::nullopt;
    const AffineMap<Dim> display = displayMap(cage);
    auto baked = conjugate(display, system);
    if (!baked) return std::nullopt;
    ControlCage<Dim> after = cage;
    after.rest = cage.current;
    if (!isSimplicial(cage)) std::ranges::transform(cage.rest, after.rest.begin(), display);
    after.current = after.rest;
    return Baked<Dim>{std::move(*baked), std::move(after)};
}

template <int Dim>
std::optional<ControlCage<Dim>> redefine(const ControlCage<Dim>& present,
                                         std::type_identity_t<std::span<const Vector<Dim>>> vertices) {
    ControlCage<Dim> result = polygonAtRest<Dim>(std::vector<Vector<Dim>>(vertices.begin(), vertices.end()));
    result.deformation = present.deformation;
    if (!isValid(result)) return std::nullopt;
    if (present.current == present.rest) return result;
    if (!isValid(present) || !isInvertible(present)) return std::nullopt;
    const auto back = inverse(displayMap(present));
    if (!back) return std::nullopt;
    for (auto& vertex : result.rest)
        vertex = (*back)(vertex);
    return isValid(result) ? std::optional(result) : std::nullopt;
}

Coordinates suitableCoordinates(std::span<const Vector<2>> rest, const SupportFunction<2>* support,
                                std::span<const AffineMap<2>> pieces) {
    const AffineMap<2> identity;
    if (pieces.empty()) pieces = {&identity, 1};
    if (rest.size() == 3) return Coordinates::Wachspress; // arbitrary: both kinds agree
    if (support == nullptr || !isStrictlyConvex(rest)) return Coordinates::MeanValue;
    const double size = support->radius() + (rest[0] - support->centre()).norm();
    const double sign = signedArea(rest) > 0 ? 1 : -1;
    for (std::size_t j = 0; j < rest.size(); ++j) {
        const Vector<2> edge = rest[(j + 1) % rest.size()] - rest[j];
        const Vector<2> outward = sign * Vector<2>(edge.y(), -edge.x()) / edge.norm();
        for (const AffineMap<2>& piece : pieces) {
            const SupportValue<2> h =
                (*support)(piece.linear.transpose() * outward, outsideTolerance * size, 20'000);
            const double reach = h.value + h.error + outward.dot(piece.translation);
            if (!(reach <= outward.dot(rest[j]) + 2 * outsideTolerance * size)) return Coordinates::MeanValue;
        }
    }
    return Coordinates::Wachspress;
}

Placement::Placement(const ControlCage<2>& cage, Coordinates coordinates) : m_affine(displayMap(cage)) {
    if (bends(cage))
        m_bend = std::make_shared<const PolygonDeformation>(coordinates, cage.rest, cage.current);
}

CageFlaw flawOf(const ControlCage<2>& cage, const Placement& placement) {
    const PolygonDeformation* bend = placement.bend();
    if (bend == nullptr) return CageFlaw::None;
    if (!isSimplePolygon(cage.current)) return CageFlaw::Folded;
    // Orientation over a grid of points of the inside.
    constexpr int steps = 24;
    Vector<2> low = cage.rest[0];
    Vector<2> high = cage.rest[0];
    for (const Vector<2>& vertex : cage.rest) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    bool kept = false;
    bool mirrored = false;
    for (int i = 0; i < steps * steps; ++i) {
        const int row = i / steps, column = i % steps;
        const Vector<2> share((column + 0.5) / steps, (row + 0.5) / steps);
        const Vector<2> x = low + share.cwiseProduct(high - low);
        if (!isInside(cage.rest, x)) continue;
        const auto expansion = bend->expansion(x);
        if (!expansion) continue;
        const double turn = determinant<2>(expansion->linear);
        kept = kept || turn > 0;
        mirrored = mirrored || turn < 0;
    }
    if (kept && mirrored) return CageFlaw::Folded;
    return hasNotch(cage.rest) || hasNotch(cage.current) ? CageFlaw::Concave : CageFlaw::None;
}

std::optional<ControlCage<2>> withVertexInserted(const ControlCage<2>& cage, std::size_t edge, double share) {
    ControlCage<2> result = cage;
    for (auto* vertices : {&result.rest, &result.current}) {
        const Vector<2> from = (*vertices)[edge];
        const Vector<2> to = (*vertices)[(edge + 1) % vertices->size()];
        vertices->insert(vertices->begin() + std::ptrdiff_t(edge) + 1, from + share * (to - from));
    }
    return isValid(result) ? std::optional(result) : std::nullopt;
}

std::optional<ControlCage<2>> withVertexRemoved(const ControlCage<2>& cage, std::size_t vertex) {
    ControlCage<2> result = cage;
    for (auto* vertices : {&result.rest, &result.current})
        vertices->erase(vertices->begin() + std::ptrdiff_t(vertex));
    return isValid(result) ? std::optional(result) : std::nullopt;
}

// The corners are c + r·ζ^j with ζ = e^(±2πi/n); least squares gives r = mean of (v_j − c)·ζ^−j.
std::optional<std::vector<Vector<2>>> regularPolygonNear(std::span<const Vector<2>> vertices) {
    const auto n = static_cast<double>(vertices.size());
    std::complex<double> centre;
    for (const Vector<2>& v : vertices)
        centre += std::complex(v.x(), v.y()) / n;
    const double turn = (signedArea(vertices) < 0 ? -2 : 2) * std::numbers::pi / n;
    std::complex<double> radius;
    for (std::size_t j = 0; j < vertices.size(); ++j)
        radius += (std::complex(vertices[j].x(), vertices[j].y()) - centre) *
                  std::polar(1.0, -turn * static_cast<double>(j)) / n;
    if (!(std::abs(radius) > flatnessLimit * std::abs(centre)) || !std::isfinite(std::abs(radius)))
        return std::nullopt;
    std::vector<Vector<2>> result;
    for (std::size_t j = 0; j < vertices.size(); ++j) {
        const std::complex<double> corner = centre + radius * std::polar(1.0, turn * static_cast<double>(j));
        result.emplace_back(corner.real(), corner.imag());
    }
    return result;
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template ControlCage<Dim> polygonAtRest<Dim>(std::vector<Vector<Dim>>);                                  \
    template ControlCage<Dim> cageAtRest<Dim>(const Simplex<Dim>&);                                          \
    template bool isValid(const ControlCage<Dim>&);                                                          \
    template AffineMap<Dim> displayMap(const ControlCage<Dim>&);                                             \
    template bool bends(const ControlCage<Dim>&);                                                            \
    template bool isInvertible(const ControlCage<Dim>&);                                                     \
    template std::optional<Baked<Dim>> bake(const IteratedFunctionSystem<Dim>&, const ControlCage<Dim>&);    \
    template std::optional<ControlCage<Dim>> redefine<Dim>(const ControlCage<Dim>&,                          \
                                                           std::span<const Vector<Dim>>);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace ifs
