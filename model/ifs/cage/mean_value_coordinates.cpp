// SPDX-License-Identifier: MIT
#include "ifs/cage/mean_value_coordinates.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace ifs {

namespace {

constexpr double atVertex = 1e-14; // relative to the size
constexpr double inPlane = 1e-14;

// α/(2 sin α) for the angle α between two directions. The sine of its half is accurate where it is small, the
// tangent where it is not.
double halfAngleOverSine(const Vector<3>& a, const Vector<3>& b) {
    constexpr double maxSine = 0.7;
    const double square = (a - b).squaredNorm() / 4; // square of the sine
    if (!(square > 0)) return 0.5;
    if (square < maxSine * maxSine) {
        const double sine = std::sqrt(square);
        return std::asin(sine) / (2 * sine * std::sqrt(1 - square));
    }
    const double normal = a.cross(b).norm();
    return normal > 0 ? std::atan2((a - b).norm(), (a + b).norm()) / normal : 0;
}

// Returns true if x, in the plane of a triangle, lies in it: the angles at x are a whole turn.
bool isAround(const std::array<Vector<3>, 3>& directions) {
    double turn = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vector<3>&a = directions[(k + 1) % 3], &b = directions[(k + 2) % 3];
        turn += 2 * std::atan2((a - b).norm(), (a + b).norm());
    }
    return turn > 2 * std::numbers::pi - 1e-5;
}

} // namespace

MeanValueCoordinates::MeanValueCoordinates(std::span<const Vector<3>> vertices,
                                           std::span<const std::array<int, 3>> triangles)
    : m_vertices(vertices.begin(), vertices.end()) {
    for (const Vector<3>& v : m_vertices)
        m_size = std::max(m_size, (v - m_vertices[0]).cwiseAbs().maxCoeff());
    std::map<std::array<std::size_t, 2>, std::size_t> known;
    for (const auto& corners : triangles) {
        Triangle triangle;
        for (std::size_t k = 0; k < 3; ++k)
            triangle.corner[k] = static_cast<std::size_t>(corners[k]);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t from = triangle.corner[(k + 1) % 3], to = triangle.corner[(k + 2) % 3];
            triangle.sense[k] = from < to ? 1 : -1;
            const std::array<std::size_t, 2> edge{std::min(from, to), std::max(from, to)};
            const auto [at, isNew] = known.emplace(edge, m_edges.size());
            if (isNew) m_edges.push_back(edge);
            triangle.edge[k] = at->second;
        }
        const Vector<3>& origin = m_vertices[triangle.corner[0]];
        triangle.normal =
            (m_vertices[triangle.corner[1]] - origin).cross(m_vertices[triangle.corner[2]] - origin);
        m_triangles.push_back(triangle);
    }
}

void MeanValueCoordinates::at(std::span<const Vector<3>> points, std::span<double> result) const {
    Seen seen{std::vector<SeenVertex>(m_vertices.size()), std::vector<SeenEdge>(m_edges.size())};
    for (std::size_t n = 0; n < points.size(); ++n) {
        const std::span<double> coordinates = result.subspan(n * size(), size());
        std::ranges::fill(coordinates, 0.0);
        add(points[n], seen, coordinates);
        double sum = 0;
        for (const double w : coordinates)
            sum += w;
        for (double& w : coordinates)
            w = std::abs(sum) > 0 && std::isfinite(sum) ? w / sum : 1.0 / static_cast<double>(size());
    }
}

// Weights up to a factor.
void MeanValueCoordinates::add(const Vector<3>& x, Seen& seen, std::span<double> result) const {
    for (std::size_t j = 0; j < m_vertices.size(); ++j) {
        const Vector<3> d = m_vertices[j] - x;
        const double distance = d.norm();
        if (distance <= atVertex * m_size) {
            result[j] = 1;
            return;
        }
        seen.vertices[j] = {d / distance, distance};
    }
    for (std::size_t e = 0; e < m_edges.size(); ++e) {
        const Vector<3>& a = seen.vertices[m_edges[e][0]].direction;
        const Vector<3>& b = seen.vertices[m_edges[e][1]].direction;
        seen.edges[e].normal = a.cross(b);
        seen.edges[e].weighted = halfAngleOverSine(a, b) * seen.edges[e].normal;
    }
    for (const Triangle& triangle : m_triangles) {
        std::array<const SeenVertex*, 3> corner{};
        for (std::size_t k = 0; k < 3; ++k)
            corner[k] = &seen.vertices[triangle.corner[k]];
        // Determinant from the distance to the plane, which is accurate near it.
        const double determinant =
            corner[0]->direction.dot(triangle.normal) / (corner[1]->distance * corner[2]->distance);
        if (std::abs(determinant) < inPlane) {
            if (!isAround({corner[0]->direction, corner[1]->direction, corner[2]->direction})) continue;
            std::ranges::fill(result, 0.0);
            for (std::size_t k = 0; k < 3; ++k) {
                const SeenVertex &next = *corner[(k + 1) % 3], &last = *corner[(k + 2) % 3];
                result[triangle.corner[k]] = next.distance * last.distance *
                                             next.direction.cross(last.direction).dot(triangle.normal) /
                                             triangle.normal.squaredNorm();
            }
            return;
        }
        Vector<3> mean = Vector<3>::Zero();
        for (std::size_t k = 0; k < 3; ++k)
            mean += triangle.sense[k] * seen.edges[triangle.edge[k]].weighted;
        for (std::size_t k = 0; k < 3; ++k)
            result[triangle.corner[k]] += triangle.sense[k] * seen.edges[triangle.edge[k]].normal.dot(mean) /
                                          (determinant * corner[k]->distance);
    }
}

std::vector<double> meanValueCoordinates(std::span<const Vector<3>> vertices,
                                         std::span<const std::array<int, 3>> triangles, const Vector<3>& x) {
    std::vector<double> result(vertices.size());
    MeanValueCoordinates(vertices, triangles).at({&x, 1}, result);
    return result;
}

} // namespace ifs
