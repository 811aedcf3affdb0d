// SPDX-License-Identifier: MIT
#include "canvas/items/map_frames_item.h"

#include "canvas/geometry/canvas_geometry.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <limits>

namespace view {

namespace {

using Kind = CanvasPart::Kind;

constexpr double frameRadius = 8; // pixels; corner of a selected frame
constexpr double frameDot = 3.5;  // pixels; corner of any other frame
constexpr double frameFocusRadius = 13;
constexpr double minSide = 8;          // pixels; least side of a frame with distinguishable corners
constexpr std::ptrdiff_t maxHeld = 50; // selected frames that show their handles at any size
// Amounts that can be painted for every move of a drag: frames with corners, and outlines of frames in pixels
// of the screen, filled, with corners, and thin; beyond these, only every n-th frame.
constexpr std::ptrdiff_t minWhole = 8; // selected frames that are always drawn
constexpr std::size_t maxWhole = 250;
constexpr double maxFilled = 16'000;
constexpr double maxOutlined = 48'000;
constexpr double maxThin = 200'000;

double area(const QPolygonF& polygon) {
    double doubled = 0;
    for (qsizetype i = 0; i < polygon.size(); ++i) {
        const QPointF &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        doubled += p.x() * q.y() - p.y() * q.x();
    }
    return std::abs(doubled) / 2;
}

// Length of the visible part of the outlines, or a little more, in pixels of the screen.
double lengthSeen(const QPainter& painter, std::span<const MapFrame* const> frames) {
    const QRectF view = painter.viewport();
    double all = 0;
    for (const MapFrame* frame : frames) {
        const QPolygonF& outline = frame->outline;
        if (!outline.boundingRect().adjusted(-1, -1, 1, 1).intersects(view)) continue;
        double length = 0;
        for (qsizetype i = 0; i < outline.size(); ++i)
            length += QLineF(outline[i], outline[(i + 1) % outline.size()]).length();
        all += std::min(length, 2 * (view.width() + view.height()));
    }
    return all * painter.device()->devicePixelRatioF();
}

double distanceToOutline(const QPolygonF& polygon, const QPointF& p) {
    double least = std::numeric_limits<double>::infinity();
    for (qsizetype i = 0; i < polygon.size(); ++i)
        least = std::min(least, distanceToSegment(p, polygon[i], polygon[(i + 1) % polygon.size()]));
    return least;
}

QPainterPath closed(const QPolygonF& polygon) {
    QPainterPath path;
    path.addPolygon(polygon);
    path.closeSubpath();
    return path;
}

QColor withOpacity(QColor colour, double opacity) {
    colour.setAlphaF(float(opacity));
    return colour;
}

QColor inkOn(const QColor& colour) {
    return qGray(colour.rgb()) > 130 ? QColor(14, 18, 26) : QColor(250, 252, 255);
}

} // namespace

const MapFrame* frameOf(const std::vector<MapFrame>& frames, int index) {
    const auto frame = std::ranges::lower_bound(frames, index, {}, &MapFrame::index);
    return frame != frames.end() && frame->index == index ? &*frame : nullptr;
}

CanvasPart framePartAt(const std::vector<MapFrame>& frames, const QPointF& position, double corner,
                       double edge) {
    for (const bool selected : {true, false}) {
        CanvasPart nearest;
        double least = corner;
        for (const MapFrame& frame : frames)
            for (int i = 0; i < frame.corners.size() && frame.selected == selected; ++i)
                if (const double d = QLineF(position, frame.corners[i]).length(); d <= least) {
                    least = d;
                    nearest = {Kind::Vertex, i, frame.index};
                }
        if (nearest.kind != Kind::None) return nearest;
    }
    CanvasPart smallest;
    double least = std::numeric_limits<double>::infinity();
    for (const MapFrame& frame : frames) {
        if (!frame.outline.containsPoint(position, Qt::OddEvenFill) &&
            distanceToOutline(frame.outline, position) > edge)
            continue;
        // Prefers the selected frame if frames cover each other.
        if (const double a = area(frame.outline) * (frame.selected ? 0.99 : 1); a < least) {
            least = a;
            smallest = {Kind::Inside, 0, frame.index};
        }
    }
    return smallest;
}

void MapFramesItem::setFrames(std::vector<MapFrame> frames, Mode mode) {
    prepareGeometryChange();
    m_frames = std::move(frames);
    m_mode = mode;
    update();
}

QRectF MapFramesItem::boundingRect() const {
    QRectF all;
    for (const MapFrame& frame : m_frames)
        // Enlarged, because a flat frame has an empty box.
        all |= frame.outline.boundingRect().adjusted(-20, -20, 20, 20);
    return all;
}

bool MapFramesItem::isHovered(const MapFrame& frame) const {
    return m_hovered.map == frame.index && m_pressed.kind == Kind::None;
}

void MapFramesItem::paintFrame(QPainter& painter, const MapFrame& frame) const {
    const double width = m_style.lineWidth + (frame.selected ? 0.75 : 0);
    strokeOutline(painter, frame.outline, m_style,
                  isHovered(frame) || frame.selected ? m_style.accent : frame.colour, width,
                  frame.takesPart ? Qt::SolidLine : Qt::DashLine);
    if (m_focused == CanvasPart{Kind::Inside, 0, frame.index})
        strokeLit(painter, closed(frame.outline), m_style, width, Qt::DashLine);
}

void MapFramesItem::paintCorners(QPainter& painter, const MapFrame& frame) const {
    QFont font = painter.font();
    font.setBold(true);
    for (int i = 0; i < frame.corners.size(); ++i) {
        const CanvasPart self{Kind::Vertex, i, frame.index};
        const QPointF& at = frame.corners[i];
        if (m_focused == self) strokeFocusRing(painter, at, frameFocusRadius, m_style);
        const bool lit = !frame.isLocked && (m_hovered == self || m_pressed == self);
        const bool numbered = !frame.isLocked && (frame.selected || lit);
        const double r = numbered ? frameRadius + (lit ? 1 : 0) : frameDot;
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_style.core);
        painter.drawEllipse(at, r + 2, r + 2);
        if (frame.isLocked) continue; // muted: a dark dot
        painter.setPen(QPen(m_style.rim, m_style.lineWidth));
        painter.setBrush(lit ? m_style.accent : frame.colour);
        painter.drawEllipse(at, r - 0.5, r - 0.5);
        if (!numbered) continue;
        font.setPixelSize(i < 9 ? 10 : 8);
        painter.setFont(font);
        painter.setPen(lit ? m_style.onAccent : inkOn(frame.colour));
        painter.drawText(QRectF(at - QPointF(12, 12), QSizeF(24, 24)), Qt::AlignCenter,
                         QString::number(i + 1));
    }
}

