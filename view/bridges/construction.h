// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/samples/orbit_trail.h"
#include "bridges/steps_bridge.h"
#include "document/document.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace view {

class RenderBridge;

// The construction of the attractor shown on the canvas: its density, the steps Wⁿ of the deterministic
// algorithm from the cage or another shape, or a chaos game that grows point by point. A state of the view:
// no part of the document, no undo.
class Construction : public QObject {
    Q_OBJECT

public:
    enum class Mode { Density, Steps, ChaosGame };
    static constexpr std::uint64_t maxPoints = 10'000'000;
    static constexpr std::uint64_t dropped = attractor::Orbit::skipped; // jumps that are not plotted

    Construction(document::Document* document, RenderBridge* bridge, QObject* parent = nullptr);

    Mode mode() const { return m_mode; }
    void setMode(Mode mode); // pauses the chaos game when it leaves it

    int step() const { return m_step; } // n
    void setStep(int n);
    int deepest() const { return m_deepest; } // largest n that is drawn
    double copies() const;                    // number of copies of the cage in Wⁿ
    StepsBridge& steps() { return m_steps; }  // start of the steps, and their distance from the attractor

    // Jumps of the chaos game, including those that are not plotted.
    std::uint64_t jumps() const { return m_jumps; }
    std::uint64_t points() const { return m_jumps - std::min(m_jumps, dropped); } // jumps that are plotted
    bool isRunning() const { return m_tick.isActive(); }
    void setRunning(bool running);
    void jumpOnce();
    void setPoints(std::uint64_t points); // number of plotted points, from the start of the chaos game
    void startAgain();                    // clears the points and draws another seed; keeps running
    double speed() const { return m_speed; }
    void setSpeed(double jumpsPerSecond);

    // The end of a jump, as displayed.
    struct Jump {
        ifs::Vector<2> x;
        std::size_t map = 0;    // index in the system of the map that was applied
        bool isPlotted = false; // false for the first jumps
    };
    // The jumps, the newest last: all of them while they are so few that each can be seen, then the last ones
    // while they can be followed; empty but in a chaos game.
    const std::vector<Jump>& trail() const { return m_trail; }
    std::optional<std::size_t> lastMap() const; // map of the newest jump

    // A face of the die for each map, as wide as its share of the jumps.
    struct Face {
        attractor::Rgba colour;
        double share = 0; // 0 if the map does not take part
    };
    const std::vector<Face>& faces() const { return m_faces; }

signals:
    void starting(); // sent before steps or a chaos game take the canvas
    void changed();
    void trailChanged();

private:
    void follow(const document::Change& change);
    void measure(); // updates values that depend on the system
    void findFaces();
    void advance();
    void jump(std::uint64_t jumps);
    void show();
    void updateTrail();

    document::Document* m_document;
    RenderBridge* m_bridge;
    StepsBridge m_steps;
    Mode m_mode = Mode::Density;
    int m_step = 0;
    int m_deepest = 0;
    std::size_t m_maps = 0; // number of maps that take part
    std::uint64_t m_jumps = 0;
    std::uint64_t m_seed = 1;
    double m_speed = 10;
    double m_due = 0; // jumps due, including a fraction
    QTimer m_tick;
    QElapsedTimer m_sinceTick;
    std::optional<attractor::OrbitTrail> m_orbit;
    std::vector<Jump> m_trail;
    std::vector<Face> m_faces;
};

} // namespace view
