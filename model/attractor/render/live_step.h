// SPDX-License-Identifier: MIT
#pragma once

namespace attractor {

// Coarseness of the pictures of a solid during a gesture: as fine as they can be and still arrive in time.
class LiveStep {
public:
    static constexpr double fluid = 16; // milliseconds per picture
    static constexpr int coarsest = 8;

    int pixels() const { return m_step; } // side in screen pixels of a pixel of the picture
    void took(double milliseconds);       // milliseconds for a picture with pixels() as it is

private:
    static constexpr double usualGrowth = 5;

    int m_step = 2;
    int m_stepBefore = 0; // step of the previous picture; 0: none
    double m_timeBefore = 0;
    double m_growth = usualGrowth; // factor by which the time grows when the step is halved
};

} // namespace attractor
