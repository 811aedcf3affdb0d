// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace ifs {

// Bounds of a set in the plane: lines that it does not cross, and one point of it for each. The lines bound a
// convex polygon around it, of which each has an edge, and the points span one inside, so its support
// function lies between theirs. docs/mathematics.md, "Convex hull".
class Outline {
public:
    struct Line {
        double angle;     // 0 to 4 for a turn; increases with the angle of the normal
        Vector<2> normal; // unit length
        double height;    // ⟨normal,x⟩ ≤ height
        std::size_t point;
        bool settled; // true if a neighbouring direction may tell more
        // The intersection with the next line counter-clockwise, and a bound of its distance from the hull of
        // the points.
        Vector<2> corner = Vector<2>::Zero();
        double gap = 0;
    };

    // Lines must come from all around before bracket() is asked.
    void add(const Vector<2>& normal, double height, const Vector<2>& point, bool settled) {
        const Line line{angleOf(normal), normal, height, m_points.size(), settled};
        m_points.push_back(point);
        const auto index = std::ranges::upper_bound(m_angles, line.angle) - m_angles.begin();
        m_angles.insert(m_angles.begin() + index, line.angle);
        m_lines.insert(m_lines.begin() + index, line);
        auto k = std::size_t(index);
        while (isSuperfluous(before(k)))
            k = remove(before(k), k);
        while (isSuperfluous(after(k)))
            k = remove(after(k), k);
        meet(before(k));
        meet(k);
        constexpr std::size_t around = neighbours + 1;
        for (std::size_t n = 0; n < std::min(2 * around, m_lines.size()); ++n)
            measure((k + m_lines.size() + n - std::min(around, m_lines.size())) % m_lines.size());
    }

    struct Bracket {
        double upper, lower; // bounds of the support function
        std::size_t point;   // index of a point at which `lower` is attained
    };
    Bracket bracket(const Vector<2>& v) const {
        const auto after = std::size_t(std::ranges::upper_bound(m_angles, angleOf(v)) - m_angles.begin());
        const Line& a = m_lines[(after == 0 ? m_lines.size() : after) - 1];
        const Line& b = m_lines[after == m_lines.size() ? 0 : after];
        const double atA = v.dot(m_points[a.point]), atB = v.dot(m_points[b.point]);
        return {v.dot(a.corner), std::max(atA, atB), atA < atB ? b.point : a.point};
    }

    const std::vector<Line>& lines() const { return m_lines; }
    const Polygon& points() const { return m_points; }

private:
    static double angleOf(const Vector<2>& v) {
        const double size = std::abs(v.x()) + std::abs(v.y());
        if (size == 0) return 0;
        return v.y() >= 0 ? 1 - v.x() / size : 3 + v.x() / size;
    }

    static Vector<2> meeting(const Line& a, const Line& b) {
        return Vector<2>(a.height * b.normal.y() - b.height * a.normal.y(),
                         b.height * a.normal.x() - a.height * b.normal.x()) /
               cross(a.normal, b.normal);
    }

    std::size_t before(std::size_t k) const { return (k == 0 ? m_lines.size() : k) - 1; }
    std::size_t after(std::size_t k) const { return k + 1 == m_lines.size() ? 0 : k + 1; }

    // Returns true if the neighbours of a line meet below it.
    bool isSuperfluous(std::size_t k) const {
        const Line &a = m_lines[before(k)], &b = m_lines[after(k)];
        return m_lines.size() > 4 && cross(a.normal, b.normal) > 0 &&
               m_lines[k].normal.dot(meeting(a, b)) <= m_lines[k].height;
    }

    // Returns the new index of another line.
    std::size_t remove(std::size_t k, std::size_t other) {
        m_angles.erase(m_angles.begin() + std::ptrdiff_t(k));
        m_lines.erase(m_lines.begin() + std::ptrdiff_t(k));
        return other - (k < other ? 1 : 0);
    }

    void meet(std::size_t k) {
        Line& a = m_lines[k];
        const Line& b = m_lines[after(k)];
        a.corner = cross(a.normal, b.normal) > 0 ? meeting(a, b) : Vector<2>(a.height * a.normal);
    }

    // The point of a line lies near its edge, yet perhaps beside it: chords around are looked at as well.
    void measure(std::size_t k) {
        Line& line = m_lines[k];
        std::size_t at = k;
        for (std::size_t n = 0; n < neighbours; ++n)
            at = before(at);
        line.gap = std::numeric_limits<double>::infinity();
        for (std::size_t n = 0; n <= 2 * neighbours; ++n, at = after(at))
            line.gap = std::min(line.gap, distanceToSegment(line.corner, m_points[m_lines[at].point],
                                                            m_points[m_lines[after(at)].point]));
    }

    static constexpr std::size_t neighbours = 2;
    std::vector<double> m_angles; // angles of the lines, contiguous for a fast search
    std::vector<Line> m_lines;
    Polygon m_points;
};

} // namespace ifs
