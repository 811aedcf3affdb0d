// SPDX-License-Identifier: MIT
#pragma once

#include "animation/keys/keys.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>

// The curves that smooth ways follow. docs/mathematics.md, "Smooth ways".
namespace animation {

// The values at the two keys of a segment and, where they exist, at the keys beside them. `from` is at time
// 0, `to` at 1, `before` at begin < 0 and `after` at end > 1.
template <class Value> struct KeysAround {
    Value from;
    Value to;
    std::optional<Value> before{};
    std::optional<Value> after{};
    double begin = -1;
    double end = 2;

    bool isAlone() const { return !before && !after; }

    // The same of what `part` makes of each value.
    template <class Part> auto of(const Part& part) const {
        KeysAround<std::decay_t<decltype(part(from))>> result{part(from), part(to)};
        if (before) result.before = part(*before);
        if (after) result.after = part(*after);
        result.begin = begin;
        result.end = end;
        return result;
    }
};

// Neighbours that `isLike` the segment's own keys; others are left out.
template <class Value, class IsLike>
KeysAround<Value> keysAround(const Segment<Value>& way, const IsLike& isLike) {
    KeysAround<Value> keys{way.from, way.to};
    if (way.before.value && way.before.time < 0 && isLike(*way.before.value)) keys.before = *way.before.value;
    if (way.after.value && way.after.time > 1 && isLike(*way.after.value)) keys.after = *way.after.value;
    if (keys.before) keys.begin = way.before.time;
    if (keys.after) keys.end = way.after.time;
    return keys;
}

template <class Value> KeysAround<Value> keysAround(const Segment<Value>& way) {
    return keysAround(way, [](const Value&) { return true; });
}

// Numbers, vectors and matrices.
template <class Value> struct Flat {
    using Step = Value;
    static Step between(const Value& from, const Value& to) { return to - from; }
    static Value moved(const Value& from, const Step& step) { return from + step; }
};

// Shares of the tangents at `from` and at `to`, from 0 (the curve stops there) to 1.
struct TangentShares {
    double from = 1;
    double to = 1;
};

// The Catmull–Rom curve through keys at any times, at the share of the way: its tangent at a key is the way
// from the key before to the key after, by the time between them; at a key without a neighbour, the curve
// does not bend. Where `Space` is not flat, the curve is the product of the steps between its four control
// points, each to the power of a cumulative Bernstein polynomial. C¹ at every key, up to the shares.
template <class Space, class Value>
Value smoothCurve(const KeysAround<Value>& keys, double t, const TangentShares& shares = {}) {
    using Step = typename Space::Step;
    if (t <= 0) return keys.from;
    if (t >= 1) return keys.to;
    const Step way = Space::between(keys.from, keys.to);
    if (keys.isAlone()) return Space::moved(keys.from, t * way);
    Step first = way, last = way; // steps to the second control point and from the third one
    if (keys.before)
        first = shares.from / (3 * (1 - keys.begin)) * (Space::between(*keys.before, keys.from) + way);
    if (keys.after) last = shares.to / (3 * keys.end) * (way + Space::between(keys.to, *keys.after));
    if (!keys.before) first = 0.5 * Space::between(keys.from, Space::moved(keys.to, -last));
    const Value second = Space::moved(keys.from, first);
    if (!keys.after) last = 0.5 * Space::between(second, keys.to);
    const Step middle = Space::between(second, Space::moved(keys.to, -last));
    const double rest = 1 - t;
    const Value begun = Space::moved(keys.from, (1 - rest * rest * rest) * first);
    return Space::moved(Space::moved(begun, t * t * (3 - 2 * t) * middle), t * t * t * last);
}

// The largest share from 0 to 1 that is allowed, if all below an allowed one are; 0 always is.
template <std::predicate<double> IsAllowed> double largestShare(const IsAllowed& isAllowed) {
    if (isAllowed(1)) return 1;
    constexpr int halvings = 30;
    double allowed = 0, excluded = 1;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (allowed + excluded) / 2;
        (isAllowed(middle) ? allowed : excluded) = middle;
    }
    return allowed;
}

// The largest shares with which the control points on both sides of a key are within the limits of their
// segments, so that the curve is as well: `limitOf(a, b)` tells whether a point is within a convex set that
// holds a and b. A share belongs to the key and not to the segment, so the curve stays C¹.
template <class Value, class LimitOf>
TangentShares sharesWithin(const KeysAround<Value>& keys, const LimitOf& limitOf) {
    const auto shareAt = [&](const Value& before, const Value& at, const Value& after, double ahead) {
        const Value third = (after - before) / 3;
        const auto isBehind = limitOf(before, at), isAhead = limitOf(at, after);
        return largestShare([&](double share) {
            const Value next = at + share * ahead * third, previous = at - share * (1 - ahead) * third;
            return isAhead(next) && isBehind(previous);
        });
    };
    TangentShares shares;
    if (keys.before) shares.from = shareAt(*keys.before, keys.from, keys.to, 1 / (1 - keys.begin));
    if (keys.after) shares.to = shareAt(keys.from, keys.to, *keys.after, (keys.end - 1) / keys.end);
    return shares;
}

// A number that is never outside of the two between which it is.
inline double smoothNumber(const KeysAround<double>& keys, double t) {
    const auto limitOf = [](double a, double b) {
        return [low = std::min(a, b), high = std::max(a, b)](double x) { return x >= low && x <= high; };
    };
    const double number = smoothCurve<Flat<double>>(keys, t, sharesWithin(keys, limitOf));
    // Fallback if a difference overflowed.
    if (!std::isfinite(number)) return (1 - t) * keys.from + t * keys.to;
    return std::clamp(number, std::min(keys.from, keys.to), std::max(keys.from, keys.to));
}

} // namespace animation
