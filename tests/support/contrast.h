// SPDX-License-Identifier: MIT
#pragma once

#include <QRgb>

#include <algorithm>
#include <array>
#include <cmath>

namespace support {

// Relative luminance and contrast ratio as the Web Content Accessibility Guidelines 2.1 define them.
inline double luminance(QRgb colour) {
    static const auto linear = [] {
        std::array<double, 256> table{};
        for (std::size_t v = 0; v < table.size(); ++v) {
            const double share = double(v) / 255;
            table[v] = share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
        }
        return table;
    }();
    const auto part = [](int v) { return linear[std::size_t(v)]; };
    return 0.2126 * part(qRed(colour)) + 0.7152 * part(qGreen(colour)) + 0.0722 * part(qBlue(colour));
}

inline double contrast(QRgb a, QRgb b) {
    const auto [darker, lighter] = std::minmax({luminance(a), luminance(b)});
    return (lighter + 0.05) / (darker + 0.05);
}

} // namespace support
