// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"

#include <QDialog>
#include <QImage>
#include <QLineF>

#include <optional>

class QSpinBox;

namespace view {

// A picture on which a line can be drawn with the mouse, in its pixels.
class LinePicture : public QWidget {
    Q_OBJECT

public:
    explicit LinePicture(const QImage& picture, QWidget* parent = nullptr);

    const std::optional<QLineF>& line() const { return m_line; }
    QSize sizeHint() const override;

signals:
    void lineDrawn(); // also sent when a click removes the line

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    QRectF shown() const;
    QPointF pixelAt(const QPointF& position) const;

    QImage m_picture;
    std::optional<QLineF> m_line;
};

// A palette of the colours of a picture, all of them or those along a line.
class PicturePaletteDialog : public QDialog {
    Q_OBJECT

public:
    explicit PicturePaletteDialog(const QImage& picture, QWidget* parent = nullptr);

    const attractor::Palette& taken() const { return m_palette; }

signals:
    void tried(const attractor::Palette& palette);

private:
    void take();

    QImage m_picture; // small copy, so that every line is evaluated quickly
    LinePicture* m_canvas;
    QSpinBox* m_colours;
    attractor::Palette m_palette;
};

} // namespace view
