// SPDX-License-Identifier: MIT
#include "animation/paths/smooth_paths.h"

#include "animation/paths/smooth_curve.h"
#include "animation/paths/smooth_spaces.h"
#include "attractor/arithmetic/arithmetic.h"
#include "attractor/request/appearance_fields.h"
#include "ifs/system/decomposition.h"
#include "ifs/system/map_interpolation.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace animation {

namespace {

template <class Value> bool isCurved(const Segment<Value>& way) {
    return way.isSmooth && way.share > 0 && way.share < 1 && (way.before.value || way.after.value);
}

// Rotations of the plane, by angles that do not jump from key to key; half a turn is counter-clockwise.
ifs::Matrix<2> turned(const KeysAround<ifs::Matrix<2>>& rotations, double t, const TangentShares& shares) {
    const KeysAround<double> angles = rotations.of(
        [](const ifs::Matrix<2>& rotation) { return std::atan2(rotation(1, 0), rotation(0, 0)); });
    const auto turn = [](double from, double to) {
        const double angle = std::remainder(to - from, 2 * std::numbers::pi);
        return angle <= -std::numbers::pi ? std::numbers::pi : angle;
    };
    KeysAround<double> unwrapped = angles;
    unwrapped.to = angles.from + turn(angles.from, angles.to);
    if (angles.before) unwrapped.before = angles.from - turn(*angles.before, angles.from);
    if (angles.after) unwrapped.after = unwrapped.to + turn(angles.to, *angles.after);
    return Eigen::Rotation2Dd(smoothCurve<Flat<double>>(unwrapped, t, shares)).toRotationMatrix();
}

ifs::Matrix<3> turned(const KeysAround<ifs::Matrix<3>>& rotations, double t, const TangentShares& shares) {
    const auto orientations =
        rotations.of([](const ifs::Matrix<3>& rotation) { return attractor::Orientation(rotation); });
    return smoothCurve<Rotations>(orientations, t, shares).toRotationMatrix();
}

// The norm of a symmetric matrix.
double normOf(const ifs::Matrix<2>& stretch) {
    const double half = (stretch(0, 0) - stretch(1, 1)) / 2;
    return std::abs(stretch(0, 0) + stretch(1, 1)) / 2 +
           std::sqrt(half * half + stretch(0, 1) * stretch(0, 1));
}
double normOf(const ifs::Matrix<3>& stretch) {
    return ifs::spectralNorm<3>(stretch);
}

template <int Dim>
ifs::Matrix<Dim> stretched(const KeysAround<ifs::Matrix<Dim>>& stretches, double t,
                           const TangentShares& most) {
    constexpr double rounding = 1e-14;
    const auto limitOf = [](const ifs::Matrix<Dim>& a, const ifs::Matrix<Dim>& b) {
        return [most = std::max(normOf(a), normOf(b)) * (1 + rounding)](const ifs::Matrix<Dim>& stretch) {
            return normOf(stretch) <= most;
        };
    };
    const TangentShares shares = sharesWithin(stretches, limitOf);
    return smoothCurve<Flat<ifs::Matrix<Dim>>>(
        stretches, t, {std::min(shares.from, most.from), std::min(shares.to, most.to)});
}

// The polar parts of maps, and where the curves through them stop: at a key whose rotation is open, because
// there it is another one on either side.
template <int Dim> struct PolarWay {
    KeysAround<ifs::Polar<Dim>> keys;
    TangentShares shares{};
};

template <int Dim> PolarWay<Dim> polarWay(const KeysAround<ifs::AffineMap<Dim>>& maps) {
    const auto linear = maps.of([](const ifs::AffineMap<Dim>& map) { return map.linear; });
    const auto [from, to] = ifs::polarPair<Dim>(linear.from, linear.to);
    PolarWay<Dim> way{{from, to, std::nullopt, std::nullopt, maps.begin, maps.end}};
    if (linear.before) way.keys.before = ifs::polarNear<Dim>(*linear.before, from.rotation);
    if (linear.after) way.keys.after = ifs::polarNear<Dim>(*linear.after, to.rotation);
    if (linear.before && ifs::isRotationOpen<Dim>(linear.from)) {
        way.keys.before->rotation = from.rotation;
        way.shares.from = 0;
    }
    if (linear.after && ifs::isRotationOpen<Dim>(linear.to)) {
        way.keys.after->rotation = to.rotation;
        way.shares.to = 0;
    }
    return way;
}

// nullopt: a number became too large.
template <int Dim>
std::optional<ifs::AffineMap<Dim>> smoothMap(const KeysAround<ifs::AffineMap<Dim>>& maps, double t,
                                             const ifs::Vector<Dim>& reference) {
    using Map = ifs::AffineMap<Dim>;
    const auto [polar, shares] = polarWay<Dim>(maps);
    const auto rotations = polar.of([](const ifs::Polar<Dim>& parts) { return parts.rotation; });
    const auto stretches = polar.of([](const ifs::Polar<Dim>& parts) { return parts.stretch; });
    const auto images = maps.of([&](const Map& map) { return map(reference); });
    const ifs::Matrix<Dim> linear = turned(rotations, t, shares) * stretched<Dim>(stretches, t, shares);
    const Map map{linear, smoothCurve<Flat<ifs::Vector<Dim>>>(images, t) - linear * reference};
    return ifs::isFinite<Dim>(map) ? std::optional(map) : std::nullopt;
}

// Moves every vertex on a curve of its own, which begins slowly if the vertex rests before the segment, and
// ends slowly if it rests after it.
template <int Dim> CagePose<Dim> smoothVertices(const KeysAround<CagePose<Dim>>& keys, double t) {
    using Vertex = ifs::Vector<Dim>;
    CagePose<Dim> pose;
    for (std::size_t i = 0; i < keys.from.size(); ++i) {
        const auto vertex = keys.of([i](const CagePose<Dim>& key) -> Vertex { return key[i]; });
        const TangentShares shares{vertex.before == vertex.from ? 0.0 : 1.0,
                                   vertex.after == vertex.to ? 0.0 : 1.0};
        const bool stays = vertex.from == vertex.to;
        pose.push_back(stays ? vertex.from : smoothCurve<Flat<Vertex>>(vertex, t, shares));
    }
    return pose;
}

// Returns true if the curves of smoothVertices() turn the cage over although both ends are on the same side.
template <int Dim> bool turnsOver(const KeysAround<CagePose<Dim>>& keys, const ifs::ControlCage<Dim>& cage) {
    constexpr int moments = 32;
    const auto sideOf = [&](const CagePose<Dim>& pose) {
        const double area =
            ifs::displayMap(ifs::ControlCage<Dim>{cage.rest, pose, cage.deformation}).linear.determinant();
        return area > 0 ? 1 : area < 0 ? -1 : 0;
    };
    const int side = sideOf(keys.from);
    if (side == 0 || sideOf(keys.to) != side) return false;
    for (int n = 1; n < moments; ++n)
        if (sideOf(smoothVertices<Dim>(keys, double(n) / moments)) != side) return true;
    return false;
}

// nullopt: a number became too large.
template <int Dim>
std::optional<CagePose<Dim>> smoothPlacement(const KeysAround<CagePose<Dim>>& keys, double t,
                                             const ifs::ControlCage<Dim>& cage, const CageWay& way) {
    const auto placements = keys.of([&](const CagePose<Dim>& pose) {
        return ifs::displayMap(ifs::ControlCage<Dim>{cage.rest, pose, cage.deformation});
    });
    const auto now = smoothMap<Dim>(placements, t, referenceOf<Dim>(way, cage));
    if (!now) return std::nullopt;
    CagePose<Dim> result;
    for (std::size_t i = 0; i < cage.rest.size(); ++i) {
        const ifs::Vector<Dim>& rest = cage.rest[i];
        auto bends = placements.of([&](const auto& map) -> ifs::Vector<Dim> { return -map(rest); });
        bends.from += keys.from[i];
        bends.to += keys.to[i];
        if (bends.before) *bends.before += (*keys.before)[i];
        if (bends.after) *bends.after += (*keys.after)[i];
        result.push_back((*now)(rest) + smoothCurve<Flat<ifs::Vector<Dim>>>(bends, t));
    }
    if (way.pivot) result[*way.pivot] = keys.from[*way.pivot]; // undoes rounding
    return result;
}

template <int Dim> std::optional<double> weightAlong(const Segment<MapPose<Dim>>& way) {
    if (!way.from.weight || !way.to.weight) return way.from.weight;
    const auto keys = keysAround(way, [](const MapPose<Dim>& pose) { return pose.weight.has_value(); });
    return smoothNumber(keys.of([](const MapPose<Dim>& pose) { return *pose.weight; }), way.share);
}

double smoothFactor(const KeysAround<double>& keys, double t) {
    return keys.from == keys.to
               ? keys.from
               : attractor::exponential(smoothNumber(keys.of(attractor::naturalLogarithm), t));
}

template <int Dim> bool isUsable(const Framing<Dim>& framing) {
    return framing.height > 0 && std::isfinite(framing.height) && framing.centre.allFinite();
}

} // namespace

