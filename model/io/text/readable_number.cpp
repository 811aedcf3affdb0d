// SPDX-License-Identifier: MIT
#include "io/text/readable_number.h"

#include "io/text/number.h"

#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace io {

namespace {

constexpr double tolerance = 4e-15; // relative error of a few sums and products of doubles
constexpr double smallest = 1e-14;
constexpr int digits = 6;

bool isClose(double a, double b) {
    return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

QByteArray whole(double value) {
    return QByteArray::number(qlonglong(value));
}

QByteArray withPower(const QByteArray& text) {
    const qsizetype e = text.indexOf('e');
    if (e < 0) return text;
    const QByteArray power = "10^{" + QByteArray::number(text.sliced(e + 1).toInt()) + '}';
    const QByteArray factor = text.first(e);
    return factor == "1" ? power : factor == "-1" ? '-' + power : factor + "\\cdot " + power;
}

QByteArray rounded(double value) {
    return formatNumber(QByteArray::number(value, 'g', digits).toDouble());
}

QByteArray fraction(bool isNegative, const QByteArray& above, int below) {
    const QByteArray sign = isNegative ? "-" : "";
    return below == 1 ? sign + above : sign + "\\frac{" + above + "}{" + QByteArray::number(below) + '}';
}

std::optional<QByteArray> ofFraction(double value) {
    constexpr int largest = 100;
    for (int below = 2; below <= largest; ++below) {
        const double above = std::round(value * below);
        if (above != 0 && std::abs(above) <= 10 * largest && isClose(above / below, value))
            return fraction(value < 0, whole(std::abs(above)), below);
    }
    return std::nullopt;
}

std::optional<QByteArray> ofRoot(double value) {
    constexpr int mostRoots = 5;
    constexpr int mostBelow = 18;
    constexpr double mostBefore = 12;
    for (const int n : {2, 3, 5, 6, 7})
        for (int below = 1; below <= mostBelow; ++below)
            for (int roots = -mostRoots; roots <= mostRoots; ++roots) {
                const double root = roots * std::sqrt(n);
                const double before = std::round(value * below - root);
                if (roots == 0 || std::abs(before) > mostBefore || !isClose((before + root) / below, value) ||
                    std::gcd(std::gcd(int(before), roots), below) != 1)
                    continue;
                QByteArray term = "\\sqrt{" + QByteArray::number(n) + '}';
                if (std::abs(roots) > 1) term.prepend(QByteArray::number(std::abs(roots)));
                if (before == 0) return fraction(roots < 0, term, below);
                QByteArray sum = before > 0 || roots < 0 ? whole(before) + (roots < 0 ? "-" : "+") + term
                                                         : term + whole(before);
                return below == 1 ? std::move(sum) : fraction(false, sum, below);
            }
    return std::nullopt;
}

} // namespace

ReadableNumber readableNumber(double value) {
    if (std::abs(value) <= smallest) return {"0", false};
    const QByteArray decimal = rounded(value);
    if (isClose(decimal.toDouble(), value)) return {withPower(decimal), false};
    if (const auto exact = ofFraction(value)) return {*exact, false};
    if (const auto exact = ofRoot(value)) return {*exact, false};
    return {withPower(decimal), true};
}

} // namespace io
