// SPDX-License-Identifier: MIT
#include "ifs/control_cage.h"

#include <algorithm>

namespace ifs {

namespace {

constexpr double FlatnessLimit = 1e-9;
constexpr double InvertibleRatio = 1e-6;

template <int Dim> bool allFinite(const std::vector<Vector<Dim>>& points) {
    return std::ranges::all_of(points, [](const Vector<Dim>& p) { return p.allFinite(); });
}

template <int Dim> Simplex<Dim> simplexOf(const std::vector<Vector<Dim>>& vertices) {
    Simplex<Dim> simplex;
    std::copy_n(vertices.begin(), Dim + 1, simplex.begin());
    return simplex;
}

template <int Dim> bool isSimplicial(const ControlCage<Dim>& cage) {
    return cage.rest.size() == Dim + 1 && cage.current.size() == Dim + 1;
}

// Whether the points fill all dimensions, none of them twice.
template <int Dim> bool holdsCoordinates(const std::vector<Vector<Dim>>& points) {
    if (points.size() == Dim + 1) return isAffineBasis<Dim>(simplexOf<Dim>(points));
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
    return spread[Dim - 1] >= FlatnessLimit * FlatnessLimit * spread[0] && std::isfinite(spread[0]);
}

template <int Dim> bool isUndoable(const Matrix<Dim>& linear) {
    const Vector<Dim> stretch = singularValues<Dim>(linear);
    return stretch[Dim - 1] > InvertibleRatio * stretch[0];
}

} // namespace

template <int Dim> ControlCage<Dim> cageAtRest(const Simplex<Dim>& simplex) {
    const std::vector<Vector<Dim>> vertices(simplex.begin(), simplex.end());
    return {vertices, vertices};
}

template <int Dim> bool isValid(const ControlCage<Dim>& cage) {
    return cage.rest.size() >= Dim + 1 && cage.rest.size() == cage.current.size() &&
           allFinite<Dim>(cage.rest) && allFinite<Dim>(cage.current) && holdsCoordinates<Dim>(cage.rest);
}

template <int Dim> AffineMap<Dim> displayMap(const ControlCage<Dim>& cage) {
    if (cage.current == cage.rest) return {};
    return simplexMap<Dim>(simplexOf<Dim>(cage.rest), simplexOf<Dim>(cage.current));
}

template <int Dim> bool isInvertible(const ControlCage<Dim>& cage) {
    return isUndoable<Dim>(displayMap(cage).linear);
}

template <int Dim>
std::optional<Baked<Dim>> bake(const IteratedFunctionSystem<Dim>& system, const ControlCage<Dim>& cage) {
    const bool atRest = cage.current == cage.rest;
    if (atRest) return Baked<Dim>{system, cage};
    if (!isValid(cage) || !isSimplicial(cage) || !isInvertible(cage)) return std::nullopt;
    auto baked = conjugate(displayMap(cage), system);
    if (!baked) return std::nullopt;
    return Baked<Dim>{std::move(*baked), {cage.current, cage.current}};
}

template <int Dim>
std::optional<ControlCage<Dim>> redefine(const ControlCage<Dim>& present, const Simplex<Dim>& clicks) {
    if (!isAffineBasis<Dim>(clicks)) return std::nullopt;
    ControlCage<Dim> result = cageAtRest<Dim>(clicks);
    if (present.current == present.rest) return result;
    if (!isValid(present) || !isSimplicial(present) || !isInvertible(present)) return std::nullopt;
    const auto back = inverse(displayMap(present));
    if (!back) return std::nullopt;
    for (auto& vertex : result.rest)
        vertex = (*back)(vertex);
    return isValid(result) ? std::optional(result) : std::nullopt;
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template ControlCage<Dim> cageAtRest<Dim>(const Simplex<Dim>&);                                          \
    template bool isValid(const ControlCage<Dim>&);                                                          \
    template AffineMap<Dim> displayMap(const ControlCage<Dim>&);                                             \
    template bool isInvertible(const ControlCage<Dim>&);                                                     \
    template std::optional<Baked<Dim>> bake(const IteratedFunctionSystem<Dim>&, const ControlCage<Dim>&);    \
    template std::optional<ControlCage<Dim>> redefine(const ControlCage<Dim>&, const Simplex<Dim>&);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace ifs
