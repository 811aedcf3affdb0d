// SPDX-License-Identifier: MIT
#include "ifs/dimension/measure.h"

#include "ifs/dimension/dimension.h"

#include <algorithm>
#include <cmath>

namespace ifs {

double entropy(std::span<const double> probabilities) {
    double result = 0;
    for (const double p : probabilities)
        result -= p * std::log(p);
    return result + 0.0; // never −0
}

template <int Dim> std::optional<double> lyapunovExponent(const ActiveMaps<Dim>& active) {
    const auto ratios = similarityRatios<Dim>(active.maps);
    if (!ratios) return std::nullopt;
    double result = 0;
    for (std::size_t i = 0; i < ratios->size(); ++i)
        result += active.probabilities[i] * std::log((*ratios)[i]);
    return result;
}

template <int Dim> std::optional<double> measureDimension(const ActiveMaps<Dim>& active) {
    const auto exponent = lyapunovExponent(active);
    if (!exponent || !(*exponent < 0)) return std::nullopt;
    return std::min<double>(Dim, entropy(active.probabilities) / -*exponent);
}

template std::optional<double> lyapunovExponent(const ActiveMaps<2>&);
template std::optional<double> lyapunovExponent(const ActiveMaps<3>&);
template std::optional<double> measureDimension(const ActiveMaps<2>&);
template std::optional<double> measureDimension(const ActiveMaps<3>&);

} // namespace ifs
