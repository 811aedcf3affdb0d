// SPDX-License-Identifier: MIT
#include "panels/links/link_layout.h"

#include <QLineF>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace view {

namespace {

constexpr double margin = 14, maxRadius = 15, minRadius = 5; // pixels
constexpr double bend = 0.16;                                // share of an arrow's length
constexpr double reach = 6;                                  // pixels around the pointer
constexpr int steps = 24;

double lengthOf(const QPointF& v) {
    return std::hypot(v.x(), v.y());
}

double distance(const QPointF& p, const QPointF& a, const QPointF& b) {
    const QPointF along = b - a;
    const double length = QPointF::dotProduct(along, along);
    const double t = length > 0 ? std::clamp(QPointF::dotProduct(p - a, along) / length, 0.0, 1.0) : 0.0;
    return lengthOf(p - a - t * along);
}

double distance(const QPointF& p, const QPolygonF& line) {
    double least = std::numeric_limits<double>::infinity();
    for (qsizetype k = 1; k < line.size(); ++k)
        least = std::min(least, distance(p, line[k - 1], line[k]));
    return least;
}

} // namespace

double arrowWidth(double weight) {
    return std::clamp(1.6 + 0.8 * std::log2(weight), 0.8, 6.0);
}

LinkLayout::LinkLayout(const QSizeF& size, int maps, const std::vector<double>& matrix, int shownOf)
    : m_middle(size.width() / 2, size.height() / 2) {
    if (maps <= 0) return;
    const double half = std::min(size.width(), size.height()) / 2;
    m_radius = std::clamp(0.5 * std::numbers::pi * half / maps, minRadius, maxRadius);
    m_loop = 0.7 * m_radius + 2;
    const double ring = maps == 1 ? 0 : std::max(1.0, half - margin - loopReach());
    for (int k = 0; k < maps; ++k) {
        const double angle = 2 * std::numbers::pi * k / maps;
        m_nodes.push_back(m_middle + ring * QPointF(std::sin(angle), -std::cos(angle)));
    }
    for (int i = 0; i < maps; ++i)
        for (int j = 0; j < maps; ++j) {
            const double weight = matrix[std::size_t(i) * std::size_t(maps) + std::size_t(j)];
            if (weight > 0 && (shownOf < 0 || shownOf == i || shownOf == j)) addArrow(i, j, weight);
        }
}

QPointF LinkLayout::outwards(int map) const {
    const QPointF v = node(map) - m_middle;
    const double length = lengthOf(v);
    return length > 0.5 ? v / length : QPointF(0, -1);
}

// A curve from rim to rim, bent to its left so that it and its opposite are seen apart.
QPolygonF LinkLayout::curve(int from, int to) const {
    const QPointF a = node(from), b = node(to), along = b - a;
    const QPointF control = (a + b) / 2 + bend * QPointF(along.y(), -along.x());
    QPolygonF line;
    for (int k = 0; k <= steps; ++k) {
        const double t = double(k) / steps, s = 1 - t;
        const QPointF point = s * s * a + 2 * s * t * control + t * t * b;
        if (lengthOf(point - a) > m_radius + 1 && lengthOf(point - b) > m_radius + 2) line << point;
    }
    return line;
}

QPolygonF LinkLayout::loop(int map) const {
    const QPointF out = outwards(map), centre = node(map) + (m_radius + 0.8 * m_loop) * out;
    QPolygonF line;
    for (int k = 0; k <= steps; ++k) {
        const double angle = 2 * std::numbers::pi * k / steps + std::atan2(-out.y(), -out.x());
        const QPointF point = centre + m_loop * QPointF(std::cos(angle), std::sin(angle));
        if (lengthOf(point - node(map)) > m_radius + 1) line << point;
    }
    return line;
}

void LinkLayout::addArrow(int from, int to, double weight) {
    Arrow arrow{from, to, weight, from == to ? loop(from) : curve(from, to), {}};
    if (arrow.line.size() < 2) return; // overlapping maps
    const double width = arrowWidth(weight), length = 4 + 2 * width;
    const QPointF tip = arrow.line.last();
    while (arrow.line.size() > 2 && lengthOf(arrow.line[arrow.line.size() - 2] - tip) < length)
        arrow.line.removeLast();
    const QPointF before = arrow.line[arrow.line.size() - 2];
    const QPointF along = (tip - before) / std::max(1e-9, lengthOf(tip - before));
    const QPointF base = tip - length * along, side(-along.y() * length / 2, along.x() * length / 2);
    arrow.line.last() = base;
    arrow.head << tip << base + side << base - side;
    m_arrows.push_back(std::move(arrow));
}

int LinkLayout::nodeAt(const QPointF& position) const {
    for (int k = 0; k < maps(); ++k)
        if (lengthOf(position - node(k)) <= m_radius + 2) return k;
    return -1;
}

int LinkLayout::arrowAt(const QPointF& position) const {
    int found = -1;
    double least = reach;
    for (std::size_t k = 0; k < m_arrows.size(); ++k) {
        const double far =
            std::min(distance(position, m_arrows[k].line), lengthOf(position - m_arrows[k].head.first()));
        if (far >= least) continue;
        least = far;
        found = int(k);
    }
    return found;
}

} // namespace view
