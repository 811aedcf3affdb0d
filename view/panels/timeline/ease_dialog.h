// SPDX-License-Identifier: MIT
#pragma once

#include "animation/keys/ease.h"

#include <QDialog>
#include <QPointF>

#include <optional>

class QDoubleSpinBox;

namespace view {

// The curve of a custom ease, time to the right and the way upwards, with its two handles to drag.
class EaseCurve : public QWidget {
    Q_OBJECT

public:
    explicit EaseCurve(QWidget* parent = nullptr);

    const animation::Ease& ease() const { return m_ease; }
    void setEase(const animation::Ease& ease);
    QPointF handle(int index) const; // `index`: 0 or 1; position in the widget

    QSize sizeHint() const override { return {260, 260}; }

signals:
    void changed(); // sent for drags

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    QRectF square() const;
    QPointF at(double x, double y) const;
    void dragTo(const QPointF& point);

    animation::Ease m_ease;
    std::optional<int> m_held;
};

// Asks for a custom ease: by dragging, or in numbers. What would be too steep is drawn towards the straight
// line.
class EaseDialog : public QDialog {
    Q_OBJECT

public:
    explicit EaseDialog(const animation::Ease& ease, QWidget* parent = nullptr);

    animation::Ease ease() const { return m_curve->ease(); }
    EaseCurve* curve() const { return m_curve; }

private:
    void showNumbers();
    void takeNumbers();

    EaseCurve* m_curve;
    QDoubleSpinBox* m_numbers[4];
};

} // namespace view
