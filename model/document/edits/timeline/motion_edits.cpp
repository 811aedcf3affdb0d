// SPDX-License-Identifier: MIT
#include "document/edits/timeline/motion_edits.h"

#include "document/edits/timeline/orbit_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/moments/animated_fractal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace document {

namespace {

constexpr double swell = 0.1;
constexpr int secondsOfOrbit = 5;
constexpr int directions = 64;      // number of directions in which a piece is measured
constexpr double viewMargin = 0.98; // share of the largest view that sees nothing else
constexpr double roundOff = 1e-9;   // relative tolerance of a similarity
constexpr double tolerance = 1e-4;  // error of a support value, as a share of the size of the attractor
constexpr int maxNodes = 5'000;     // nodes of its search; reaching the limit only enlarges the view a little

template <int Dim> ifs::Vector<Dim> displayed(const Fractal& fractal, const ifs::Vector<Dim>& point) {
    if constexpr (Dim == 2)
        return placement(fractal)(point);
    else
        return point;
}

template <int Dim> std::vector<ifs::Vector<Dim>> fixedPoints(const Shape<Dim>& shape) {
    std::vector<ifs::Vector<Dim>> result;
    for (const auto& map : ifs::activeMaps(shape.system).maps)
        if (const auto fixed = ifs::fixedPoint<Dim>(map)) result.push_back(*fixed);
    return result;
}

// The foot of a plant: the lowest fixed point on the screen; fixed points belong to the attractor.
template <int Dim> ifs::Vector<Dim> root(const Fractal& fractal, const Shape<Dim>& shape) {
    const auto points = fixedPoints<Dim>(shape);
    const auto height = [&](const ifs::Vector<Dim>& point) { return displayed<Dim>(fractal, point).y(); };
    if (points.empty()) return ifs::Vector<Dim>::Zero();
    return *std::ranges::min_element(points, {}, height);
}

template <int Dim> ifs::Vector<Dim> middle(const Shape<Dim>& shape) {
    ifs::Vector<Dim> sum = ifs::Vector<Dim>::Zero();
    const auto points = fixedPoints<Dim>(shape);
    for (const auto& point : points)
        sum += point;
    return points.empty() ? sum : ifs::Vector<Dim>(sum / double(points.size()));
}

template <int Dim> Fractal withMotion(Fractal entry, animation::Motion<Dim> motion) {
    auto& shape = std::get<Shape<Dim>>(entry.shape);
    if (!shape.animation) shape.animation.emplace();
    if (animation::trackCount(*shape.animation) == 0) shape.animation->loop = animation::Loop::Cycle;
    shape.animation->motions.push_back(std::move(motion));
    return entry;
}

// Calls `make` with the shape of the entry's dimension, if it has maps.
template <class Make> std::optional<Fractal> ofItsDimension(const Fractal& entry, Make make) {
    if (const auto* shape = plane(entry); shape && !shape->system.maps.empty())
        return make.template operator()<2>(*shape);
    if (const auto* shape = space(entry); shape && !shape->system.maps.empty())
        return make.template operator()<3>(*shape);
    return std::nullopt;
}

std::optional<Fractal> asStrongAsCanBe(const Fractal& entry, const std::stop_token& stop) {
    return withSafeStrength(entry, animationFacts(entry)->motions - 1, stop);
}

// Lower bound of the distance of the piece w(A) from a point: the largest distance to a line that has the
// piece on one side.
double distanceTo(const ifs::SupportFunction<2>& attractor, const ifs::AffineMap<2>& piece,
                  const ifs::Vector<2>& point) {
    double distance = 0;
    for (int i = 0; i < directions; ++i) {
        const double angle = 2 * std::numbers::pi * i / directions;
        const ifs::Vector<2> u(std::cos(angle), std::sin(angle));
        const auto extent = attractor(piece.linear.transpose() * u, tolerance * attractor.radius(), maxNodes);
        distance = std::max(distance, u.dot(point - piece.translation) - extent.value - extent.error);
    }
    return distance;
}

struct SmallCopy {
    ifs::Vector<2> centre; // displayed coordinates
    double ratio = 1;      // scale of the view in the copy
    double turn = 0;       // counter-clockwise, in (−π, π]
    double radius = 0;     // largest ball about the centre that, scaled, meets no other piece
};

double ratioOf(const ifs::AffineMap<2>& map) {
    return std::sqrt(std::abs(map.linear.determinant()));
}

// The view at which a zoom by the map ends, if it is a similarity; its radius is 0. A mirrored copy is
// replaced by its own copy, which is not mirrored and lies in the same place.
std::optional<SmallCopy> copyUnder(const ifs::AffineMap<2>& map) {
    const double ratio = ratioOf(map), square = ratio * ratio;
    const auto centre = ifs::fixedPoint<2>(map);
    const ifs::Matrix<2> excess = map.linear.transpose() * map.linear - square * ifs::Matrix<2>::Identity();
    if (!centre || ratio <= roundOff || ratio >= 1 - roundOff || excess.norm() > roundOff * square)
        return std::nullopt;
    if (map.linear.determinant() < 0) return SmallCopy{*centre, square, 0, 0};
    return SmallCopy{*centre, ratio, std::atan2(map.linear(1, 0), map.linear(0, 0)), 0};
}

std::optional<SmallCopy> largestCopy(const System2& shown, const std::stop_token& stop) {
    const auto active = ifs::activeMaps(shown);
    const auto attractor = ifs::SupportFunction<2>::of(active.maps);
    std::optional<SmallCopy> best;
    if (!attractor) return best;
    for (std::size_t j = 0; j < active.maps.size(); ++j) {
        const ifs::AffineMap<2>& map = active.maps[j];
        auto copy = copyUnder(map);
        if (!copy) continue;
        double clear = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < active.maps.size(); ++i) {
            if (stop.stop_requested()) return std::nullopt;
            if (i != j) clear = std::min(clear, distanceTo(*attractor, active.maps[i], copy->centre));
        }
        copy->radius = std::min(clear / ratioOf(map), 4 * attractor->radius());
        if (copy->radius > (best ? best->radius : 0)) best = copy;
    }
    return best;
}

