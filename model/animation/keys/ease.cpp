// SPDX-License-Identifier: MIT
#include "animation/keys/ease.h"

#include <algorithm>
#include <cmath>

namespace animation {

namespace {

// A coordinate of the curve at its parameter.
double bezier(double first, double second, double s) {
    const double rest = 1 - s;
    return 3 * rest * rest * s * first + 3 * rest * s * s * second + s * s * s;
}

// Returns true if p₀(1−s)² + 2p₁s(1−s) + p₂s² ≥ 0 for 0 ≤ s ≤ 1.
bool isNeverNegative(double p0, double p1, double p2) {
    return p0 >= 0 && p2 >= 0 && (p1 >= 0 || p1 * p1 <= p0 * p2);
}

// Returns true if −K·x′ ≤ y′ ≤ K·x′ all along.
bool isGentle(const Ease& ease) {
    const auto holds = [&](double sign) {
        return isNeverNegative(maxSlope * ease.x1 - sign * ease.y1,
                               maxSlope * (ease.x2 - ease.x1) - sign * (ease.y2 - ease.y1),
                               maxSlope * (1 - ease.x2) - sign * (1 - ease.y2));
    };
    return holds(1) && holds(-1);
}

double onCurve(const Ease& ease, double u) {
    double low = 0, high = 1;
    for (;;) {
        const double s = (low + high) / 2;
        if (s <= low || s >= high) break; // no double between the bounds
        (bezier(ease.x1, ease.x2, s) < u ? low : high) = s;
    }
    return std::clamp(bezier(ease.y1, ease.y2, high), 0.0, 1.0);
}

} // namespace

double eased(const Ease& ease, double u) {
    if (!(u > 0)) return 0;
    if (u >= 1) return 1;
    switch (ease.kind) {
    case Ease::Kind::Hold:
        return 0;
    case Ease::Kind::Linear:
    case Ease::Kind::Smooth:
        break;
    case Ease::Kind::In:
        return u * u;
    case Ease::Kind::Out:
        return u * (2 - u);
    case Ease::Kind::Both:
        return u * u * (3 - 2 * u);
    case Ease::Kind::Cubic:
        return onCurve(ease, u);
    }
    return u;
}

bool isValid(const Ease& ease) {
    if (ease.kind != Ease::Kind::Cubic) return true;
    const auto isShare = [](double number) { return number >= 0 && number <= 1; };
    return isShare(ease.x1) && isShare(ease.y1) && isShare(ease.x2) && isShare(ease.y2) && isGentle(ease);
}

Ease cubicEase(double x1, double y1, double x2, double y2) {
    const auto share = [](double number) { return std::clamp(number, 0.0, 1.0); };
    const Ease wanted{Ease::Kind::Cubic, share(x1), share(y1), share(x2), share(y2)};
    if (isGentle(wanted)) return wanted;
    const auto drawn = [&](double keep) {
        const auto between = [keep](double handle, double straight) {
            return keep * handle + (1 - keep) * straight;
        };
        return Ease{Ease::Kind::Cubic, between(wanted.x1, 1.0 / 3), between(wanted.y1, 1.0 / 3),
                    between(wanted.x2, 2.0 / 3), between(wanted.y2, 2.0 / 3)};
    };
    constexpr int halvings = 50;
    double gentle = 0, steep = 1; // the handles of gentle curves are a convex set
    for (int n = 0; n < halvings; ++n) {
        const double middle = (gentle + steep) / 2;
        (isGentle(drawn(middle)) ? gentle : steep) = middle;
    }
    return drawn(gentle);
}

} // namespace animation
