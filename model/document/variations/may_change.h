// SPDX-License-Identifier: MIT
#pragma once

namespace document {

// Parts of a fractal that may change when it is varied or crossed.
struct MayChange {
    bool shape = true; // maps
    bool colours = false;
    bool weights = true;

    bool anything() const { return shape || colours || weights; }
    friend bool operator==(const MayChange&, const MayChange&) = default;
};

} // namespace document
