// SPDX-License-Identifier: MIT
#include "document/animated_fractal.h"

#include "document/fractal_geometry.h"
#include "ifs/links/linked_existence.h"

#include <algorithm>
#include <utility>

namespace document {

namespace {

constexpr int trials = 33; // moments at which existence is looked at

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
                                                      0,
                                                      frame.fractal.inSpace});
    shape.system = std::move(pose.system);
    shape.cage = std::move(pose.cage);
    shape.moved = std::move(pose.moved);
    frame.fractal.appearance = std::move(pose.appearance);
    frame.fractal.inSpace = pose.inSpace;
    frame.orbit = pose.orbit;
    if constexpr (Dim == 2)
        frame.view = pose.camera;
    else
        frame.camera = pose.camera;
    return frame;
}

template <int Dim> std::optional<AnimationFacts> factsOf(const Shape<Dim>& shape) {
    if (!shape.animation) return std::nullopt;
    const auto& animation = *shape.animation;
    return AnimationFacts{animation.rate, animation.length, animation.loop, animation::trackCount(animation),
                          animation.motions.size()};
}

template <int Dim> ifs::Verdict verdictOf(const Shape<Dim>& shape) {
    return ifs::classifyLinked<Dim>(ifs::activeMaps(shape.system)).verdict;
}

// None as well when stopped.
std::optional<MomentWithoutAttractor> firstTried(const Fractal& fractal, const AnimationFacts& facts,
                                                 const std::stop_token& stop) {
    for (const animation::Moment& moment : moments(facts, trials))
        if (stop.stop_requested())
            break;
        else if (const auto verdict = lossAt(fractal, moment))
            return MomentWithoutAttractor{moment, *verdict};
    return std::nullopt;
}

template <int Dim> bool hasCommonNorm(const Shape<Dim>& shape) {
    return ifs::countActive(shape.system) > 0 && // of the listed maps: the group need not keep their norm
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
