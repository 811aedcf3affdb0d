// SPDX-License-Identifier: MIT
#include "document/edits/shadow_edits.h"

#include "attractor/request/appearance_fields.h"
#include "document/fractal/fractal_geometry.h"
#include "document/text/text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace document {

namespace {

constexpr double opacityAtFirst = 0.6;

} // namespace

QString shadowObstacle(const Fractal& fractal) {
    if (plane(fractal)) return {};
    if (space(fractal))
        return Text::tr("A solid has no shadow on the ground. Move its light in the Appearance panel: the "
                        "solid darkens the side that faces away from it.");
    return Text::tr("This entry could not be read, so there is no picture to cast a shadow.");
}

bool hasShadow(const Fractal& fractal) {
    return plane(fractal) && fractal.appearance.shadow > 0;
}

Fractal withShadow(Fractal fractal, bool on) {
    if (!plane(fractal) || on == hasShadow(fractal)) return fractal;
    fractal.appearance.shadow = on ? opacityAtFirst : 0;
    return fractal;
}

std::optional<ShadowStick> shadowStick(const Fractal& fractal, attractor::YAxis yAxis) {
    const auto box = hasShadow(fractal) ? displayedBox(fractal) : std::nullopt;
    if (!box || !(box->max.y() > box->min.y())) return std::nullopt;
    const double middle = (box->min.x() + box->max.x()) / 2;
    ShadowStick stick;
    stick.foot = {middle, box->min.y()};
    stick.top = {middle, box->max.y()};
    if (yAxis == attractor::YAxis::Down) std::swap(stick.foot, stick.top);
    const ifs::Vector<2> up = stick.top - stick.foot;
    const attractor::Appearance& look = fractal.appearance;
    stick.tip = stick.foot + look.shadowLength * up + ifs::Vector<2>(look.shadowLean * std::abs(up.y()), 0);
    return stick;
}

Fractal withShadowTip(Fractal fractal, const ShadowStick& stick, const ifs::Vector<2>& tip) {
    const ifs::Vector<2> up = stick.top - stick.foot, along = tip - stick.foot;
    const auto within = [](double value) {
        return std::clamp(value, -attractor::longestShadow, attractor::longestShadow);
    };
    fractal.appearance.shadowLean = within(along.x() / std::abs(up.y()));
    fractal.appearance.shadowLength = within(along.y() / up.y());
    return fractal;
}

} // namespace document
