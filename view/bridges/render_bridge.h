// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/render/render_thread.h"
#include "attractor/render/renderer.h"
#include "attractor/request/camera.h"
#include "document/document.h"

#include <QObject>
#include <QTimer>

#include <memory>

namespace view {

// The only place that knows both the document and the render thread: every change of the document or the
// camera becomes a request, every finished frame a signal in the GUI thread.
class RenderBridge : public QObject {
    Q_OBJECT

public:
    explicit RenderBridge(document::Document* document, QObject* parent = nullptr);
    ~RenderBridge() override;

    void setCamera(const attractor::Camera& camera); // device pixels; nothing is drawn before the first call
    const attractor::Camera& camera() const { return m_camera; }

    // Number of samples at which an idle picture stops refining.
    void setQuality(std::uint64_t samples);
    std::uint64_t quality() const { return m_quality; }

    // Content of the picture: the density, refined while at rest; Wⁿ of the cage at rest; or an exact number
    // of points of the chaos game.
    void showDensity();
    void showSteps(int iterations);
    void showChaosGame(std::uint64_t points, std::uint64_t seed);

    // Draws this in place of the document, which must be of the plane, too; nullptr: the document again.
    void showInstead(std::shared_ptr<const document::Fractal> fractal);
    // The same of one of many, in motion: each waits for the frame before it, and none is refined.
    void showMoving(std::shared_ptr<const document::Fractal> fractal); // never null

    // The newest frame; null until one is drawn, and for entries in space.
    std::shared_ptr<const attractor::Frame> frame() const { return m_frame; }
    bool isCurrent() const; // true if the frame shows the present document and camera

    // Samples in the first pass of a frame during a gesture: what this machine does in one sixtieth of a
    // second.
    std::uint64_t liveSamples() const { return m_liveSamples; }
    // Turns the adaptive sample budget off, for benchmarks.
    void fixLiveSamples(std::uint64_t samples);

    // Pictures from elsewhere, such as stolen colours: while on, every change asks for one by wanted(), and
    // those that are taken are shown in place of the density.
    void setSubstituted(bool on);
    bool isSubstituted() const { return m_isSubstituted; }
    void take(std::shared_ptr<const attractor::Frame> frame); // never null
    std::uint64_t requested() const { return m_requested; }   // newest revision

signals:
    void qualityChanged(std::uint64_t samples);
    void frameChanged();
    void wanted(bool live);

private:
    // Meaning of brightness relative to the frame before.
    enum class Exposing { Kept, Eased, Measured };

    // Treatment of an older request.
    enum class Haste {
        // Abandons it.
        Now,
        // Queued behind the frame under way, so that a stream of changes starves no frame.
        InTurn,
    };

    struct Shown {
        attractor::Algorithm algorithm = attractor::Algorithm::Density;
        int iterations = 0;
        std::uint64_t points = 0;
        std::uint64_t seed = 1;
        friend bool operator==(const Shown&, const Shown&) = default;
    };

    void show(const Shown& shown);
    void follow(const document::Change& change);
    void request(Haste haste);
    void submit();
    void takeFrame();
    void turnEnds();
    void adaptBudget(const attractor::Frame& frame);

    document::Document* m_document;
    std::shared_ptr<const document::Fractal> m_instead; // fractal shown in place of the document; null: none
    attractor::Camera m_camera;
    std::shared_ptr<const attractor::Frame> m_frame;
    Shown m_shown;
    std::uint64_t m_shownFrom = 1; // first request of m_shown
    std::uint64_t m_quality = 200'000'000;
    std::uint64_t m_liveSamples = 4'000'000;
    std::uint64_t m_requested = 0;    // revision of the newest request
    std::uint64_t m_measuredFrom = 1; // first of the requests that share their exposure
    Exposing m_exposing = Exposing::Measured;
    bool m_adapting = true; // true: m_liveSamples adapts to the speed of the machine
    bool m_live = false;
    bool m_isMoving = false; // true: m_instead moves
    bool m_waiting = false;  // true: a request is scheduled
    bool m_isSubstituted = false;
    QTimer m_underWay; // running until the first frame of the newest request, or a timeout
    std::unique_ptr<attractor::RenderThread> m_thread; // last member: its thread uses the others
};

} // namespace view
