// SPDX-License-Identifier: MIT
#include "ifs/cage/cage_surface.h"

#include "ifs/cage/generalized_coordinates.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace ifs {

namespace {

constexpr double tolerance = 1e-9; // relative to the size

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

// Sorts counter-clockwise about the normal.
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
    // Smallest index first, so that no rounding decides where a face begins.
    const auto first = std::ranges::min_element(order, {}, &std::pair<double, int>::second);
    std::rotate(order.begin(), first, order.end());
    std::ranges::transform(order, face.begin(), &std::pair<double, int>::second);
}

// Returns true if the face turns at every corner.
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
                if (j <= i || j == k) continue; // requires i to be the smallest; both orientations are tried
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

CageCoordinates::Surface CageCoordinates::surfaceOf(std::span<const Vector<3>> vertices) {
    Surface result;
    result.corners.assign(vertices.begin(), vertices.end());
    const std::optional<CageSurface> surface = convexSurface(vertices);
    for (const std::vector<int>& face : surface ? surface->faces : std::vector<std::vector<int>>()) {
        if (face.size() == 3) {
            result.triangles.push_back({face[0], face[1], face[2]});
            continue;
        }
        Vector<3> mean = Vector<3>::Zero();
        for (const int corner : face)
            mean += vertices[std::size_t(corner)] / double(face.size());
        for (std::size_t k = 0; k < face.size(); ++k)
            result.triangles.push_back({face[k], face[(k + 1) % face.size()], int(result.corners.size())});
        result.corners.push_back(mean);
        result.meanOf.push_back(face);
    }
    return result;
}

CageCoordinates::CageCoordinates(std::span<const Vector<3>> vertices)
    : CageCoordinates(vertices.size(), surfaceOf(vertices)) {}

CageCoordinates::CageCoordinates(std::size_t count, Surface surface)
    : m_count(count), m_meanOf(std::move(surface.meanOf)), m_surface(surface.corners, surface.triangles) {}

std::vector<double> CageCoordinates::at(std::span<const Vector<3>> points) const {
    std::vector<double> weights(points.size() * m_surface.size());
    m_surface.at(points, weights);
    std::vector<double> result(points.size() * m_count);
    for (std::size_t n = 0; n < points.size(); ++n) {
        const double* all = weights.data() + n * m_surface.size();
        double* own = result.data() + n * m_count;
        std::copy_n(all, m_count, own);
        for (std::size_t f = 0; f < m_meanOf.size(); ++f)
            for (const int corner : m_meanOf[f])
                own[corner] += all[m_count + f] / double(m_meanOf[f].size());
    }
    return result;
}

CageDeformation::CageDeformation(std::span<const Vector<3>> from, std::span<const Vector<3>> to)
    : CageDeformation(std::make_shared<const CageCoordinates>(from), to) {}

CageDeformation::CageDeformation(std::shared_ptr<const CageCoordinates> from, std::span<const Vector<3>> to)
    : m_rest(std::move(from)), m_fit(affineFit<3>(m_rest->vertices(), to)) {
    for (std::size_t j = 0; j < m_rest->size(); ++j)
        m_residuals.emplace_back(to[j] - m_fit(m_rest->vertices()[j]));
}

std::vector<double> CageDeformation::coordinates(const Vector<3>& x) const {
    return m_rest->at({&x, 1});
}

Vector<3> CageDeformation::operator()(const Vector<3>& x) const {
    Vector<3> result = m_fit(x);
    const std::vector<double> weights = coordinates(x);
    for (std::size_t j = 0; j < m_residuals.size(); ++j)
        result += weights[j] * m_residuals[j];
    return result;
}

} // namespace ifs
