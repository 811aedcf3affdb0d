// SPDX-License-Identifier: MIT
#include "bench/canvas_drag.h"

#include "attractor/tops/picture_patterns.h"
#include "bridges/render_bridge.h"
#include "bridges/theft_bridge.h"
#include "canvas/canvas_view.h"
#include "canvas/geometry/canvas_part.h"
#include "canvas/scene/canvas_scene.h"
#include "document/document.h"
#include "document/edits/entries_edits.h"
#include "document/fractal/fractal.h"
#include "panels/timeline/playback.h"

#include <QApplication>
#include <QMouseEvent>
#include <QSplitter>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace {

// Notes when the viewport has been painted with the picture of the newest request.
class Watch : public QObject {
public:
    Watch(const view::RenderBridge* bridge, QObject* viewport) : m_bridge(bridge) {
        viewport->installEventFilter(this);
    }
    bool isShown() const { return m_bridge->isCurrent() && m_painted == m_bridge->frame()->revision; }
    void await() {
        while (!isShown())
            QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
    }

protected:
    // The picture is painted, and handed to the screen, before processEvents() returns.
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::Paint && m_bridge->frame()) m_painted = m_bridge->frame()->revision;
        return false;
    }

private:
    const view::RenderBridge* m_bridge;
    std::uint64_t m_painted = 0;
};

void send(view::CanvasView& canvas, QEvent::Type type, const QPointF& at) {
    const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, at, canvas.viewport()->mapToGlobal(at), button, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(canvas.viewport(), &event);
}

// The canvas with a document whose first picture has been painted.
struct Shown {
    Shown(const document::Fractal& fractal, std::uint64_t samples, const QSize& size = {1920, 1080}) {
        document.setFile(document::fileOf(fractal));
        bridge.fixLiveSamples(samples);
        canvas.setFixedSize(size);
        canvas.show();
        watch.await();
    }
    document::Document document;
    view::RenderBridge bridge{&document};
    view::CanvasView canvas{&document, &bridge};
    Watch watch{&bridge, canvas.viewport()};
};

// Events that are measured, after so many that are not.
std::vector<double> dragged(view::CanvasView& canvas, Watch& watch, int before, int events) {
    const QPointF start = canvas.canvas().positionOf({view::CanvasPart::Kind::Vertex, 1});
    send(canvas, QEvent::MouseButtonPress, start);
    std::vector<double> times;
    for (int event = 1; event <= before + events; ++event) {
        const QPointF at = start + QPointF(40 * std::sin(0.1 * event), 25 * std::sin(0.17 * event));
        const auto begin = std::chrono::steady_clock::now();
        send(canvas, QEvent::MouseMove, at);
        watch.await();
        const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
        if (event > before) times.push_back(time.count());
    }
    return times;
}

} // namespace

std::vector<double> scrubInCanvas(const document::Fractal& animated, std::uint64_t samples, int events) {
    Shown shown(animated, samples);
    const int length = document::animationFacts(animated)->length;
    std::vector<double> times;
    for (int event = 1; event <= events; ++event) {
        const auto begin = std::chrono::steady_clock::now();
        shown.document.setMoment(animation::moment(7 * event % length));
        shown.watch.await();
        times.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    }
    return times;
}

double lateInCanvas(document::Fractal animated, std::uint64_t samples, int frames) {
    constexpr double allowed = 16.7; // milliseconds
    auto& animation = *document::plane(animated)->animation;
    animation.length = frames;
    animation.loop = animation::Loop::Off;
    Shown shown(animated, samples);
    view::Playback playback(&shown.document);
    QObject::connect(&shown.bridge, &view::RenderBridge::frameChanged, &playback,
                     &view::Playback::countPicture);
    std::vector<double> paintedAt(std::size_t(frames) + 1, HUGE_VAL);
    const auto begin = std::chrono::steady_clock::now();
    playback.setPlaying(true);
    do {
        QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
        const std::chrono::duration<double, std::milli> now = std::chrono::steady_clock::now() - begin;
        double& painted = paintedAt[std::size_t(playback.position())];
        if (shown.watch.isShown()) painted = std::min(painted, now.count());
    } while (playback.isPlaying());
    int late = 0;
    for (int frame = 0; frame < frames; ++frame) { // the last one may still be on its way
        const double due = 1000.0 * frame * animation.rate.seconds / animation.rate.frames;
        late += paintedAt[std::size_t(frame)] > due + allowed;
    }
    return double(late) / frames;
}

std::vector<double> dragInCanvas(const ifs::IteratedFunctionSystem<2>& system, std::uint64_t samples,
                                 int events, const QSize& size) {
    document::Fractal fractal = document::Document().fractal();
    *document::system2(fractal) = system;
    document::plane(fractal)->cage.reset();
    Shown shown(fractal, samples, size);
    return dragged(shown.canvas, shown.watch, 0, events);
}

std::vector<double> dragWithStolenColours(const ifs::IteratedFunctionSystem<2>& from,
                                          const ifs::IteratedFunctionSystem<2>& to, int events) {
    constexpr int warm = 60;
    document::Fractal first, second;
    first.name = QStringLiteral("F");
    first.shape = document::Shape<2>{from};
    second.name = QStringLiteral("G");
    second.shape = document::Shape<2>{to};
    const document::Inserted both = document::inserted(
        document::fileOf(first), document::fileOf(second).entries, document::EntryId::None);
    document::Document document;
    document.setFile(both.file);
    document::PartnerDocument partner(&document);
    partner.setPartner(both.ids.front());
    view::RenderBridge onFirst(&document), onSecond(&partner.document());
    view::TheftBridge theft(&document, &onFirst, &partner, &onSecond);
    QSplitter window; // owns the canvases
    auto* canvas = new view::CanvasView(&document, &onFirst, &window);
    window.addWidget(canvas);
    window.addWidget(new view::CanvasView(&partner.document(), &onSecond, &window));
    window.setFixedSize(1920, 1080);
    window.setSizes({960, 960});
    Watch watch(&onFirst, canvas->viewport());
    theft.setPicture(
        std::make_shared<const attractor::MipPicture>(attractor::picture(attractor::Pattern::Wheel)));
    theft.setActive(true);
    window.show();
    while (!onFirst.isSubstituted())
        QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
    watch.await();
    return dragged(*canvas, watch, warm, events);
}
