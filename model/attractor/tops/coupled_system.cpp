// SPDX-License-Identifier: MIT
#include "attractor/tops/coupled_system.h"

#include "ifs/extent/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace attractor {

namespace {

// The attractor's hull, to what a search for extreme points finds out in any case.
ifs::Polygon hullOf(const ifs::SupportFunction<2>& attractor) {
    const auto* better = attractor.conditioning();
    const ifs::Outline* known = better ? better->support.outline() : attractor.outline();
    ifs::Polygon points = known->points();
    for (ifs::Vector<2>& point : points)
        if (better) point = better->image.linear * point;
    return ifs::convexHull(std::move(points), 0);
}

double squaredDiameter(const ifs::Polygon& hull) {
    double square = 0;
    for (const ifs::Vector<2>& p : hull)
        for (const ifs::Vector<2>& q : hull)
            square = std::max(square, (p - q).squaredNorm());
    return square;
}

// The ratio of the areas; if one of them is flat, that of the squares of the diameters.
double wholeRatioOf(const ifs::SupportFunction<2>& from, const ifs::SupportFunction<2>& to) {
    constexpr double flat = 1e-9;
    const ifs::Polygon f = hullOf(from), g = hullOf(to);
    const double areaOfF = ifs::area(f), areaOfG = ifs::area(g);
    const double squareOfF = squaredDiameter(f), squareOfG = squaredDiameter(g);
    const bool isFlat = !(areaOfF > flat * squareOfF) || !(areaOfG > flat * squareOfG);
    const double ratio = isFlat ? squareOfG / squareOfF : areaOfG / areaOfF;
    return std::isfinite(ratio) && ratio > 0 ? ratio : 1; // 1 for a single point
}

} // namespace

CoupledSystem::CoupledSystem(const ifs::SupportFunction<2>& attractor, const ifs::SupportFunction<2>& image,
                             std::vector<double> weights)
    : from(attractor.maps()),
      to(image.maps()),
      probabilities(std::move(weights)),
      around(attractor),
      wholeRatio(wholeRatioOf(attractor, image)),
      fromTop(ifs::fixedPoint(from.front()).value_or(from.front().translation)),
      toTop(ifs::fixedPoint(to.front()).value_or(to.front().translation)) {
    for (std::size_t i = 0; i < from.size(); ++i) {
        const double above = std::abs(ifs::determinant<2>(to[i].linear));
        const double below = std::abs(ifs::determinant<2>(from[i].linear));
        const bool isFlat = !(above > 0) || !(below > 0);
        areaRatios.push_back(isFlat ? std::numeric_limits<double>::quiet_NaN() : above / below);
    }
}

double stretchOf(double areaRatio, const ifs::Matrix<2>& to, const ifs::Matrix<2>& from) {
    if (std::isfinite(areaRatio)) return areaRatio;
    const double whole = from.squaredNorm();
    return whole > 0 ? to.squaredNorm() / whole : 0;
}

PixelBox boxOf(const ifs::AffineMap<2>& shown, const ifs::EnclosingPolygon& around) {
    const ifs::Matrix<2>& a = shown.linear;
    const ifs::Vector<2> first = around.corners.front();
    double left = a(0, 0) * first.x() + a(0, 1) * first.y(), right = left;
    double top = a(1, 0) * first.x() + a(1, 1) * first.y(), bottom = top;
    for (const ifs::Vector<2>& corner : around.corners) {
        const double x = a(0, 0) * corner.x() + a(0, 1) * corner.y();
        const double y = a(1, 0) * corner.x() + a(1, 1) * corner.y();
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::min(top, y);
        bottom = std::max(bottom, y);
    }
    return {left + shown.translation.x(), right + shown.translation.x(), top + shown.translation.y(),
            bottom + shown.translation.y()};
}

} // namespace attractor
