// SPDX-License-Identifier: MIT
#include "canvas/geometry/coordinate_text.h"

#include <algorithm>
#include <cmath>

namespace view {

namespace {

constexpr int usualDecimals = 4;

// Fixed decimals, so that digits stay in place while the pointer moves; no −0.
QString fixed(double value, int decimals) {
    return QString::number(std::abs(value) < std::pow(10, -decimals) / 2 ? 0 : value, 'f', decimals);
}

} // namespace

CoordinateText::CoordinateText(const attractor::Camera& camera, int axis) {
    m_decimals = std::max(0, int(std::ceil(std::log10(camera.pixelsPerUnit))) + 1);
    if (m_decimals <= maxPlainDecimals) return;
    const double across = std::max({1, camera.width, camera.height}) / camera.pixelsPerUnit;
    m_baseDecimals = std::clamp(int(std::floor(-std::log10(across))), 1, 17);
    m_base = fixed(camera.centre[axis], m_baseDecimals).toDouble();
}

QString CoordinateText::offset(double value) const {
    const double offset = value - m_base;
    return (offset < 0 ? QStringLiteral("− %1") : QStringLiteral("+ %1")).arg(std::abs(offset), 0, 'e', 4);
}

QString CoordinateText::text(double value) const {
    if (m_decimals <= maxPlainDecimals) return fixed(value, std::max(usualDecimals, m_decimals));
    return fixed(m_base, m_baseDecimals) + u' ' + offset(value);
}

QString CoordinateText::label(double value) const {
    if (m_decimals <= maxPlainDecimals) return QString::number(value, 'g', 14);
    // Rounded to the difference of neighbouring pixels, since a difference of two long numbers has further
    // digits.
    const double unit = std::pow(10, -m_decimals);
    const double offset = std::round((value - m_base) / unit) * unit;
    return offset == 0 ? QStringLiteral("0") : QString::number(offset, 'g', 5);
}

QString CoordinateText::base() const {
    if (m_decimals <= maxPlainDecimals) return {};
    return fixed(m_base, m_baseDecimals) + QStringLiteral(" + …");
}

} // namespace view
