// SPDX-License-Identifier: MIT
#include "document/moments/motion_extent.h"

#include "document/moments/animated_fractal.h"

#include <set>
#include <utility>

namespace document {

namespace {

constexpr int evenMoments = 37; // a prime, so that no motion that repeats is met at the same phase each time
constexpr std::size_t mostKeys = 100;

// A cage that is not stored is that of the entry at rest at all moments.
Fractal heldByItsCage(Fractal entry) {
    Shape<2>* shape = plane(entry);
    if (!shape->cage) shape->cage = effectiveCage(entry);
    return entry;
}

void addMoment(MotionExtent& extent, const Fractal& shown, attractor::YAxis yAxis) {
    if (const auto box = boxWithShadow(shown, yAxis))
        extent.picture = extent.picture ? united(*extent.picture, *box) : *box;
    if (const auto* cage = cage2(shown))
        extent.corners.insert(extent.corners.end(), cage->current.begin(), cage->current.end());
}

std::set<int> keyFrames(const animation::Animation<2>& animation) {
    std::set<int> frames;
    for (const auto& key : animation.cage)
        frames.insert(key.frame);
    for (const auto& track : animation.maps)
        for (const auto& key : track.keys)
            if (frames.size() < mostKeys) frames.insert(key.frame);
    return frames;
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
    std::vector<animation::Moment> looked = moments(*facts, evenMoments);
    for (const int frame : keyFrames(*shape->animation))
        looked.push_back(animation::moment(frame));
    for (const animation::Moment& moment : looked) {
        if (stopped()) break;
        addMoment(extent, frameAt(held, moment).fractal, yAxis);
    }
    return extent;
}

} // namespace document
