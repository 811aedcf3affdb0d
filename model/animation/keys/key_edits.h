// SPDX-License-Identifier: MIT
#pragma once

#include "animation/keys/keys.h"

#include <utility>

namespace animation {

// A key with this value at this frame. One that is there keeps its ease; a new one takes that of the key
// before it, and the first ones start and end slowly.
template <class Value> void setKey(Keys<Value>& keys, int frame, Value value) {
    const auto at = std::ranges::lower_bound(keys, frame, {}, &Key<Value>::frame);
    if (at != keys.end() && at->frame == frame) {
        at->value = std::move(value);
        return;
    }
    const Ease ease = at == keys.begin() ? Ease{Ease::Kind::Both} : (at - 1)->ease;
    keys.insert(at, {frame, std::move(value), ease});
}

// The first key of a track that was still. At a frame > 0 it also keys frame 0, with the value it had.
template <class Value> void setFirstKey(Keys<Value>& keys, int frame, const Value& value) {
    setKey(keys, 0, value);
    if (frame > 0) setKey(keys, frame, value);
}

} // namespace animation
