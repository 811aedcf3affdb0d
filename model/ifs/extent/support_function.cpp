// SPDX-License-Identifier: MIT
#include "ifs/extent/support_function.h"

#include "ifs/existence/attractor_existence.h"
#include "ifs/existence/conditioning.h"
#include "ifs/extent/outline.h"
#include "ifs/extent/sandwich.h"
#include "ifs/extent/support_builder.h"
#include "ifs/extent/support_container.h"
#include "ifs/extent/support_search.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <mutex>

namespace ifs {

namespace {

// The Frobenius norm, also where squares underflow. (Eigen 3.4 asserts in stableNorm() of a matrix.)
template <class Figure> double lengthOf(const Figure& figure) {
    constexpr double tiny = 0x1p-400;
    const double length = figure.norm();
    return length > tiny ? length : figure.reshaped().stableNorm();
}

} // namespace

template <int Dim> struct SupportFunction<Dim>::LazyOutline {
    std::once_flag isMade;
    std::optional<Outline> outline;
};

template <int Dim> struct SupportFunction<Dim>::LazyContainer {
    ContractingNorm<Dim> norm;
    std::once_flag isMade;
    std::shared_ptr<const SupportContainer<Dim>> container;
};

template <int Dim>
std::optional<SupportFunction<Dim>> SupportFunction<Dim>::of(std::span<const AffineMap<Dim>> maps) {
    const Existence existence = classify(maps);
    if (!existence.hasFactor()) return std::nullopt;
    if (const auto better = conditioned(maps))
        if (auto result = through(*better, maps)) return result;
    return of(maps, existence);
}

// The support function of the maps in better coordinates, if rounding leaves enough of these.
template <int Dim>
std::optional<SupportFunction<Dim>> SupportFunction<Dim>::through(const Conditioned<Dim>& better,
                                                                  std::span<const AffineMap<Dim>> maps) {
    const Existence existence = classify<Dim>(better.maps);
    if (!existence.hasFactor()) return std::nullopt;
    const auto support = of(better.maps, existence);
    if (!support) return std::nullopt;
    // Radius of points considered: the exact maps take every point within `error` of the attractor of the
    // rounded maps to another such point.
    const double reach = support->centre().norm() + support->radius();
    const double growth = support->normEquivalence() / (1 - support->contractivity());
    const double error = 2 * growth * better.rounding(reach);
    if (!(growth * better.rounding(reach + error) <= error)) return std::nullopt;

    SupportFunction result;
    result.m_conditioning = std::make_shared<const Conditioning>(Conditioning{*support, better.image, error});
    result.m_container = support->m_container;
    result.m_maps.assign(maps.begin(), maps.end());
    result.m_contractivity = support->contractivity();
    result.m_normEquivalence = support->normEquivalence() * better.condition * (1 + 1e-12);
    const Matrix<Dim>& image = better.image.linear;
    Vector<Dim> low, high;
    for (int k = 0; k < Dim; ++k) {
        const Vector<Dim> v = image.row(k).transpose();
        low[k] = -support->m_container->bound(-v);
        high[k] = support->m_container->bound(v);
    }
    result.m_centre = result.m_conditioning->image(support->centre()) + (low + high) / 2;
    result.m_radius = (1 + 1e-12) * lengthOf(high - low) / 2 + error * lengthOf(image) +
                      16 * roundingUnit * (lengthOf(result.m_centre) + lengthOf(image) * reach);
    return result;
}

template <int Dim>
std::optional<SupportFunction<Dim>> SupportFunction<Dim>::of(std::span<const AffineMap<Dim>> maps,
                                                             const Existence& existence) {
    const ContractingNorm<Dim> norm = contractingNorm(maps, existence);
    auto container = supportContainer(maps, norm);
    if (!container) return std::nullopt;

    SupportFunction result;
    result.m_maps.assign(maps.begin(), maps.end());
    result.m_centre = container->centre;
    result.m_radius = container->radius;
    result.m_contractivity = norm.contractivity;
    result.m_normEquivalence = norm.equivalence;
    result.m_container = std::move(container);
    result.m_outline = std::make_shared<LazyOutline>();
    result.m_finer = std::make_shared<LazyContainer>();
    result.m_finer->norm = norm;
    return result;
}

// Finer and finer: each outline makes the next one cheap. Where the hull is round the lines run out before
// the tolerance is reached, and finer ones would cost as much as no outline at all.
template <int Dim> const Outline* SupportFunction<Dim>::outline(const std::stop_token& stop) const {
    if constexpr (Dim != 2) {
        return nullptr;
    } else {
        if (m_conditioning) return m_conditioning->support.outline(stop);
        std::call_once(m_outline->isMade, [this, &stop] {
            constexpr int maxLines = 64;
            auto& known = m_outline->outline;
            for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-6, 1e-8}) {
                const Sandwich finer(std::cref(*this), m_centre, tolerance * m_radius,
                                     known ? &*known : nullptr, maxLines, stop);
                known = finer.outline();
                if (!(finer.error() <= tolerance * m_radius) || stop.stop_requested()) break;
            }
        });
        return &*m_outline->outline;
    }
}

