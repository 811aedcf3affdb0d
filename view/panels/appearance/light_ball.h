// SPDX-License-Identifier: MIT
#pragma once

#include <QTimer>
#include <QWidget>

namespace view {

// The direction of the key light: a small lit sphere. The light is dragged over it, or moved with the arrow
// keys. One drag or one run of keys is one edit: tried() while it lasts, then accepted() or rejected().
class LightBall : public QWidget {
    Q_OBJECT

public:
    explicit LightBall(QWidget* parent = nullptr);

    // Degrees from the line of sight: attractor::lampAt().
    void setDirection(double azimuth, double elevation);
    double azimuth() const { return m_azimuth; }
    double elevation() const { return m_elevation; }

    QSize sizeHint() const override;

signals:
    void tried(double azimuth, double elevation);
    void accepted();
    void rejected();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    QPointF spot() const; // position of the light in the unit disc, y up
    double radius() const;
    void dragTo(const QPointF& position);
    void offer(double azimuth, double elevation);

    double m_azimuth = -40;
    double m_elevation = 40;
    bool m_isDragging = false;
    QTimer m_settled; // ends a run of keys
};

} // namespace view