template <int Dim>
MapPose<Dim> along(const Segment<MapPose<Dim>>& way, const ifs::Vector<Dim>& reference,
                   const CommonNorm<Dim>& norm) {
    MapPose<Dim> pose = between<Dim>(way.from, way.to, way.share, reference, norm);
    if (!isCurved(way)) return pose;
    const auto seen = [&](const MapPose<Dim>& key) {
        if (norm.isEuclidean) return key.map;
        return ifs::AffineMap<Dim>{norm.root * key.map.linear * norm.inverse,
                                   norm.root * key.map.translation};
    };
    auto map = smoothMap<Dim>(keysAround(way).of(seen), way.share, norm.root * reference);
    if (map && !norm.isEuclidean)
        map = ifs::AffineMap<Dim>{norm.inverse * map->linear * norm.root, norm.inverse * map->translation};
    if (map && ifs::isFinite<Dim>(*map)) pose.map = *map;
    pose.weight = weightAlong(way);
    return pose;
}

template <int Dim>
ifs::AffineMap<Dim> along(const Segment<ifs::AffineMap<Dim>>& way, const ifs::Vector<Dim>& reference) {
    if (isCurved(way))
        if (const auto map = smoothMap<Dim>(keysAround(way), way.share, reference)) return *map;
    return ifs::interpolated<Dim>(way.from, way.to, way.share, reference);
}

