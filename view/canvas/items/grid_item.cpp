// SPDX-License-Identifier: MIT
#include "canvas/items/grid_item.h"

#include "canvas/geometry/canvas_geometry.h"
#include "canvas/geometry/coordinate_text.h"
#include "canvas/geometry/grid_spacing.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace view {

namespace {

// k·step for first ≤ k ≤ last; none where the numbers are too coarse to tell neighbours apart.
struct Multiples {
    double first = 0;
    double last = -1;
};

Multiples multiplesBetween(double a, double b, double step) {
    const double low = std::min(a, b) / step;
    const double high = std::max(a, b) / step;
    if (std::max(std::abs(low), std::abs(high)) > 4e15) return {};
    return {std::ceil(low), std::floor(high)};
}

// nullopt where the line does not meet the rectangle.
std::optional<QLineF> partWithin(const QRectF& area, const QLineF& line) {
    double from = 0, to = 1; // visible section, as shares of the line
    const auto clip = [&](double start, double change, double low, double high) {
        if (change == 0) {
            if (start < low || start > high) to = -1;
            return;
        }
        const double a = (low - start) / change, b = (high - start) / change;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    };
    clip(line.x1(), line.dx(), area.left(), area.right());
    clip(line.y1(), line.dy(), area.top(), area.bottom());
    if (!(from < to)) return std::nullopt;
    return QLineF(line.pointAt(from), line.pointAt(to));
}

QRectF boxOf(const QString& text, const QPointF& at, const QFontMetricsF& metrics) {
    return {at.x(), at.y() - metrics.ascent(), metrics.horizontalAdvance(text), metrics.height()};
}

QFont labelFont(const QPainter& painter) {
    QFont font = painter.font();
    font.setPointSizeF(std::max(7.0, font.pointSizeF() - 1.5));
    return font;
}

} // namespace

void GridItem::setView(const attractor::Camera& camera) {
    if (camera.width != m_camera.width || camera.height != m_camera.height) prepareGeometryChange();
    m_camera = camera;
    update();
}

void GridItem::setGridVisible(bool visible) {
    m_grid = visible;
    update();
}

void GridItem::setAxesVisible(bool visible) {
    m_axes = visible;
    update();
}

QRectF GridItem::boundingRect() const {
    return {0, 0, double(m_camera.width), double(m_camera.height)};
}

// Device pixels of the grid's lines and the axis along one coordinate, in the order in which they are drawn.
std::vector<GridItem::Line> GridItem::linesAlong(int axis, double ratio) const {
    std::vector<Line> lines;
    const auto pixel = [&](double coordinate) {
        ifs::Vector<2> world = m_camera.centre;
        world[axis] = coordinate;
        return int(std::floor(attractor::toPixel(m_camera, world)[axis] * ratio));
    };
    if (m_grid) {
        const GridSpacing spacing = gridSpacing(m_camera.pixelsPerUnit);
        const ifs::Vector<2> corner = worldAt(m_camera, QPointF(0, 0));
        const ifs::Vector<2> opposite = worldAt(m_camera, QPointF(m_camera.width, m_camera.height));
        const Multiples seen = multiplesBetween(corner[axis], opposite[axis], spacing.minor);
        for (double k = seen.first; k <= seen.last; ++k) {
            if (k == 0 && m_axes) continue;
            const bool major = std::fmod(k, spacing.subdivisions) == 0;
            lines.push_back({pixel(k * spacing.minor), 1, major ? m_style.gridMajor : m_style.gridMinor});
        }
    }
    const double origin = attractor::toPixel(m_camera, ifs::Vector<2>::Zero())[axis];
    if (m_axes && origin >= 0 && origin <= (axis == 0 ? m_camera.width : m_camera.height)) {
        const int thickness = std::max(1, qRound(ratio));
        lines.push_back({pixel(0) - (thickness - 1) / 2, thickness, m_style.axis});
    }
    return lines;
}