// The entry in colours of the palette, if it has others: by density, or a solid by address.
Fractal showingPalette(Fractal entry) {
    using attractor::ColourBy;
    using attractor::LookInSpace;
    using attractor::SolidColour;
    const LookInSpace look = entry.inSpace.look;
    ColourBy& colour = entry.appearance.colourBy;
    if (!space(entry) || look == LookInSpace::Cloud) {
        if (colour == ColourBy::Map || colour == ColourBy::Plain) colour = ColourBy::Density;
    } else if (!attractor::showsCloud(look)) {
        const SolidColour shown = solidColour(entry);
        if (shown == SolidColour::Map || shown == SolidColour::Plain)
            entry.inSpace.colourBy = SolidColour::Address;
    }
    return entry;
}

// A copy that hardly shrinks repeats its turn 1/(1 − s) times: a breeze would bend such a plant like a storm.
template <int Dim> double gentle(double strength, const ifs::IteratedFunctionSystem<Dim>& system) {
    constexpr double copies = 10; // that bend as strongly as the preset says
    double largest = 0;
    for (const ifs::WeightedMap<Dim>& each : system.maps)
        if (each.enabled)
            largest =
                std::max(largest, std::pow(std::abs(ifs::determinant<Dim>(each.map.linear)), 1.0 / Dim));
    const double share = std::clamp(copies * (1 - largest), 0.05, 1.0);
    return std::round(10 * strength * share) / 10; // degrees, as a field shows them
}

} // namespace

