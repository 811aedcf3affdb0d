// SPDX-License-Identifier: MIT
#pragma once

#include "animation/keys/keys.h"

#include <cstddef>

namespace animation {

// segmentAt() with only those neighbours that the motion comes from or goes on to. Beyond a key that holds
// there is none. In a cycle, a last key at the length is the first key once more: where both have the same
// value, the neighbour is the key beyond; where they differ, the motion jumps there and has none.
template <class Value> Segment<Value> wayAt(const Keys<Value>& keys, const Clock& clock) {
    Segment<Value> way = segmentAt(keys, clock);
    if (!way.isSmooth) return way;
    const auto isReached = [&](const Key<Value>& key) {
        return key.frame * clock.moment.denominator <= clock.moment.numerator;
    };
    const std::size_t count = keys.size(), last = count - 1;
    const auto next = std::size_t(std::ranges::partition_point(keys, isReached) - keys.begin());
    const std::size_t from = next == 0 ? last : next - 1, to = next == count ? 0 : next;
    const auto holds = [&](std::size_t key) { return keys[key].ease.kind == Ease::Kind::Hold; };
    const bool isDouble =
        clock.loop == Loop::Cycle && keys.front().frame == 0 && keys.back().frame == clock.length;
    if (!isDouble) {
        if (holds(from == 0 ? last : from - 1)) way.before = {};
        if (holds(to)) way.after = {};
        return way;
    }
    const bool isClosed = count > 2 && keys.front().value == keys.back().value;
    const double begin = keys[from].frame, frames = keys[to].frame - begin;
    if (from == 0) way.before = {};
    if (from == 0 && isClosed)
        way.before = {&keys[last - 1].value, (keys[last - 1].frame - clock.length - begin) / frames};
    if (to == last) way.after = {};
    if (to == last && isClosed) way.after = {&keys[1].value, (keys[1].frame + clock.length - begin) / frames};
    if (holds(from == 0 ? last - 1 : from - 1)) way.before = {};
    if (holds(to == last ? 0 : to)) way.after = {};
    return way;
}

} // namespace animation
