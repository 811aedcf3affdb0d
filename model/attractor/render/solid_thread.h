// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/depth_raster.h"
#include "attractor/light/solid_appearance.h"
#include "attractor/light/stereo.h"
#include "attractor/request/space_request.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace attractor {

// A finished picture of a solid: an immutable result.
struct SolidFrame {
    std::uint64_t revision = 0;
    OrbitCamera camera; // camera of the request; in stereo, of each eye
    Stereo stereo = Stereo::None;
    double eyeShift = 0; // shift of the eye that the raster belongs to
    int step = 1;        // side of a pixel of this picture, in pixels of the request; their middles coincide
    DepthRaster raster;  // nearest points by pixel
    // 0xAARRGGBB, premultiplied: as many as the raster has, side by side twice as many
    std::vector<std::uint32_t> pixels;
    RenderNote note = RenderNote::None;
    bool isCoarse = false;   // true if so many pieces overlap that parts may be missing
    double milliseconds = 0; // duration of the drawing
};

// The depth of what a frame shows at a pixel of its request, in units of the system, 0 in the plane of the
// target; infinite where nothing is seen.
double depthAt(const SolidFrame& frame, const ifs::Vector<2>& pixel);

// A worker thread around SolidRendering and its light, or the density for the looks that show it: the newest
// request wins, an older one is abandoned within milliseconds. While requests come from a hand that moves,
// pictures are as coarse as keeps them fluid; the exact one follows once it rests; a density goes on to
// collect samples.
class SolidThread {
public:
    // `frameReady` is called on the worker thread, never again before newestFrame() has been called since.
    explicit SolidThread(std::function<void()> frameReady);
    ~SolidThread(); // stops and joins

    SolidThread(const SolidThread&) = delete;
    SolidThread& operator=(const SolidThread&) = delete;

    struct Job {
        SpaceRequest request;
        LookInSpace look = LookInSpace::Stone;
        SolidAppearance appearance; // solids only
        bool isLive = false;        // true: similar requests will follow
        Stereo stereo = Stereo::None;
    };
    void submit(Job job); // thread-safe
    void cancel();        // drops the present request; the newest frame stays

    // Thread-safe; nullptr before the first frame.
    std::shared_ptr<const SolidFrame> newestFrame();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace attractor
