// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace ifs {

// A number (p + q√d)/n with 64-bit integers p, q, n and d without rounding: the rationals and square roots
// that people type. Sums and products that need another kind of number, or longer integers, have no value,
// and nothing that is made of them has one.
class Surd {
public:
    Surd() = default; // 0
    Surd(std::int64_t whole) : m_whole(whole) {}

    static Surd none();
    static Surd stored(double number);            // without value if it has too many digits
    static Surd decimal(std::string_view digits); // exact value of the digits: "0.25", "1e-3"
    static Surd root(const Surd& number);         // square root of a rational ≥ 0

    bool hasValue() const { return m_denominator != 0; }
    bool isZero() const { return hasValue() && m_whole == 0 && m_factor == 0; }
    int sign() const; // sign of the value
    double rounded() const;
    // The value of a whole number; nullopt for any other.
    std::optional<std::int64_t> whole() const;

    friend Surd operator-(const Surd& a);
    friend Surd operator+(const Surd& a, const Surd& b);
    friend Surd operator-(const Surd& a, const Surd& b) { return a + -b; }
    friend Surd operator*(const Surd& a, const Surd& b);
    friend Surd operator/(const Surd& a, const Surd& b); // without value for b = 0
    // Numbers without value differ from all others.
    friend bool operator==(const Surd& a, const Surd& b);

private:
    __extension__ using Wide = __int128;
    static Surd made(Wide whole, Wide factor, std::int64_t radicand, Wide denominator);
    static bool isWide(Wide number);
    bool isRational() const { return m_factor == 0; }

    std::int64_t m_whole = 0, m_factor = 0;
    std::int64_t m_radicand = 0;    // square-free, at least 2; 0 for rationals
    std::int64_t m_denominator = 1; // > 0; 0: without value
};

} // namespace ifs
