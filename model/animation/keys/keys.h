// SPDX-License-Identifier: MIT
#pragma once

#include "animation/keys/ease.h"
#include "animation/keys/moment.h"

#include <algorithm>
#include <vector>

namespace animation {

// The value at one frame, and how it goes on from there to the next key.
template <class Value> struct Key {
    int frame = 0;
    Value value;
    Ease ease;

    friend bool operator==(const Key&, const Key&) = default;
};

// Keys by frame, strictly ascending. Without keys, a value is not animated.
template <class Value> using Keys = std::vector<Key<Value>>;

// A moment within an animation, as tracks need it.
struct Clock {
    Moment moment; // folded
    Loop loop = Loop::Off;
    int length = 1;
};

// A key beside a segment, and where it lies on the time of the segment: below 0, or above 1.
template <class Value> struct Neighbour {
    const Value* value = nullptr; // nullptr: there is none
    double time = 0;
};

// The two keys that a moment lies between, and the share of the way from one to the other: exactly 0 at a
// key. Only where the way is smooth: the key before the first of them, and the one after the second.
template <class Value> struct Segment {
    const Value& from;
    const Value& to;
    double share;
    bool isSmooth = false;
    Neighbour<Value> before = {};
    Neighbour<Value> after = {};
};

// Needs a key. Before the first key and after the last one their values stay; in a cycle, the last key leads
// to the first one.
template <class Value> Segment<Value> segmentAt(const Keys<Value>& keys, const Clock& clock) {
    const auto isLater = [](const Moment& moment, const Key<Value>& key) {
        return moment.numerator < key.frame * moment.denominator;
    };
    const auto next = std::upper_bound(keys.begin(), keys.end(), clock.moment, isLater);
    const bool isBetween = next != keys.begin() && next != keys.end();
    const Key<Value>& from = next == keys.begin() ? keys.back() : *(next - 1);
    const Key<Value>& to = next == keys.end() ? keys.front() : *next;
    if (!isBetween && (clock.loop != Loop::Cycle || keys.size() == 1)) {
        const Value& still = next == keys.begin() ? keys.front().value : keys.back().value;
        return {still, still, 0};
    }
    const int begin = next == keys.begin() ? from.frame - clock.length : from.frame;
    const int end = next == keys.end() ? to.frame + clock.length : to.frame;
    const Moment& at = clock.moment;
    const double time =
        double(at.numerator - begin * at.denominator) / double((end - begin) * at.denominator);
    Segment<Value> segment{from.value, to.value, eased(from.ease, time)};
    segment.isSmooth = from.ease.kind == Ease::Kind::Smooth;
    if (!segment.isSmooth) return segment;
    const bool isCycle = clock.loop == Loop::Cycle;
    const auto timeOf = [&](int frame) { return double(frame - begin) / double(end - begin); };
    const Key<Value>& first = keys.front();
    const Key<Value>& last = keys.back();
    if (&from != &first)
        segment.before = {&(&from - 1)->value, timeOf((&from - 1)->frame - (from.frame - begin))};
    else if (isCycle)
        segment.before = {&last.value, timeOf(last.frame - clock.length - (from.frame - begin))};
    if (&to != &last)
        segment.after = {&(&to + 1)->value, timeOf((&to + 1)->frame + (end - to.frame))};
    else if (isCycle)
        segment.after = {&first.value, timeOf(first.frame + clock.length + (end - to.frame))};
    return segment;
}

} // namespace animation