// A dot is all that can be seen of one map in ten thousand, and painted in time.
void MapFramesItem::paintDot(QPainter& painter, const MapFrame& frame) const {
    const int side = frame.selected ? 4 : 2;
    painter.fillRect(QRect(frame.outline.boundingRect().center().toPoint(), QSize(side, side)),
                     frame.selected ? m_style.accent : frame.colour);
}

void MapFramesItem::paintThin(QPainter& painter, std::span<const MapFrame* const> frames) const {
    const auto stride = 1 + std::size_t(lengthSeen(painter, frames) / maxThin);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setBrush(Qt::NoBrush);
    for (std::size_t k = 0; k < frames.size(); ++k) {
        const MapFrame& frame = *frames[k];
        if (k % stride != 0) {
            paintDot(painter, frame);
            continue;
        }
        painter.setPen(frame.selected ? m_style.accent : frame.colour);
        painter.drawPolygon(frame.outline);
    }
    painter.setRenderHint(QPainter::Antialiasing);
}

void MapFramesItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->setRenderHint(QPainter::Antialiasing);
    const auto selectedCount = std::ranges::count_if(m_frames, &MapFrame::selected);
    std::vector<const MapFrame*> whole;
    for (const MapFrame& frame : m_frames) {
        if (m_mode == Mode::Hint && !frame.selected) continue;
        const QRectF box = frame.outline.boundingRect();
        if (std::max(box.width(), box.height()) >= minSide || isHovered(frame) ||
            m_focused.map == frame.index || (frame.selected && selectedCount <= maxHeld)) {
            whole.push_back(&frame);
            continue;
        }
        paintDot(*painter, frame);
    }
    const double length = lengthSeen(*painter, whole);
    const auto isHeld = [&](const MapFrame* frame) {
        return isHovered(*frame) || m_focused.map == frame->index ||
               (frame->selected && selectedCount <= minWhole);
    };
    if (whole.size() > maxWhole || length > maxOutlined) {
        const auto thin = std::partition(whole.begin(), whole.end(), [&](const MapFrame* frame) {
            return m_mode == Mode::Held && isHeld(frame);
        });
        paintThin(*painter, {thin, whole.end()});
        whole.erase(thin, whole.end());
    }
    if (m_mode == Mode::Hint) {
        for (const MapFrame* frame : whole)
            strokeOutline(*painter, frame->outline, m_style, m_style.accent, m_style.lineWidth, Qt::DotLine);
        return;
    }
    // Clipped, because the cost of a fill depends on its height.
    const QRectF near = QRectF(painter->viewport()).adjusted(-8, -8, 8, 8);
    for (const MapFrame* frame : whole) // painted below all lines, which it would make fainter
        if (length <= maxFilled || isHeld(frame))
            painter->fillPath(closed(clippedTo(near, frame->outline)),
                              withOpacity(frame->colour, frame->selected || isHovered(*frame) ? 0.16 : 0.05));
    for (const bool selected : {false, true}) {
        for (const MapFrame* frame : whole)
            if (frame->selected == selected) paintFrame(*painter, *frame);
        for (const MapFrame* frame : whole)
            if (frame->selected == selected) paintCorners(*painter, *frame);
    }
}

} // namespace view
