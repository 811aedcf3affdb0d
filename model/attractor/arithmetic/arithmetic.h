// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

// Functions that may decide a pixel: only + − × ÷ and bit operations, so that every machine and C library
// gives the same bits. Relative error about 1e-15.
namespace attractor {

double naturalLogarithm(double x); // −745 for x ≤ 0
double exponential(double x);
double power(double base, double exponent); // 0 for base ≤ 0
double sineOfDegrees(double angle);         // exact at multiples of 90°; 0 for angles that are not finite
double cosineOfDegrees(double angle);

// SplitMix64: turns counters and keys into well-mixed numbers.
constexpr std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
}

} // namespace attractor
