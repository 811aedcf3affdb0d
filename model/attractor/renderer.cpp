// SPDX-License-Identifier: MIT
#include "attractor/renderer.h"

#include "attractor/picture.h"

#include <chrono>

namespace attractor {

struct Rendering::State : Picture {};

Rendering::Rendering(RenderRequest request) : m_state(std::make_unique<State>()) {
    restart(std::move(request));
}

Rendering::~Rendering() = default;
Rendering::Rendering(Rendering&&) noexcept = default;
Rendering& Rendering::operator=(Rendering&&) noexcept = default;

void Rendering::restart(RenderRequest request) {
    m_state->start(std::move(request));
    m_state->rewind(0, m_state->request.camera.height);
}

bool Rendering::refine(std::stop_token stop, std::uint64_t samples) {
    const auto begin = std::chrono::steady_clock::now();
    if (m_state->interrupted() && !m_state->complete(stop)) return false;
    m_state->remaining = samples > 0 ? samples : m_state->request.samples;
    if (!m_state->complete(stop)) return false;
    ++m_state->passes;
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
    m_state->milliseconds = time.count();
    return true;
}

bool Rendering::finished() const {
    return m_state->finished();
}

Exposure Rendering::exposure(std::stop_token stop) const {
    if (m_state->interrupted()) m_state->complete(stop);
    m_state->measureExposure(stop);
    return m_state->exposure.value_or(Exposure{});
}

Frame Rendering::frame(Frame reuse, std::stop_token stop, const std::optional<Exposure>& other) const {
    if (m_state->interrupted()) m_state->complete(stop);
    return m_state->frame(std::move(reuse), stop, other);
}

Frame render(const RenderRequest& request) {
    Rendering rendering(request);
    rendering.refine();
    return rendering.frame();
}

} // namespace attractor