template <int Dim> Vector<Dim> SupportFunction<Dim>::pointOfAttractor() const {
    if (m_conditioning) return m_conditioning->image(m_conditioning->support.pointOfAttractor());
    return m_centre + m_container->anchor;
}

template <int Dim> const std::vector<std::size_t>& SupportFunction<Dim>::mapsToTheHull() const {
    return m_container->indices;
}

template <int Dim> double SupportFunction<Dim>::roundingError(int depth) const {
    const double size = m_centre.norm() + m_radius;
    return std::max(1e-12 * m_radius, roundingUnit * size * m_container->longest *
                                          (8 * depth + 4 * m_normEquivalence / (1 - m_contractivity)));
}

template <int Dim>
SupportValue<Dim> SupportFunction<Dim>::operator()(const Vector<Dim>& u, double tolerance, int maxNodes,
                                                   const Outline* known) const {
    if (m_conditioning && u.allFinite()) return m_conditioning->ask(u, tolerance, maxNodes, known);
    SupportValue<Dim> result;
    result.point = pointOfAttractor();
    const double size = u.cwiseAbs().maxCoeff();
    if (!u.allFinite() || size == 0) {
        result.error = size == 0 ? 0 : std::numeric_limits<double>::infinity();
        return result;
    }
    // Power of two, so that scaling is exact.
    int exponent = 0;
    std::frexp(size, &exponent);
    Vector<Dim> scaled;
    for (int k = 0; k < Dim; ++k)
        scaled[k] = std::ldexp(u[k], -exponent);
    const double smallest = 8 * roundingUnit * m_radius * scaled.norm();
    const double wanted = std::max(std::ldexp(tolerance, -exponent), smallest);
    // Merging for codes with rounded digits, which have thousands of near ties. If merging at a quarter of
    // the tolerance does not settle them within half of the nodes, it becomes coarser, and the error states
    // the price.
    const double fineness = 16 * m_radius * scaled.norm() / (wanted * m_container->mergeLimit);
    const int withinTolerance = fineness < 0x1p43 ? std::max(14, std::ilogb(fineness) + 1) : exactMerging;
    double minError = std::numeric_limits<double>::infinity();
    const auto search = [&](const SupportContainer<Dim>& container, const Outline* outline, int mergeBits,
                            int nodes) {
        auto found = searchAddresses(container, outline, scaled, wanted, mergeBits, nodes);
        const Vector<Dim> point = follow(found.address, found.start);
        const double value = scaled.dot(point);
        const double gap = std::max(0.0, found.upperBound + scaled.dot(m_centre) - value);
        const double error = gap + roundingError(found.depth) * scaled.norm();
        if (error < minError) {
            minError = error;
            if (found.direction) container.lengthen(found.address, *found.direction);
            result = {std::ldexp(value, exponent), std::ldexp(error, exponent), point,
                      std::move(found.address)};
        }
        return found.isFinished;
    };
    for (const auto& [mergeBits, share] : {std::pair{withinTolerance, 2}, {26, 4}, {14, 4}})
        if (mergeBits <= withinTolerance && search(*m_container, known, mergeBits, maxNodes / share))
            return result;
    constexpr double goodEnough = 1e-7; // relative to the size
    if (minError > std::max(wanted, goodEnough * m_radius * scaled.norm()))
        if (const auto* finer = finerContainer())
            for (const int mergeBits : {withinTolerance, 26})
                if (mergeBits <= withinTolerance && search(*finer, nullptr, mergeBits, maxNodes)) break;
    return result;
}

template <int Dim> const SupportContainer<Dim>* SupportFunction<Dim>::finerContainer() const {
    std::call_once(m_finer->isMade, [this] {
        m_finer->container = ifs::finerContainer<Dim>(m_maps, m_finer->norm, *m_container);
    });
    return m_finer->container.get();
}

// h_A(u) = ⟨u,t⟩ + h(Mᵀu) where the image is y ↦ M y + t.
template <int Dim>
SupportValue<Dim> SupportFunction<Dim>::Conditioning::ask(const Vector<Dim>& u, double tolerance,
                                                          int maxNodes, const Outline* known) const {
    const Vector<Dim> v = image.linear.transpose() * u;
    SupportValue<Dim> result = support(v, tolerance, maxNodes, known);
    const double bound = u.dot(image.translation) + result.value + result.error;
    result.point = image(result.point);
    result.value = u.dot(result.point);
    result.error = std::max(0.0, bound - result.value) + lengthOf(v) * error + u.norm() * rounding();
    return result;
}

template <int Dim> double SupportFunction<Dim>::Conditioning::errorOf(double distance) const {
    return spectralNorm<Dim>(image.linear) * (1 + 1e-12) * (distance + error) + rounding();
}

template <int Dim> double SupportFunction<Dim>::Conditioning::rounding() const {
    const double reach = support.centre().norm() + support.radius();
    const double size = lengthOf(image.translation) + lengthOf(image.linear) * reach;
    // The last term covers rounding of the smallest numbers.
    return 8 * Dim * (roundingUnit * size + (size > 0 ? std::numeric_limits<double>::denorm_min() : 0));
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
