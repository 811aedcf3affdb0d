// SPDX-License-Identifier: MIT
#include "document/moments/motion_extent.h"

#include "document/fractal/space_geometry.h"
#include "document/moments/animated_fractal.h"

#include <set>
#include <utility>

namespace document {

namespace {

constexpr int evenMoments = 37; // prime, so that a periodic motion is not always met at the same phase
constexpr std::size_t mostKeys = 100;

// A cage that is not stored is that of the entry at rest at all moments.
Fractal heldByItsCage(Fractal entry) {
    Shape<2>* shape = plane(entry);
    if (!shape->cage) shape->cage = effectiveCage(entry);
    return entry;
}

Fractal heldInSpace(Fractal entry) {
    Shape<3>* shape = space(entry);
    if (!shape->cage) shape->cage = spaceCage(entry);
    return entry;
}

void addMoment(MotionExtent& extent, const Fractal& shown, attractor::YAxis yAxis) {
    if (const auto box = boxWithShadow(shown, yAxis))
        extent.picture = extent.picture ? united(*extent.picture, *box) : *box;
    if (const auto* cage = cage2(shown))
        extent.corners.insert(extent.corners.end(), cage->current.begin(), cage->current.end());
}

template <int Dim> std::set<int> keyFrames(const animation::Animation<Dim>& animation) {
    std::set<int> frames;
    for (const auto& key : animation.cage)
        frames.insert(key.frame);
    for (const auto& track : animation.maps)
        for (const auto& key : track.keys)
            if (frames.size() < mostKeys) frames.insert(key.frame);
    return frames;
}

template <int Dim>
std::vector<animation::Moment> momentsToLookAt(const AnimationFacts& facts,
                                               const animation::Animation<Dim>& animation) {
    std::vector<animation::Moment> looked = moments(facts, evenMoments);
    for (const int frame : keyFrames(animation))
        looked.push_back(animation::moment(frame));
    return looked;
}

void addCorners(std::vector<ifs::Vector<3>>& corners, const Fractal& shown) {
    ifs::Vector<3> low, high;
    for (int i = 0; i < 3; ++i) {
        const Extent extent = extentAlong(shown, ifs::Vector<3>::Unit(i));
        low[i] = extent.low;
        high[i] = extent.high;
    }
    for (int corner = 0; corner < 8; ++corner)
        corners.push_back({corner & 1 ? high.x() : low.x(), corner & 2 ? high.y() : low.y(),
                           corner & 4 ? high.z() : low.z()});
    if (const auto cage = spaceCage(shown))
        corners.insert(corners.end(), cage->current.begin(), cage->current.end());
}

bool showsTheSame(const Fractal& a, const Fractal& b) {
    return isSameSystem(a, b) && space(a)->cage == space(b)->cage;
}

} // namespace

Box united(const Box& a, const Box& b) {
    return {a.min.cwiseMin(b.min), a.max.cwiseMax(b.max)};
}

MotionExtent motionExtent(const Fractal& entry, const std::function<bool()>& stopped,
                          attractor::YAxis yAxis) {
    MotionExtent extent;
    const Shape<2>* shape = plane(entry);
    if (!shape) return extent;
    const Fractal held = heldByItsCage(entry);
    const auto facts = animationFacts(entry);
    if (!facts) {
        addMoment(extent, held, yAxis);
        return extent;
    }
    for (const animation::Moment& moment : momentsToLookAt(*facts, *shape->animation)) {
        if (stopped()) break;
        addMoment(extent, frameAt(held, moment).fractal, yAxis);
    }
    return extent;
}

std::vector<ifs::Vector<3>> motionCorners(const Fractal& entry, const std::function<bool()>& stopped) {
    std::vector<ifs::Vector<3>> corners;
    const Shape<3>* shape = space(entry);
    const auto facts = animationFacts(entry);
    if (!shape || !facts) return corners;
    std::optional<Fractal> before;
    bool moves = false;
    const Fractal held = heldInSpace(entry);
    for (const animation::Moment& moment : momentsToLookAt(*facts, *shape->animation)) {
        if (stopped()) break;
        Fractal shown = frameAt(held, moment).fractal;
        if (before && showsTheSame(*before, shown)) continue;
        moves = moves || before;
        addCorners(corners, shown);
        before = std::move(shown);
    }
    return moves ? corners : std::vector<ifs::Vector<3>>();
}

} // namespace document
