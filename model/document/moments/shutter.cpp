// SPDX-License-Identifier: MIT
#include "document/moments/shutter.h"

#include "attractor/arithmetic/arithmetic.h"

#include <algorithm>

namespace document {

namespace {

using animation::Moment;

constexpr int circle = 360'000;        // thousandths of a degree
constexpr int partsOfMotions = 8;      // number of pilots in an animation with motions
constexpr std::size_t maxPilots = 128; // limit before midpoints are added

// Side of the frame that the shutter sees: it does not open across a cut.
enum class Side { Both, After, Before, Neither };

Side sideOf(const AnimationFacts& facts, int frame) {
    const auto isCut = [&](int at) { return std::ranges::find(facts.cuts, at) != facts.cuts.end(); };
    const int length = std::max(facts.length, 1);
    if (facts.loop == animation::Loop::Cycle)
        return isCut(frame % length) || (frame % length == 0 && isCut(length)) ? Side::After : Side::Both;
    if (facts.loop == animation::Loop::Off) return isCut(frame) ? Side::After : Side::Both;
    const int phase = frame % (2 * length), folded = std::min(phase, 2 * length - phase);
    if (!isCut(folded)) return Side::Both;
    return folded == length ? Side::Neither : phase < length ? Side::After : Side::Before;
}

// frame + angle/circle · (part/parts − ½), within the animation; half as long on one side of a cut.
Moment momentAt(const AnimationFacts& facts, int frame, ShutterAngle angle, int part, int parts) {
    const std::int64_t denominator = std::int64_t(2) * circle * parts;
    const std::int64_t wide = angle;
    std::int64_t offset = 0;
    switch (sideOf(facts, frame)) {
    case Side::Both:
        offset = wide * (2 * part - parts);
        break;
    case Side::After:
        offset = wide * part;
        break;
    case Side::Before:
        offset = wide * (part - parts);
        break;
    case Side::Neither:
        break;
    }
    return animation::folded(animation::moment(frame * denominator + offset, denominator), facts.loop,
                             facts.length);
}

// Adds the frames of keys, and the last ones before a value jumps: where a key holds its value, and in a
// cycle at the end, where frame 0 follows.
template <class Keys>
void addFrames(std::vector<int>& frames, const Keys& keys, const AnimationFacts& facts) {
    constexpr auto hold = animation::Ease::Kind::Hold;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        frames.push_back(keys[i].frame);
        if (i > 0 && keys[i - 1].ease.kind == hold) frames.push_back(keys[i].frame - 1);
    }
    if (facts.loop != animation::Loop::Cycle || keys.size() < 2) return;
    const int first = keys.front().frame;
    if (keys.back().frame == facts.length)
        frames.push_back(facts.length - 1);
    else if (keys.back().ease.kind == hold)
        frames.push_back(first > 0 ? first - 1 : facts.length - 1);
}

template <int Dim>
std::vector<int> keyFrames(const animation::Animation<Dim>& animation, const AnimationFacts& facts) {
    std::vector<int> frames{0, animation.length};
    addFrames(frames, animation.cage, facts);
    for (const auto& track : animation.maps)
        addFrames(frames, track.keys, facts);
    for (const auto& track : animation.branches)
        addFrames(frames, track.keys, facts);
    addFrames(frames, animation.look, facts);
    addFrames(frames, animation.camera, facts);
    return frames;
}

// Ascending, each once, evenly thinned where there are very many.
std::vector<Moment> inOrder(std::vector<Moment> moments) {
    std::ranges::sort(moments, animation::isBefore);
    moments.erase(std::unique(moments.begin(), moments.end()), moments.end());
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
    const std::vector<int> frames = plane(fractal) ? keyFrames(*plane(fractal)->animation, *facts)
                                                   : keyFrames(*space(fractal)->animation, *facts);
    std::vector<Moment> moments;
    for (const int frame : frames)
        moments.push_back(animation::moment(frame));
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
    const auto next = std::ranges::lower_bound(pilots, moment, animation::isBefore);
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
