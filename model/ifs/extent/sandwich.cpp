// SPDX-License-Identifier: MIT
#include "ifs/extent/sandwich.h"

#include <algorithm>
#include <utility>

namespace ifs {

namespace {

constexpr int nodesPerLine = 4'000;

} // namespace

Sandwich::Sandwich(Ask support, const Vector<2>& centre, double tolerance, const Outline* known, int maxLines,
                   std::stop_token stop)
    : m_support(std::move(support)),
      m_centre(centre),
      m_tolerance(tolerance),
      m_known(known),
      m_stop(std::move(stop)) {
    const Vector<2> axes[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (const Vector<2>& axis : axes)
        add(axis, m_support(axis, tolerance / 8, nodesPerLine, known));
    for (int asked = 4; asked < maxLines && !m_stop.stop_requested(); ++asked)
        if (!refine()) break;
}

double Sandwich::error() const {
    double widest = 0;
    for (const auto& line : m_outline.lines())
        widest = std::max(widest, line.gap);
    return widest;
}

void Sandwich::settleCorners(const Polygon& polygon) {
    const auto settle = [this](const Vector<2>& outward) {
        if (!m_stop.stop_requested()) add(outward, ask(outward, 0));
    };
    const std::size_t n = polygon.size();
    for (std::size_t k = 0; n == 2 && k < n; ++k) // ends of a segment
        settle((polygon[k] - polygon[1 - k]).normalized());
    // Limit; more corners belong to a curve and depend on the tolerance.
    constexpr std::size_t maxCorners = 255;
    for (std::size_t k = 0; n > 2 && n <= maxCorners && k < n; ++k) {
        const Vector<2> before = (polygon[k] - polygon[(k + n - 1) % n]).normalized(),
                        after = (polygon[(k + 1) % n] - polygon[k]).normalized();
        constexpr double minTurn = 1e-4; // limit below which a point inside an edge is left by the tolerance
        if (cross(before, after) < minTurn && before.dot(after) > 0) continue;
        const Vector<2> along = before + after;
        if (along.norm() < 1e-6) continue;
        settle(Vector<2>(along.y(), -along.x()).normalized());
    }
}

// Asks with the best known outline: the one made so far, or the one to begin with as long as that has more
// lines.
SupportValue<2> Sandwich::ask(const Vector<2>& normal, double tolerance) const {
    const bool isAhead = !m_known || m_outline.lines().size() >= m_known->lines().size();
    return m_support(normal, tolerance, nodesPerLine, isAhead ? &m_outline : m_known);
}

void Sandwich::add(const Vector<2>& normal, const SupportValue<2>& h) {
    m_outline.add(normal, h.value + h.error - normal.dot(m_centre), h.point - m_centre,
                  h.error <= m_tolerance / 2);
}

const Vector<2>& Sandwich::pointAt(std::size_t line) const {
    return m_outline.points()[m_outline.lines()[line % m_outline.lines().size()].point];
}

// Asks once more where it is worth most; false when nowhere.
bool Sandwich::refine() {
    double widest = m_tolerance;
    std::optional<Vector<2>> best;
    for (std::size_t k = 0; k < m_outline.lines().size(); ++k)
        if (const double gap = m_outline.lines()[k].gap; gap > widest)
            if (const auto normal = directionInto(k)) {
                widest = gap;
                best = normal;
            }
    if (best) add(*best, ask(*best, m_tolerance / 32));
    return best.has_value();
}

// Along the chord where it is longer than the gap is wide, else between the two normals. nullopt when no
// direction between them can tell more.
std::optional<Vector<2>> Sandwich::directionInto(std::size_t line) const {
    const Outline::Line &a = m_outline.lines()[line],
                        &b = m_outline.lines()[(line + 1) % m_outline.lines().size()];
    const double turn = cross(a.normal, b.normal);
    constexpr double minTurn = 1e-10;
    if (!a.settled || !b.settled || turn < 2 * minTurn) return std::nullopt;
    const Vector<2> chord = pointAt(line + 1) - pointAt(line);
    if (chord.norm() > a.gap) {
        const Vector<2> normal = Vector<2>(chord.y(), -chord.x()).normalized();
        if (cross(a.normal, normal) > turn / 64 && cross(normal, b.normal) > turn / 64) return normal;
    }
    return (a.normal + b.normal).normalized();
}

} // namespace ifs
