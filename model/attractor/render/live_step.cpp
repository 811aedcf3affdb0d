// SPDX-License-Identifier: MIT
#include "attractor/render/live_step.h"

#include <algorithm>

namespace attractor {

// Some solids take twenty times as long with four times the pixels. Trying this again and again would
// stutter, so measurements are forgotten only slowly.
void LiveStep::took(double milliseconds) {
    constexpr double kept = 0.99; // share kept per picture; one half after 70 pictures
    if (m_stepBefore == 2 * m_step)
        m_growth = std::max(usualGrowth, milliseconds / m_timeBefore);
    else if (2 * m_stepBefore == m_step)
        m_growth = std::max(usualGrowth, m_timeBefore / milliseconds);
    else
        m_growth = usualGrowth + kept * (m_growth - usualGrowth);
    m_stepBefore = m_step;
    m_timeBefore = milliseconds;
    if (milliseconds > fluid)
        m_step = std::min(2 * m_step, coarsest);
    else if (milliseconds * m_growth < fluid)
        m_step = std::max(m_step / 2, 1);
}

} // namespace attractor
