// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "document/saved_views.h"

#include <optional>
#include <span>
#include <variant>
#include <vector>

// Edits of the animation of an entry: its keys and its timing. Functions take an entry with its animation, or
// one that has none yet and begins with animation::Animation's own timing, and return it changed.
namespace document {

// A part of an entry that keys can move.
struct Track {
    enum class Kind { Cage, Map, Branch, Look, Camera };
    Kind kind = Kind::Cage;
    std::vector<ifs::MapId> maps{}; // map, or address of a branch; empty for the other kinds

    friend bool operator==(const Track&, const Track&) = default;
};

// The tracks of an entry, including those without keys, with their keys by frame.
struct TrackKeys {
    struct Key {
        int frame = 0;
        animation::Ease ease;
        friend bool operator==(const Key&, const Key&) = default;
    };
    Track track;
    std::vector<Key> keys;

    friend bool operator==(const TrackKeys&, const TrackKeys&) = default;
};
std::vector<TrackKeys> tracksOf(const Fractal& entry);
// Returns true if tracks, keys, motions and timing of both are the same, without listing them.
bool areTracksAlike(const Fractal& a, const Fractal& b);

// Timing of an animation; for an entry without one, that of a new one.
struct Timing {
    animation::FrameRate rate;
    int length = 0;
    animation::Loop loop = animation::Loop::Off;

    friend bool operator==(const Timing&, const Timing&) = default;
};
Timing timingOf(const Fractal& entry);
// Keys behind a new end are lost.
Fractal withTiming(Fractal entry, const Timing& timing);

// A key of one track.
struct KeyAt {
    Track track;
    int frame = 0;

    friend bool operator==(const KeyAt&, const KeyAt&) = default;
};

// Adds a key at this frame with the value shown there; the first of its track also keys frame 0. `camera` is
// the view there, the orbit of an entry in space included; a view of the other dimension adds no key.
using SeenCamera = std::optional<SavedView::Camera>;
Fractal withKey(Fractal entry, const Track& track, int frame, const SeenCamera& camera);
// A track that loses its last keys stays as the first of these had it.
Fractal withoutKeys(Fractal entry, std::span<const KeyAt> keys);
Fractal withEase(Fractal entry, std::span<const KeyAt> keys, const animation::Ease& ease);

enum class KeyMove {
    Move,   // replaces keys at the new frames
    Copy,   // moves copies; the originals stay
    Ripple, // moves all later keys of these tracks, too, and extends the animation if necessary
};
// Moves keys by a number of frames, as far as they stay within the animation.
Fractal withKeysMoved(Fractal entry, std::span<const KeyAt> keys, int by, KeyMove how);
// Number of frames by which these keys can be moved, at most `by`.
int possibleMove(const Fractal& entry, std::span<const KeyAt> keys, int by, KeyMove how);

// Keys apart from any entry, for the clipboard; frames count from the first of them.
struct CopiedKey {
    KeyAt at;
    std::variant<animation::Key<animation::CagePose<2>>, animation::Key<animation::CagePose<3>>,
                 animation::Key<animation::MapPose<2>>, animation::Key<animation::MapPose<3>>,
                 animation::Key<ifs::AffineMap<2>>, animation::Key<ifs::AffineMap<3>>,
                 animation::Key<animation::Look>, animation::Key<attractor::View>,
                 animation::Key<attractor::OrbitCamera>>
        key;
};
std::vector<CopiedKey> copiedKeys(const Fractal& entry, std::span<const KeyAt> keys);
// The keys that were pasted into tracks of this entry, at `frame` and later, and where they are now.
struct Pasted {
    Fractal fractal;
    std::vector<KeyAt> keys;
};
Pasted withKeysPasted(Fractal entry, std::span<const CopiedKey> keys, int frame);

// Removes the motion of this index.
Fractal withoutMotion(Fractal entry, std::size_t motion);

// A number of a motion that a user may change.
struct MotionNumber {
    enum class Kind {
        Degrees, // strength of a sway, up to ±360
        Share,   // strength of breathing, in (−1, 1)
        Turns,   // turns in the length of the animation, up to ±animation::maxCycles, not 0
        Cycles,  // cycles in the length of the animation, at least 1; for a sway, of each wave
    };
    Kind kind = Kind::Turns;
    double value = 0;

    friend bool operator==(const MotionNumber&, const MotionNumber&) = default;
};
// The numbers, always in the same order; none if there is no motion of this index.
std::vector<MotionNumber> motionNumbers(const Fractal& entry, std::size_t motion);
// Sets all numbers. If one is out of its range, the entry stays as it is.
Fractal withMotionNumbers(Fractal entry, std::size_t motion, std::span<const MotionNumber> numbers);

} // namespace document
