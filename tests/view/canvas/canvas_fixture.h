// SPDX-License-Identifier: MIT
#pragma once

#include "bridges/render_bridge.h"
#include "canvas/canvas_view.h"
#include "canvas/geometry/canvas_geometry.h"
#include "canvas/items/note_item.h"
#include "canvas/scene/canvas_scene.h"
#include "document/fractal/fractal.h"

#include <QMouseEvent>
#include <QTest>

#include <memory>

using document::Document;
using ifs::Vector;
using view::CanvasPart;
using view::CanvasView;
using Kind = view::CanvasPart::Kind;

// A canvas with the first picture, and the pointer over it: events with buttons and modifiers of our own.
class CanvasFixture : public QObject {
protected:
    std::unique_ptr<Document> m_document;
    std::unique_ptr<view::RenderBridge> m_bridge;
    std::unique_ptr<CanvasView> m_canvas;

    void open(const QSize& size = {640, 480}) {
        close();
        m_document = std::make_unique<Document>();
        m_bridge = std::make_unique<view::RenderBridge>(m_document.get());
        m_bridge->setQuality(1'000'000);
        m_canvas = std::make_unique<CanvasView>(m_document.get(), m_bridge.get());
        m_canvas->resize(size);
        m_canvas->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_canvas.get()));
        m_canvas->setFocus();
    }
    void close() {
        m_canvas.reset();
        m_bridge.reset();
        m_document.reset();
    }

    const view::CanvasScene& scene() const { return m_canvas->canvas(); }
    int steps() const { return m_document->undoStack()->count(); }
    QString undoText() const { return m_document->undoStack()->undoText(); }
    const document::System2& system() const { return *document::system2(m_document->fractal()); }
    QPointF at(const CanvasPart& part) const { return scene().positionOf(part); }
    QString stopNote() const {
        for (const QGraphicsItem* item : scene().items())
            if (const auto* note = dynamic_cast<const view::NoteItem*>(item);
                note && note->text().startsWith(QStringLiteral("Stopped")))
                return note->text();
        return {};
    }
    // Of the control cage.
    const std::vector<Vector<2>>& vertices() const { return m_canvas->canvas().handles().cage()->current; }
    QPoint vertex(int index) const { return at({Kind::Vertex, index}).toPoint(); }
    QPoint empty() const { return {12, 12}; }
    QPoint inside() const {
        return ((m_canvas->canvas().positionOf({Kind::Vertex, 0}) * 2 +
                 m_canvas->canvas().positionOf({Kind::Edge, 1}) * 3) /
                5)
            .toPoint();
    }
    Qt::CursorShape cursor() const { return m_canvas->viewport()->cursor().shape(); }

    void mouse(QEvent::Type type, const QPointF& p, Qt::MouseButton button, Qt::MouseButtons buttons,
               Qt::KeyboardModifiers modifiers) {
        QMouseEvent event(type, p, m_canvas->viewport()->mapToGlobal(p), button, buttons, modifiers);
        QCoreApplication::sendEvent(m_canvas->viewport(), &event);
    }
    void press(const QPointF& p, Qt::KeyboardModifiers modifiers = {},
               Qt::MouseButton button = Qt::LeftButton) {
        mouse(QEvent::MouseButtonPress, p, button, button, modifiers);
    }
    void move(const QPointF& p, Qt::KeyboardModifiers modifiers = {},
              Qt::MouseButtons buttons = Qt::LeftButton) {
        mouse(QEvent::MouseMove, p, Qt::NoButton, buttons, modifiers);
    }
    void release(const QPointF& p, Qt::KeyboardModifiers modifiers = {},
                 Qt::MouseButton button = Qt::LeftButton) {
        mouse(QEvent::MouseButtonRelease, p, button, Qt::NoButton, modifiers);
    }
    void hover(const QPointF& p) { move(p, {}, Qt::NoButton); }
    void drag(const QPointF& from, const QPointF& by, Qt::KeyboardModifiers modifiers = {}) {
        press(from, modifiers);
        for (const double part : {0.3, 0.7, 1.0})
            move(from + by * part, modifiers);
        release(from + by, modifiers);
    }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(m_canvas.get(), key, modifiers);
    }
    void click(const QPointF& p, Qt::KeyboardModifiers modifiers = {}) {
        press(p, modifiers);
        release(p, modifiers);
    }
};
