// SPDX-License-Identifier: MIT
#include "attractor/colour/srgb_transfer.h"

#include "attractor/arithmetic/arithmetic.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace attractor {

double linearFromEncoded(double code) {
    return code <= 0.04045 ? code / 12.92 : power((code + 0.055) / 1.055, 2.4);
}

double encodedFromLinear(double linear) {
    return linear <= 0.0031308 ? linear * 12.92 : 1.055 * power(linear, 1 / 2.4) - 0.055;
}

double linearLight(std::uint8_t code) {
    static const std::array<double, 256> table = [] {
        std::array<double, 256> values{};
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = linearFromEncoded(static_cast<double>(i) / 255);
        return values;
    }();
    return table[code];
}

namespace {

std::uint8_t roundedCode(double linear) {
    return static_cast<std::uint8_t>(std::min(encodedFromLinear(linear) * 255 + 0.5, 255.0));
}

// Starts of the codes, and for equal parts of 0 … 1 the code at their starts: two steps instead of a power.
struct CodeTable {
    static constexpr std::size_t parts = 4096;
    std::array<double, 257> begins{}; // last entry unreachable
    std::array<std::uint8_t, parts + 1> codes{};

    CodeTable() {
        for (std::size_t code = 1; code < 256; ++code) {
            double low = begins[code - 1], high = 1; // the code of `high` is as large, that of `low` is not
            for (double middle = (low + high) / 2; low < middle && middle < high; middle = (low + high) / 2)
                (roundedCode(middle) >= code ? high : low) = middle;
            begins[code] = high;
        }
        begins[256] = 2;
        for (std::size_t i = 0; i <= parts; ++i)
            codes[i] = roundedCode(static_cast<double>(i) / parts);
    }
};

} // namespace

std::uint8_t encoded(double linear) {
    static const CodeTable table;
    if (!(linear > 0)) return 0;
    if (linear >= 1) return 255;
    std::uint8_t code = table.codes[static_cast<std::size_t>(linear * CodeTable::parts)];
    while (linear >= table.begins[code + 1U])
        ++code;
    return code;
}

} // namespace attractor
