// SPDX-License-Identifier: MIT
#include "bridges/construction.h"

#include "attractor/folds/prefractal.h"
#include "bridges/render_bridge.h"
#include "document/fractal/fractal_geometry.h"

#include <algorithm>
#include <cmath>

namespace view {

namespace {

constexpr int maxSteps = 30;                 // limit for a system of one map
constexpr int tick = 33;                     // milliseconds
constexpr std::uint64_t followable = 50'000; // number of jumps up to which the last ones are shown
constexpr std::size_t followed = 8;          // number of shown jumps

} // namespace

Construction::Construction(document::Document* document, RenderBridge* bridge, QObject* parent)
    : QObject(parent), m_document(document), m_bridge(bridge), m_steps(document, bridge) {
    m_tick.setInterval(tick);
    connect(&m_tick, &QTimer::timeout, this, &Construction::advance);
    connect(document, &document::Document::changed, this, &Construction::follow);
    connect(&m_steps, &StepsBridge::changed, this, &Construction::changed);
    measure();
}

void Construction::setMode(Mode mode) {
    if (mode == m_mode) return;
    if (mode != Mode::Density) emit starting();
    m_mode = mode;
    m_tick.stop();
    measure();
    show();
}

void Construction::setStep(int n) {
    const int step = std::clamp(n, 0, m_deepest);
    if (step == m_step) return;
    m_step = step;
    show();
}

double Construction::copies() const {
    return std::pow(double(m_maps), m_step);
}

void Construction::setRunning(bool running) {
    if (running == isRunning() || (running && (m_mode != Mode::ChaosGame || points() >= maxPoints))) return;
    m_due = 0;
    m_sinceTick.start();
    running ? m_tick.start() : m_tick.stop();
    emit changed();
}

void Construction::jumpOnce() {
    setRunning(false);
    jump(m_jumps + 1);
}

void Construction::setPoints(std::uint64_t points) {
    m_due = 0;
    jump(points == 0 ? 0 : points + dropped);
}

void Construction::startAgain() {
    ++m_seed;
    m_orbit.reset();
    jump(0);
}

void Construction::setSpeed(double jumpsPerSecond) {
    m_speed = jumpsPerSecond;
    m_due = 0;
    emit changed();
}

void Construction::advance() {
    // At most a quarter of a second at a time: time lost on a busy machine is not made up for.
    m_due += m_speed * std::min(0.25, double(m_sinceTick.restart()) / 1000);
    const double whole = std::floor(m_due);
    if (whole < 1) return;
    m_due -= whole;
    jump(m_jumps + std::uint64_t(whole));
}

void Construction::jump(std::uint64_t jumps) {
    m_jumps = std::min(jumps, maxPoints + dropped);
    if (points() == maxPoints) m_tick.stop();
    show();
}

void Construction::follow(const document::Change& change) {
    using document::Change;
    if (change.parts & (Change::Current | Change::File)) {
        m_tick.stop();
        m_jumps = 0;
    }
    if (change.parts & (Change::System | Change::Current | Change::File)) {
        m_orbit.reset();
        measure();
        show();
    } else if (change.parts & Change::Cage) {
        updateTrail();
    } else if (change.parts & Change::Appearance) {
        findFaces();
        emit changed();
    }
}

void Construction::measure() {
    const document::System2* system = document::system2(m_document->fractal());
    m_maps = system ? ifs::countActive(*system) : 0;
    m_deepest = attractor::affordableIterations(m_maps, maxSteps);
    m_step = std::min(m_step, m_deepest);
    findFaces();
}

void Construction::findFaces() {
    m_faces.clear();
    const document::Fractal& fractal = m_document->fractal();
    const document::System2* system = document::system2(fractal);
    if (!system) return;
    const std::vector<double> shares = ifs::probabilities(*system);
    for (std::size_t i = 0; i < shares.size(); ++i)
        m_faces.push_back({mapColour(fractal.appearance, system->maps[i].id, i), shares[i]});
}

void Construction::show() {
    m_steps.show(m_mode == Mode::Steps ? std::optional(m_step) : std::nullopt);
    switch (m_mode) {
    case Mode::Density:
        m_bridge->showDensity();
        break;
    case Mode::Steps:
        m_bridge->showSteps(m_step);
        break;
    case Mode::ChaosGame:
        m_bridge->showChaosGame(points(), m_seed);
        break;
    }
    updateTrail();
    emit changed();
}

std::optional<std::size_t> Construction::lastMap() const {
    return m_trail.empty() ? std::nullopt : std::optional(m_trail.back().map);
}

void Construction::updateTrail() {
    const bool had = !m_trail.empty();
    m_trail.clear();
    const document::Fractal& fractal = m_document->fractal();
    const document::System2* system = document::system2(fractal);
    if (m_mode == Mode::ChaosGame && system && m_jumps > 0 && m_jumps <= followable) {
        if (!m_orbit) m_orbit.emplace(attractor::prepared(*system, document::movedBranches(fractal)), m_seed);
        std::span<const attractor::OrbitTrail::Point> all = m_orbit->after(m_jumps);
        if (all.size() < m_jumps) all = all.last(std::min(all.size(), followed));
        const ifs::Placement display = document::placement(fractal);
        std::uint64_t number = m_jumps - all.size();
        for (const auto& point : all)
            m_trail.push_back({display(point.x), point.map, ++number > dropped});
    }
    if (had || !m_trail.empty()) emit trailChanged();
}

} // namespace view
