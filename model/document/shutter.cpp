// SPDX-License-Identifier: MIT
#include "document/shutter.h"

#include "attractor/arithmetic/arithmetic.h"

#include <algorithm>

namespace document {

namespace {

using animation::Moment;

constexpr int circle = 360'000;        // thousandths of a degree
constexpr int partsOfMotions = 8;      // pilots in the length of an animation with motions
constexpr std::size_t maxPilots = 128; // before the middles come in between

bool isBefore(const Moment& a, const Moment& b) {
    return a.numerator * b.denominator < b.numerator * a.denominator;
}

// frame + angle/circle · (part/parts − ½), within the animation.
Moment momentAt(const AnimationFacts& facts, int frame, ShutterAngle angle, int part, int parts) {
    const std::int64_t denominator = std::int64_t(2) * circle * parts;
    const std::int64_t offset = std::int64_t(angle) * (2 * part - parts);
    return animation::folded(animation::moment(frame * denominator + offset, denominator), facts.loop,
                             facts.length);
}

template <class Keys> void addFrames(std::vector<int>& frames, const Keys& keys) {
    for (const auto& key : keys)
        frames.push_back(key.frame);
}

template <int Dim> std::vector<int> keyFrames(const animation::Animation<Dim>& animation) {
    std::vector<int> frames{0, animation.length};
    addFrames(frames, animation.cage);
    for (const auto& track : animation.maps)
        addFrames(frames, track.keys);
    for (const auto& track : animation.branches)
        addFrames(frames, track.keys);
    addFrames(frames, animation.look);
    addFrames(frames, animation.camera);
    return frames;
}

template <int Dim> bool hasCameraAtEnd(const animation::Animation<Dim>& animation) {
    return !animation.camera.empty() && animation.camera.back().frame == animation.length;
}

// Ascending, each once, evenly thinned where there are very many.
std::vector<Moment> inOrder(std::vector<Moment> moments) {
    std::ranges::sort(moments, isBefore);
    moments.erase(std::ranges::unique(moments).begin(), moments.end());
    if (moments.size() <= maxPilots) return moments;
    std::vector<Moment> some;
    for (std::size_t i = 0; i < maxPilots; ++i)
        some.push_back(moments[i * (moments.size() - 1) / (maxPilots - 1)]);
    return some;
}

Moment middle(const Moment& a, const Moment& b) {
    return animation::moment(a.numerator * b.denominator + b.numerator * a.denominator,
                             2 * a.denominator * b.denominator);
}

} // namespace

std::vector<Moment> shutterMiddles(const AnimationFacts& facts, int frame, ShutterAngle angle, int count) {
    std::vector<Moment> moments;
    for (int k = 0; k < count; ++k)
        moments.push_back(momentAt(facts, frame, angle, 2 * k + 1, 2 * count));
    return moments;
}

std::vector<Moment> shutterEdges(const AnimationFacts& facts, int frame, ShutterAngle angle, int count) {
    std::vector<Moment> moments;
    for (int k = 0; k <= count; ++k)
        moments.push_back(momentAt(facts, frame, angle, k, count));
    return moments;
}

std::vector<Moment> exposurePilots(const Fractal& fractal) {
    const auto facts = animationFacts(fractal);
    if (!facts) return {animation::moment(0)};
    const std::vector<int> frames =
        plane(fractal) ? keyFrames(*plane(fractal)->animation) : keyFrames(*space(fractal)->animation);
    std::vector<Moment> moments;
    for (const int frame : frames)
        moments.push_back(animation::moment(frame));
    // In a cycle the camera's key at the end is never shown, because frame 0 is; an endless zoom jumps there.
    const bool jumps = plane(fractal) ? hasCameraAtEnd(*plane(fractal)->animation)
                                      : hasCameraAtEnd(*space(fractal)->animation);
    if (facts->loop == animation::Loop::Cycle && jumps)
        moments.push_back(animation::moment(facts->length - 1));
    for (int part = 1; part < partsOfMotions && facts->motions > 0; ++part)
        moments.push_back(animation::moment(std::int64_t(facts->length) * part, partsOfMotions));
    const std::vector<Moment> ends = inOrder(std::move(moments));
    std::vector<Moment> pilots{ends.front()};
    for (std::size_t i = 1; i < ends.size(); ++i) {
        pilots.push_back(middle(ends[i - 1], ends[i]));
        pilots.push_back(ends[i]);
    }
    return pilots;
}

BetweenPilots betweenPilots(const std::vector<Moment>& pilots, const Moment& moment) {
    const auto next = std::ranges::lower_bound(pilots, moment, isBefore);
    if (next == pilots.end()) return {pilots.size() - 1, pilots.size() - 1, 0};
    const auto after = std::size_t(next - pilots.begin());
    if (after == 0 || *next == moment) return {after, after, 0};
    const Moment& from = pilots[after - 1];
    const Moment& to = pilots[after];
    const double way = double(moment.numerator) / double(moment.denominator) -
                       double(from.numerator) / double(from.denominator);
    const double whole =
        double(to.numerator) / double(to.denominator) - double(from.numerator) / double(from.denominator);
    return {after - 1, after, way / whole};
}

attractor::Exposure interpolated(const attractor::Exposure& from, const attractor::Exposure& to,
                                 double share) {
    if (share == 0) return from;
    const auto between = [share](double a, double b) {
        if (a == b || !(a > 0) || !(b > 0)) return a;
        return a * attractor::power(b / a, share);
    };
    return {between(from.meanDensity, to.meanDensity), between(from.whitePoint, to.whitePoint),
            between(from.gain, to.gain)};
}

} // namespace document
