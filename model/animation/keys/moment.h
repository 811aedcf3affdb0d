// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/names.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

// Time, counted in frames: frame 0 is the start.
namespace animation {

constexpr int maxLength = 1'000'000;                   // frames
constexpr std::int64_t maxDenominator = 1'000'000'000; // greatest denominator of a fraction of a frame
constexpr int maxCycles = 1000;                        // most cycles of a motion in one animation

// A frame or a fraction of one, in lowest terms with a positive denominator.
struct Moment {
    std::int64_t numerator = 0;
    std::int64_t denominator = 1;

    friend bool operator==(const Moment&, const Moment&) = default;
};

// A fraction reduced to lowest terms. The denominator must not be 0.
Moment moment(std::int64_t numerator, std::int64_t denominator = 1);
// "12", "12.25" or "49/4"; nullopt for anything else, for a negative one, and beyond maxLength or
// maxDenominator.
std::optional<Moment> parseMoment(std::string_view text);
bool isAfter(const Moment& moment, std::int64_t frame);
bool isBefore(const Moment& a, const Moment& b);

// Behaviour after the last frame.
enum class Loop {
    Off,          // the last frame stays
    Cycle,        // frame 0 follows the last frame, which shows the same and is not drawn
    ThereAndBack, // all frames in reverse order
};

// The frames to draw: length + 1 without a loop, `length` in a cycle, 2·length there and back.
int frameCount(Loop loop, int length);
int lastFrame(Loop loop, int length); // greatest frame of the loop: `length`, or 2 · length

// The moment from 0 to `length` that is shown at this one.
Moment folded(const Moment& moment, Loop loop, int length);

// The share of a cycle, 0 ≤ … < 1, that a motion of `cycles` in the length is at. Reduced in integers: at
// `length` it is exactly 0 again. The moment is folded.
double phase(const Moment& moment, int length, int cycles);

} // namespace animation

template <>
inline constexpr auto ifs::names<animation::Loop> = std::to_array<ifs::Named<animation::Loop>>({
    {animation::Loop::Off, "off"},
    {animation::Loop::Cycle, "cycle"},
    {animation::Loop::ThereAndBack, "there-and-back"},
});
