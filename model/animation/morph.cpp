// SPDX-License-Identifier: MIT
#include "animation/morph.h"

#include "ifs/dimension/moments.h"
#include "ifs/system/map_interpolation.h"

#include <algorithm>

namespace animation {

namespace {

// ∫ |A x + b − (B x + d)|² dν for a measure ν with this mean and covariance; a map that would have to fold
// over pays the variance of ν on top.
template <int Dim>
double costOf(const ifs::AffineMap<Dim>& a, const ifs::AffineMap<Dim>& b, const ifs::Vector<Dim>& mean,
              const ifs::Matrix<Dim>& covariance) {
    const ifs::Matrix<Dim> difference = a.linear - b.linear;
    const double spread = (difference * covariance * difference.transpose()).trace();
    const double shift = (difference * mean + a.translation - b.translation).squaredNorm();
    return spread + shift + (ifs::mirrors<Dim>(a, b) ? covariance.trace() : 0);
}

} // namespace

template <int Dim>
std::optional<Correspondence<Dim>> correspondence(const ifs::ActiveMaps<Dim>& from,
                                                  const ifs::ActiveMaps<Dim>& to, std::span<const Pin> pins) {
    const auto first = ifs::moments<Dim>(from), last = ifs::moments<Dim>(to);
    if (!first || !last || std::max(from.maps.size(), to.maps.size()) > maxMorphMaps) return std::nullopt;
    Correspondence<Dim> result;
    result.reference = (first->mean + last->mean) / 2;
    const ifs::Vector<Dim> apart = first->mean - last->mean;
    const ifs::Matrix<Dim> covariance =
        (first->covariance + last->covariance) / 2 + apart * apart.transpose() / 4;
    const auto rows = Eigen::Index(from.maps.size()), columns = Eigen::Index(to.maps.size());
    result.cost.resize(rows, columns);
    for (Eigen::Index i = 0; i < rows; ++i)
        for (Eigen::Index k = 0; k < columns; ++k)
            result.cost(i, k) =
                costOf<Dim>(from.maps[std::size_t(i)], to.maps[std::size_t(k)], result.reference, covariance);
    Eigen::MatrixXd pinned = result.cost;
    // Exceeds the saving of any detour.
    const double more = 2 * double(rows + columns) * (1 + result.cost.maxCoeff());
    for (const Pin& pin : pins)
        pinned(Eigen::Index(pin.from), Eigen::Index(pin.to)) -= more;
    result.pairs = transport(from.probabilities, to.probabilities, pinned);
    for (const Shipment& pair : result.pairs)
        result.total += pair.amount * result.cost(Eigen::Index(pair.from), Eigen::Index(pair.to));
    return result;
}

template <int Dim>
Morph<Dim> morph(const ifs::ActiveMaps<Dim>& from, const ifs::ActiveMaps<Dim>& to,
                 const Correspondence<Dim>& correspondence, int length) {
    Morph<Dim> morph;
    morph.animation.length = length;
    morph.animation.reference = correspondence.reference;
    for (const Shipment& pair : correspondence.pairs) {
        const MapPose<Dim> first{from.maps[pair.from], pair.amount}, last{to.maps[pair.to], pair.amount};
        const ifs::MapId id = ifs::append(morph.system, first.map, first.weight);
        morph.animation.maps.push_back({id, {{0, first, {Ease::Kind::Both}}, {length, last, {}}}});
    }
    return morph;
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template std::optional<Correspondence<Dim>> correspondence<Dim>(                                         \
        const ifs::ActiveMaps<Dim>&, const ifs::ActiveMaps<Dim>&, std::span<const Pin>);                     \
    template Morph<Dim> morph<Dim>(const ifs::ActiveMaps<Dim>&, const ifs::ActiveMaps<Dim>&,                 \
                                   const Correspondence<Dim>&, int);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace animation
