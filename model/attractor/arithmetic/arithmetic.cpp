// SPDX-License-Identifier: MIT
#include "attractor/arithmetic/arithmetic.h"

#include <bit>
#include <initializer_list>

namespace attractor {

namespace {
constexpr double ln2High = 0x1.62e42fefa38p-1; // 11 trailing zero bits: k·ln2High is exact
constexpr double ln2Low = 0x1.ef35793c7673p-45;
constexpr double sqrt2 = 1.4142135623730951;
} // namespace

double naturalLogarithm(double x) {
    if (!(x > 1e-300)) return -745;
    const auto bits = std::bit_cast<std::uint64_t>(x);
    int exponent = static_cast<int>(bits >> 52) - 1023;
    double mantissa = std::bit_cast<double>((bits & 0xfffffffffffffU) | 0x3ff0000000000000U);
    if (mantissa > sqrt2) {
        mantissa /= 2;
        ++exponent;
    }
    // ln m = 2 artanh z, z = (m − 1)/(m + 1), |z| ≤ 0.172
    const double z = (mantissa - 1) / (mantissa + 1);
    const double square = z * z;
    double sum = 1.0 / 21;
    for (const double coefficient :
         {1.0 / 19, 1.0 / 17, 1.0 / 15, 1.0 / 13, 1.0 / 11, 1.0 / 9, 1.0 / 7, 1.0 / 5, 1.0 / 3, 1.0})
        sum = sum * square + coefficient;
    return exponent * ln2High + (2 * z * sum + exponent * ln2Low);
}

double exponential(double x) {
    if (x < -700) return 0;
    if (x > 700) x = 700;
    const double turns = x / 0.6931471805599453;
    const int k = static_cast<int>(turns < 0 ? turns - 0.5 : turns + 0.5);
    const double rest = (x - k * ln2High) - k * ln2Low;
    double sum = 1.0 / 87178291200; // 1/14!
    for (const double coefficient :
         {1.0 / 6227020800, 1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320,
          1.0 / 5040, 1.0 / 720, 1.0 / 120, 1.0 / 24, 1.0 / 6, 1.0 / 2, 1.0, 1.0})
        sum = sum * rest + coefficient;
    return sum * std::bit_cast<double>(static_cast<std::uint64_t>(k + 1023) << 52);
}

double power(double base, double exponent) {
    return base > 0 ? exponential(exponent * naturalLogarithm(base)) : 0;
}

double sineOfDegrees(double angle) {
    constexpr double farthest = 1e15;
    if (!(angle > -farthest && angle < farthest)) return 0;
    const double quarters = angle / 90;
    const auto quarter = static_cast<std::int64_t>(quarters < 0 ? quarters - 0.5 : quarters + 0.5);
    const double x = (angle - 90.0 * static_cast<double>(quarter)) * 0.017453292519943295; // |x| ≤ π/4
    const double square = x * x;
    const bool isEven = (quarter & 1) == 0;
    // Taylor series from the last term to the first, for sin x and cos x alternately.
    double sum = 1;
    for (int n = isEven ? 19 : 18; n > 1; n -= 2)
        sum = 1 - sum * square / (n * (n - 1));
    const double value = isEven ? sum * x : sum;
    return (quarter & 2) == 0 ? value : -value;
}

double cosineOfDegrees(double angle) {
    return sineOfDegrees(angle < 0 ? angle + 90 : 90 - angle);
}

} // namespace attractor