// Upright lines are put into one strip that is laid over the view band by band: filled one by one, they would
// take milliseconds, since each touches every row of the screen.
QImage GridItem::uprightLines(double ratio) const {
    QImage strip(int(std::ceil(m_camera.width * ratio)), band, QImage::Format_ARGB32_Premultiplied);
    strip.fill(Qt::transparent);
    QPainter upright(&strip);
    for (const Line& line : linesAlong(0, ratio))
        upright.fillRect(line.at, 0, line.thickness, band, line.colour);
    return strip;
}

void GridItem::paintLines(QPainter& painter) {
    const double ratio = painter.device()->devicePixelRatioF();
    painter.scale(1 / ratio, 1 / ratio);
    if (!std::exchange(m_areUprightPainted, false)) {
        const QImage strip = uprightLines(ratio);
        for (int top = 0; top < m_camera.height * ratio; top += band)
            painter.drawImage(0, top, strip);
    }
    const int width = int(std::ceil(m_camera.width * ratio));
    for (const Line& line : linesAlong(1, ratio))
        painter.fillRect(0, line.at, width, line.thickness, line.colour);
}

// The numbers stand by the axes, or at the edge where an axis is out of sight.
void GridItem::paintLabels(QPainter& painter) const {
    painter.setFont(labelFont(painter));
    painter.setPen(m_style.label);
    const QFontMetricsF metrics(painter.font());
    const GridSpacing spacing = gridSpacing(m_camera.pixelsPerUnit);
    const ifs::Vector<2> corner = worldAt(m_camera, QPointF(0, 0));
    const ifs::Vector<2> opposite = worldAt(m_camera, QPointF(m_camera.width, m_camera.height));
    const QPointF origin = pixelOf(m_camera, ifs::Vector<2>::Zero());
    const CoordinateText abscissae(m_camera, 0), ordinates(m_camera, 1);
    const Multiples across = multiplesBetween(corner.x(), opposite.x(), spacing.major);
    const double baseline =
        std::clamp(origin.y() + metrics.ascent() + 3, metrics.ascent() + 3,
                   std::max(metrics.ascent() + 3, m_camera.height - metrics.descent() - 3));
    for (double k = across.first; k <= across.last; ++k)
        if (k != 0) {
            const double x = pixelOf(m_camera, {k * spacing.major, 0}).x();
            painter.drawText(QPointF(x + 4, baseline), abscissae.label(k * spacing.major));
        }
    const Multiples along = multiplesBetween(corner.y(), opposite.y(), spacing.major);
    for (double k = along.first; k <= along.last; ++k) {
        if (k == 0) continue;
        const QString text = ordinates.label(k * spacing.major);
        const double width = metrics.horizontalAdvance(text);
        const double x = std::clamp(origin.x() + 4, 4.0, std::max(4.0, m_camera.width - width - 4));
        painter.drawText(QPointF(x, pixelOf(m_camera, {0, k * spacing.major}).y() - 3), text);
    }
    paintBase(painter);
}

// Paints the base of labels that would be too long, to which they are offsets.
QRectF GridItem::paintBase(QPainter& painter) const {
    const CoordinateText abscissae(m_camera, 0), ordinates(m_camera, 1);
    if (abscissae.base().isEmpty()) return {};
    const QFontMetricsF metrics(painter.font());
    const QString text = QStringLiteral("x = %1   y = %2").arg(abscissae.base(), ordinates.base());
    const QPointF at(m_camera.width - metrics.horizontalAdvance(text) - 8, 2 * metrics.height());
    painter.drawText(at, text);
    return boxOf(text, at, metrics);
}

