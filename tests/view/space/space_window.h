// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/space_geometry.h"
#include "space/space_view.h"

#include <QtTest>

#include <memory>

// A window into space that shows a solid, and what a hand does in it.
namespace space_window {

inline document::Fractal cubeOfEight() {
    document::Fractal fractal;
    fractal.name = QStringLiteral("cube");
    document::Shape<3> cube;
    for (int corner = 0; corner < 8; ++corner)
        ifs::append<3>(cube.system,
                       {0.5 * ifs::Matrix<3>::Identity(),
                        ifs::Vector<3>((corner & 1) / 2.0, (corner >> 1 & 1) / 2.0, (corner >> 2) / 2.0)});
    fractal.shape = cube;
    return fractal;
}

struct Window {
    document::Document document;
    std::unique_ptr<view::SolidBridge> bridge;
    std::unique_ptr<view::SpaceView> view;

    explicit Window(const document::Fractal& fractal = cubeOfEight()) {
        document.edit(QStringLiteral("Begin"), fractal);
        document.undoStack()->clear();
        bridge = std::make_unique<view::SolidBridge>(&document);
        view = std::make_unique<view::SpaceView>(&document, bridge.get());
        view->resize(600, 500);
        view->show();
        view->setFocus();
    }

    const attractor::OrbitCamera& camera() const { return view->navigation().camera(); }
    QPoint handle(std::size_t vertex) const { return view->cageItem().handle(vertex).toPoint(); }
    bool rests() const {
        return QTest::qWaitFor([&] { return bridge->isCurrent(); }, 20000);
    }
    // As a hand does it: the motion in small steps, with keys pressed between them.
    void send(QEvent::Type type, QPointF at, Qt::MouseButton button,
              Qt::KeyboardModifiers modifiers = {}) const {
        QWidget* viewport = view->viewport();
        const Qt::MouseButton own = type == QEvent::MouseMove ? Qt::NoButton : button;
        const Qt::MouseButtons held = type == QEvent::MouseButtonRelease ? Qt::NoButton : button;
        QMouseEvent event(type, at, viewport->mapToGlobal(at), own, held, modifiers);
        QCoreApplication::sendEvent(viewport, &event);
    }
    void drag(const QPointF& from, const QPointF& to, Qt::MouseButton button = Qt::LeftButton,
              Qt::KeyboardModifiers modifiers = {}) const {
        send(QEvent::MouseButtonPress, from, button, modifiers);
        for (int step = 1; step <= 10; ++step)
            send(QEvent::MouseMove, from + (to - from) * step / 10, button, modifiers);
        send(QEvent::MouseButtonRelease, to, button, modifiers);
    }
    std::vector<ifs::Vector<3>> vertices() const { return document::spaceCage(document.fractal())->current; }
};

inline int lightness(const QImage& image, const QPoint& at) {
    return image.pixelColor(at).lightness();
}

} // namespace space_window
