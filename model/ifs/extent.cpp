// SPDX-License-Identifier: MIT
#include "ifs/support_function.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ifs {

namespace {

constexpr int NodesPerFace = 3'000; // keeps a box and a canonical simplex within one frame

template <int Dim> using AxisSupports = std::array<SupportValue<Dim>, 2 * Dim>;

// h_A(e_k), h_A(−e_k) for every axis.
template <int Dim> AxisSupports<Dim> axisSupports(const SupportFunction<Dim>& support, double tolerance) {
    AxisSupports<Dim> result;
    for (int k = 0; k < Dim; ++k) {
        const Vector<Dim> axis = Vector<Dim>::Unit(k);
        result[std::size_t(2 * k)] = support(axis, tolerance, NodesPerFace);
        result[std::size_t(2 * k + 1)] = support(-axis, tolerance, NodesPerFace);
    }
    return result;
}

template <int Dim> Vector<Dim> signs(const Orientation<Dim>& orientation) {
    Vector<Dim> result;
    for (int k = 0; k < Dim; ++k)
        result[k] = orientation[std::size_t(k)];
    return result;
}

template <int Dim>
CanonicalSimplex<Dim> simplexFrom(const AxisSupports<Dim>& axes, const SupportFunction<Dim>& support,
                                  const Orientation<Dim>& orientation, double tolerance) {
    const Vector<Dim> omega = signs<Dim>(orientation);
    const SupportValue<Dim> oblique = support(omega, tolerance, NodesPerFace);
    CanonicalSimplex<Dim> result;
    result.orientation = orientation;
    result.leg = oblique.value;
    double axisError = 0;
    double reach = std::abs(oblique.value);
    for (int k = 0; k < Dim; ++k) {
        const auto& face = axes[std::size_t(2 * k + (omega[k] > 0 ? 1 : 0))]; // h_A(−ω_k e_k) = −α_k
        result.vertices[0][k] = -omega[k] * face.value + 0.0;
        result.leg += face.value;
        axisError = std::max(axisError, face.error);
        reach = std::max(reach, std::abs(face.value));
    }
    // The outer simplex: the corner moves by at most √Dim·axisError, the leg grows by Dim·axisError +
    // oblique.error.
    result.error = (std::sqrt(Dim) + Dim) * axisError + oblique.error;
    // The leg is attained, so only rounding can make one of a single point, however wide the certificate is.
    if (!(result.leg > 64 * std::numeric_limits<double>::epsilon() * reach)) result.leg = 1;
    for (int k = 0; k < Dim; ++k)
        result.vertices[std::size_t(k + 1)] =
            result.vertices[0] + omega[k] * result.leg * Vector<Dim>::Unit(k);
    return result;
}

} // namespace

template <int Dim> BoundingBox<Dim> boundingBox(const SupportFunction<Dim>& support, double tolerance) {
    const auto axes = axisSupports<Dim>(support, tolerance);
    BoundingBox<Dim> box;
    for (int k = 0; k < Dim; ++k) {
        const auto& high = axes[std::size_t(2 * k)];
        const auto& low = axes[std::size_t(2 * k + 1)];
        box.max[k] = high.value;
        box.min[k] = 0.0 - low.value;
        box.error = std::max({box.error, high.error, low.error});
    }
    box.error *= std::sqrt(Dim);
    return box;
}

template <int Dim>
CanonicalSimplex<Dim> canonicalSimplex(const SupportFunction<Dim>& support,
                                       const std::type_identity_t<Orientation<Dim>>& orientation,
                                       double tolerance) {
    return simplexFrom<Dim>(axisSupports<Dim>(support, tolerance), support, orientation, tolerance);
}

template <int Dim>
CanonicalSimplex<Dim> minimalCanonicalSimplex(const SupportFunction<Dim>& support, double tolerance) {
    const auto axes = axisSupports<Dim>(support, tolerance);
    std::vector<CanonicalSimplex<Dim>> candidates;
    for (unsigned flips = 0; flips < (1u << Dim); ++flips) {
        Orientation<Dim> orientation;
        for (unsigned k = 0; k < Dim; ++k)
            orientation[k] = flips >> k & 1 ? -1 : 1;
        candidates.push_back(simplexFrom<Dim>(axes, support, orientation, tolerance));
    }
    const double smallest = std::ranges::min(candidates, {}, &CanonicalSimplex<Dim>::leg).leg;
    return *std::ranges::find_if(candidates, [=](const auto& c) { return c.leg <= smallest * (1 + 1e-12); });
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template BoundingBox<Dim> boundingBox<Dim>(const SupportFunction<Dim>&, double);                         \
    template CanonicalSimplex<Dim> canonicalSimplex<Dim>(const SupportFunction<Dim>&,                        \
                                                         const Orientation<Dim>&, double);                   \
    template CanonicalSimplex<Dim> minimalCanonicalSimplex<Dim>(const SupportFunction<Dim>&, double);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace ifs
