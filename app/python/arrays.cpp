// SPDX-License-Identifier: MIT
#include "python/arrays.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace python {

namespace {

[[noreturn]] void refuse(const std::string& sentence) {
    throw std::invalid_argument(sentence);
}

void checkFinite(const Numbers& array, const char* what) {
    const double* const begin = array.data();
    if (!std::all_of(begin, begin + array.size(), [](double number) { return std::isfinite(number); }))
        refuse(std::string(what) + ": every number must be finite");
}

template <int Dim> ifs::AffineMap<Dim> mapAt(const double* numbers, bool hasTranslation) {
    ifs::AffineMap<Dim> map;
    for (int i = 0; i < Dim; ++i) {
        for (int j = 0; j < Dim; ++j)
            map.linear(i, j) = *numbers++;
        if (hasTranslation) map.translation[i] = *numbers++;
    }
    return map;
}

} // namespace

template <int Dim> Numbers arrayOf(std::span<const ifs::AffineMap<Dim>> maps) {
    std::vector<double> numbers;
    numbers.reserve(maps.size() * Dim * (Dim + 1));
    for (const auto& map : maps)
        for (int i = 0; i < Dim; ++i) {
            for (int j = 0; j < Dim; ++j)
                numbers.push_back(map.linear(i, j));
            numbers.push_back(map.translation[i]);
        }
    return arrayOf(std::move(numbers), {pybind11::ssize_t(maps.size()), Dim, Dim + 1});
}

template <int Dim> std::vector<ifs::AffineMap<Dim>> mapsFrom(const Numbers& array) {
    if (array.ndim() != 3 || array.shape(1) != Dim || array.shape(2) != Dim + 1)
        refuse("maps: the shape must be (maps, 2, 3) in the plane and (maps, 3, 4) in space");
    checkFinite(array, "maps");
    std::vector<ifs::AffineMap<Dim>> maps;
    for (pybind11::ssize_t k = 0; k < array.shape(0); ++k)
        maps.push_back(mapAt<Dim>(array.data() + k * Dim * (Dim + 1), true));
    return maps;
}

template <int Dim> ifs::AffineMap<Dim> mapFrom(const Numbers& array) {
    const bool isMatrix = array.ndim() == 2 && array.shape(0) == Dim;
    if (!isMatrix || (array.shape(1) != Dim && array.shape(1) != Dim + 1))
        refuse("a map: the shape must be (d, d) or, with a translation as the last column, (d, d + 1), where "
               "d = " +
               std::to_string(Dim));
    checkFinite(array, "a map");
    return mapAt<Dim>(array.data(), array.shape(1) == Dim + 1);
}

template <int Dim> ifs::Vector<Dim> vectorFrom(const Numbers& array, const char* what) {
    if (array.ndim() != 1 || array.shape(0) != Dim)
        refuse(std::string(what) + ": the shape must be (" + std::to_string(Dim) + ",)");
    checkFinite(array, what);
    return Eigen::Map<const ifs::Vector<Dim>>(array.data());
}

template <int Dim> std::vector<ifs::Vector<Dim>> pointsFrom(const Numbers& array, const char* what) {
    if (array.ndim() != 2 || array.shape(1) != Dim)
        refuse(std::string(what) + ": the shape must be (n, " + std::to_string(Dim) + ")");
    checkFinite(array, what);
    std::vector<ifs::Vector<Dim>> points;
    for (pybind11::ssize_t k = 0; k < array.shape(0); ++k)
        points.push_back(Eigen::Map<const ifs::Vector<Dim>>(array.data() + k * Dim));
    return points;
}

template Numbers arrayOf(std::span<const ifs::AffineMap<2>>);
template Numbers arrayOf(std::span<const ifs::AffineMap<3>>);
template std::vector<ifs::AffineMap<2>> mapsFrom<2>(const Numbers&);
template std::vector<ifs::AffineMap<3>> mapsFrom<3>(const Numbers&);
template ifs::AffineMap<2> mapFrom<2>(const Numbers&);
template ifs::AffineMap<3> mapFrom<3>(const Numbers&);
template ifs::Vector<2> vectorFrom<2>(const Numbers&, const char*);
template ifs::Vector<3> vectorFrom<3>(const Numbers&, const char*);
template std::vector<ifs::Vector<2>> pointsFrom<2>(const Numbers&, const char*);
template std::vector<ifs::Vector<3>> pointsFrom<3>(const Numbers&, const char*);

} // namespace python
