// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"

#include <QTimer>
#include <QWidget>

#include <cstddef>

namespace view {

// A gradient with its stops as handles below it. The handles are dragged, or walked with Tab-less keys: Page
// Up and Page Down (or Ctrl with the arrows) choose one, the arrows move it (Shift: ten times as far), Insert
// adds one after it, Delete removes it, Enter asks for its colour. One drag or one run of arrow keys is one
// edit: tried() while it lasts, then accepted() or rejected().
class GradientStrip : public QWidget {
    Q_OBJECT

public:
    explicit GradientStrip(QWidget* parent = nullptr);

    const attractor::Palette& gradient() const { return m_gradient; }
    void setGradient(const attractor::Palette& gradient);
    std::size_t selected() const { return m_selected; }
    void select(std::size_t stop);
    void add(double position); // also selects the new stop
    void addAfterSelected();
    void removeSelected();
    QPoint handleOf(std::size_t stop) const; // middle of the handle in the widget

    QSize sizeHint() const override { return {240, 44}; }
    QSize minimumSizeHint() const override { return {120, 44}; }

signals:
    void selectionChanged();
    void tried(const QString& what, const attractor::Palette& gradient);
    void accepted();
    void rejected();
    void colourWanted();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    bool event(QEvent* event) override;

private:
    QRectF bar() const;
    double positionAt(double x) const;
    int stopAt(const QPointF& point) const; // −1: none
    void move(double position);
    void settle(); // ends a run of arrow keys
    void describe();

    attractor::Palette m_gradient;
    std::size_t m_selected = 0;
    bool m_dragging = false;
    double m_grip = 0; // pixels from the middle of the handle to the pointer
    QTimer m_settled;
};

} // namespace view
