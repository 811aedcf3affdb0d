// SPDX-License-Identifier: MIT
#include "animation/cage_path.h"

#include "ifs/system/map_interpolation.h"

namespace animation {

template <int Dim>
CagePose<Dim> between(const ifs::ControlCage<Dim>& cage, const CagePose<Dim>& from, const CagePose<Dim>& to,
                      double share) {
    if (share <= 0 || from == to) return from;
    if (share >= 1) return to;
    ifs::Vector<Dim> centre = ifs::Vector<Dim>::Zero();
    for (const auto& vertex : cage.rest)
        centre += vertex / double(cage.rest.size());
    const auto placementAt = [&](const CagePose<Dim>& current) {
        return ifs::displayMap(ifs::ControlCage<Dim>{cage.rest, current, cage.deformation});
    };
    const ifs::AffineMap<Dim> first = placementAt(from), last = placementAt(to);
    const ifs::AffineMap<Dim> now = ifs::interpolated<Dim>(first, last, share, centre);
    CagePose<Dim> pose;
    for (std::size_t i = 0; i < cage.rest.size(); ++i) {
        const ifs::Vector<Dim>& rest = cage.rest[i];
        pose.push_back(now(rest) + (1 - share) * (from[i] - first(rest)) + share * (to[i] - last(rest)));
    }
    return pose;
}

template CagePose<2> between(const ifs::ControlCage<2>&, const CagePose<2>&, const CagePose<2>&, double);
template CagePose<3> between(const ifs::ControlCage<3>&, const CagePose<3>&, const CagePose<3>&, double);

} // namespace animation
