// SPDX-License-Identifier: MIT
#include "space/space_cage_item.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>

namespace view {

namespace {

constexpr double grip = 12; // pixels around a handle that hold it
constexpr std::size_t corners = 4;

using Points = std::vector<ifs::Vector<2>>;

double turn(const Points& p, std::size_t a, std::size_t b, std::size_t c) {
    const ifs::Vector<2> u = p[b] - p[a];
    const ifs::Vector<2> v = p[c] - p[a];
    return u.x() * v.y() - u.y() * v.x();
}

// An edge of a tetrahedron lies behind it where the other two vertices, seen on either side of it, span an
// edge that crosses in front of it.
bool isBehind(const Points& p, const std::vector<double>& depth, std::size_t a, std::size_t b) {
    std::array<std::size_t, 2> other{};
    std::size_t n = 0;
    for (std::size_t i = 0; i < corners; ++i)
        if (i != a && i != b) other[n++] = i;
    const auto [c, d] = other;
    const double sideC = turn(p, a, b, c);
    const double sideD = turn(p, a, b, d);
    const double sideA = turn(p, c, d, a);
    const double sideB = turn(p, c, d, b);
    if (sideC * sideD >= 0) return false; // seen at the border
    if (sideA * sideB < 0) {              // the two edges cross: the farther one is behind
        const double t = sideA / (sideA - sideB);
        const double s = sideC / (sideC - sideD);
        return depth[a] + t * (depth[b] - depth[a]) > depth[c] + s * (depth[d] - depth[c]);
    }
    // One end is seen inside the triangle of the other three: it is behind where that end is behind them.
    const bool isAInside = std::abs(sideA) < std::abs(sideB);
    const std::size_t inner = isAInside ? a : b;
    const std::size_t outer = isAInside ? b : a;
    const double whole = turn(p, outer, c, d);
    if (whole == 0) return false;
    const double wc = turn(p, inner, d, outer) / whole;
    const double wd = turn(p, inner, outer, c) / whole;
    return depth[inner] > (1 - wc - wd) * depth[outer] + wc * depth[c] + wd * depth[d];
}

} // namespace

void SpaceCageItem::layOut(const attractor::OrbitCamera& camera, const std::vector<ifs::Vector<3>>& vertices,
                           const Hidden& isHidden) {
    prepareGeometryChange();
    m_vertices = vertices;
    m_points.clear();
    m_depths.clear();
    m_edges.clear();
    m_hidden.clear();
    Points pixels;
    for (const ifs::Vector<3>& vertex : vertices) {
        const attractor::ScreenPoint seen = toScreen(camera, vertex);
        // Far outside, painting lines takes long; what is behind the eye has no place at all.
        constexpr double far = 1e5;
        pixels.push_back(seen.pixel.allFinite() ? seen.pixel.cwiseMax(-far).cwiseMin(far)
                                                : ifs::Vector<2>(-far, -far));
        m_points << QPointF(pixels.back().x(), pixels.back().y());
        m_depths.push_back(seen.depth);
        m_hidden.push_back(isHidden(seen));
    }
    for (std::size_t a = 0; a < pixels.size() && pixels.size() == corners; ++a)
        for (std::size_t b = a + 1; b < corners; ++b)
            m_edges.push_back(
                {{m_points[qsizetype(a)], m_points[qsizetype(b)]}, isBehind(pixels, m_depths, a, b)});
    while (m_handles.size() > pixels.size())
        m_handles.pop_back();
    while (m_handles.size() < pixels.size()) {
        m_handles.push_back(std::make_unique<VertexHandle>(int(m_handles.size()) + 1, this));
        m_handles.back()->setStyle(m_style);
    }
    for (std::size_t i = 0; i < m_handles.size(); ++i) {
        m_handles[i]->setPos(m_points[qsizetype(i)]);
        m_handles[i]->setZValue(-m_depths[i]);
    }
    setMarks(m_hovered, m_pressed, m_focused);
    update();
}

void SpaceCageItem::setMarks(std::optional<std::size_t> hovered, std::optional<std::size_t> pressed,
                             std::optional<std::size_t> focused) {
    m_hovered = hovered;
    m_pressed = pressed;
    m_focused = focused;
    for (std::size_t i = 0; i < m_handles.size(); ++i) {
        HandleStates state;
        state.setFlag(HandleState::Hovered, hovered == i);
        state.setFlag(HandleState::Pressed, pressed == i);
        state.setFlag(HandleState::Focused, focused == i);
        state.setFlag(HandleState::Hidden, m_hidden[i]);
        m_handles[i]->setState(state);
    }
}

std::vector<std::size_t> SpaceCageItem::handlesAt(const QPointF& position) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < m_handles.size(); ++i)
        if (QLineF(handle(i), position).length() <= grip) found.push_back(i);
    std::ranges::sort(found, {}, [this](std::size_t i) { return m_depths[i]; });
    return found;
}

void SpaceCageItem::setStyle(const OverlayStyle& style) {
    OverlayItem::setStyle(style);
    for (const auto& handle : m_handles)
        handle->setStyle(style);
}

QRectF SpaceCageItem::boundingRect() const {
    return m_points.boundingRect().adjusted(-4, -4, 4, 4);
}

void SpaceCageItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->setRenderHint(QPainter::Antialiasing);
    for (const bool behind : {true, false}) {
        QPainterPath path;
        for (const Edge& edge : m_edges)
            if (edge.isBehind == behind) {
                path.moveTo(edge.line.p1());
                path.lineTo(edge.line.p2());
            }
        strokeWithHalo(*painter, path, m_style, m_style.line,
                       behind ? m_style.lineWidth / 2 : m_style.lineWidth,
                       behind ? Qt::DashLine : Qt::SolidLine);
    }
}

} // namespace view
