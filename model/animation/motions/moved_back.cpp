// SPDX-License-Identifier: MIT
#include "animation/motions/moved_back.h"

#include "animation/motions/motion_fields.h"

#include <Eigen/LU>

namespace animation {

namespace {

// The reference of a motion w ↦ q + L(w − q) with q = w(reference).
template <int Dim> ifs::Vector<Dim> referenceOf(const Motion<Dim>& motion) {
    struct : SkippedFields {
        ifs::Vector<Dim> reference = ifs::Vector<Dim>::Zero();
        void pivot(const ifs::Vector<Dim>& point) { reference = point; }
    } found;
    listFields(motion, found);
    return found.reference;
}

// L of every map: what the motion makes of the identity.
template <int Dim>
ifs::IteratedFunctionSystem<Dim> factors(const Motion<Dim>& motion, const Moment& moment, int length,
                                         ifs::IteratedFunctionSystem<Dim> system) {
    for (auto& map : system.maps)
        map.map = {ifs::Matrix<Dim>::Identity(), ifs::Vector<Dim>::Zero()};
    moveMaps<Dim>(motion, moment, length, system);
    return system;
}

} // namespace

template <int Dim>
ifs::IteratedFunctionSystem<Dim> movedBack(const std::vector<Motion<Dim>>& motions, const Moment& moment,
                                           int length, ifs::IteratedFunctionSystem<Dim> shown) {
    for (auto motion = motions.rbegin(); motion != motions.rend(); ++motion) {
        const ifs::IteratedFunctionSystem<Dim> moved = factors<Dim>(*motion, moment, length, shown);
        const ifs::Vector<Dim> reference = referenceOf<Dim>(*motion);
        for (std::size_t i = 0; i < shown.maps.size(); ++i) {
            const ifs::Matrix<Dim>& factor = moved.maps[i].map.linear;
            if (factor == ifs::Matrix<Dim>::Identity()) continue;
            const ifs::Matrix<Dim> back = factor.inverse();
            ifs::AffineMap<Dim>& map = shown.maps[i].map;
            const ifs::Vector<Dim> pivot = map(reference);
            map = {back * map.linear, pivot + back * (map.translation - pivot)};
        }
    }
    return shown;
}

void turnBack(const std::vector<Motion<2>>& motions, const Moment& moment, int length,
              ifs::ControlCage<2>& cage) {
    for (auto motion = motions.rbegin(); motion != motions.rend(); ++motion)
        if (const auto* orbit = std::get_if<Orbit<2>>(&*motion))
            turnCage(cage, orbit->centre, -orbitAngle<2>(*motion, moment, length));
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template ifs::IteratedFunctionSystem<Dim> movedBack<Dim>(const std::vector<Motion<Dim>>&, const Moment&, \
                                                             int, ifs::IteratedFunctionSystem<Dim>);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace animation
