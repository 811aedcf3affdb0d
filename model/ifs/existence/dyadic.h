// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace ifs {

// A number m·2^e with integers m and e of any size: sums and products of doubles without rounding.
class Dyadic {
public:
    Dyadic() = default;
    explicit Dyadic(double finite);

    int sign() const { return m_digits.empty() ? 0 : m_isNegative ? -1 : 1; }
    Dyadic operator-() const;
    friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
    friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }
    friend Dyadic operator*(const Dyadic& a, const Dyadic& b);
    friend bool operator==(const Dyadic& a, const Dyadic& b) { return (a - b).sign() == 0; }

    // The number in double, within a relative 2⁻⁵¹; infinite or 0 where it is too large or too small for a
    // double.
    double rounded() const;
    // The same of a/b with b ≠ 0.
    friend double roundedQuotient(const Dyadic& a, const Dyadic& b);

private:
    void trim();
    Dyadic scaledTo(int exponent) const;
    double leading(int& exponent) const;

    std::vector<std::uint32_t> m_digits; // digits of |m|, least significant first, without leading zeros
    int m_exponent = 0;
    bool m_isNegative = false;
};

} // namespace ifs
