// SPDX-License-Identifier: MIT
#include "space/space_definition.h"

#include "attractor/request/orbit_navigation.h"
#include "document/analysis/space_outlines.h"

#include <algorithm>
#include <cmath>

namespace view {

namespace {

constexpr double apart = 4;      // pixels; prevents a double click from setting two corners
constexpr double steepest = 0.1; // least sine of the angle between plane and line of sight

} // namespace

void SpaceDefinition::setActive(bool active) {
    m_isActive = active;
    m_points.clear();
    m_next.reset();
    m_lift = 1;
    show();
}

double SpaceDefinition::regularHeight() const {
    const double edges = (m_points[1] - m_points[0]).norm() + (m_points[2] - m_points[1]).norm() +
                         (m_points[0] - m_points[2]).norm();
    return std::sqrt(2.0 / 3) * edges / 3;
}

std::optional<ifs::Vector<3>> SpaceDefinition::pointAt(const attractor::OrbitCamera& camera,
                                                       const ifs::Vector<2>& pixel) const {
    if (m_points.empty()) return toWorld(camera, {pixel, 0});
    const double height = isLifting() ? m_lift * regularHeight() : 0;
    const attractor::Ray ray = rayThrough(camera, pixel);
    const double slope = m_normal.dot(ray.direction);
    if (std::abs(slope) < steepest) return std::nullopt;
    const double along = (height - m_normal.dot(ray.origin - m_origin)) / slope;
    return ray.origin + along * ray.direction;
}

std::optional<ifs::Simplex<3>> SpaceDefinition::click(const attractor::OrbitCamera& camera,
                                                      const ifs::Vector<2>& pixel) {
    const auto point = pointAt(camera, pixel);
    const bool isKnown = !point || std::ranges::any_of(m_points, [&](const ifs::Vector<3>& other) {
        return (*point - other).norm() * pixelsPerUnit(camera) < apart;
    });
    if (isKnown) return std::nullopt;
    if (m_points.empty()) {
        m_origin = camera.target;
        m_normal = camera.orientation.toRotationMatrix().col(2);
    }
    if (isLifting()) return ifs::Simplex<3>{m_points[0], m_points[1], m_points[2], *point};
    m_points.push_back(*point);
    follow(camera, pixel);
    return std::nullopt;
}

void SpaceDefinition::follow(const attractor::OrbitCamera& camera, const ifs::Vector<2>& pixel) {
    m_next = pointAt(camera, pixel);
    show();
}

void SpaceDefinition::lift(double share) {
    m_lift += share;
}

bool SpaceDefinition::takeBack() {
    if (m_points.empty()) return false;
    m_points.pop_back();
    m_lift = 1;
    show();
    return true;
}

void SpaceDefinition::show() {
    std::vector<document::SpaceOutline> shapes;
    if (m_isActive && !m_points.empty()) {
        document::SpaceOutline lines{document::Outline::Simplex, m_points, {}, {}};
        if (m_next) lines.points.push_back(*m_next);
        for (int b = 1; b < int(lines.points.size()); ++b)
            for (int a = 0; a < b; ++a)
                lines.edges.push_back({a, b});
        shapes.push_back({document::Outline::Simplex, m_points, {}, {}});
        if (!lines.edges.empty()) shapes.push_back(std::move(lines));
    }
    m_lines.setShapes(std::move(shapes));
}

QString SpaceDefinition::prompt() const {
    if (!m_isActive) return {};
    switch (m_points.size()) {
    case 0:
        return tr("Click the first of the four corners. The picture stays where it is; Esc cancels.");
    case 1:
        return tr("Click the second corner. Backspace removes the last point.");
    case 2:
        return tr("Click the third corner. Backspace removes the last point.");
    default:
        return tr("Click the fourth corner, in front of the other three. The wheel pushes it away, and the "
                  "right button turns the view.");
    }
}

} // namespace view
