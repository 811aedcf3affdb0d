// SPDX-License-Identifier: MIT
#include "panels/timeline/ruler_scale.h"

#include "widgets/numbers/number_text.h"

#include <algorithm>
#include <cmath>

namespace view {

int rulerStep(double wanted, const animation::FrameRate& rate, RulerUnit unit) {
    double step = unit == RulerUnit::Seconds ? double(rate.frames) / rate.seconds : 1;
    for (int i = 0; step < wanted; ++i)
        step *= i % 3 == 1 ? 2.5 : 2;
    return std::max(1, int(std::lround(step)));
}

QString rulerText(int frame, const animation::FrameRate& rate, RulerUnit unit) {
    return unit == RulerUnit::Frames ? QString::number(frame)
                                     : roundedNumber(double(frame) * rate.seconds / rate.frames, 2);
}

} // namespace view
