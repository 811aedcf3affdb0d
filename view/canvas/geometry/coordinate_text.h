// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"

#include <QString>

namespace view {

// Texts of coordinates of a view, along one axis (0: x, 1: y): with digits enough to tell neighbouring pixels
// apart. Where that takes more than maxPlainDecimals, a base that all of the view has in common and an
// offset: "0.123456789 + 3.215e-13".
class CoordinateText {
public:
    CoordinateText(const attractor::Camera& camera, int axis);

    QString text(double value) const; // constant number of digits
    // Label of an axis: without trailing zeros; only the offset if there is a base.
    QString label(double value) const;
    QString base() const; // "0.123456789 + …"; empty if labels are whole coordinates
    static constexpr int maxPlainDecimals = 9;

private:
    QString offset(double value) const;

    int m_decimals = 0; // decimals that distinguish neighbouring pixels
    int m_baseDecimals = 0;
    double m_base = 0;
};

} // namespace view
