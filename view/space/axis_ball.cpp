// SPDX-License-Identifier: MIT
#include "space/axis_ball.h"

#include <QLineF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace view {

namespace {

constexpr double margin = 20;
constexpr double radius = 44;    // pixels; radius of the ball
constexpr double spotReach = 32; // pixels from its middle to the middle of a spot
constexpr double spot = 10;

// Apart in lightness as well, so that they are told apart without colour; letters say the rest.
QColor axisColour(int axis) {
    constexpr std::array<QRgb, 3> colours{0xffe5574f, 0xff6fbf3f, 0xff4f8fe8};
    return QColor::fromRgb(colours[std::size_t(axis)]);
}

QString nameOf(const AxisBall::End& end) {
    const QChar letter(u'X' + end.axis);
    return end.isPositive ? QString(letter) : QString(u'−') + letter;
}

} // namespace

void AxisBall::layOut(const attractor::OrbitCamera& camera) {
    m_centre = {camera.size.width - margin - radius, margin + radius};
    const ifs::Matrix<3> toCamera = worldToCamera(camera).linear;
    prepareGeometryChange();
    std::size_t k = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool isPositive : {true, false}) {
            const ifs::Vector<3> seen = (isPositive ? 1 : -1) * toCamera.col(axis);
            m_spots[k++] = {
                {axis, isPositive}, m_centre + spotReach * QPointF(seen.x(), -seen.y()), seen.z()};
        }
    std::ranges::stable_sort(m_spots, std::greater<>(), &Spot::depth);
}

bool AxisBall::covers(const QPointF& position) const {
    return QLineF(m_centre, position).length() <= radius;
}

std::optional<AxisBall::End> AxisBall::endAt(const QPointF& position) const {
    for (auto it = m_spots.rbegin(); it != m_spots.rend(); ++it)
        if (QLineF(it->centre, position).length() <= spot + 2) return it->end;
    return std::nullopt;
}

// Prefers ends that lie more ahead than aside, so that each key leads to where it points. Of two in one
// place, the one in front.
std::optional<AxisBall::End> AxisBall::beside(const End& from, const QPointF& direction) const {
    constexpr double same = 0.5; // pixels
    const auto start = std::ranges::find(m_spots, from, &Spot::end);
    std::optional<End> result;
    std::pair nearest{true, HUGE_VAL};
    for (const Spot& spot : m_spots) {
        const QPointF way = spot.centre - start->centre;
        const double ahead = QPointF::dotProduct(way, direction);
        if (ahead < same) continue;
        const double away = std::hypot(way.x(), way.y());
        const std::pair distance{away > std::numbers::sqrt2 * ahead, away + same * spot.depth};
        if (distance >= nearest) continue;
        nearest = distance;
        result = spot.end;
    }
    return result;
}

void AxisBall::setHovered(std::optional<End> end) {
    if (m_hovered == end) return;
    m_hovered = end;
    update();
}

void AxisBall::setFocused(std::optional<End> end) {
    if (m_focused == end) return;
    m_focused = end;
    update();
}

QRectF AxisBall::boundingRect() const {
    constexpr double extent = radius + 4;
    return {m_centre.x() - extent, m_centre.y() - extent, 2 * extent, 2 * extent};
}

QColor AxisBall::colourOf(const End& end) const {
    return m_hovered == end ? m_style.accent : axisColour(end.axis);
}

void AxisBall::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->setRenderHint(QPainter::Antialiasing);
    QColor ground = m_style.noteBackground;
    ground.setAlphaF(0.55F);
    painter->setPen(Qt::NoPen);
    painter->setBrush(ground);
    painter->drawEllipse(m_centre, radius, radius);
    for (const Spot& at : m_spots)
        paintSpot(*painter, at, ground);
    if (m_focused) paintFocus(*painter);
}

void AxisBall::paintSpot(QPainter& painter, const Spot& at, const QColor& ground) const {
    const QColor colour = colourOf(at.end);
    if (at.end.isPositive) {
        painter.setPen(QPen(colour, 2.5, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(m_centre, at.centre);
    }
    const bool isFilled = at.end.isPositive || m_hovered == at.end;
    paintDisc(painter, at, colour, isFilled ? colour : ground);
    if (isFilled) paintName(painter, at);
}

// Paints over all ends, also where the focused one is behind another.
void AxisBall::paintFocus(QPainter& painter) const {
    const auto chosen = std::ranges::find(m_spots, *m_focused, &Spot::end);
    const QColor colour = colourOf(chosen->end);
    paintDisc(painter, *chosen, colour, colour);
    paintName(painter, *chosen);
    strokeFocusRing(painter, chosen->centre, spot + 2, m_style);
}

void AxisBall::paintDisc(QPainter& painter, const Spot& at, const QColor& rim, const QColor& fill) {
    painter.setPen(QPen(rim, 2));
    painter.setBrush(fill);
    painter.drawEllipse(at.centre, spot - 1, spot - 1);
}

void AxisBall::paintName(QPainter& painter, const Spot& at) {
    QFont font = painter.font();
    font.setPixelSize(at.end.isPositive ? 12 : 10); // leaves room for the sign
    font.setBold(true);
    painter.setFont(font);
    painter.setPen(QColor(16, 18, 22));
    painter.drawText(QRectF(at.centre.x() - spot, at.centre.y() - spot, 2 * spot, 2 * spot), Qt::AlignCenter,
                     nameOf(at.end));
}

attractor::Direction AxisBall::towards(const End& end, attractor::UpAxis up) {
    const bool isZUp = up == attractor::UpAxis::Z;
    if (end.axis == 0) return {end.isPositive ? 90.0 : -90.0, 0};
    if (end.axis == (isZUp ? 2 : 1)) return {0, end.isPositive ? 90.0 : -90.0};
    return {end.isPositive != isZUp ? 0.0 : 180.0, 0}; // front view: from +z, or −y
}

bool AxisBall::looksFrom(const attractor::OrbitCamera& camera, const End& end) {
    const ifs::Vector<3> towardsEye = camera.orientation.toRotationMatrix().col(2);
    return towardsEye[end.axis] * (end.isPositive ? 1 : -1) > 1 - 1e-9;
}

} // namespace view