template <int Dim> CagePose<Dim> along(const Segment<CagePose<Dim>>& way, const ifs::ControlCage<Dim>& cage) {
    const CagePose<Dim> straight = between<Dim>(cage, way.from, way.to, way.share);
    if (!isCurved(way)) return straight;
    const CageWay kind = wayOf<Dim>(cage, way.from, way.to);
    auto keys = keysAround(way, [&](const CagePose<Dim>& pose) { return pose.size() == cage.rest.size(); });
    if (keys.before && wayOf<Dim>(cage, *keys.before, keys.from) != kind) keys.before.reset();
    if (keys.after && wayOf<Dim>(cage, keys.to, *keys.after) != kind) keys.after.reset();
    if (keys.isAlone()) return straight;
    std::optional<CagePose<Dim>> pose;
    if (!kind.isByVertex)
        pose = smoothPlacement<Dim>(keys, way.share, cage, kind);
    else if (!turnsOver<Dim>(keys, cage))
        pose = smoothVertices<Dim>(keys, way.share);
    const auto isFinite = [](const ifs::Vector<Dim>& vertex) { return vertex.allFinite(); };
    return pose && std::ranges::all_of(*pose, isFinite) ? *std::move(pose) : straight;
}

attractor::View along(const Segment<attractor::View>& way) {
    attractor::View view = between(way.from, way.to, way.share);
    if (!isCurved(way)) return view;
    const auto framings = keysAround(way).of([](const attractor::View& key) {
        return Framing<2>{key.height, key.centre};
    });
    const Framing<2> now = smoothCurve<Framings<2>>(framings, way.share);
    if (!isUsable(now)) return view;
    view.height = now.height;
    view.centre = now.centre;
    auto rotations = keysAround(way).of([](const attractor::View& key) { return key.rotation; });
    rotations.to = rotations.from + turnBetween(rotations.from, rotations.to);
    if (rotations.before) rotations.before = rotations.from + turnBetween(rotations.from, *rotations.before);
    if (rotations.after) rotations.after = rotations.to + turnBetween(rotations.to, *rotations.after);
    view.rotation = smoothNumber(rotations, way.share);
    return view;
}

attractor::OrbitCamera along(const Segment<attractor::OrbitCamera>& way) {
    using attractor::OrbitCamera;
    OrbitCamera camera = between(way.from, way.to, way.share);
    if (!isCurved(way)) return camera;
    const auto keys = keysAround(way);
    const auto framings = keys.of([](const OrbitCamera& key) { return Framing<3>{key.height, key.target}; });
    const auto orientations = keys.of([](const OrbitCamera& key) { return key.orientation; });
    const auto fields = keys.of([](const OrbitCamera& key) { return key.fieldOfView; });
    const Framing<3> now = smoothCurve<Framings<3>>(framings, way.share);
    if (!isUsable(now)) return camera;
    camera.height = now.height;
    camera.target = now.centre;
    camera.orientation = smoothCurve<Rotations>(orientations, way.share);
    camera.fieldOfView = smoothNumber(fields, way.share);
    return camera;
}

Look along(const Segment<Look>& way) {
    Look look = between(way.from, way.to, way.share);
    if (!isCurved(way)) return look;
    const auto keys = keysAround(way);
    for (const attractor::AppearanceNumber& number : attractor::appearanceNumbers) {
        const auto values = keys.of([&](const Look& key) { return key.*number.member; });
        const bool byFactors = number.scale == attractor::AppearanceNumber::Scale::Factor;
        look.*number.member = byFactors ? smoothFactor(values, way.share) : smoothNumber(values, way.share);
    }
    return look;
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template MapPose<Dim> along<Dim>(const Segment<MapPose<Dim>>&, const ifs::Vector<Dim>&,                  \
                                     const CommonNorm<Dim>&);                                                \
    template ifs::AffineMap<Dim> along<Dim>(const Segment<ifs::AffineMap<Dim>>&, const ifs::Vector<Dim>&);   \
    template CagePose<Dim> along<Dim>(const Segment<CagePose<Dim>>&, const ifs::ControlCage<Dim>&);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace animation
