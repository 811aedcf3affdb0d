// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/appearance.h"

#include <array>
#include <limits>

// The numbers and colours of an appearance, one row each. Lines of files, keys of animations, the sliders of
// the panel and the options of the command line follow from these tables.
namespace attractor {

struct AppearanceNumber {
    enum class Scale {
        Factor, // > 0; keys and sliders change it by constant factors
        Even,   // any sign; keys and sliders change it by constant differences
    };
    enum class InKeys { Always, IfUnusual }; // condition under which a key of an animation stores the value
    enum class Part { Tone, Shadow };        // part of the picture; only pictures in the plane have a shadow

    const char* key; // key in files; the option is the key after two dashes
    double Appearance::*member;
    Scale scale;
    double lowest; // least value; excluded for Factor
    double highest;
    InKeys inKeys = InKeys::IfUnusual;
    Part part = Part::Tone;

    // Returns false for values out of range and for those that are not a number.
    constexpr bool accepts(double value) const {
        return (scale == Scale::Factor ? value > lowest : value >= lowest) && value <= highest;
    }
};

inline constexpr double largestAppearanceNumber = std::numeric_limits<double>::max();
inline constexpr double longestShadow = 10; // longest shadow of a point one unit high
inline constexpr std::array appearanceNumbers{
    AppearanceNumber{"brightness", &Appearance::brightness, AppearanceNumber::Scale::Factor, 0,
                     largestAppearanceNumber, AppearanceNumber::InKeys::Always},
    AppearanceNumber{"gamma", &Appearance::gamma, AppearanceNumber::Scale::Factor, 0, largestAppearanceNumber,
                     AppearanceNumber::InKeys::Always},
    AppearanceNumber{"contrast", &Appearance::contrast, AppearanceNumber::Scale::Factor, 0,
                     largestAppearanceNumber},
    AppearanceNumber{"vibrancy", &Appearance::vibrancy, AppearanceNumber::Scale::Even, 0, 1},
    AppearanceNumber{"shadow", &Appearance::shadow, AppearanceNumber::Scale::Even, 0, 1,
                     AppearanceNumber::InKeys::IfUnusual, AppearanceNumber::Part::Shadow},
    AppearanceNumber{"shadow-lean", &Appearance::shadowLean, AppearanceNumber::Scale::Even, -longestShadow,
                     longestShadow, AppearanceNumber::InKeys::IfUnusual, AppearanceNumber::Part::Shadow},
    AppearanceNumber{"shadow-length", &Appearance::shadowLength, AppearanceNumber::Scale::Even,
                     -longestShadow, longestShadow, AppearanceNumber::InKeys::IfUnusual,
                     AppearanceNumber::Part::Shadow},
};

struct AppearanceColour {
    const char* key; // key in files
    Rgba Appearance::*member;
};

inline constexpr std::array appearanceColours{
    AppearanceColour{"plain", &Appearance::plain},
    AppearanceColour{"background", &Appearance::background},
};

} // namespace attractor
