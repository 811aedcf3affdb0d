// SPDX-License-Identifier: MIT
#include "document/moments/animated_fractal.h"

#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "ifs/links/linked_existence.h"

#include <algorithm>
#include <utility>

namespace document {

namespace {

// Numbers of the moments at which existence is looked at.
constexpr int trials = 33, mostFrames = 240;
constexpr std::size_t mostMaps = 20'000; // limit for all frames together

template <int Dim> bool turnsCage(const animation::Animation<Dim>& animation) {
    return Dim == 2 && std::ranges::any_of(animation.motions, [](const animation::Motion<Dim>& motion) {
               return std::holds_alternative<animation::Orbit<Dim>>(motion);
           });
}

template <int Dim> AnimatedFrame frameOf(const Fractal& fractal, const animation::Moment& moment) {
    AnimatedFrame frame{fractal};
    auto& shape = std::get<Shape<Dim>>(frame.fractal.shape);
    if (!shape.animation) return frame;
    const animation::Animation<Dim> animation = *std::exchange(shape.animation, std::nullopt);
    if constexpr (Dim == 2)
        if (!shape.cage && turnsCage<Dim>(animation)) shape.cage = canonicalCage(frame.fractal);
    animation::Pose<Dim> pose = animation.at(moment, {std::move(shape.system),
                                                      std::move(shape.cage),
                                                      std::move(shape.moved),
                                                      std::move(frame.fractal.appearance),
                                                      {},
                                                      {},
                                                      frame.fractal.inSpace});
    shape.system = std::move(pose.system);
    shape.cage = std::move(pose.cage);
    shape.moved = std::move(pose.moved);
    frame.fractal.appearance = std::move(pose.appearance);
    frame.fractal.inSpace = pose.inSpace;
    frame.orbit = std::move(pose.orbit);
    if constexpr (Dim == 2)
        frame.view = pose.camera;
    else
        frame.camera = pose.camera;
    return frame;
}

// Cuts: keys that hold their value until the next, and in a cycle the end, if it is not the beginning.
template <class Keys> std::vector<int> cutsAmong(const Keys& keys, int length, animation::Loop loop) {
    constexpr auto hold = animation::Ease::Kind::Hold;
    std::vector<int> cuts;
    for (std::size_t i = 1; i < keys.size(); ++i)
        if (keys[i - 1].ease.kind == hold && !(keys[i - 1].value == keys[i].value))
            cuts.push_back(keys[i].frame);
    if (loop != animation::Loop::Cycle || keys.size() < 2 || keys.back().value == keys.front().value)
        return cuts;
    const bool jumpsBack = keys.back().frame == length && keys.front().frame == 0;
    if (jumpsBack || keys.back().ease.kind == hold) cuts.push_back(keys.front().frame);
    return cuts;
}

template <int Dim> std::optional<AnimationFacts> factsOf(const Shape<Dim>& shape) {
    if (!shape.animation) return std::nullopt;
    const auto& animation = *shape.animation;
    return AnimationFacts{
        animation.rate,           animation.length,
        animation.loop,           animation::trackCount(animation),
        animation.motions.size(), cutsAmong(animation.camera, animation.length, animation.loop)};
}

template <int Dim> ifs::Verdict verdictOf(const Shape<Dim>& shape) {
    return ifs::classifyLinked<Dim>(ifs::activeMaps(shape.system)).verdict;
}

// Tries the few moments that lie anywhere before the many frames. nullopt as well when stopped.
std::optional<MomentWithoutAttractor> firstTried(const Fractal& fractal, const AnimationFacts& facts,
                                                 const std::stop_token& stop) {
    std::vector<animation::Moment> frames;
    for (const int frame : framesToTry(fractal))
        frames.push_back(animation::moment(frame));
    std::optional<MomentWithoutAttractor> first;
    for (const auto& tried : {moments(facts, trials), frames})
        for (const animation::Moment& moment : tried) {
            if (stop.stop_requested() || (first && !isBefore(moment, first->moment))) break;
            if (const auto verdict = lossAt(fractal, moment)) first = {moment, *verdict};
        }
    return first;
}

template <int Dim> bool hasCommonNorm(const Shape<Dim>& shape) {
    return ifs::countActive(shape.system) > 0 && // for the listed maps: the group need not keep their norm
           shape.system.symmetry.group == ifs::SymmetryGroup::None &&
           animation::commonNorm(*shape.animation, shape.system).has_value();
}

// Keys with a common norm, and no motion that leaves them.
bool isSafeByNorm(const Fractal& fractal, const AnimationFacts& facts) {
    const auto* flat = plane(fractal);
    return facts.motions == 0 && (flat ? hasCommonNorm(*flat) : hasCommonNorm(*space(fractal)));
}

template <int Dim> Fractal weakened(const Fractal& fractal, std::size_t motion, double share) {
    Fractal result = fractal;
    auto& motions = std::get<Shape<Dim>>(result.shape).animation->motions;
    motions[motion] = animation::weakened<Dim>(motions[motion], share);
    return result;
}

} // namespace

std::optional<AnimationFacts> animationFacts(const Fractal& fractal) {
    if (const auto* shape = plane(fractal)) return factsOf(*shape);
    if (const auto* shape = space(fractal)) return factsOf(*shape);
    return std::nullopt;
}

AnimatedFrame frameAt(const Fractal& fractal, const animation::Moment& moment) {
    if (plane(fractal)) return frameOf<2>(fractal, moment);
    if (space(fractal)) return frameOf<3>(fractal, moment);
    return {fractal};
}

LastingCage lastingCage(const Fractal& entry) {
    const auto* flat = plane(entry);
    const auto* solid = space(entry);
    if (flat && !flat->cage) return LastingCage(effectiveCage(entry));
    const bool isQuick = solid && solid->system.maps.size() <= manyMapsInSpace;
    return isQuick && !solid->cage ? LastingCage(*spaceCage(entry)) : LastingCage();
}

animation::Look lookOf(const Fractal& fractal) {
    return space(fractal) ? animation::lookOf(fractal.appearance, fractal.inSpace)
                          : animation::lookOf(fractal.appearance);
}

Fractal withLook(Fractal fractal, const animation::Look& look) {
    fractal.appearance = animation::withLook(std::move(fractal.appearance), look);
    if (look.inSpace) fractal.inSpace = *look.inSpace;
    return fractal;
}

std::vector<animation::Moment> moments(const AnimationFacts& facts, int count) {
    std::vector<animation::Moment> result;
    for (int i = 0; i < count; ++i)
        result.push_back(animation::moment(std::int64_t(facts.length) * i, count - 1));
    return result;
}

std::set<int> keyFramesOfMaps(const Fractal& fractal) {
    std::set<int> frames;
    const auto collect = [&](const auto& shape) {
        if (!shape.animation) return;
        for (const auto& track : shape.animation->maps)
            for (const auto& key : track.keys)
                frames.insert(key.frame);
    };
    if (const auto* shape = plane(fractal)) collect(*shape);
    if (const auto* shape = space(fractal)) collect(*shape);
    return frames;
}

std::set<int> framesToTry(const Fractal& fractal) {
    std::set<int> frames;
    const auto facts = animationFacts(fractal);
    if (!facts) return frames;
    const auto* flat = plane(fractal);
    const std::size_t maps = flat ? flat->system.maps.size() : space(fractal)->system.maps.size();
    const int most = std::clamp(int(mostMaps / std::max(maps, std::size_t(1))), trials - 1, mostFrames);
    const int step = (facts->length + most - 1) / most;
    for (int frame = 0; frame <= facts->length; frame += step)
        frames.insert(frame);
    for (const int key : keyFramesOfMaps(fractal)) {
        if (int(frames.size()) >= 2 * mostFrames) break;
        frames.insert(key);
    }
    return frames;
}

std::optional<ifs::Verdict> lossAt(const Fractal& fractal, const animation::Moment& moment) {
    const AnimatedFrame frame = frameAt(fractal, moment);
    const auto* flat = plane(frame.fractal);
    const ifs::Verdict verdict = flat ? verdictOf(*flat) : verdictOf(*space(frame.fractal));
    const bool isCertain =
        verdict == ifs::Verdict::Hyperbolic || verdict == ifs::Verdict::EventuallyContractive;
    return isCertain ? std::nullopt : std::optional(verdict);
}

std::optional<MomentWithoutAttractor> firstWithoutAttractor(const Fractal& fractal,
                                                            const std::stop_token& stop) {
    const auto facts = animationFacts(fractal);
    return facts && !isSafeByNorm(fractal, *facts) ? firstTried(fractal, *facts, stop) : std::nullopt;
}

std::optional<bool> losesAttractor(const Fractal& fractal, const std::stop_token& stop) {
    const auto facts = animationFacts(fractal);
    if (!facts || isSafeByNorm(fractal, *facts)) return false;
    const bool loses = firstTried(fractal, *facts, stop).has_value();
    return loses || !stop.stop_requested() ? std::optional(loses) : std::nullopt;
}

std::optional<Fractal> withSafeStrength(const Fractal& fractal, std::size_t motion,
                                        const std::stop_token& stop) {
    const auto facts = animationFacts(fractal);
    if (!facts || motion >= facts->motions) return fractal;
    const auto withShare = [&](double share) {
        return plane(fractal) ? weakened<2>(fractal, motion, share) : weakened<3>(fractal, motion, share);
    };
    double safe = 0, lost = 1;
    for (double share = 1; lost - safe > 1e-3; share = (safe + lost) / 2) {
        (firstTried(withShare(share), *facts, stop) ? lost : safe) = share;
        if (stop.stop_requested()) return std::nullopt;
    }
    return safe == 1 ? fractal : withShare(safe);
}

Fractal withSafeStrength(const Fractal& fractal, std::size_t motion) {
    return *withSafeStrength(fractal, motion, {});
}

} // namespace document
