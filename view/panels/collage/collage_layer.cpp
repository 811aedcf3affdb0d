// SPDX-License-Identifier: MIT
#include "panels/collage/collage_layer.h"

#include "canvas/canvas_view.h"
#include "canvas/geometry/canvas_geometry.h"
#include "canvas/items/overlay_style.h"
#include "gestures/pointer.h"

#include <QGraphicsScene>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace view {

namespace {

constexpr double level = 0.5;      // between the attractor and the grid
constexpr double markRadius = 9;   // pixels
constexpr double markReach = 14;   // pixels within which the pointer takes the mark
constexpr int imageOpacity = 70;   // alpha, 0 … 255
constexpr double imageLine = 1.75; // pixels
constexpr int maxScaled = 4096;    // device pixels
// Rows of a fill. Qt hands longer ones to other threads and waits for them, while they draw the next picture.
constexpr int fillBand = 48;

QTransform transformOf(const ifs::AffineMap<2>& map) {
    return {map.linear(0, 0), map.linear(1, 0),    map.linear(0, 1),
            map.linear(1, 1), map.translation.x(), map.translation.y()};
}

} // namespace

CollageLayer::CollageLayer(document::Document* document, CanvasView* canvas)
    : m_document(document), m_canvas(canvas), m_area(canvas->scene()->sceneRect()) {
    setZValue(level);
    setAcceptedMouseButtons(Qt::NoButton);
    canvas->scene()->addItem(this);
    connect(canvas->scene(), &QGraphicsScene::sceneRectChanged, this, [this](const QRectF& area) {
        prepareGeometryChange();
        m_area = area;
    });
    canvas->viewport()->installEventFilter(this);
    connect(document, &document::Document::changed, this, [this] { update(); });
    connect(canvas, &CanvasView::toolChanged, this, [this] { update(); });
    connect(canvas, &CanvasView::selectedMapsChanged, this, [this] { update(); });
    connect(&canvas->options(), &CanvasOptions::overlaysVisibleChanged, this, [this] { update(); });
}

void CollageLayer::setTarget(std::shared_ptr<const document::TracedPicture> traced) {
    m_traced = std::move(traced);
    m_measured.reset();
    m_target = {};
    m_outline = {};
    if (m_traced)
        for (const auto& outline : m_traced->outlines) {
            QPolygonF polygon;
            for (const auto& corner : outline)
                polygon << toPoint(corner);
            m_outline.addPolygon(polygon);
            m_outline.closeSubpath();
        }
    update();
}

void CollageLayer::setOpacity100(int percent) {
    m_opacity = percent;
    m_target = {};
    update();
}

void CollageLayer::setMeasured(std::optional<document::MeasuredFractal> measured) {
    m_measured = std::move(measured);
    update();
}

void CollageLayer::setAgreementVisible(bool visible) {
    m_showsAgreement = visible;
    update();
}

bool CollageLayer::isShown() const {
    return m_traced && m_canvas->options().overlaysVisible() &&
           document::dimension(m_document->fractal()) == 2;
}

bool CollageLayer::isOnDark() const {
    return overlayStyle(m_document->fractal().appearance.background, m_canvas->palette()).onDark;
}

std::optional<QPointF> CollageLayer::mark() const {
    if (!isShown() || !m_showsAgreement || !m_measured || m_measured->agreement.hausdorff <= 0)
        return std::nullopt;
    return pixelOf(m_canvas->camera(), m_measured->agreement.worst);
}

QTransform CollageLayer::toPixels() const {
    return transformOf(attractor::worldToPixel(m_canvas->camera()));
}

bool CollageLayer::isTurned() const {
    return m_canvas->camera().rotation != 0;
}

// A picture whose rows run downwards, over a rectangle of the plane with y up.
void CollageLayer::paintTurned(QPainter& painter, const QImage& picture, const QRectF& there) const {
    painter.save();
    painter.setTransform(QTransform::fromScale(1, -1) * toPixels(), true);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRectF(there.x(), -there.bottom(), there.width(), there.height()), picture);
    painter.restore();
}

QRectF CollageLayer::boundingRect() const {
    return m_area;
}

// Draws a light shape on a dark picture, and a dark one on a light picture: both ways the attractor stays in
// sight.
void CollageLayer::prepareTarget() {
    m_targetOnDark = isOnDark();
    m_scaled = {};
    const collage::GreyPicture& picture = m_traced->picture;
    m_target = QImage(picture.width, picture.height, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < picture.height; ++y) {
        auto* line = reinterpret_cast<QRgb*>(m_target.scanLine(y));
        for (int x = 0; x < picture.width; ++x) {
            const auto k = m_traced->mask.index(x, y);
            const int ink =
                m_traced->mask.cells[k] != 0 ? 255 - picture.grey[k] / 2 : (255 - picture.grey[k]) / 4;
            const int alpha = ink * m_opacity / 100;
            line[x] = qPremultiply(m_targetOnDark ? qRgba(225, 225, 225, alpha) : qRgba(40, 40, 40, alpha));
        }
    }
}

