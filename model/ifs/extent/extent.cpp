// SPDX-License-Identifier: MIT
#include "ifs/extent/extent.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ifs {

namespace {

constexpr int nodesPerFace = 20'000; // nodes for a face; most systems need few

template <int Dim> using Supports = std::vector<SupportValue<Dim>>;

// h_T(A)(u) = h_A(Tᵀu) + ⟨u,t⟩.
template <int Dim>
SupportValue<Dim> supportOfImage(const AffineMap<Dim>& image, const Vector<Dim>& direction,
                                 const SupportFunction<Dim>& support, double tolerance) {
    SupportValue<Dim> h =
        support(image.linear.transpose() * direction, tolerance, nodesPerFace, support.outline());
    h.value += direction.dot(image.translation);
    h.error += 4 * std::numeric_limits<double>::epsilon() * image.translation.norm();
    h.point = image(h.point);
    return h;
}

// The largest height of a union. What the ball of the attractor keeps below it is not looked at.
template <int Dim>
SupportValue<Dim> supportOfImages(std::span<const AffineMap<Dim>> images, const Vector<Dim>& direction,
                                  const SupportFunction<Dim>& support, double tolerance) {
    SupportValue<Dim> result = supportOfImage(images.front(), direction, support, tolerance);
    for (const AffineMap<Dim>& image : images.subspan(1)) {
        const Vector<Dim> within = image.linear.transpose() * direction;
        const double reach = direction.dot(image(support.centre())) + within.norm() * support.radius();
        if (reach < result.value) continue;
        const SupportValue<Dim> h = supportOfImage(image, direction, support, tolerance);
        const double bound = std::max(result.value + result.error, h.value + h.error);
        if (h.value > result.value) result = h;
        result.error = bound - result.value;
    }
    return result;
}

template <int Dim>
Supports<Dim> supportsIn(const std::vector<Vector<Dim>>& directions, const SupportFunction<Dim>& support,
                         double tolerance, std::span<const AffineMap<Dim>> images) {
    Supports<Dim> result;
    for (const auto& direction : directions)
        result.push_back(supportOfImages(images, direction, support, tolerance));
    return result;
}

// e_1, −e_1, e_2, −e_2, …
template <int Dim> std::vector<Vector<Dim>> axes() {
    std::vector<Vector<Dim>> result;
    for (int k = 0; k < Dim; ++k)
        for (const double sign : {1.0, -1.0})
            result.push_back(sign * Vector<Dim>::Unit(k));
    return result;
}

template <int Dim> Vector<Dim> signs(const Orientation<Dim>& orientation) {
    Vector<Dim> result;
    for (int k = 0; k < Dim; ++k)
        result[k] = orientation[std::size_t(k)];
    return result;
}

template <int Dim>
CanonicalSimplex<Dim> simplexFrom(const Supports<Dim>& axes, const SupportValue<Dim>& oblique,
                                  const Orientation<Dim>& orientation) {
    const Vector<Dim> omega = signs<Dim>(orientation);
    CanonicalSimplex<Dim> result;
    result.orientation = orientation;
    result.leg = oblique.value;
    double axisError = 0;
    double reach = std::abs(oblique.value);
    for (int k = 0; k < Dim; ++k) {
        const auto& face = axes[2 * std::size_t(k) + (omega[k] > 0 ? 1 : 0)]; // h_A(−ω_k e_k) = −α_k
        result.vertices[0][k] = -omega[k] * face.value + 0.0;
        result.leg += face.value;
        axisError = std::max(axisError, face.error);
        reach = std::max(reach, std::abs(face.value));
    }
    // The outer simplex: the corner moves by at most √Dim·axisError, the leg grows by Dim·axisError +
    // oblique.error.
    result.error = (std::sqrt(Dim) + Dim) * axisError + oblique.error;
    // Limit of rounding: the leg is attained, so that only rounding can give one to a single point, however
    // wide the certificate is.
    if (!(result.leg > 64 * std::numeric_limits<double>::epsilon() * reach)) result.leg = 1;
    for (int k = 0; k < Dim; ++k)
        result.vertices[std::size_t(k) + 1] =
            result.vertices[0] + omega[k] * result.leg * Vector<Dim>::Unit(k);
    return result;
}

// Orientations in the order of ties: x flips fastest.
template <int Dim> std::vector<Orientation<Dim>> allOrientations() {
    std::vector<Orientation<Dim>> result(std::size_t(1) << Dim);
    for (std::size_t flips = 0; flips < result.size(); ++flips)
        for (std::size_t k = 0; k < Dim; ++k)
            result[flips][k] = flips >> k & 1 ? -1 : 1;
    return result;
}

} // namespace

