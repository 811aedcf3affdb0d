// SPDX-License-Identifier: MIT
#pragma once

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
};

// An engine without what draws entries in space is much smaller.
#ifdef BARYCAGE_PLANE_ONLY
constexpr bool knowsSpace = false;
#else
constexpr bool knowsSpace = true;
#endif

// State of an engine between the calls of its interface.
struct Engine {
    int dimension = 2;
    Loaded<2> plane;
    Loaded<3> space;
    attractor::Appearance appearance;
    attractor::SpaceAppearance inSpace;
    std::optional<attractor::SpaceClip> clip;
    attractor::Camera camera;
    attractor::OrbitCamera orbit;

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
    double drawPlane(double samples, bool begin);
    double drawSpace(double samples, bool begin);
    double drawCloud(attractor::SpaceRequest request, bool begin);
    void drawSolid(attractor::SpaceRequest request);
};

} // namespace web
