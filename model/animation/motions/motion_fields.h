// SPDX-License-Identifier: MIT
#pragma once

#include "animation/motions/motion.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

// Names and fields of the motions in files, in the order of their lines. `use` has an overload for each kind
// of field: maps, count, strength, pivot, axis, waves.
namespace animation {

template <class Kind> struct MotionFields;

template <int Dim> struct MotionFields<Sway<Dim>> {
    static constexpr std::string_view id = "sway";
    static void list(auto& sway, auto& use) {
        use.maps(sway.maps);
        use.strength(sway.strength);
        use.pivot(sway.root);
        use.axis(sway.axis);
        use.waves(sway.waves);
    }
};

template <int Dim> struct MotionFields<Turn<Dim>> {
    static constexpr std::string_view id = "turn";
    static void list(auto& turn, auto& use) {
        use.maps(turn.maps);
        use.count(turn.turns);
        use.pivot(turn.reference);
        use.axis(turn.axis);
    }
};

template <int Dim> struct MotionFields<Orbit<Dim>> {
    static constexpr std::string_view id = "orbit";
    static void list(auto& orbit, auto& use) {
        use.count(orbit.turns);
        use.pivot(orbit.centre);
        use.axis(orbit.axis, orbit.pivot);
    }
};

template <int Dim> struct MotionFields<Breathe<Dim>> {
    static constexpr std::string_view id = "breathe";
    static void list(auto& breathe, auto& use) {
        use.maps(breathe.maps);
        use.count(breathe.cycles);
        use.strength(breathe.strength);
        use.pivot(breathe.reference);
    }
};

template <> struct MotionFields<PaletteCycle> {
    static constexpr std::string_view id = "palette";
    static void list(auto& cycle, auto& use) { use.count(cycle.cycles); }
};

// Uses no field; for what uses only some of them.
struct SkippedFields {
    void maps(const auto& /*ids*/) {}
    void count(const auto& /*number*/) {}
    void strength(const auto& /*number*/) {}
    void pivot(const auto& /*point*/) {}
    void axis(const auto&... /*direction*/) {}
    void waves(const auto& /*waves*/) {}
};

// Calls `use` for each field of a Motion<Dim>, which may be constant.
void listFields(auto& motion, auto& use) {
    std::visit(
        [&](auto& kind) {
            MotionFields<std::remove_const_t<std::remove_reference_t<decltype(kind)>>>::list(kind, use);
        },
        motion);
}

template <int Dim> std::string_view idOf(const Motion<Dim>& motion) {
    return std::visit([](const auto& kind) { return MotionFields<std::remove_cvref_t<decltype(kind)>>::id; },
                      motion);
}

// A motion with its initial values; nullopt for an unknown name.
template <int Dim> std::optional<Motion<Dim>> motionNamed(std::string_view id) {
    std::optional<Motion<Dim>> named;
    [&]<std::size_t... K>(std::index_sequence<K...>) {
        const auto take = [&]<class Kind>(Kind kind) {
            if (MotionFields<Kind>::id == id) named = kind;
        };
        (take(std::variant_alternative_t<K, Motion<Dim>>()), ...);
    }
    (std::make_index_sequence<std::variant_size_v<Motion<Dim>>>());
    return named;
}

} // namespace animation
