// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/samples/orbit_trail.h"
#include "document/document.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <cstdint>
#include <optional>
#include <vector>

namespace view {

class RenderBridge;

// How the attractor arises: whether the canvas shows its density, the steps Wⁿ(cage) of the deterministic
// algorithm, or a chaos game that grows point by point. A state of the view: no part of the document, no
// undo.
class Construction : public QObject {
    Q_OBJECT

public:
    enum class Mode { Density, Steps, ChaosGame };
    static constexpr std::uint64_t maxPoints = 10'000'000;

    Construction(document::Document* document, RenderBridge* bridge, QObject* parent = nullptr);

    Mode mode() const { return m_mode; }
    void setMode(Mode mode); // leaving the chaos game pauses it

    int step() const { return m_step; } // n
    void setStep(int n);
    int deepest() const { return m_deepest; } // the largest n that is drawn
    double copies() const;                    // of the cage in Wⁿ

    std::uint64_t points() const { return m_points; }
    bool isRunning() const { return m_tick.isActive(); }
    void setRunning(bool running);
    void plotOne();
    void setPoints(std::uint64_t points); // the first of the chaos game
    void startAgain();                    // no points, other dice; keeps running
    double speed() const { return m_speed; }
    void setSpeed(double pointsPerSecond);

    // The last points, the newest last, as they are displayed; empty but in a chaos game of few points.
    const std::vector<ifs::Vector<2>>& trail() const { return m_trail; }
    std::optional<std::size_t> lastMap() const {
        return m_lastMap;
    } // of the newest point: index in the system

signals:
    void changed();
    void trailChanged();

private:
    void follow(const document::Change& change);
    void measure(); // what depends on the system
    void advance();
    void plot(std::uint64_t points);
    void show();
    void updateTrail();

    document::Document* m_document;
    RenderBridge* m_bridge;
    Mode m_mode = Mode::Density;
    int m_step = 0;
    int m_deepest = 0;
    std::size_t m_maps = 0; // that take part
    std::uint64_t m_points = 0;
    std::uint64_t m_seed = 1;
    double m_speed = 10;
    double m_due = 0; // points, a fraction of one may be left over
    QTimer m_tick;
    QElapsedTimer m_sinceTick;
    std::optional<attractor::OrbitTrail> m_orbit;
    std::vector<ifs::Vector<2>> m_trail;
    std::optional<std::size_t> m_lastMap;
};

} // namespace view
