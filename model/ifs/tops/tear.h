// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/support_function.h"

#include <array>
#include <cstddef>
#include <optional>

// Continuity of a fractal transformation. docs/mathematics.md, "Fractal tops".
namespace ifs {

// The largest diameter of v_σ(A_G) ∪ v_ω(A_G), where σ, ω differ in their first symbol and are the shortest
// words whose pieces of F have diameters of at most ε and lie within ε of each other. This is proved: no jump
// of T_FG between points of different pieces w_i(A_F) is larger.
struct Tear {
    double size = 0;
    std::optional<std::array<Vector<2>, 2>>
        place;               // one point of F in each piece; nullopt: no pieces are near
    bool isCutShort = false; // true if pieces are larger than ε; `size` is a bound all the same
    double whole = 0;        // diameter for all of A_G, which no jump can exceed
};

// Both systems must have equally many maps, which correspond by their indices. ε > 0. About `maxPairs` pairs
// are kept at most.
Tear tear(const SupportFunction<2>& from, const SupportFunction<2>& to, double epsilon,
          std::size_t maxPairs = 1U << 20);

// Verdict on whether T_FG takes the attractor of F to that of G without tearing or gluing.
enum class Homeomorphism { Unknown, Proved, Refuted };
Homeomorphism homeomorphism(const SupportFunction<2>& from, const SupportFunction<2>& to);

} // namespace ifs