template <int Dim>
BoundingBox<Dim> boundingBoxOfImages(std::span<const AffineMap<Dim>> images,
                                     const SupportFunction<Dim>& support, double tolerance) {
    const auto faces = supportsIn<Dim>(axes<Dim>(), support, tolerance, images);
    BoundingBox<Dim> box;
    for (int k = 0; k < Dim; ++k) {
        const auto& high = faces[2 * std::size_t(k)];
        const auto& low = faces[2 * std::size_t(k) + 1];
        box.max[k] = high.value;
        box.min[k] = 0.0 - low.value;
        box.error = std::max({box.error, high.error, low.error});
    }
    box.error *= std::sqrt(Dim);
    return box;
}

template <int Dim>
BoundingBox<Dim> boundingBoxOfImage(const AffineMap<Dim>& transformation, const SupportFunction<Dim>& support,
                                    double tolerance) {
    return boundingBoxOfImages<Dim>({&transformation, 1}, support, tolerance);
}

template <int Dim> BoundingBox<Dim> boundingBox(const SupportFunction<Dim>& support, double tolerance) {
    return boundingBoxOfImage<Dim>({}, support, tolerance);
}

namespace {

template <int Dim>
std::vector<CanonicalSimplex<Dim>> simplicesOf(std::span<const AffineMap<Dim>> images,
                                               const SupportFunction<Dim>& support, double tolerance) {
    const auto orientations = allOrientations<Dim>();
    auto directions = axes<Dim>();
    for (const auto& orientation : orientations)
        directions.push_back(signs<Dim>(orientation));
    const auto faces = supportsIn<Dim>(directions, support, tolerance, images);
    std::vector<CanonicalSimplex<Dim>> result;
    for (std::size_t k = 0; k < orientations.size(); ++k)
        result.push_back(simplexFrom<Dim>(faces, faces[2 * Dim + k], orientations[k]));
    return result;
}

} // namespace

template <int Dim>
std::vector<CanonicalSimplex<Dim>> canonicalSimplices(const SupportFunction<Dim>& support, double tolerance) {
    const AffineMap<Dim> identity;
    return simplicesOf<Dim>({&identity, 1}, support, tolerance);
}

template <int Dim>
CanonicalSimplex<Dim> canonicalSimplex(const SupportFunction<Dim>& support,
                                       const std::type_identity_t<Orientation<Dim>>& orientation,
                                       double tolerance) {
    const auto all = canonicalSimplices(support, tolerance);
    return *std::ranges::find(all, orientation, &CanonicalSimplex<Dim>::orientation);
}

template <int Dim>
CanonicalSimplex<Dim> minimalCanonicalSimplexOfImages(std::span<const AffineMap<Dim>> images,
                                                      const SupportFunction<Dim>& support, double tolerance) {
    const auto all = simplicesOf(images, support, tolerance);
    const auto smallest = std::ranges::min(all, {}, &CanonicalSimplex<Dim>::leg);
    return *std::ranges::find_if(
        all, [&](const auto& c) { return c.leg <= smallest.leg * (1 + 1e-12) + c.error + smallest.error; });
}

template <int Dim>
CanonicalSimplex<Dim> minimalCanonicalSimplexOfImage(const AffineMap<Dim>& transformation,
                                                     const SupportFunction<Dim>& support, double tolerance) {
    return minimalCanonicalSimplexOfImages<Dim>({&transformation, 1}, support, tolerance);
}

template <int Dim>
CanonicalSimplex<Dim> minimalCanonicalSimplex(const SupportFunction<Dim>& support, double tolerance) {
    return minimalCanonicalSimplexOfImage<Dim>({}, support, tolerance);
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template BoundingBox<Dim> boundingBoxOfImages(std::span<const AffineMap<Dim>>,                           \
                                                  const SupportFunction<Dim>&, double);                      \
    template CanonicalSimplex<Dim> minimalCanonicalSimplexOfImages(std::span<const AffineMap<Dim>>,          \
                                                                   const SupportFunction<Dim>&, double);     \
    template BoundingBox<Dim> boundingBoxOfImage(const AffineMap<Dim>&, const SupportFunction<Dim>&,         \
                                                 double);                                                    \
    template CanonicalSimplex<Dim> minimalCanonicalSimplexOfImage(const AffineMap<Dim>&,                     \
                                                                  const SupportFunction<Dim>&, double);      \
    template BoundingBox<Dim> boundingBox<Dim>(const SupportFunction<Dim>&, double);                         \
    template std::vector<CanonicalSimplex<Dim>> canonicalSimplices<Dim>(const SupportFunction<Dim>&,         \
                                                                        double);                             \
    template CanonicalSimplex<Dim> canonicalSimplex<Dim>(const SupportFunction<Dim>&,                        \
                                                         const Orientation<Dim>&, double);                   \
    template CanonicalSimplex<Dim> minimalCanonicalSimplex<Dim>(const SupportFunction<Dim>&, double);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace ifs
