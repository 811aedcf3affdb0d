// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <pybind11/numpy.h>

#include <memory>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

// Between arrays of NumPy and the values of the model.
namespace python {

using Numbers = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

// An array that owns the memory of the vector, without copying it.
template <class Number>
pybind11::array_t<Number> arrayOf(std::vector<Number>&& numbers, std::vector<pybind11::ssize_t> shape) {
    auto owned = std::make_unique<std::vector<Number>>(std::move(numbers));
    Number* const data = owned->data();
    const pybind11::capsule owner(owned.release(),
                                  [](void* memory) { delete static_cast<std::vector<Number>*>(memory); });
    return pybind11::array_t<Number>(std::move(shape), data, owner);
}

template <int Dim> Numbers arrayOf(const ifs::Vector<Dim>& vector) {
    return Numbers(Dim, vector.data());
}
template <int Dim> Numbers arrayOf(std::span<const ifs::Vector<Dim>> points) { // shape (n, Dim)
    std::vector<double> numbers;
    numbers.reserve(points.size() * Dim);
    for (const auto& point : points)
        numbers.insert(numbers.end(), point.data(), point.data() + Dim);
    return arrayOf(std::move(numbers), {pybind11::ssize_t(points.size()), Dim});
}
template <int Dim> Numbers matrixArray(const ifs::Matrix<Dim>& matrix) {
    std::vector<double> numbers;
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j)
            numbers.push_back(matrix(i, j));
    return arrayOf(std::move(numbers), {Dim, Dim});
}

// (maps, Dim, Dim + 1): the linear part, then the translation as the last column.
template <int Dim> Numbers arrayOf(std::span<const ifs::AffineMap<Dim>> maps);
template <int Dim> std::vector<ifs::AffineMap<Dim>> mapsFrom(const Numbers& array);
// One map: (Dim, Dim + 1), or (Dim, Dim) without a translation.
template <int Dim> ifs::AffineMap<Dim> mapFrom(const Numbers& array);

template <int Dim> ifs::Vector<Dim> vectorFrom(const Numbers& array, const char* what);
template <int Dim> std::vector<ifs::Vector<Dim>> pointsFrom(const Numbers& array, const char* what);

} // namespace python
