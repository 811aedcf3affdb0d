// SPDX-License-Identifier: MIT
#include "animation/paths/cage_path.h"

#include "ifs/system/map_interpolation.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>

namespace animation {

namespace {

// The Bernstein coefficients of a polynomial of degree Dim.
template <int Dim> using Bernstein = std::array<double, Dim + 1>;

// Returns true if the polynomial is proved to be positive in all of [0, 1].
template <int Dim> bool isPositive(const Bernstein<Dim>& coefficients, int halvings = 30) {
    if (!(coefficients.front() > 0 && coefficients.back() > 0)) return false;
    if (std::ranges::all_of(coefficients, [](double value) { return value >= 0; })) return true;
    if (halvings == 0) return false;
    Bernstein<Dim> left, right = coefficients; // de Casteljau
    for (int i = 0; i <= Dim; ++i) {
        left[std::size_t(i)] = right[0];
        for (int k = 0; k < Dim - i; ++k)
            right[std::size_t(k)] = (right[std::size_t(k)] + right[std::size_t(k) + 1]) / 2;
    }
    return isPositive<Dim>(left, halvings - 1) && isPositive<Dim>(right, halvings - 1);
}

// The coefficients of det((1 − t)I + tA).
Bernstein<2> determinants(const ifs::Matrix<2>& a) {
    return {1, a.trace() / 2, a.determinant()};
}
Bernstein<3> determinants(const ifs::Matrix<3>& a) {
    const double trace = a.trace();
    return {1, trace / 3, (trace * trace - (a * a).trace()) / 6, a.determinant()};
}

template <int Dim>
ifs::AffineMap<Dim> placementOf(const ifs::ControlCage<Dim>& cage, const CagePose<Dim>& pose) {
    return ifs::displayMap(ifs::ControlCage<Dim>{cage.rest, pose, cage.deformation});
}

// The placement is linear in the vertices, so straight ways of all vertices blend it evenly.
template <int Dim>
bool turnsOverAndBack(const ifs::ControlCage<Dim>& cage, const CagePose<Dim>& from, const CagePose<Dim>& to) {
    const ifs::Matrix<Dim> first = placementOf<Dim>(cage, from).linear;
    const ifs::Matrix<Dim> change = first.inverse() * placementOf<Dim>(cage, to).linear;
    Bernstein<Dim> area = determinants(change);
    if (!(area.back() > 0)) return false;
    constexpr double flat = 1e-6; // share of the smaller end within which rounding cannot tell from 0
    const double least = flat * std::min(area.front(), area.back());
    for (double& coefficient : area)
        coefficient -= least;
    return !isPositive<Dim>(area);
}

} // namespace

template <int Dim>
CageWay wayOf(const ifs::ControlCage<Dim>& cage, const CagePose<Dim>& from, const CagePose<Dim>& to) {
    std::optional<std::size_t> first;
    int count = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        if (from[i] != to[i]) continue;
        if (count++ == 0) first = i;
    }
    if (count >= 2 && !turnsOverAndBack<Dim>(cage, from, to)) return {true};
    return {false, first};
}

template <int Dim> ifs::Vector<Dim> referenceOf(const CageWay& way, const ifs::ControlCage<Dim>& cage) {
    if (way.pivot) return cage.rest[*way.pivot];
    ifs::Vector<Dim> centre = ifs::Vector<Dim>::Zero();
    for (const auto& vertex : cage.rest)
        centre += vertex / double(cage.rest.size());
    return centre;
}

template <int Dim>
CagePose<Dim> between(const ifs::ControlCage<Dim>& cage, const CagePose<Dim>& from, const CagePose<Dim>& to,
                      double share) {
    if (share <= 0 || from == to) return from;
    if (share >= 1) return to;
    const CageWay way = wayOf<Dim>(cage, from, to);
    CagePose<Dim> pose;
    if (way.isByVertex) {
        for (std::size_t i = 0; i < from.size(); ++i)
            pose.push_back(from[i] == to[i] ? from[i]
                                            : ifs::Vector<Dim>((1 - share) * from[i] + share * to[i]));
        return pose;
    }
    const ifs::AffineMap<Dim> first = placementOf<Dim>(cage, from), last = placementOf<Dim>(cage, to);
    const ifs::AffineMap<Dim> now = ifs::interpolated<Dim>(first, last, share, referenceOf<Dim>(way, cage));
    for (std::size_t i = 0; i < cage.rest.size(); ++i) {
        const ifs::Vector<Dim>& rest = cage.rest[i];
        pose.push_back(now(rest) + (1 - share) * (from[i] - first(rest)) + share * (to[i] - last(rest)));
    }
    if (way.pivot) pose[*way.pivot] = from[*way.pivot]; // undoes rounding
    return pose;
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template CageWay wayOf<Dim>(const ifs::ControlCage<Dim>&, const CagePose<Dim>&, const CagePose<Dim>&);   \
    template ifs::Vector<Dim> referenceOf<Dim>(const CageWay&, const ifs::ControlCage<Dim>&);                \
    template CagePose<Dim> between<Dim>(const ifs::ControlCage<Dim>&, const CagePose<Dim>&,                  \
                                        const CagePose<Dim>&, double);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace animation