void CollageLayer::paintTarget(QPainter& painter) {
    if (m_target.isNull() || m_targetOnDark != isOnDark()) prepareTarget();
    const document::PicturePlace& place = m_traced->place;
    const double width = place.height * m_target.width() / m_target.height();
    const QRectF inPlane(place.middle.x() - width / 2, place.middle.y() - place.height / 2, width,
                         place.height);
    if (isTurned()) return paintTurned(painter, m_target, inPlane);
    const QRectF there = toPixels().mapRect(inPlane);
    const bool isUpright = m_canvas->camera().yAxis == attractor::YAxis::Up;
    const double ratio = m_canvas->devicePixelRatioF();
    const QSize size = (there.size() * ratio).toSize();
    if (size.isEmpty()) return;
    if (std::max(size.width(), size.height()) > maxScaled) {
        painter.drawImage(there, isUpright ? m_target : m_target.mirrored());
        return;
    }
    // Scaled once for each zoom, so that a drag only copies it.
    if (m_scaled.size() != size) {
        m_scaled = m_target.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        m_scaled.setDevicePixelRatio(ratio);
    }
    painter.drawImage(there.topLeft(), isUpright ? m_scaled : m_scaled.mirrored());
}

void CollageLayer::paintAgreement(QPainter& painter) const {
    if (!m_showsAgreement || !m_measured) return;
    const QRectF& area = m_measured->area;
    const QRectF inPlane(area.x(), area.y() - area.height(), area.width(), area.height());
    if (isTurned()) return paintTurned(painter, m_measured->picture, inPlane);
    const QRectF there = toPixels().mapRect(inPlane);
    const bool isUpright = m_canvas->camera().yAxis == attractor::YAxis::Up;
    const QImage picture = isUpright ? m_measured->picture : m_measured->picture.mirrored();
    QRect used = m_measured->used;
    if (!isUpright) used.moveTop(picture.height() - used.top() - used.height());
    const QTransform onto =
        QTransform::fromScale(there.width() / picture.width(), there.height() / picture.height()) *
        QTransform::fromTranslate(there.x(), there.y());
    // Visible part only, because the cost of scaling depends on the number of pixels.
    const QRect source = onto.inverted().mapRect(m_area).toAlignedRect() & used;
    if (!source.isEmpty()) painter.drawImage(onto.mapRect(QRectF(source)), picture, QRectF(source));
}

// Paints the target under each map: w_i(L), in the colour of the map.
void CollageLayer::paintImages(QPainter& painter) const {
    if (m_canvas->tool() != CanvasView::Tool::Maps) return;
    const auto maps = document::collageMaps(m_document->fractal());
    if (!maps) return;
    const document::System2& system = *document::system2(m_document->fractal());
    // Clipped, because the cost of a fill depends on its height.
    const QRectF near = m_area.adjusted(-8, -8, 8, 8);
    for (std::size_t k = 0; k < maps->maps.size(); ++k) {
        const std::size_t index = maps->index[k];
        const attractor::Rgba rgba =
            attractor::mapColour(m_document->fractal().appearance, system.maps[index].id, index);
        QList<QPolygonF> parts;
        for (const QPolygonF& part : m_outline.toSubpathPolygons(transformOf(maps->maps[k]) * toPixels()))
            parts << clippedTo(near, part);
        paintImage(painter, parts, {rgba.red, rgba.green, rgba.blue});
    }
}

// The fill has hard edges, but they lie under the lines. Lines one by one are painted without a path of their
// outline, which takes three times as long.
void CollageLayer::paintImage(QPainter& painter, const QList<QPolygonF>& parts, QColor colour) const {
    QPainterPath path;
    QList<QLineF> lines;
    for (const QPolygonF& part : parts) {
        path.addPolygon(part);
        path.closeSubpath();
        for (qsizetype k = 0; k < part.size(); ++k)
            lines << QLineF(part[k], part[(k + 1) % part.size()]);
    }
    const QRect box = path.boundingRect().toAlignedRect() & m_area.toAlignedRect();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(colour.red(), colour.green(), colour.blue(), imageOpacity));
    for (int top = box.top(); top <= box.bottom(); top += fillBand) {
        painter.setClipRect(QRect(box.left(), top, box.width(), fillBand));
        painter.drawPath(path);
    }
    painter.restore();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, imageLine, Qt::SolidLine, Qt::SquareCap));
    painter.drawLines(lines);
}

void CollageLayer::paintMark(QPainter& painter) const {
    const auto at = mark();
    if (!at) return;
    const OverlayStyle style = overlayStyle(m_document->fractal().appearance.background, m_canvas->palette());
    QPainterPath path;
    path.addEllipse(*at, markRadius, markRadius);
    path.moveTo(at->x() - 4, at->y());
    path.lineTo(at->x() + 4, at->y());
    path.moveTo(at->x(), at->y() - 4);
    path.lineTo(at->x(), at->y() + 4);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    strokeLit(painter, path, style, style.lineWidth);
}

void CollageLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    if (!isShown()) return;
    painter->save();
    paintTarget(*painter);
    paintAgreement(*painter);
    paintImages(*painter);
    paintMark(*painter);
    painter->restore();
}

bool CollageLayer::isOnMark(const QPointF& position) const {
    const auto at = mark();
    if (!at || QLineF(position, *at).length() > markReach) return false;
    const CanvasPart::Kind kind = m_canvas->canvas().partAt(position, Reach::Mouse).kind;
    return kind == CanvasPart::Kind::None || kind == CanvasPart::Kind::Inside;
}

bool CollageLayer::eventFilter(QObject* watched, QEvent* event) {
    const bool isPress = event->type() == QEvent::MouseButtonPress;
    if (!isPress && event->type() != QEvent::MouseButtonRelease)
        return QGraphicsObject::eventFilter(watched, event);
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if (mouse->button() != Qt::LeftButton) return false;
    if (isPress) {
        m_isPressed = mouse->modifiers() == Qt::NoModifier && isOnMark(mouse->position());
        return m_isPressed;
    }
    if (!std::exchange(m_isPressed, false)) return false;
    if (isOnMark(mouse->position())) emit markClicked();
    return true;
}

} // namespace view
