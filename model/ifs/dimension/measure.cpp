// SPDX-License-Identifier: MIT
#include "ifs/dimension/measure.h"

#include "ifs/dimension/dimension.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ifs {

double entropy(std::span<const double> probabilities) {
    double result = 0;
    for (const double p : probabilities)
        result -= p * std::log(p);
    return result + 0.0; // avoids −0
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
    return entropy(active.probabilities) / -*exponent;
}

template <int Dim> std::optional<DimensionSpectrum> dimensionSpectrum(const ActiveMaps<Dim>& active) {
    const auto ratios = similarityRatios<Dim>(active.maps);
    if (!ratios) return std::nullopt;
    const auto capacity = moranDimension(*ratios);
    const auto exponent = lyapunovExponent(active);
    if (!capacity || !exponent || !(*exponent < 0)) return std::nullopt;
    DimensionSpectrum result{.capacity = *capacity,
                             .information = entropy(active.probabilities) / -*exponent};
    result.least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ratios->size(); ++i)
        result.least = std::min(result.least, std::log(active.probabilities[i]) / std::log((*ratios)[i]));
    double low = 0, high = *capacity; // D_q decreases with q
    constexpr int halvings = 100;
    for (int k = 0; k < halvings; ++k) {
        const double middle = (low + high) / 2;
        double sum = 0;
        for (std::size_t i = 0; i < ratios->size(); ++i)
            sum += active.probabilities[i] * active.probabilities[i] * std::pow((*ratios)[i], -middle);
        (sum < 1 ? low : high) = middle;
    }
    result.correlation = (low + high) / 2;
    return result;
}

template std::optional<DimensionSpectrum> dimensionSpectrum(const ActiveMaps<2>&);
template std::optional<DimensionSpectrum> dimensionSpectrum(const ActiveMaps<3>&);
template std::optional<double> lyapunovExponent(const ActiveMaps<2>&);
template std::optional<double> lyapunovExponent(const ActiveMaps<3>&);
template std::optional<double> measureDimension(const ActiveMaps<2>&);
template std::optional<double> measureDimension(const ActiveMaps<3>&);

} // namespace ifs
