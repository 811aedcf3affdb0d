// SPDX-License-Identifier: MIT
#include "attractor/solid/bent_word.h"

#include <algorithm>
#include <cmath>

namespace attractor {

namespace {

constexpr std::size_t points = 15; // centre, two for each side, eight corners

double sign(int corner, int side) {
    return (corner >> side & 1) != 0 ? 1 : -1;
}

std::array<ifs::Vector<3>, points> pointsOf(const ifs::AffineMap<3>& word) {
    std::array<ifs::Vector<3>, points> result;
    result[0] = word.translation;
    for (int side = 0; side < 3; ++side) {
        result[std::size_t(2 * side + 1)] = word.translation + word.linear.col(side);
        result[std::size_t(2 * side + 2)] = word.translation - word.linear.col(side);
    }
    for (int k = 0; k < 8; ++k)
        result[std::size_t(7 + k)] = word(ifs::Vector<3>(sign(k, 0), sign(k, 1), sign(k, 2)));
    return result;
}

// The mean of the remainders at the corners times the signs of these sides.
double component(const std::array<double, 8>& rest, int sides) {
    double sum = 0;
    for (int k = 0; k < 8; ++k) {
        double factor = 0.125;
        for (int side = 0; side < 3; ++side)
            if ((sides >> side & 1) != 0) factor *= sign(k, side);
        sum += factor * rest[std::size_t(k)];
    }
    return sum;
}

} // namespace

PixelBend::PixelBend(const ifs::CageDeformation& bend, const ifs::AffineMap<3>& after)
    : fit(after * bend.fit()) {
    for (const ifs::Vector<3>& residual : bend.residuals())
        residuals.emplace_back(after.linear * residual);
}

WordCoordinates::WordCoordinates(const ifs::CageCoordinates& rest, const ifs::AffineMap<3>& word)
    : m_straight(rest.size() * straightTerms), m_bent(rest.size() * bentTerms) {
    constexpr std::array<int, 8> sides{0b110, 0b101, 0b011, 0b000, 0b001, 0b010, 0b100, 0b111};
    const std::vector<double> values = rest.at(pointsOf(word));
    for (std::size_t j = 0; j < rest.size(); ++j) {
        const auto at = [&](std::size_t point) { return values[point * rest.size() + j]; };
        double* straight = m_straight.data() + j * straightTerms;
        float* bent = m_bent.data() + j * bentTerms;
        straight[0] = at(0);
        std::array<double, 3> squares{};
        for (std::size_t side = 0; side < 3; ++side) {
            const double high = at(2 * side + 1), low = at(2 * side + 2);
            straight[1 + side] = (high - low) / 2;
            squares[side] = (high + low) / 2 - at(0);
            bent[side] = float(squares[side]);
        }
        std::array<double, 8> left{};
        for (int k = 0; k < 8; ++k) {
            double& value = left[std::size_t(k)];
            value = at(std::size_t(7 + k)) - at(0);
            for (int side = 0; side < 3; ++side)
                value -= sign(k, side) * straight[1 + side] + squares[std::size_t(side)];
        }
        for (std::size_t k = 0; k < sides.size(); ++k)
            bent[3 + k] = float(component(left, sides[k]));
    }
}

BentWord WordCoordinates::bent(const ifs::AffineMap<3>& word, const PixelBend& bend) const {
    std::array<std::array<double, straightTerms>, 3> straight{};
    std::array<std::array<double, bentTerms>, 3> sums{};
    for (std::size_t j = 0; j < bend.residuals.size(); ++j)
        for (std::size_t row = 0; row < 3; ++row) {
            const double residual = bend.residuals[j][Eigen::Index(row)];
            for (std::size_t k = 0; k < straightTerms; ++k)
                straight[row][k] += m_straight[j * straightTerms + k] * residual;
            for (std::size_t k = 0; k < bentTerms; ++k)
                sums[row][k] += double(m_bent[j * bentTerms + k]) * residual;
        }
    const ifs::AffineMap<3> fitted = bend.fit * word;
    BentWord result;
    for (int row = 0; row < 3; ++row) {
        const std::array<double, bentTerms>& s = sums[std::size_t(row)];
        result.middle[row] = fitted.translation[row] + straight[std::size_t(row)][0];
        for (int side = 0; side < 3; ++side)
            result.linear(row, side) =
                fitted.linear(row, side) + straight[std::size_t(row)][std::size_t(1 + side)];
        result.second[std::size_t(row)] << 2 * s[0], s[5], s[4], //
            s[5], 2 * s[1], s[3],                                //
            s[4], s[3], 2 * s[2];
        double miss = 0;
        for (int k = 0; k < 8; ++k) {
            const double x = sign(k, 0), y = sign(k, 1), z = sign(k, 2);
            miss = std::max(miss, std::abs(s[6] + x * s[7] + y * s[8] + z * s[9] + x * y * z * s[10]));
        }
        result.miss[row] = 2 * miss; // doubled, because cubes along a side vanish at its ends
    }
    return result;
}

} // namespace attractor
