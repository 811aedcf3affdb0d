// SPDX-License-Identifier: MIT
#include "widgets/thumbnail_tile.h"

#include <QPainter>
#include <QPainterPath>

namespace view {
namespace {

QColor mixed(const QColor& a, const QColor& b, double share) {
    return QColor::fromRgbF(static_cast<float>(a.redF() + (b.redF() - a.redF()) * share),
                            static_cast<float>(a.greenF() + (b.greenF() - a.greenF()) * share),
                            static_cast<float>(a.blueF() + (b.blueF() - a.blueF()) * share));
}

QPainterPath emptySet(const QRectF& box) {
    QPainterPath path;
    path.addEllipse(
        box.adjusted(box.width() * 0.1, box.height() * 0.1, -box.width() * 0.1, -box.height() * 0.1));
    path.moveTo(box.bottomLeft());
    path.lineTo(box.topRight());
    return path;
}

QPainterPath warning(const QRectF& box) {
    QPainterPath path(QPointF(box.center().x(), box.top() + box.height() * 0.06));
    path.lineTo(box.right(), box.bottom() - box.height() * 0.06);
    path.lineTo(box.left(), box.bottom() - box.height() * 0.06);
    path.closeSubpath();
    path.moveTo(box.center().x(), box.top() + box.height() * 0.40);
    path.lineTo(box.center().x(), box.top() + box.height() * 0.64);
    path.moveTo(box.center().x(), box.top() + box.height() * 0.76);
    path.lineTo(box.center().x(), box.top() + box.height() * 0.77);
    return path;
}

QPainterPath sign(Thumbnail::State state, const QRectF& box) {
    switch (state) {
    case Thumbnail::State::NoAttractor:
        return emptySet(box);
    case Thumbnail::State::Unreadable:
        return warning(box);
    case Thumbnail::State::Pending:
    case Thumbnail::State::Ready:
        break;
    }
    return {};
}

} // namespace

void paintThumbnail(QPainter& painter, const QRect& area, const Thumbnail& thumbnail,
                    const QPalette& palette) {
    if (!thumbnail.pixmap.isNull()) {
        painter.drawPixmap(area, thumbnail.pixmap);
        return;
    }
    const QColor base = palette.color(QPalette::Base);
    const QColor text = palette.color(QPalette::Text);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(mixed(base, text, 0.09));
    painter.drawRoundedRect(area, Thumbnails::cornerRadius, Thumbnails::cornerRadius);
    const double extent = area.height() * 0.42;
    QRectF box(0, 0, extent, extent);
    box.moveCenter(QRectF(area).center());
    painter.setPen(QPen(mixed(base, text, 0.55), 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(sign(thumbnail.state, box));
    painter.restore();
}

} // namespace view
