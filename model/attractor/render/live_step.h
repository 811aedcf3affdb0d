// SPDX-License-Identifier: MIT
#pragma once

namespace attractor {

// Coarseness of the pictures of a solid during a gesture: as fine as they can be and still arrive in time.
class LiveStep {
public:
    static constexpr double fluid = 16; // milliseconds for a picture
    static constexpr int coarsest = 8;

    int pixels() const { return m_step; } // of the screen, each way, for one of the picture
    void took(double milliseconds);       // the picture with so many

private:
    static constexpr double usualGrowth = 5;

    int m_step = 2;
    int m_stepBefore = 0; // of the picture before; 0: there was none
    double m_timeBefore = 0;
    double m_growth = usualGrowth; // how many times as long a picture takes at half of the step
};

} // namespace attractor
