// SPDX-License-Identifier: MIT
#pragma once

namespace attractor {

// An unevaluated sum of two doubles: about 31 digits. Needs arithmetic without fused operations.
struct DoubleDouble {
    double high = 0;
    double low = 0;

    constexpr DoubleDouble() = default;
    constexpr DoubleDouble(double value) : high(value) {} // NOLINT: numbers convert
    constexpr DoubleDouble(double h, double l) : high(h), low(l) {}
    explicit constexpr operator double() const { return high + low; }

    friend constexpr DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
        const double sum = a.high + b.high;
        const double part = sum - a.high;
        const double error = (a.high - (sum - part)) + (b.high - part) + (a.low + b.low);
        const double high = sum + error;
        return {high, error - (high - sum)};
    }
    friend constexpr DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }
    friend constexpr DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
    friend constexpr DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
        const double product = a.high * b.high;
        const auto [aHigh, aLow] = halves(a.high);
        const auto [bHigh, bLow] = halves(b.high);
        const double error = (((aHigh * bHigh - product) + aHigh * bLow + aLow * bHigh) + aLow * bLow) +
                             (a.high * b.low + a.low * b.high);
        const double high = product + error;
        return {high, error - (high - product)};
    }

private:
    struct Halves {
        double high;
        double low;
    };
    static constexpr Halves halves(double x) { // Veltkamp: 26 bits each
        const double scaled = 134217729.0 * x;
        const double high = scaled - (scaled - x);
        return {high, x - high};
    }
};

} // namespace attractor
