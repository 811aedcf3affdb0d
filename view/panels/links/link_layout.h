// SPDX-License-Identifier: MIT
#pragma once

#include <QPointF>
#include <QPolygonF>
#include <QSizeF>

#include <optional>
#include <vector>

namespace view {

// Layout of the graph of linked maps: the maps on a circle, the first on top, clockwise, and a curved arrow
// from each map to those that may follow it. Pixels of the widget.
class LinkLayout {
public:
    struct Arrow {
        int from = 0, to = 0;
        double weight = 0;
        QPolygonF line; // line up to the head
        QPolygonF head;
    };

    LinkLayout() = default;
    // The matrix by rows; arrows only where `isShown` is −1 or one of the ends.
    LinkLayout(const QSizeF& size, int maps, const std::vector<double>& matrix, int shownOf);

    int maps() const { return int(m_nodes.size()); }
    QPointF node(int map) const { return m_nodes[std::size_t(map)]; }
    QPointF outwards(int map) const; // unit vector from the middle
    double nodeRadius() const { return m_radius; }
    // Distance from a node to the far end of its loop.
    double loopReach() const { return m_radius + 2 * m_loop; }
    const std::vector<Arrow>& arrows() const { return m_arrows; }

    int nodeAt(const QPointF& position) const; // −1: none
    // The index of the arrow nearest to the position, within a few pixels; −1: none.
    int arrowAt(const QPointF& position) const;

private:
    void addArrow(int from, int to, double weight);
    QPolygonF curve(int from, int to) const;
    QPolygonF loop(int map) const;

    QPointF m_middle;
    std::vector<QPointF> m_nodes;
    double m_radius = 0;
    double m_loop = 0; // radius of the arrows from a map to itself
    std::vector<Arrow> m_arrows;
};

double arrowWidth(double weight); // pixels, increasing with the weight

} // namespace view
