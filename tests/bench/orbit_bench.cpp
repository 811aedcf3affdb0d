// SPDX-License-Identifier: MIT
#include "bench/orbit_bench.h"

#include "bridges/solid_bridge.h"
#include "document/document.h"
#include "document/fractal/fractal.h"
#include "space/space_view.h"

#include <QCoreApplication>
#include <QMouseEvent>

#include <chrono>
#include <cmath>

namespace orbit_bench {

namespace {

// Notes when the viewport has been painted with a picture of the camera as it is.
class Watch : public QObject {
public:
    Watch(const view::SolidBridge* bridge, QObject* viewport) : m_bridge(bridge) {
        viewport->installEventFilter(this);
    }
    void await(bool exact) const {
        while (!isShown() || (exact && !m_bridge->isCurrent()))
            QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
    }

protected:
    // The picture is painted, and handed to the screen, before processEvents() returns.
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::Paint) m_painted = m_bridge->frame();
        return false;
    }

private:
    bool isShown() const {
        return m_painted && m_painted == m_bridge->frame() && m_painted->camera == m_bridge->camera();
    }

    const view::SolidBridge* m_bridge;
    std::shared_ptr<const attractor::SolidFrame> m_painted;
};

// The right button turns the view wherever it is pressed.
void send(const view::SpaceView& view, QEvent::Type type, const QPointF& at) {
    const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::RightButton;
    const Qt::MouseButtons held = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::RightButton;
    QMouseEvent event(type, at, view.viewport()->mapToGlobal(at), button, held, Qt::NoModifier);
    QCoreApplication::sendEvent(view.viewport(), &event);
}

} // namespace

Orbit measure(const ifs::IteratedFunctionSystem<3>& system, int moves, const QSize& size) {
    document::Fractal fractal;
    fractal.shape = document::Shape<3>{system};
    document::Document document;
    document.setFile(document::fileOf(fractal));
    view::SolidBridge bridge(&document);
    view::SpaceView view(&document, &bridge);
    view.setFixedSize(size);
    view.show();
    const Watch watch(&bridge, view.viewport());
    watch.await(true);
    const QPointF press(0.1 * size.width(), 0.9 * size.height());
    send(view, QEvent::MouseButtonPress, press);
    Orbit orbit;
    for (int move = 1; move <= moves; ++move) {
        const QPointF at = press + QPointF(300 * std::sin(0.02 * move), 80 * std::sin(0.05 * move));
        const auto begin = std::chrono::steady_clock::now();
        send(view, QEvent::MouseMove, at);
        watch.await(false);
        const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
        orbit.milliseconds.push_back(time.count());
        orbit.steps.push_back(bridge.frame()->step);
    }
    send(view, QEvent::MouseButtonRelease, press);
    return orbit;
}

} // namespace orbit_bench
