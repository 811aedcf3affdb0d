// SPDX-License-Identifier: MIT
#include "ifs/existence/dyadic.h"

#include <algorithm>
#include <cmath>
#include <compare>

namespace ifs {

namespace {

using Digits = std::vector<std::uint32_t>;
constexpr int digitBits = 32;

std::strong_ordering compare(const Digits& a, const Digits& b) {
    if (a.size() != b.size()) return a.size() <=> b.size();
    return std::lexicographical_compare_three_way(a.rbegin(), a.rend(), b.rbegin(), b.rend());
}

Digits sum(const Digits& a, const Digits& b) {
    Digits result(std::max(a.size(), b.size()) + 1);
    std::uint64_t carry = 0;
    for (std::size_t k = 0; k < result.size(); ++k, carry >>= digitBits) {
        carry += (k < a.size() ? a[k] : 0ull) + (k < b.size() ? b[k] : 0ull);
        result[k] = std::uint32_t(carry);
    }
    return result;
}

// The difference of a ≥ b.
Digits difference(const Digits& a, const Digits& b) {
    Digits result(a.size());
    std::int64_t borrow = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        const std::int64_t digit = std::int64_t(a[k]) - (k < b.size() ? std::int64_t(b[k]) : 0) + borrow;
        result[k] = std::uint32_t(digit);
        borrow = digit < 0 ? -1 : 0;
    }
    return result;
}

} // namespace

Dyadic::Dyadic(double finite) : m_isNegative(finite < 0) {
    constexpr int mantissa = 53;
    int exponent = 0;
    const auto digits = std::uint64_t(std::ldexp(std::frexp(std::abs(finite), &exponent), mantissa));
    m_digits = {std::uint32_t(digits), std::uint32_t(digits >> digitBits)};
    m_exponent = exponent - mantissa;
    trim();
}

void Dyadic::trim() {
    while (!m_digits.empty() && m_digits.back() == 0)
        m_digits.pop_back();
    const auto first = std::ranges::find_if(m_digits, [](std::uint32_t digit) { return digit != 0; });
    m_exponent += digitBits * int(first - m_digits.begin());
    m_digits.erase(m_digits.begin(), first);
    if (m_digits.empty()) m_exponent = 0;
}

Dyadic Dyadic::operator-() const {
    Dyadic result = *this;
    result.m_isNegative = !m_isNegative;
    return result;
}

// The same number with an exponent that is not larger.
Dyadic Dyadic::scaledTo(int exponent) const {
    Dyadic result = *this;
    const int shift = m_exponent - exponent, bits = shift % digitBits;
    if (bits > 0) {
        result.m_digits.push_back(0);
        for (std::size_t k = result.m_digits.size(); k-- > 0;)
            result.m_digits[k] =
                result.m_digits[k] << bits | (k > 0 ? result.m_digits[k - 1] >> (digitBits - bits) : 0);
    }
    result.m_digits.insert(result.m_digits.begin(), std::size_t(shift / digitBits), 0);
    while (!result.m_digits.empty() && result.m_digits.back() == 0)
        result.m_digits.pop_back();
    result.m_exponent = exponent;
    return result;
}

// A number from ½ to 1 that is this one times 2^−exponent, but for rounding; 0 of 0.
double Dyadic::leading(int& exponent) const {
    constexpr std::size_t telling = 3; // digits
    const std::size_t count = std::min(m_digits.size(), telling);
    double result = 0;
    for (std::size_t k = 0; k < count; ++k)
        result = std::ldexp(result, digitBits) + m_digits[m_digits.size() - 1 - k];
    result = std::frexp(result, &exponent);
    exponent += m_exponent + digitBits * int(m_digits.size() - count);
    return m_isNegative ? -result : result;
}

double Dyadic::rounded() const {
    int exponent = 0;
    const double number = leading(exponent);
    return std::ldexp(number, exponent);
}

double roundedQuotient(const Dyadic& a, const Dyadic& b) {
    int above = 0, below = 0;
    const double numerator = a.leading(above), denominator = b.leading(below);
    return std::ldexp(numerator / denominator, above - below);
}

Dyadic operator+(const Dyadic& a, const Dyadic& b) {
    if (a.sign() == 0) return b;
    if (b.sign() == 0) return a;
    const int exponent = std::min(a.m_exponent, b.m_exponent);
    const Dyadic x = a.scaledTo(exponent), y = b.scaledTo(exponent);
    Dyadic result;
    result.m_exponent = exponent;
    if (x.m_isNegative == y.m_isNegative) {
        result.m_isNegative = x.m_isNegative;
        result.m_digits = sum(x.m_digits, y.m_digits);
    } else {
        const bool isLarger = std::is_gt(compare(x.m_digits, y.m_digits));
        result.m_isNegative = isLarger ? x.m_isNegative : y.m_isNegative;
        result.m_digits = isLarger ? difference(x.m_digits, y.m_digits) : difference(y.m_digits, x.m_digits);
    }
    result.trim();
    return result;
}

Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    Dyadic result;
    result.m_isNegative = a.m_isNegative != b.m_isNegative;
    result.m_exponent = a.m_exponent + b.m_exponent;
    result.m_digits.resize(a.m_digits.size() + b.m_digits.size());
    for (std::size_t i = 0; i < a.m_digits.size(); ++i) {
        std::uint64_t carry = 0;
        for (std::size_t j = 0; j < b.m_digits.size(); ++j, carry >>= digitBits) {
            carry += std::uint64_t(a.m_digits[i]) * b.m_digits[j] + result.m_digits[i + j];
            result.m_digits[i + j] = std::uint32_t(carry);
        }
        result.m_digits[i + b.m_digits.size()] = std::uint32_t(carry);
    }
    result.trim();
    return result;
}

} // namespace ifs
