// SPDX-License-Identifier: MIT
#include "animation/paths/map_path.h"

#include "ifs/system/map_interpolation.h"

namespace animation {

template <int Dim>
MapPose<Dim> between(const MapPose<Dim>& from, const MapPose<Dim>& to, double share,
                     const ifs::Vector<Dim>& reference, const CommonNorm<Dim>& norm) {
    if (share <= 0) return from;
    if (share >= 1) return to;
    MapPose<Dim> pose;
    if (norm.isEuclidean) {
        pose.map = ifs::interpolated<Dim>(from.map, to.map, share, reference);
    } else {
        const auto seen = [&](const ifs::AffineMap<Dim>& map) {
            return ifs::AffineMap<Dim>{norm.root * map.linear * norm.inverse, norm.root * map.translation};
        };
        const auto map = ifs::interpolated<Dim>(seen(from.map), seen(to.map), share, norm.root * reference);
        pose.map = {norm.inverse * map.linear * norm.root, norm.inverse * map.translation};
    }
    pose.weight = from.weight;
    if (from.weight && to.weight) pose.weight = (1 - share) * *from.weight + share * *to.weight;
    return pose;
}

template <int Dim>
ifs::AffineMap<Dim> straight(const ifs::AffineMap<Dim>& from, const ifs::AffineMap<Dim>& to, double share) {
    if (share <= 0) return from;
    if (share >= 1) return to;
    return {(1 - share) * from.linear + share * to.linear,
            (1 - share) * from.translation + share * to.translation};
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template MapPose<Dim> between<Dim>(const MapPose<Dim>&, const MapPose<Dim>&, double,                     \
                                       const ifs::Vector<Dim>&, const CommonNorm<Dim>&);                     \
    template ifs::AffineMap<Dim> straight<Dim>(const ifs::AffineMap<Dim>&, const ifs::AffineMap<Dim>&,       \
                                               double);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace animation
