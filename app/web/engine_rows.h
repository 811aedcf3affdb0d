// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/iterated_function_system.h"

#include <algorithm>

// Maps and points as the numbers of the interface.
namespace web {

template <int Dim> constexpr int rowLength = Dim*(Dim + 1) + 1; // with the weight

template <int Dim> ifs::Vector<Dim> vectorAt(const double* numbers) {
    return Eigen::Map<const ifs::Vector<Dim>>(numbers);
}

template <int Dim> ifs::AffineMap<Dim> mapAt(const double* numbers) {
    ifs::AffineMap<Dim> map;
    for (int row = 0; row < Dim; ++row)
        for (int column = 0; column < Dim; ++column)
            map.linear(row, column) = *numbers++;
    map.translation = vectorAt<Dim>(numbers);
    return map;
}

template <class Numbers> double* written(const Numbers& vector, double* to) {
    return std::copy_n(vector.data(), vector.size(), to);
}

template <int Dim> double* written(const ifs::AffineMap<Dim>& map, double* to) {
    for (int row = 0; row < Dim; ++row)
        for (int column = 0; column < Dim; ++column)
            *to++ = map.linear(row, column);
    return written(map.translation, to);
}

} // namespace web
