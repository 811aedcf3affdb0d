// SPDX-License-Identifier: MIT
#include "document/edits/maps/map_shape.h"

#include "ifs/system/decomposition.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace document {

namespace {

constexpr std::size_t maxKnown = 1000;

struct Direction {
    double cosine;
    double sine;
};

// Exact where the values are rational, and the same for both at 45°.
Direction direction(double degrees) {
    const double quarters = std::nearbyint(degrees / 90);
    const double rest = std::remainder(degrees, 90); // −45 … 45
    const double radians = rest * std::numbers::pi / 180;
    double c = std::cos(radians), s = std::sin(radians);
    if (std::abs(rest) == 45) c = std::numbers::sqrt2 / 2;
    if (std::abs(rest) == 45) s = std::copysign(c, rest);
    if (std::abs(rest) == 30) s = std::copysign(0.5, rest);
    switch (static_cast<int>(std::remainder(quarters, 4))) {
    case 0:
        return {c, s};
    case 1:
        return {-s, c};
    case -1:
        return {s, -c};
    default:
        return {-c, -s};
    }
}

ifs::Matrix<2> linearPart(const MapShape::Parts& parts) {
    const auto [cosine, sine] = direction(parts[MapShape::Rotation]);
    const double x = parts[MapShape::ScaleX], y = parts[MapShape::ScaleY];
    const double along = x * parts[MapShape::Shear];
    ifs::Matrix<2> linear;
    linear << x * cosine, along * cosine - y * sine, x * sine, along * sine + y * cosine;
    return linear.unaryExpr([](double v) { return v + 0.0; }); // avoids −0
}

ifs::Matrix<3> linearPart(const MapShape3::Parts& parts) {
    const ifs::AxisAngle turn{{parts[MapShape3::AxisX], parts[MapShape3::AxisY], parts[MapShape3::AxisZ]},
                              parts[MapShape3::Angle] * std::numbers::pi / 180};
    ifs::RotationScaleShear3 result;
    result.rotation = ifs::rotationAbout(turn);
    result.scale = {parts[MapShape3::ScaleX], parts[MapShape3::ScaleY], parts[MapShape3::ScaleZ]};
    result.shear << 1, parts[MapShape3::ShearXY], parts[MapShape3::ShearXZ], //
        0, 1, parts[MapShape3::ShearYZ],                                     //
        0, 0, 1;
    return ifs::linearPart(result).unaryExpr([](double v) { return v + 0.0; }); // avoids −0
}

double degreesOf(double radians) {
    const double degrees = radians * 180 / std::numbers::pi;
    const double round = std::nearbyint(degrees * 1e8) / 1e8;
    return std::abs(degrees - round) < 1e-13 ? round : degrees;
}

MapShape::Parts partsOf(const ifs::Matrix<2>& linear) {
    const ifs::RotationScaleShear parts = ifs::rotationScaleShear(linear);
    return {degreesOf(parts.rotation), parts.scaleX, parts.scaleY, parts.shear};
}

MapShape3::Parts partsOf(const ifs::Matrix<3>& linear) {
    const ifs::RotationScaleShear3 parts = ifs::rotationScaleShear(linear);
    const ifs::AxisAngle turn = ifs::axisAngle(parts.rotation);
    return {turn.axis.x(),   turn.axis.y(),   turn.axis.z(),     degreesOf(turn.angle), parts.scale.x(),
            parts.scale.y(), parts.scale.z(), parts.shear(0, 1), parts.shear(0, 2),     parts.shear(1, 2)};
}

} // namespace

template <int Dim> void MapShapeIn<Dim>::show(const ifs::Matrix<Dim>& linear) {
    const auto isShown = [&](const Known& known) { return known.linear == linear; };
    auto known =
        std::ranges::find_if(m_known, [&](const Known& k) { return isShown(k) && k.parts == m_parts; });
    if (known == m_known.end()) known = std::ranges::find_if(m_known, isShown);
    if (known == m_known.end()) {
        m_known.assign(1, {linear, partsOf(linear)});
        known = m_known.begin();
    }
    m_parts = known->parts;
}

template <int Dim> ifs::Matrix<Dim> MapShapeIn<Dim>::changed(Part part, double value) {
    m_parts[part] = value;
    const auto known = std::ranges::find(m_known, m_parts, &Known::parts);
    if (known != m_known.end()) return known->linear;
    if (m_known.size() == maxKnown) m_known.erase(m_known.begin() + 1, m_known.begin() + maxKnown / 2);
    m_known.push_back({composed(m_parts), m_parts});
    return m_known.back().linear;
}

// The coefficients of these numbers. Coefficients that come out as they did from the first numbers keep the
// bits of the first matrix.
template <int Dim> ifs::Matrix<Dim> MapShapeIn<Dim>::composed(const Parts& parts) const {
    const Known& first = m_known.front();
    const ifs::Matrix<Dim> before = linearPart(first.parts);
    ifs::Matrix<Dim> linear = linearPart(parts);
    for (int i = 0; i < Dim * Dim; ++i)
        if (linear.data()[i] == before.data()[i]) linear.data()[i] = first.linear.data()[i];
    return linear;
}

template class MapShapeIn<2>;
template class MapShapeIn<3>;

} // namespace document
