// SPDX-License-Identifier: MIT
#include "gestures/viewport.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPainter>
#include <QTouchEvent>
#include <QWheelEvent>
#include <QWindow>

#include <utility>

namespace view {

Viewport::Viewport(QWidget* parent) : QGraphicsView(parent) {
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setAlignment(Qt::AlignLeft | Qt::AlignTop);
    setTransformationAnchor(QGraphicsView::NoAnchor);
    setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(110, 110);
    setAcceptDrops(false); // the window handles dropped files
    viewport()->setAcceptDrops(false);
    viewport()->setMouseTracking(true);
    viewport()->setAttribute(Qt::WA_AcceptTouchEvents);
    viewport()->setCursor(Qt::CrossCursor);
}

void Viewport::showScene(QGraphicsScene* scene) {
    setScene(scene);
    connect(&input(), &ViewportInput::pointerLeft, this, &Viewport::pointerLeft);
    connect(&input(), &ViewportInput::message, this, &Viewport::message);
}

bool Viewport::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && input().needsKey(static_cast<QKeyEvent&>(*event))) {
        event->accept();
        return true;
    }
    return QGraphicsView::event(event);
}

bool Viewport::viewportEvent(QEvent* event) {
    bool isOurs = false;
    switch (event->type()) {
    case QEvent::Leave:
        input().leave();
        break;
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
        isOurs = input().touch(static_cast<QTouchEvent&>(*event));
        break;
    case QEvent::NativeGesture:
        isOurs = input().gesture(static_cast<QNativeGestureEvent&>(*event));
        break;
    default:
        break;
    }
    return isOurs || QGraphicsView::viewportEvent(event);
}

void Viewport::resizeEvent(QResizeEvent*) {
    scene()->setSceneRect(viewport()->rect());
    navigated().adoptViewport();
}

void Viewport::showEvent(QShowEvent* event) {
    QGraphicsView::showEvent(event);
    if (QWindow* handle = window()->windowHandle())
        connect(handle, &QWindow::screenChanged, &navigated(), &ViewNavigation::adoptViewport,
                Qt::UniqueConnection);
    navigated().adoptViewport();
    if (!std::exchange(m_wasShown, true)) begin();
}

void Viewport::hideEvent(QHideEvent* event) {
    input().interrupt();
    QGraphicsView::hideEvent(event);
}

void Viewport::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) adoptDesktop();
    QGraphicsView::changeEvent(event);
}

void Viewport::wheelEvent(QWheelEvent* event) {
    input().turnWheel(*event);
    event->accept();
}

void Viewport::mousePressEvent(QMouseEvent* event) {
    m_showsFocus = false;
    input().press(*event);
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
    input().handleDoubleClick(*event);
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
    input().move(*event);
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    input().release(*event);
}

void Viewport::keyPressEvent(QKeyEvent* event) {
    event->setAccepted(input().pressKey(*event));
}

void Viewport::keyReleaseEvent(QKeyEvent* event) {
    event->setAccepted(input().releaseKey(*event));
}

// The focus is shown to those who use the keyboard.
void Viewport::focusInEvent(QFocusEvent* event) {
    m_showsFocus = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
    QGraphicsView::focusInEvent(event);
    viewport()->update();
    input().setFocused(true);
}

void Viewport::focusOutEvent(QFocusEvent* event) {
    viewport()->update();
    QGraphicsView::focusOutEvent(event);
    input().setFocused(false);
}

void Viewport::drawForeground(QPainter* painter, const QRectF& area) {
    QGraphicsView::drawForeground(painter, area);
    if (!m_showsFocus || !hasFocus()) return;
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(palette().color(QPalette::Base), 4));
    painter->drawRect(sceneRect().adjusted(2, 2, -2, -2));
    painter->setPen(QPen(palette().color(QPalette::Highlight), 2));
    painter->drawRect(sceneRect().adjusted(1, 1, -1, -1));
}

} // namespace view
