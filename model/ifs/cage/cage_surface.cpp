// SPDX-License-Identifier: MIT
#include "ifs/cage/cage_surface.h"

#include "ifs/cage/generalized_coordinates.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <set>

namespace ifs {

namespace {

constexpr double tolerance = 1e-9; // of the size

// The corners in the plane, if all others are below it; else none.
std::vector<int> faceThrough(std::span<const Vector<3>> vertices, const Vector<3>& normal, double offset,
                             double room) {
    std::vector<int> face;
    for (std::size_t j = 0; j < vertices.size(); ++j) {
        const double height = normal.dot(vertices[j]) - offset;
        if (height > room) return {};
        if (height >= -room) face.push_back(int(j));
    }
    return face;
}

// In the sense of turning about the normal.
void sortAround(std::vector<int>& face, std::span<const Vector<3>> vertices, const Vector<3>& normal) {
    Vector<3> middle = Vector<3>::Zero();
    for (const int j : face)
        middle += vertices[std::size_t(j)] / double(face.size());
    const Vector<3> right = (vertices[std::size_t(face[0])] - middle).normalized();
    const Vector<3> up = normal.cross(right);
    std::vector<std::pair<double, int>> order;
    for (const int j : face) {
        const Vector<3> spoke = vertices[std::size_t(j)] - middle;
        order.emplace_back(std::atan2(spoke.dot(up), spoke.dot(right)), j);
    }
    std::ranges::sort(order);
    // The smallest index first, so that no rounding decides where a face begins.
    const auto first = std::ranges::min_element(order, {}, &std::pair<double, int>::second);
    std::ranges::rotate(order, first);
    std::ranges::transform(order, face.begin(), &std::pair<double, int>::second);
}

// Whether the face turns at every corner.
bool isStrict(const std::vector<int>& face, std::span<const Vector<3>> vertices, const Vector<3>& normal) {
    const std::size_t n = face.size();
    for (std::size_t k = 0; k < n; ++k) {
        const Vector<3>& a = vertices[std::size_t(face[k])];
        const Vector<3> in = vertices[std::size_t(face[(k + 1) % n])] - a;
        const Vector<3> out =
            vertices[std::size_t(face[(k + 2) % n])] - vertices[std::size_t(face[(k + 1) % n])];
        if (!(in.cross(out).dot(normal) > tolerance * in.norm() * out.norm())) return false;
    }
    return true;
}

double sizeOf(std::span<const Vector<3>> vertices) {
    double size = 0;
    for (const Vector<3>& v : vertices)
        size = std::max(size, (v - vertices[0]).norm());
    return size;
}

} // namespace

std::vector<std::array<int, 2>> CageSurface::edges() const {
    std::set<std::array<int, 2>> edges;
    for (const std::vector<int>& face : faces)
        for (std::size_t k = 0; k < face.size(); ++k) {
            const auto [a, b] = std::minmax(face[k], face[(k + 1) % face.size()]);
            edges.insert({a, b});
        }
    return {edges.begin(), edges.end()};
}

std::optional<CageSurface> convexSurface(std::span<const Vector<3>> vertices) {
    const std::size_t n = vertices.size();
    if (n < 4 || n > maxSpaceCorners) return std::nullopt;
    const double size = sizeOf(vertices);
    if (!(size > 0) || !std::isfinite(size)) return std::nullopt;
    const double room = tolerance * size;
    CageSurface surface;
    std::set<std::vector<int>> known;
    std::vector<int> facesAt(n, 0);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            for (std::size_t k = i + 1; k < n; ++k) {
                if (j <= i || j == k) continue; // i is the smallest, and both senses are tried
                const Vector<3> across = (vertices[j] - vertices[i]).cross(vertices[k] - vertices[i]);
                if (!(across.norm() > room * size)) continue;
                const Vector<3> normal = across.normalized();
                std::vector<int> face = faceThrough(vertices, normal, normal.dot(vertices[i]), room);
                if (face.size() < 3 || face.size() == n || !known.insert(face).second) continue;
                sortAround(face, vertices, normal);
                if (!isStrict(face, vertices, normal)) return std::nullopt;
                for (const int corner : face)
                    ++facesAt[std::size_t(corner)];
                surface.faces.push_back(std::move(face));
            }
    const bool isClosed = std::ranges::all_of(facesAt, [](int faces) { return faces >= 3; }) &&
                          n + surface.faces.size() == surface.edges().size() + 2;
    return isClosed ? std::optional(std::move(surface)) : std::nullopt;
}

CageDeformation::CageDeformation(std::span<const Vector<3>> from, std::span<const Vector<3>> to)
    : m_count(from.size()), m_corners(from.begin(), from.end()), m_fit(affineFit<3>(from, to)) {
    const std::optional<CageSurface> surface = convexSurface(from);
    for (const std::vector<int>& face : surface ? surface->faces : std::vector<std::vector<int>>()) {
        if (face.size() == 3) {
            m_triangles.push_back({face[0], face[1], face[2]});
            continue;
        }
        Vector<3> mean = Vector<3>::Zero();
        for (const int corner : face)
            mean += from[std::size_t(corner)] / double(face.size());
        for (std::size_t k = 0; k < face.size(); ++k)
            m_triangles.push_back({face[k], face[(k + 1) % face.size()], int(m_corners.size())});
        m_corners.push_back(mean);
        m_meanOf.push_back(face);
    }
    for (std::size_t j = 0; j < m_count; ++j)
        m_residuals.emplace_back(to[j] - m_fit(from[j]));
}

std::vector<double> CageDeformation::coordinates(const Vector<3>& x) const {
    std::vector<double> weights = meanValueCoordinates(m_corners, m_triangles, x);
    for (std::size_t f = 0; f < m_meanOf.size(); ++f)
        for (const int corner : m_meanOf[f])
            weights[std::size_t(corner)] += weights[m_count + f] / double(m_meanOf[f].size());
    weights.resize(m_count);
    return weights;
}

Vector<3> CageDeformation::operator()(const Vector<3>& x) const {
    Vector<3> result = m_fit(x);
    const std::vector<double> weights = coordinates(x);
    for (std::size_t j = 0; j < m_count; ++j)
        result += weights[j] * m_residuals[j];
    return result;
}

} // namespace ifs
