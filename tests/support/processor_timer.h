// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/processor_clock.h"

#include <QtGlobal>

namespace support {

/// A stopwatch of the processor time of this process, which other programs on the machine do not stretch.
class ProcessorTimer {
public:
    /// Milliseconds since it was made.
    qint64 elapsed() const { return qint64(1000 * (ifs::ProcessorClock::now() - m_start).count()); }

private:
    const ifs::ProcessorClock::time_point m_start = ifs::ProcessorClock::now();
};

} // namespace support
