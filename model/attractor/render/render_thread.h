// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/render/renderer.h"

#include <functional>
#include <memory>

namespace attractor {

// A worker thread around Rendering: the newest request wins, an older one is abandoned within milliseconds.
// After the first frame of a request the picture is refined with growing passes until `quality` samples per
// picture are reached; then the thread sleeps.
class RenderThread {
public:
    enum class Brightness {
        OfThePicture, // value from Rendering
        Eased,        // short transition to that value from the previous frame
        Continued,    // same, but only if the previous frame is still in a transition
    };

    // `frameReady` is called on the worker thread, never again before newestFrame() has been called since.
    explicit RenderThread(std::function<void()> frameReady);
    ~RenderThread(); // stops and joins

    RenderThread(const RenderThread&) = delete;
    RenderThread& operator=(const RenderThread&) = delete;

    // Thread-safe. `quality` is the total number of samples to refine to; the first pass has request.samples.
    void submit(RenderRequest request, std::uint64_t quality,
                Brightness brightness = Brightness::OfThePicture);
    void cancel(); // drops the present request; the newest frame stays

    // Thread-safe; nullptr before the first frame.
    std::shared_ptr<const Frame> newestFrame();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace attractor
