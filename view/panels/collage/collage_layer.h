// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "document/edits/agreement_picture.h"
#include "document/traced_picture.h"

#include <QGraphicsObject>
#include <QImage>
#include <QPainterPath>

#include <memory>
#include <optional>

namespace view {

class CanvasView;

// The target on the canvas, between the attractor and all handles: dimmed, with agreeing, excess and missing
// parts, with its images under the maps while the Maps tool is in use, and with a mark where the agreement is
// worst.
class CollageLayer : public QGraphicsObject {
    Q_OBJECT

public:
    CollageLayer(document::Document* document, CanvasView* canvas);

    void setTarget(std::shared_ptr<const document::TracedPicture> traced); // null: shows nothing
    void setOpacity100(int percent);                                       // per cent; opacity of the target
    void setMeasured(std::optional<document::MeasuredFractal> measured);
    void setAgreementVisible(bool visible);
    // The position of the mark, in pixels of the canvas; nullopt without one.
    std::optional<QPointF> mark() const;

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

signals:
    void markClicked();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void paintTarget(QPainter& painter);
    void paintAgreement(QPainter& painter) const;
    void paintImages(QPainter& painter) const;
    void paintImage(QPainter& painter, const QList<QPolygonF>& parts, QColor colour) const;
    void paintMark(QPainter& painter) const;
    bool isShown() const;
    bool isOnDark() const;
    bool isOnMark(const QPointF& position) const;
    QTransform toPixels() const; // plane → pixels
    bool isTurned() const;       // true if the view is rotated
    void paintTurned(QPainter& painter, const QImage& picture, const QRectF& there) const;
    void prepareTarget();

    document::Document* m_document;
    CanvasView* m_canvas;
    QRectF m_area; // area of the scene: the whole canvas
    std::shared_ptr<const document::TracedPicture> m_traced;
    QPainterPath m_outline; // outline of the target in the plane
    QImage m_target;        // target in the colours that are blended with the picture
    QImage m_scaled;        // m_target in device pixels
    bool m_targetOnDark = false;
    std::optional<document::MeasuredFractal> m_measured;
    int m_opacity = 40;
    bool m_showsAgreement = true;
    bool m_isPressed = false; // true during a press on the mark
};

} // namespace view
