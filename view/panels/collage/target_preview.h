// SPDX-License-Identifier: MIT
#pragma once

#include "collage/target/mask.h"

#include <QImage>
#include <QWidget>

#include <memory>
#include <optional>

namespace view {

// The picture that is traced, the shape in it marked, and what is cropped away dimmed. Drag a rectangle to
// crop; double-click for the whole picture.
class TargetPreview : public QWidget {
    Q_OBJECT

public:
    explicit TargetPreview(QWidget* parent);

    void setPicture(std::shared_ptr<const collage::GreyPicture> picture); // null: none
    // The shape within the crop; an empty mask marks nothing.
    void setShape(const collage::Mask& mask, const std::optional<collage::PixelBox>& crop);

    QSize sizeHint() const override;

signals:
    void cropChosen(const std::optional<collage::PixelBox>& crop);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    QRectF pictureArea() const;
    QRectF dragged() const; // pixels of the picture

    std::shared_ptr<const collage::GreyPicture> m_picture;
    QImage m_grey;
    QImage m_shape; // traced shape over the crop
    std::optional<collage::PixelBox> m_crop;
    std::optional<QPointF> m_pressed;
    QPointF m_pointer;
};

} // namespace view
