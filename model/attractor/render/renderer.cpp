// SPDX-License-Identifier: MIT
#include "attractor/render/renderer.h"

#include "attractor/light/shadow_layer.h"
#include "attractor/render/render_state.h"
#include "attractor/request/shadow.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace attractor {

namespace {

bool isCaughtUp(RenderState& render, const std::stop_token& stop) {
    return !render.fold().interrupted() || render.complete(stop);
}

} // namespace

struct Rendering::State {
    RenderState render;
    RenderRequest request; // request for picture and shadow
    std::unique_ptr<RenderState> shadow;
    std::vector<std::uint32_t> shadowPixels;
    int passes = 0;
    double milliseconds = 0; // duration of the last pass

    // Completes the part of the present pass that a stop has left open.
    bool catchUp(const std::stop_token& stop) {
        return isCaughtUp(render, stop) && (!shadow || isCaughtUp(*shadow, stop));
    }
    void layOverShadow(Frame& frame, const std::stop_token& stop);
};

// The shadow is as bright as the picture: with its own mean density, which follows from its size, the white
// point and the gain of the picture, and as far from the mean as the picture is while it adapts.
void Rendering::State::layOverShadow(Frame& frame, const std::stop_token& stop) {
    const std::optional<Exposure> own = shadow->fold().exposure(stop);
    if (!own) return;
    Exposure shown = frame.shown;
    shown.meanDensity = frame.exposure.meanDensity > 0
                            ? own->meanDensity * frame.shown.meanDensity / frame.exposure.meanDensity
                            : own->meanDensity;
    shadowPixels.resize(frame.pixels.size());
    if (!shadow->fold().tone(shown, shadowPixels, stop)) return;
    ShadowLayer{request.appearance.shadow, request.appearance.background}.putUnder(frame.pixels,
                                                                                   shadowPixels);
}

Rendering::Rendering(RenderRequest request) : m_state(std::make_unique<State>()) {
    restart(std::move(request));
}

Rendering::~Rendering() = default;
Rendering::Rendering(Rendering&&) noexcept = default;
Rendering& Rendering::operator=(Rendering&&) noexcept = default;

void Rendering::restart(RenderRequest request) {
    std::optional<RenderRequest> shadow = shadowRequest(request);
    m_state->request = request;
    m_state->render.start(shadow ? requestAboveShadow(std::move(request)) : std::move(request));
    m_state->render.rewind(0, m_state->render.request().camera.height);
    if (!shadow) m_state->shadow.reset();
    if (shadow) {
        if (!m_state->shadow) m_state->shadow = std::make_unique<RenderState>();
        m_state->shadow->start(*std::move(shadow));
        m_state->shadow->rewind(0, m_state->request.camera.height);
    }
    m_state->passes = 0;
    m_state->milliseconds = 0;
}

bool Rendering::refine(std::stop_token stop, std::uint64_t samples) {
    const auto begin = std::chrono::steady_clock::now();
    RenderState& render = m_state->render;
    if (!m_state->catchUp(stop)) return false;
    const std::uint64_t pass = samples > 0 ? samples : render.request().samples;
    render.fold().begin(pass);
    RenderState* const shadow = m_state->shadow.get();
    if (shadow) shadow->fold().begin(shadowSamples(m_state->request, pass));
    if (!render.complete(stop) || (shadow && !shadow->complete(stop))) return false;
    ++m_state->passes;
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
    m_state->milliseconds = time.count();
    return true;
}

bool Rendering::finished() const {
    return m_state->render.finished() && (!m_state->shadow || m_state->shadow->finished());
}

Exposure Rendering::exposure(std::stop_token stop) const {
    m_state->catchUp(stop);
    return m_state->render.fold().exposure(stop).value_or(Exposure{});
}

Frame Rendering::frame(Frame reuse, std::stop_token stop, const std::optional<Exposure>& other) const {
    m_state->catchUp(stop);
    const RenderRequest& request = m_state->request;
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
    if (m_state->shadow) m_state->layOverShadow(result, stop);
    return result;
}

Frame render(const RenderRequest& request) {
    Rendering rendering(request);
    rendering.refine();
    return rendering.frame();
}

} // namespace attractor
