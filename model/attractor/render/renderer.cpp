// SPDX-License-Identifier: MIT
#include "attractor/render/renderer.h"

#include "attractor/render/render_state.h"

#include <algorithm>
#include <chrono>

namespace attractor {

struct Rendering::State {
    RenderState render;
    int passes = 0;
    double milliseconds = 0; // of the last one

    // What a stop has left of the present pass.
    bool catchUp(const std::stop_token& stop) {
        return !render.fold().interrupted() || render.complete(stop);
    }
};

Rendering::Rendering(RenderRequest request) : m_state(std::make_unique<State>()) {
    restart(std::move(request));
}

Rendering::~Rendering() = default;
Rendering::Rendering(Rendering&&) noexcept = default;
Rendering& Rendering::operator=(Rendering&&) noexcept = default;

void Rendering::restart(RenderRequest request) {
    m_state->render.start(std::move(request));
    m_state->render.rewind(0, m_state->render.request().camera.height);
    m_state->passes = 0;
    m_state->milliseconds = 0;
}

bool Rendering::refine(std::stop_token stop, std::uint64_t samples) {
    const auto begin = std::chrono::steady_clock::now();
    RenderState& render = m_state->render;
    if (!m_state->catchUp(stop)) return false;
    render.fold().begin(samples > 0 ? samples : render.request().samples);
    if (!render.complete(stop)) return false;
    ++m_state->passes;
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
    m_state->milliseconds = time.count();
    return true;
}

bool Rendering::finished() const {
    return m_state->render.finished();
}

Exposure Rendering::exposure(std::stop_token stop) const {
    m_state->catchUp(stop);
    return m_state->render.fold().exposure(stop).value_or(Exposure{});
}

Frame Rendering::frame(Frame reuse, std::stop_token stop, const std::optional<Exposure>& other) const {
    m_state->catchUp(stop);
    const RenderRequest& request = m_state->render.request();
    Fold& fold = m_state->render.fold();
    Frame result;
    result.pixels = std::move(reuse.pixels);
    result.revision = request.revision;
    result.camera = request.camera;
    result.samples = fold.samples();
    result.measure = fold.measure();
    result.passes = m_state->passes;
    result.iterations = fold.iterations();
    result.note = m_state->render.note();
    result.opaque = request.appearance.background.alpha == 255;
    result.milliseconds = m_state->milliseconds;
    const auto width = static_cast<std::size_t>(std::max(0, request.camera.width));
    const auto height = static_cast<std::size_t>(std::max(0, request.camera.height));
    result.pixels.resize(width * height);
    if (width * height == 0) return result;
    const std::optional<Exposure> exposure = fold.exposure(stop);
    if (!exposure) return result;
    result.exposure = *exposure;
    result.shown = other ? *other : *exposure;
    fold.tone(result.shown, result.pixels, stop);
    return result;
}

Frame render(const RenderRequest& request) {
    Rendering rendering(request);
    rendering.refine();
    return rendering.frame();
}

} // namespace attractor
