// SPDX-License-Identifier: MIT
#pragma once

#include "gestures/viewport_input.h"

#include <QGraphicsView>

namespace view {

// A window onto the plane or into space, to which events come. The scene is in device-independent pixels of
// the viewport and the view's own transform stays the identity; a camera leads from there to the pixels.
class Viewport : public QGraphicsView {
    Q_OBJECT

public:
    bool cancelGesture() { return input().cancelGesture(); } // false if there was none

signals:
    void pointerLeft();
    void message(const QString& sentence); // sentence for the status bar

protected:
    explicit Viewport(QWidget* parent);
    void showScene(QGraphicsScene* scene); // also connects the gestures

    virtual ViewportInput& input() = 0;
    virtual ViewNavigation& navigated() = 0;
    virtual void adoptDesktop() = 0; // adopts palette and font
    virtual void begin() = 0;        // called before the first painting
    bool wasShown() const { return m_wasShown; }
    void refreshCursor() { viewport()->setCursor(input().cursor()); }

    bool event(QEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void drawForeground(QPainter* painter, const QRectF& area) override;

private:
    bool m_wasShown = false;
    bool m_showsFocus = false;
};

} // namespace view
