// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <Eigen/Core>

#include <cmath>
#include <vector>

// Figures with their errors, for a person to read.
namespace io {

// 0 where nothing of the value is known.
inline double withoutNoise(double value, double error) {
    return std::abs(value) <= error ? 0 : value;
}

template <class Matrix> Matrix withoutNoise(Matrix values, double error) {
    for (auto& value : values.reshaped())
        value = withoutNoise(value, error);
    return values;
}

// The value with `digits` significant digits, with more where things of that size lie far from 0, but none
// beyond the second digit of the error.
QString figure(double value, double error, double size, int digits);

// A bound with two digits, rounded up.
QString boundText(double bound);

// " ± 2e-07", rounded up, when the error shows in the digits that figure() gives to one of the values, or,
// where all of them are noise, of the size of things; else nothing.
QString errorNote(const std::vector<double>& values, double error, double size, int digits);

// Returns true if the error leaves nothing of a figure of that size.
inline bool isWorthless(double error, double size) {
    return !(error < size) && error > 0;
}

} // namespace io
