// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace ifs {

// A number that depends on a point of the plane, with its derivatives there up to the third. Only + − × ÷ and
// √, so that every machine gives the same bits.
struct Jet {
    double value = 0;
    double x = 0, y = 0;
    double xx = 0, xy = 0, yy = 0;
    double xxx = 0, xxy = 0, xyy = 0, yyy = 0;

    constexpr Jet() = default;
    constexpr Jet(double constant) : value(constant) {} // NOLINT: numbers convert
    constexpr Jet(double v, double dx, double dy) : value(v), x(dx), y(dy) {}

    friend constexpr Jet operator+(const Jet& a, const Jet& b) { return combined(a, 1, b); }
    friend constexpr Jet operator-(const Jet& a, const Jet& b) { return combined(a, -1, b); }
    friend constexpr Jet operator*(const Jet& a, double k) { return combined({}, k, a); }
    friend constexpr Jet operator*(const Jet& a, const Jet& b) { // Leibniz
        Jet p;
        p.value = a.value * b.value;
        p.x = a.value * b.x + a.x * b.value;
        p.y = a.value * b.y + a.y * b.value;
        p.xx = a.value * b.xx + 2 * (a.x * b.x) + a.xx * b.value;
        p.xy = a.value * b.xy + (a.x * b.y + a.y * b.x) + a.xy * b.value;
        p.yy = a.value * b.yy + 2 * (a.y * b.y) + a.yy * b.value;
        p.xxx = a.value * b.xxx + 3 * (a.x * b.xx + a.xx * b.x) + a.xxx * b.value;
        p.xxy = a.value * b.xxy + (a.y * b.xx + a.xx * b.y) + 2 * (a.x * b.xy + a.xy * b.x) + a.xxy * b.value;
        p.xyy = a.value * b.xyy + (a.x * b.yy + a.yy * b.x) + 2 * (a.y * b.xy + a.xy * b.y) + a.xyy * b.value;
        p.yyy = a.value * b.yyy + 3 * (a.y * b.yy + a.yy * b.y) + a.yyy * b.value;
        return p;
    }
    friend constexpr Jet operator/(const Jet& a, const Jet& b) { // q·b = a, one derivative after the other
        const double k = 1 / b.value;
        Jet q;
        q.value = a.value * k;
        q.x = (a.x - q.value * b.x) * k;
        q.y = (a.y - q.value * b.y) * k;
        q.xx = (a.xx - q.value * b.xx - 2 * (q.x * b.x)) * k;
        q.xy = (a.xy - q.value * b.xy - (q.x * b.y + q.y * b.x)) * k;
        q.yy = (a.yy - q.value * b.yy - 2 * (q.y * b.y)) * k;
        q.xxx = (a.xxx - q.value * b.xxx - 3 * (q.x * b.xx + q.xx * b.x)) * k;
        q.xxy = (a.xxy - q.value * b.xxy - (q.y * b.xx + q.xx * b.y) - 2 * (q.x * b.xy + q.xy * b.x)) * k;
        q.xyy = (a.xyy - q.value * b.xyy - (q.x * b.yy + q.yy * b.x) - 2 * (q.y * b.xy + q.xy * b.y)) * k;
        q.yyy = (a.yyy - q.value * b.yyy - 3 * (q.y * b.yy + q.yy * b.y)) * k;
        return q;
    }
    friend Jet sqrt(const Jet& a) { // r·r = a
        Jet r;
        r.value = std::sqrt(a.value);
        const double k = 0.5 / r.value;
        r.x = k * a.x;
        r.y = k * a.y;
        r.xx = k * (a.xx - 2 * (r.x * r.x));
        r.xy = k * (a.xy - 2 * (r.x * r.y));
        r.yy = k * (a.yy - 2 * (r.y * r.y));
        r.xxx = k * (a.xxx - 6 * (r.x * r.xx));
        r.xxy = k * (a.xxy - 2 * (r.y * r.xx) - 4 * (r.x * r.xy));
        r.xyy = k * (a.xyy - 2 * (r.x * r.yy) - 4 * (r.y * r.xy));
        r.yyy = k * (a.yyy - 6 * (r.y * r.yy));
        return r;
    }

private:
    static constexpr Jet combined(const Jet& a, double k, const Jet& b) {
        Jet s;
        s.value = a.value + k * b.value;
        s.x = a.x + k * b.x;
        s.y = a.y + k * b.y;
        s.xx = a.xx + k * b.xx;
        s.xy = a.xy + k * b.xy;
        s.yy = a.yy + k * b.yy;
        s.xxx = a.xxx + k * b.xxx;
        s.xxy = a.xxy + k * b.xxy;
        s.xyy = a.xyy + k * b.xyy;
        s.yyy = a.yyy + k * b.yyy;
        return s;
    }
};

constexpr double valueOf(double number) {
    return number;
}
constexpr double valueOf(const Jet& number) {
    return number.value;
}

} // namespace ifs
