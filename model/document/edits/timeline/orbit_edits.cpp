// SPDX-License-Identifier: MIT
#include "document/edits/timeline/orbit_edits.h"

#include "animation/animation.h"
#include "attractor/arithmetic/arithmetic.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"

#include <cmath>
#include <numbers>

namespace document {

namespace {

template <int Dim, class Place> auto* orbitAt(Place& shape, std::size_t motion) {
    using Orbit = animation::Orbit<Dim>;
    return shape.animation && motion < shape.animation->motions.size()
               ? std::get_if<Orbit>(&shape.animation->motions[motion])
               : nullptr;
}

double degreesOfArc(double radians) {
    return radians * 180 / std::numbers::pi;
}

} // namespace

std::optional<OrbitPlace> orbitPlace(const Fractal& entry, std::size_t motion) {
    if (const auto* shape = plane(entry))
        if (const auto* orbit = orbitAt<2>(*shape, motion))
            return OrbitPlace{orbit->axis, orbit->pivot, {orbit->centre.x(), orbit->centre.y(), 0}};
    if (const auto* shape = space(entry))
        if (const auto* orbit = orbitAt<3>(*shape, motion))
            return OrbitPlace{orbit->axis, orbit->pivot, orbit->centre};
    return std::nullopt;
}

Fractal withOrbitPlace(Fractal entry, std::size_t motion, const OrbitPlace& place) {
    if (auto* shape = plane(entry))
        if (auto* orbit = orbitAt<2>(*shape, motion); orbit && place.centre.allFinite())
            orbit->centre = place.centre.head<2>();
    if (auto* shape = space(entry))
        if (auto* orbit = orbitAt<3>(*shape, motion)) {
            const animation::Orbit<3> moved{orbit->turns, place.centre, place.axis, place.pivot};
            if (animation::isValid<3>(moved)) *orbit = moved;
        }
    return entry;
}

std::optional<ifs::Vector<3>> orbitCentre(const Fractal& entry) {
    if (!plane(entry)) return centreOfPicture(entry);
    const auto box = displayedBox(entry);
    if (!box) return std::nullopt;
    const ifs::Vector<2> middle = (box->min + box->max) / 2;
    return ifs::Vector<3>(middle.x(), middle.y(), 0);
}

ifs::Vector<3> directionOf(const LeaningAxis& leaning) {
    const double across = attractor::sineOfDegrees(leaning.lean);
    ifs::Vector<3> direction;
    direction[leaning.axis] = attractor::cosineOfDegrees(leaning.lean);
    direction[(leaning.axis + 1) % 3] = across * attractor::cosineOfDegrees(leaning.towards);
    direction[(leaning.axis + 2) % 3] = across * attractor::sineOfDegrees(leaning.towards);
    return direction.normalized();
}

LeaningAxis leaningAxisOf(const ifs::Vector<3>& direction) {
    LeaningAxis leaning;
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(direction[axis]) > std::abs(direction[leaning.axis])) leaning.axis = axis;
    const double next = direction[(leaning.axis + 1) % 3];
    const double last = direction[(leaning.axis + 2) % 3];
    const double across = std::hypot(next, last);
    if (across > 0 || direction[leaning.axis] < 0)
        leaning.lean = degreesOfArc(std::atan2(across, direction[leaning.axis]));
    if (across > 0) leaning.towards = degreesOfArc(std::atan2(last, next));
    return leaning;
}

} // namespace document
