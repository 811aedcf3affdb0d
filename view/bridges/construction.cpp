// SPDX-License-Identifier: MIT
#include "bridges/construction.h"

#include "attractor/folds/prefractal.h"
#include "bridges/render_bridge.h"
#include "document/fractal_geometry.h"

#include <algorithm>
#include <cmath>

namespace view {

namespace {

constexpr int maxSteps = 30;                 // of a system of one map
constexpr int tick = 33;                     // milliseconds
constexpr std::uint64_t followable = 50'000; // points whose last jumps are shown

} // namespace

Construction::Construction(document::Document* document, RenderBridge* bridge, QObject* parent)
    : QObject(parent), m_document(document), m_bridge(bridge) {
    m_tick.setInterval(tick);
    connect(&m_tick, &QTimer::timeout, this, &Construction::advance);
    connect(document, &document::Document::changed, this, &Construction::follow);
    measure();
}

void Construction::setMode(Mode mode) {
    if (mode == m_mode) return;
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
    if (running == isRunning() || (running && (m_mode != Mode::ChaosGame || m_points >= maxPoints))) return;
    m_due = 0;
    m_sinceTick.start();
    running ? m_tick.start() : m_tick.stop();
    emit changed();
}

void Construction::plotOne() {
    setRunning(false);
    plot(m_points + 1);
}

void Construction::setPoints(std::uint64_t points) {
    m_due = 0;
    plot(points);
}

void Construction::startAgain() {
    ++m_seed;
    m_orbit.reset();
    plot(0);
}

void Construction::setSpeed(double pointsPerSecond) {
    m_speed = pointsPerSecond;
    m_due = 0;
    emit changed();
}

void Construction::advance() {
    // At most a quarter of a second at a time: what a busy machine missed is not made up for.
    m_due += m_speed * std::min(0.25, double(m_sinceTick.restart()) / 1000);
    const double whole = std::floor(m_due);
    if (whole < 1) return;
    m_due -= whole;
    plot(m_points + std::uint64_t(whole));
}

void Construction::plot(std::uint64_t points) {
    m_points = std::min(points, maxPoints);
    if (m_points == maxPoints) m_tick.stop();
    show();
}

void Construction::follow(const document::Change& change) {
    using document::Change;
    if (change.parts & (Change::Current | Change::File)) {
        m_tick.stop();
        m_points = 0;
    }
    if (change.parts & (Change::System | Change::Current | Change::File)) {
        m_orbit.reset();
        measure();
        show();
    } else if (change.parts & Change::Cage) {
        updateTrail();
    }
}

void Construction::measure() {
    const document::System2* system = document::system2(m_document->fractal());
    m_maps = system ? ifs::countActive(*system) : 0;
    m_deepest = attractor::affordableIterations(m_maps, maxSteps);
    m_step = std::min(m_step, m_deepest);
}

void Construction::show() {
    switch (m_mode) {
    case Mode::Density:
        m_bridge->showDensity();
        break;
    case Mode::Steps:
        m_bridge->showSteps(m_step);
        break;
    case Mode::ChaosGame:
        m_bridge->showChaosGame(m_points, m_seed);
        break;
    }
    updateTrail();
    emit changed();
}

void Construction::updateTrail() {
    const bool had = !m_trail.empty();
    m_trail.clear();
    m_lastMap.reset();
    const document::Fractal& fractal = m_document->fractal();
    const document::System2* system = document::system2(fractal);
    if (m_mode == Mode::ChaosGame && system && m_points > 0 && m_points <= followable) {
        if (!m_orbit) m_orbit.emplace(attractor::prepared(*system, document::movedBranches(fractal)), m_seed);
        const auto& points = m_orbit->after(m_points);
        const ifs::Placement display = document::placement(fractal);
        for (const auto& point : points)
            m_trail.push_back(display(point.x));
        if (!points.empty()) m_lastMap = points.back().map;
    }
    if (had || !m_trail.empty()) emit trailChanged();
}

} // namespace view