// Grid lines in a view that is turned, each at a multiple of the step, with its index.
std::vector<GridItem::TurnedLine> GridItem::turnedLines(int axis, double step) const {
    const QRectF area = boundingRect();
    ifs::Vector<2> low = worldAt(m_camera, area.topLeft()), high = low;
    for (const QPointF& corner : {area.topRight(), area.bottomLeft(), area.bottomRight()}) {
        low = low.cwiseMin(worldAt(m_camera, corner));
        high = high.cwiseMax(worldAt(m_camera, corner));
    }
    std::vector<TurnedLine> lines;
    const Multiples seen = multiplesBetween(low[axis], high[axis], step);
    for (double k = seen.first; k <= seen.last; ++k) {
        low[axis] = high[axis] = k * step;
        if (const auto line = partWithin(area, {pixelOf(m_camera, low), pixelOf(m_camera, high)}))
            lines.push_back({k, *line});
    }
    return lines;
}

void GridItem::paintTurnedLines(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing);
    const GridSpacing spacing = gridSpacing(m_camera.pixelsPerUnit);
    for (const int axis : {0, 1})
        for (const auto& [index, line] : turnedLines(axis, spacing.minor)) {
            const bool isAxis = index == 0 && m_axes;
            if (!m_grid && !isAxis) continue;
            const bool isMajor = std::fmod(index, spacing.subdivisions) == 0;
            constexpr double hairline = 0; // one device pixel
            painter.setPen(isAxis ? QPen(m_style.axis, 1)
                                  : QPen(isMajor ? m_style.gridMajor : m_style.gridMinor, hairline));
            painter.drawLine(line);
        }
}

// The numbers stand by the axes; where an axis is out of sight, at an end of each line, with the name of the
// coordinate, since lines of both may end at one edge. None stands on another.
void GridItem::paintTurnedLabels(QPainter& painter) const {
    painter.setFont(labelFont(painter));
    painter.setPen(m_style.label);
    const QFontMetricsF metrics(painter.font());
    const double step = gridSpacing(m_camera.pixelsPerUnit).major;
    const QRectF area = boundingRect();
    const QRectF room = area.adjusted(4, metrics.ascent() + 3, -4, -metrics.descent() - 3);
    std::vector<QRectF> taken{paintBase(painter)};
    const auto paint = [&](const QString& text, const QPointF& by) { // false if something is there already
        const double right = std::max(room.left(), room.right() - metrics.horizontalAdvance(text));
        const QPointF at(std::clamp(by.x() + 4, room.left(), right),
                         std::clamp(by.y() - 3, room.top(), std::max(room.top(), room.bottom())));
        const QRectF box = boxOf(text, at, metrics);
        if (std::ranges::any_of(taken, [&](const QRectF& other) { return other.intersects(box); }))
            return false;
        painter.drawText(at, text);
        taken.push_back(box);
        return true;
    };
    for (const int axis : {0, 1}) {
        const CoordinateText numbers(m_camera, axis);
        const bool isAxisSeen = std::ranges::any_of( // true if the axis that shows this coordinate is visible
            turnedLines(1 - axis, step), [](const TurnedLine& other) { return other.index == 0; });
        for (const auto& [index, line] : turnedLines(axis, step)) {
            ifs::Vector<2> onAxis = ifs::Vector<2>::Zero();
            onAxis[axis] = index * step;
            const QPointF by = pixelOf(m_camera, onAxis);
            const QString number = numbers.label(index * step);
            if (isAxisSeen && (index == 0 || !area.contains(by))) continue;
            if (isAxisSeen) {
                paint(number, by);
                continue;
            }
            // Label at the lowest end of a line of x, at the leftmost end of a line of y, or else at the
            // other end.
            const bool isFirst = axis == 0 ? line.y1() > line.y2() : line.x1() < line.x2();
            const QString text = (axis == 0 ? QStringLiteral("x ") : QStringLiteral("y ")) + number;
            if (!paint(text, isFirst ? line.p1() : line.p2())) paint(text, isFirst ? line.p2() : line.p1());
        }
    }
}

void GridItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    const bool isTurned = m_camera.rotation != 0;
    painter->save();
    if (isTurned)
        paintTurnedLines(*painter);
    else
        paintLines(*painter);
    painter->restore();
    if (m_axes && isTurned) paintTurnedLabels(*painter);
    if (m_axes && !isTurned) paintLabels(*painter);
}

} // namespace view
