// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/decomposition.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>

namespace document {

// Random numbers that are the same on every machine: the distributions of the standard library differ between
// libraries.
class Chance {
public:
    explicit Chance(std::uint64_t seed) : m_engine(seed) {}

    double between(double low, double high) {
        return low + (high - low) * double(m_engine() >> 11) * 0x1p-53;
    }
    bool comes(double probability) { return between(0, 1) < probability; }
    // The sum of four is near enough to the normal distribution; deviation 1.
    double normal() {
        constexpr double deviation = 0.57735026918962576; // standard deviation of a number between −1 and 1
        double sum = 0;
        for (int i = 0; i < 4; ++i)
            sum += between(-1, 1);
        return sum / (2 * deviation);
    }
    std::size_t below(std::size_t count) {
        return std::min(count - 1, std::size_t(between(0, double(count))));
    }

    template <int Dim> ifs::Vector<Dim> vector() { // coordinates between −1 and 1
        ifs::Vector<Dim> result;
        for (Eigen::Index i = 0; i < Dim; ++i)
            result[i] = between(-1, 1);
        return result;
    }

    // A rotation by this angle; in space, about a random axis.
    template <int Dim> ifs::Matrix<Dim> rotation(double angle) {
        if constexpr (Dim == 2) {
            ifs::Matrix<2> matrix;
            matrix << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
            return matrix;
        } else {
            ifs::Vector<3> axis(normal(), normal(), normal());
            if (!(axis.norm() > 0)) axis = ifs::Vector<3>::UnitX();
            return ifs::rotationAbout({axis, angle});
        }
    }
    template <int Dim> ifs::Matrix<Dim> anyRotation() {
        return rotation<Dim>(between(-1, 1) * std::numbers::pi);
    }

private:
    std::mt19937_64 m_engine;
};

} // namespace document