std::optional<Fractal> withWind(const Fractal& entry, const animation::SwayPreset& preset,
                                const std::stop_token& stop) {
    return ofItsDimension(entry, [&]<int Dim>(const Shape<Dim>& shape) {
        animation::SwayPreset wind = preset;
        wind.strength = gentle<Dim>(preset.strength, shape.system);
        return asStrongAsCanBe(
            withMotion<Dim>(entry, animation::swayOf<Dim>(wind, {}, root<Dim>(entry, shape))), stop);
    });
}

std::optional<Fractal> withTurn(const Fractal& entry, const std::stop_token& stop) {
    return ofItsDimension(entry, [&]<int Dim>(const Shape<Dim>& shape) -> std::optional<Fractal> {
        const auto turned = [&](animation::MapIds maps) {
            return withMotion<Dim>(entry, animation::Turn<Dim>{std::move(maps), 1, middle<Dim>(shape)});
        };
        const auto isSafe = [&](const Fractal& fractal) { return losesAttractor(fractal, stop) == false; };
        if (Fractal all = turned({}); isSafe(all)) return all;
        animation::MapIds able;
        for (const auto& map : shape.system.maps) {
            if (stop.stop_requested()) return std::nullopt;
            if (isSafe(turned({map.id}))) able.push_back(map.id);
        }
        while (!able.empty() && !stop.stop_requested() && !isSafe(turned(able)))
            able.pop_back();
        return able.empty() || stop.stop_requested() ? std::nullopt : std::optional(turned(able));
    });
}

std::optional<Fractal> withOrbit(const Fractal& entry, const ifs::Vector<3>& axis) {
    return ofItsDimension(entry, [&]<int Dim>(const Shape<Dim>& shape) {
        animation::Orbit<Dim> orbit;
        const auto centre = orbitCentre(entry);
        orbit.centre = centre ? ifs::Vector<Dim>(centre->template head<Dim>())
                              : displayed<Dim>(entry, middle<Dim>(shape));
        if (Dim == 3) orbit.axis = axis;
        Fractal turning = withMotion<Dim>(entry, orbit);
        if (!shape.animation) {
            auto& animation = *std::get<Shape<Dim>>(turning.shape).animation;
            animation.length = secondsOfOrbit * animation.rate.frames / animation.rate.seconds;
        }
        return turning;
    });
}

std::optional<Fractal> withBreathing(const Fractal& entry, const std::stop_token& stop) {
    return ofItsDimension(entry, [&]<int Dim>(const Shape<Dim>& shape) {
        return asStrongAsCanBe(
            withMotion<Dim>(entry, animation::Breathe<Dim>{{}, swell, 1, middle<Dim>(shape)}), stop);
    });
}

std::optional<Fractal> withPaletteCycle(const Fractal& entry) {
    const Fractal shown = showingPalette(entry);
    return ofItsDimension(
        shown, [&]<int Dim>(const Shape<Dim>&) { return withMotion<Dim>(shown, animation::PaletteCycle{}); });
}

std::optional<Fractal> withEndlessZoom(const Fractal& entry, double aspect, attractor::YAxis yAxis,
                                       const std::stop_token& stop) {
    const auto system = plane(entry) && plane(entry)->moved.empty() ? effectiveSystem(entry) : std::nullopt;
    const auto copy = system ? largestCopy(*system, stop) : std::nullopt;
    if (!copy) return std::nullopt;
    const double height = viewMargin * 2 * copy->radius / std::hypot(1, aspect);
    const attractor::View from{copy->centre, height, yAxis};
    // Opposite turn of the picture, which makes a rotated copy upright again.
    const double turn = yAxis == attractor::YAxis::Up ? -copy->turn : copy->turn;
    const attractor::View to{copy->centre, height * copy->ratio, yAxis,
                             attractor::rotationOf(attractor::degreesOf(turn))};
    Fractal result = entry;
    Shape<2>& shape = *plane(result);
    if (!shape.animation) shape.animation.emplace();
    shape.animation->loop = animation::Loop::Cycle;
    shape.animation->camera = {{0, from, {}}, {shape.animation->length, to, {}}};
    return result;
}

} // namespace document
