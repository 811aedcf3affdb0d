// SPDX-License-Identifier: MIT
#include "ifs/numbers/surd.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ifs {

namespace {

// Products of two of these, and the sum of three such products, are shorter than 128 bits.
constexpr std::int64_t longest = std::int64_t(1) << 62;

__extension__ using Long = __int128;

Long magnitude(Long number) {
    return number < 0 ? -number : number;
}

Long divisor(Long a, Long b) {
    a = magnitude(a);
    b = magnitude(b);
    while (b != 0) {
        const Long rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

} // namespace

bool Surd::isWide(Wide number) {
    return magnitude(number) > longest;
}

Surd Surd::none() {
    Surd result;
    result.m_denominator = 0;
    return result;
}

Surd Surd::made(Wide whole, Wide factor, std::int64_t radicand, Wide denominator) {
    if (denominator == 0) return none();
    const Wide common = divisor(divisor(whole, factor), denominator) * (denominator < 0 ? -1 : 1);
    whole /= common;
    factor /= common;
    denominator /= common;
    if (isWide(whole) || isWide(factor) || isWide(denominator)) return none();
    Surd result;
    result.m_whole = std::int64_t(whole);
    result.m_factor = std::int64_t(factor);
    result.m_radicand = factor == 0 ? 0 : radicand;
    result.m_denominator = std::int64_t(denominator);
    return result;
}

Surd Surd::stored(double number) {
    constexpr int bits = std::numeric_limits<double>::digits, most = 61;
    if (!std::isfinite(number)) return none();
    int exponent = 0;
    auto digits = std::int64_t(std::ldexp(std::frexp(number, &exponent), bits));
    exponent -= bits;
    for (; digits != 0 && digits % 2 == 0; ++exponent)
        digits /= 2;
    if (digits == 0) return {};
    if (exponent < -most || exponent > most) return none();
    const Wide power = Wide(1) << std::abs(exponent);
    return exponent < 0 ? made(digits, 0, 0, power) : made(digits * power, 0, 0, 1);
}

Surd Surd::decimal(std::string_view digits) {
    Wide whole = 0;
    int places = 0;
    std::size_t i = 0;
    for (bool isBehind = false; i < digits.size() && digits[i] != 'e' && digits[i] != 'E'; ++i) {
        if (digits[i] == '.') {
            isBehind = true;
            continue;
        }
        if (digits[i] < '0' || digits[i] > '9' || isWide(whole)) return none();
        whole = 10 * whole + (digits[i] - '0');
        places += isBehind ? 1 : 0;
    }
    int exponent = 0;
    if (i < digits.size()) {
        const bool isNegative = i + 1 < digits.size() && digits[i + 1] == '-';
        for (i += isNegative || (i + 1 < digits.size() && digits[i + 1] == '+') ? 2 : 1; i < digits.size();
             ++i) {
            if (digits[i] < '0' || digits[i] > '9' || exponent > 100) return none();
            exponent = 10 * exponent + (digits[i] - '0');
        }
        if (isNegative) exponent = -exponent;
    }
    Surd result = made(whole, 0, 0, 1);
    for (exponent -= places; exponent != 0 && result.hasValue(); exponent += exponent < 0 ? 1 : -1)
        result = exponent < 0 ? result / Surd(10) : result * Surd(10);
    return result;
}

// √(p/n) = √(pn)/n, with the squares taken out of pn. Once the factors up to the cube root are divided out,
// two are left at most.
Surd Surd::root(const Surd& number) {
    constexpr std::int64_t most = std::int64_t(1) << 40; // limit for 10⁴ divisions
    if (!number.hasValue() || !number.isRational() || number.m_whole < 0) return none();
    const Wide product = Wide(number.m_whole) * number.m_denominator;
    if (product > most) return none();
    auto rest = std::int64_t(product);
    if (rest == 0) return {};
    std::int64_t outside = 1, under = 1;
    for (std::int64_t k = 2; k * k * k <= rest; ++k)
        for (int times = 1; rest % k == 0; ++times) {
            rest /= k;
            (times % 2 == 0 ? outside : under) *= k;
            if (times % 2 == 0) under /= k;
        }
    const auto last = std::int64_t(std::llround(std::sqrt(double(rest))));
    (last * last == rest ? outside : under) *= last * last == rest ? last : rest;
    return under == 1 ? made(outside, 0, 0, number.m_denominator)
                      : made(0, outside, under, number.m_denominator);
}

int Surd::sign() const {
    const int ofWhole = m_whole < 0   ? -1
                        : m_whole > 0 ? 1
                                      : 0,
              ofRoot = m_factor < 0   ? -1
                       : m_factor > 0 ? 1
                                      : 0;
    if (ofWhole == ofRoot || ofRoot == 0) return ofWhole;
    if (ofWhole == 0) return ofRoot;
    // p² ≠ q²d, since d is square-free.
    return Wide(m_whole) * m_whole / m_radicand < Wide(m_factor) * m_factor ? ofRoot : ofWhole;
}

double Surd::rounded() const {
    if (!hasValue()) return std::numeric_limits<double>::quiet_NaN();
    const long double root = isRational() ? 0 : std::sqrt((long double)m_radicand);
    return double(((long double)m_whole + (long double)m_factor * root) / (long double)m_denominator);
}

std::optional<std::int64_t> Surd::whole() const {
    return m_denominator == 1 && isRational() ? std::optional(m_whole) : std::nullopt;
}

Surd operator-(const Surd& a) {
    using Wide = Surd::Wide;
    return a.hasValue() ? Surd::made(-Wide(a.m_whole), -Wide(a.m_factor), a.m_radicand, a.m_denominator)
                        : Surd::none();
}

Surd operator+(const Surd& a, const Surd& b) {
    using Wide = Surd::Wide;
    if (!a.hasValue() || !b.hasValue()) return Surd::none();
    if (!a.isRational() && !b.isRational() && a.m_radicand != b.m_radicand) return Surd::none();
    return Surd::made(Wide(a.m_whole) * b.m_denominator + Wide(b.m_whole) * a.m_denominator,
                      Wide(a.m_factor) * b.m_denominator + Wide(b.m_factor) * a.m_denominator,
                      a.isRational() ? b.m_radicand : a.m_radicand, Wide(a.m_denominator) * b.m_denominator);
}

Surd operator*(const Surd& a, const Surd& b) {
    using Wide = Surd::Wide;
    if (!a.hasValue() || !b.hasValue()) return Surd::none();
    const Wide denominator = Wide(a.m_denominator) * b.m_denominator;
    if (!a.isRational() && !b.isRational() && a.m_radicand != b.m_radicand) {
        if (a.m_whole != 0 || b.m_whole != 0) return Surd::none();
        const Surd root = Surd::root(Surd(a.m_radicand) * Surd(b.m_radicand)); // such as √2·√3
        return Surd::made(Wide(a.m_factor) * b.m_factor, 0, 0, denominator) * root;
    }
    Wide ofRoots = Wide(a.m_factor) * b.m_factor;
    if (ofRoots != 0) {
        if (Surd::isWide(ofRoots)) return Surd::none();
        ofRoots *= a.m_radicand;
        if (magnitude(ofRoots) > Wide(longest) * longest) return Surd::none();
    }
    return Surd::made(Wide(a.m_whole) * b.m_whole + ofRoots,
                      Wide(a.m_whole) * b.m_factor + Wide(a.m_factor) * b.m_whole,
                      a.isRational() ? b.m_radicand : a.m_radicand, denominator);
}

// Divides by means of (p − q√d)/(p² − q²d), whose denominator is 0 of 0 alone.
Surd operator/(const Surd& a, const Surd& b) {
    using Wide = Surd::Wide;
    if (!b.hasValue() || b.isZero()) return Surd::none();
    if (b.isRational()) return a * Surd::made(b.m_denominator, 0, 0, b.m_whole);
    const Surd conjugate = Surd::made(b.m_whole, -Wide(b.m_factor), b.m_radicand, b.m_denominator);
    const Surd norm = b * conjugate;
    return norm.hasValue() ? a * conjugate * (Surd(1) / norm) : Surd::none();
}

bool operator==(const Surd& a, const Surd& b) {
    return a.hasValue() && b.hasValue() && a.m_whole == b.m_whole && a.m_factor == b.m_factor &&
           a.m_radicand == b.m_radicand && a.m_denominator == b.m_denominator;
}

} // namespace ifs
