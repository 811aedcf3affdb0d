// SPDX-License-Identifier: MIT
#include "attractor/arithmetic.h"

#include <bit>

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
    double sum = 0;
    for (int odd = 21; odd >= 1; odd -= 2)
        sum = sum * square + 1.0 / odd;
    return exponent * ln2High + (2 * z * sum + exponent * ln2Low);
}

double exponential(double x) {
    if (x < -700) return 0;
    if (x > 700) x = 700;
    const double turns = x / 0.6931471805599453;
    const int k = static_cast<int>(turns < 0 ? turns - 0.5 : turns + 0.5);
    const double rest = (x - k * ln2High) - k * ln2Low;
    double sum = 1;
    for (int n = 14; n >= 1; --n)
        sum = 1 + sum * rest / n;
    return sum * std::bit_cast<double>(static_cast<std::uint64_t>(k + 1023) << 52);
}

double power(double base, double exponent) {
    return base > 0 ? exponential(exponent * naturalLogarithm(base)) : 0;
}

} // namespace attractor
