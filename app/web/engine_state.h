// SPDX-License-Identifier: MIT
#pragma once

#include "animation/animation.h"
#include "attractor/render/cloud_rendering.h"
#include "attractor/render/renderer.h"
#include "attractor/render/solid_rendering.h"
#include "attractor/request/space_request.h"
#include "attractor/threads/workers.h"
#include "ifs/extent/extent.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace web {

// An entry of one dimension, without what says how it is shown.
template <int Dim> struct Loaded {
    ifs::IteratedFunctionSystem<Dim> system;
    std::optional<ifs::ControlCage<Dim>> cage;
    std::vector<ifs::MovedBranch<Dim>> moved;
    std::optional<ifs::BoundingBox<Dim>> box;
    std::optional<ifs::CanonicalSimplex<Dim>> simplex;
    std::optional<animation::Animation<Dim>> animation;
    bool ownsCage = false; // the entry stores a cage, to which its animation refers
};

// What a picture shows of an entry, at rest or at a moment.
template <int Dim> struct Shown {
    ifs::IteratedFunctionSystem<Dim> system;
    std::optional<ifs::ControlCage<Dim>> cage;
    std::vector<ifs::MovedBranch<Dim>> moved;
    attractor::Appearance appearance;
    attractor::SpaceAppearance inSpace;
    std::optional<animation::CameraPose<Dim>> camera; // nullopt: no key sets it
    std::vector<animation::CameraTurn> orbit;
};

// An engine without what draws entries in space, or without what moves entries, is much smaller.
#ifdef BARYCAGE_PLANE_ONLY
constexpr bool knowsSpace = false;
#else
constexpr bool knowsSpace = true;
#endif
#ifdef BARYCAGE_STILL
constexpr bool knowsMotion = false;
#else
constexpr bool knowsMotion = true;
#endif

// State of an engine between the calls of its interface.
struct Engine {
    int dimension = 2;
    Loaded<2> plane;
    Loaded<3> space;
    attractor::Appearance appearance;
    attractor::SpaceAppearance inSpace;
    attractor::Camera camera;
    attractor::OrbitCamera orbit;
    std::optional<animation::Moment> moment; // nullopt: at rest
    bool followsCamera = false;              // keys of the camera set it

    std::unique_ptr<attractor::Rendering> density;
    std::unique_ptr<attractor::CloudRendering> cloud;
    std::unique_ptr<attractor::SolidRendering> solid;
    attractor::Workers alone{1};
    attractor::Frame frame;
    std::optional<attractor::Exposure> exposure;
    std::vector<std::uint32_t> pixels; // picture of an entry in space
    std::vector<std::uint8_t> straight;

    bool isSpace() const { return knowsSpace && dimension == 3; }
    template <class Work> auto with(const Work& work) { return isSpace() ? work(space) : work(plane); }
    std::span<const std::uint32_t> picture() const {
        return isSpace() ? std::span<const std::uint32_t>(pixels) : frame.pixels;
    }
    template <int Dim> Shown<Dim> shown(const Loaded<Dim>& loaded) const;
    attractor::Camera cameraOf(const Shown<2>& shown) const;
    attractor::OrbitCamera cameraOf(const Shown<3>& shown) const;
    double drawPlane(double samples, bool begin);
    double drawSpace(double samples, bool begin);
    double drawCloud(attractor::SpaceRequest request, bool begin);
    void drawSolid(attractor::SpaceRequest request, const Shown<3>& shown);
};

} // namespace web
