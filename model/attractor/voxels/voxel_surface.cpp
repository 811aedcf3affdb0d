// SPDX-License-Identifier: MIT
#include "attractor/voxels/voxel_surface.h"

#include <algorithm>
#include <bit>

namespace attractor {

namespace {

using Point = SurfaceMesh::Point;
using Index = VoxelGrid::Index;

constexpr std::int32_t bar = 1; // half the thickness of a bar, in steps of the lattice
constexpr std::int32_t voxel = latticePerVoxel;

// Eight voxels around a corner as bits x + 2y + 4z: whether those of one kind are connected through faces.
constexpr bool isConnected(unsigned octants) {
    if (octants == 0) return true;
    unsigned reached = octants & (~octants + 1);
    for (int step = 0; step < 8; ++step) {
        const unsigned alongX = (reached & 0x55U) << 1 | (reached & 0xAAU) >> 1;
        const unsigned alongY = (reached & 0x33U) << 2 | (reached & 0xCCU) >> 2;
        const unsigned alongZ = (reached & 0x0FU) << 4 | (reached & 0xF0U) >> 4;
        reached |= (alongX | alongY | alongZ) & octants;
    }
    return reached == octants;
}

constexpr std::array<bool, 256> singularPatterns() {
    std::array<bool, 256> result{};
    for (unsigned octants = 0; octants < 256; ++octants)
        result[octants] = !isConnected(octants) || !isConnected(~octants & 0xFFU);
    return result;
}
constexpr std::array<bool, 256> isSingularPattern = singularPatterns();

// Numbers the points in the order in which they come.
class PointNumbers {
public:
    explicit PointNumbers(std::vector<Point>& points) : m_points(points), m_slots(1U << 16, none) {}

    std::uint32_t operator()(const Point& point) {
        if (m_points.size() * 2 >= m_slots.size()) grow();
        std::size_t slot = slotOf(point);
        for (; m_slots[slot] != none; slot = (slot + 1) & (m_slots.size() - 1))
            if (m_points[m_slots[slot]] == point) return m_slots[slot];
        m_slots[slot] = std::uint32_t(m_points.size());
        m_points.push_back(point);
        return m_slots[slot];
    }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    std::size_t slotOf(const Point& point) const {
        std::uint64_t hash = 0;
        for (const std::int32_t c : point)
            hash = (hash ^ std::uint64_t(std::uint32_t(c))) * 0x9e3779b97f4a7c15U;
        return std::size_t(hash >> 24) & (m_slots.size() - 1);
    }

    void grow() {
        m_slots.assign(m_slots.size() * 4, none);
        for (std::uint32_t i = 0; i < m_points.size(); ++i) {
            std::size_t slot = slotOf(m_points[i]);
            while (m_slots[slot] != none)
                slot = (slot + 1) & (m_slots.size() - 1);
            m_slots[slot] = i;
        }
    }

    std::vector<Point>& m_points;
    std::vector<std::uint32_t> m_slots;
};

// An edge of the voxels: from a corner along an axis.
struct Edge {
    Index corner;
    int axis;

    friend auto operator<=>(const Edge&, const Edge&) = default;
};

class Builder {
public:
    explicit Builder(const VoxelGrid& grid) : m_grid(grid), m_number(m_mesh.points) {}

    std::optional<SurfaceMesh> build() {
        const auto [sizeX, sizeY, sizeZ] = m_grid.size();
        for (int z = 0; z < sizeZ && !m_isFull; ++z)
            for (int y = 0; y < sizeY && !m_isFull; ++y)
                for (int x = 0; x < sizeX; ++x)
                    if (m_grid.isFilled({x, y, z})) addFaces({x, y, z});
        unique(m_corners);
        unique(m_edges);
        for (const Index& corner : m_corners)
            addCube(corner);
        for (const Edge& edge : m_edges)
            addBar(edge);
        if (m_isFull) return std::nullopt;
        return std::move(m_mesh);
    }

private:
    template <class Value> static void unique(std::vector<Value>& values) {
        std::ranges::sort(values);
        values.erase(std::unique(values.begin(), values.end()), values.end());
    }

    // True if the voxels around the corner form a singular pattern.
    bool isSingular(const Index& corner) const {
        unsigned octants = 0;
        for (unsigned k = 0; k < 8; ++k)
            octants |= unsigned(m_grid.isFilled({corner[0] - 1 + int(k & 1), corner[1] - 1 + int(k >> 1 & 1),
                                                 corner[2] - 1 + int(k >> 2)}))
                       << k;
        return isSingularPattern[octants];
    }

    // True if two filled or two empty voxels touch only in the edge.
    bool isSingular(const Edge& edge) const {
        const std::size_t u = std::size_t(edge.axis + 1) % 3;
        const std::size_t v = std::size_t(edge.axis + 2) % 3;
        const auto at = [&](int i, int k) {
            Index voxelAt = edge.corner;
            voxelAt[u] -= i;
            voxelAt[v] -= k;
            return m_grid.isFilled(voxelAt);
        };
        return at(0, 0) == at(1, 1) && at(0, 1) == at(1, 0) && at(0, 0) != at(0, 1);
    }

    static Index moved(Index from, std::size_t axis, int by) {
        from[axis] += by;
        return from;
    }

    void addFaces(const Index& filled) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int side : {0, 1})
                if (!m_grid.isFilled(moved(filled, axis, 2 * side - 1))) addFace(filled, axis, side);
    }

    void addFace(const Index& filled, std::size_t axis, int side) {
        const std::size_t u = (axis + 1) % 3;
        const std::size_t v = (axis + 2) % 3;
        const Index origin = moved(filled, axis, side);
        constexpr std::array<std::array<int, 2>, 4> steps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
        std::array<bool, 4> isCut{};      // for corner k
        std::array<bool, 4> isStripped{}; // for the edge from corner k to the next
        Index corner = origin;
        for (std::size_t k = 0; k < 4; ++k) {
            if (isCut[k] = isSingular(corner); isCut[k]) m_corners.push_back(corner);
            Index lower = corner;
            if (k == 2) --lower[u];
            if (k == 3) --lower[v];
            const Edge edge{lower, int(k % 2 == 0 ? u : v)};
            if (isStripped[k] = isSingular(edge); isStripped[k]) m_edges.push_back(edge);
            corner[u] += steps[k][0];
            corner[v] += steps[k][1];
        }
        m_outline.clear();
        std::array<std::int32_t, 2> at{0, 0};
        for (std::size_t k = 0; k < 4; ++k) {
            const auto& before = steps[(k + 3) % 4];
            const auto& after = steps[k];
            const auto point = [&](std::int32_t back, std::int32_t on) {
                Point p = scaled(origin);
                p[u] += at[0] - back * before[0] + on * after[0];
                p[v] += at[1] - back * before[1] + on * after[1];
                m_outline.push_back(p);
            };
            if (!isCut[k]) {
                point(0, 0);
            } else {
                if (!isStripped[(k + 3) % 4]) point(bar, 0);
                point(bar, bar);
                if (!isStripped[k]) point(0, bar);
            }
            at[0] += voxel * after[0];
            at[1] += voxel * after[1];
        }
        if (side == 0) std::ranges::reverse(m_outline);
        const bool isWhole = std::ranges::none_of(isCut, [](bool cut) { return cut; });
        Point middle = scaled(origin);
        middle[u] += voxel / 2;
        middle[v] += voxel / 2;
        isWhole ? addFan(m_outline.front(), 1, m_outline.size() - 1) : addFan(middle, 0, m_outline.size());
    }

    // Adds triangles from a point to the edges of the outline between two of its points, or to all edges
    // around it.
    void addFan(const Point& apex, std::size_t first, std::size_t last) {
        const std::size_t count = m_outline.size();
        const std::uint32_t top = m_number(apex);
        for (std::size_t i = first; i < last; ++i)
            addTriangle({top, m_number(m_outline[i]), m_number(m_outline[(i + 1) % count])});
    }

    static Point scaled(const Index& corner) {
        return {corner[0] * voxel, corner[1] * voxel, corner[2] * voxel};
    }

    // Rectangle from a corner along two axes; `side` 1: seen from the positive end of `axis`.
    void addRectangle(Point corner, std::size_t axis, int side, std::int32_t alongU, std::int32_t alongV) {
        const std::size_t u = (axis + 1) % 3;
        const std::size_t v = (axis + 2) % 3;
        corner[u] += std::min(alongU, 0);
        corner[v] += std::min(alongV, 0);
        m_outline.assign(4, corner);
        m_outline[1][u] += std::abs(alongU);
        m_outline[2][u] += std::abs(alongU);
        m_outline[2][v] += std::abs(alongV);
        m_outline[3][v] += std::abs(alongV);
        if (side == 0) std::ranges::reverse(m_outline);
        addFan(m_outline.front(), 1, 3);
    }

    void addCube(const Index& corner) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int side : {0, 1}) {
                const Edge outward{moved(corner, axis, side - 1), int(axis)};
                if (isSingular(outward)) continue; // continues a bar
                for (unsigned quarter = 0; quarter < 4; ++quarter) {
                    const int onU = int(quarter & 1);
                    const int onV = int(quarter >> 1);
                    const std::size_t u = (axis + 1) % 3;
                    const std::size_t v = (axis + 2) % 3;
                    Index beyond = moved(corner, axis, side - 1);
                    beyond[u] += onU - 1;
                    beyond[v] += onV - 1;
                    if (m_grid.isFilled(beyond)) continue;
                    Point at = scaled(corner);
                    at[axis] += (2 * side - 1) * bar;
                    addRectangle(at, axis, side, (2 * onU - 1) * bar, (2 * onV - 1) * bar);
                }
            }
    }

    void addBar(const Edge& edge) {
        const auto axis = std::size_t(edge.axis);
        const std::size_t u = (axis + 1) % 3;
        const std::size_t v = (axis + 2) % 3;
        for (unsigned quarter = 0; quarter < 4; ++quarter) {
            const int onU = int(quarter & 1);
            const int onV = int(quarter >> 1);
            Index around = edge.corner;
            around[u] += onU - 1;
            around[v] += onV - 1;
            if (m_grid.isFilled(around)) continue;
            Point at = scaled(edge.corner);
            at[axis] += bar;
            constexpr std::int32_t length = voxel - 2 * bar;
            Point onSide = at;
            onSide[u] += (2 * onU - 1) * bar;
            addRectangle(onSide, u, onU, (2 * onV - 1) * bar, length); // axes after u: v, axis
            onSide = at;
            onSide[v] += (2 * onV - 1) * bar;
            addRectangle(onSide, v, onV, length, (2 * onU - 1) * bar); // axes after v: axis, u
        }
    }

    void addTriangle(const SurfaceMesh::Triangle& triangle) {
        if (m_mesh.triangles.size() < SurfaceMesh::maxTriangles)
            m_mesh.triangles.push_back(triangle);
        else
            m_isFull = true;
    }

    const VoxelGrid& m_grid;
    SurfaceMesh m_mesh;
    PointNumbers m_number;
    std::vector<Index> m_corners; // singular corners
    std::vector<Edge> m_edges;
    std::vector<Point> m_outline;
    bool m_isFull = false;
};

// The edges opposite a point in its triangles, as (from, to).
using Ring = std::vector<std::array<std::uint32_t, 2>>;

SurfaceFlaw flawOfRing(Ring& ring) {
    if (ring.empty()) return SurfaceFlaw::None; // corner without triangles
    for (std::size_t i = 0; i < ring.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (ring[i][0] == ring[k][0] || ring[i][1] == ring[k][1]) return SurfaceFlaw::NotManifold;
    std::uint32_t at = ring.front()[1];
    std::size_t seen = 1;
    for (; at != ring.front()[0]; ++seen) {
        const auto next =
            std::ranges::find_if(ring, [at](const std::array<std::uint32_t, 2>& e) { return e[0] == at; });
        if (next == ring.end()) return SurfaceFlaw::Open;
        at = (*next)[1];
    }
    return seen == ring.size() ? SurfaceFlaw::None : SurfaceFlaw::NotManifold;
}

} // namespace

std::optional<SurfaceMesh> voxelSurface(const VoxelGrid& grid) {
    return Builder(grid).build();
}

SurfaceFlaw flawOf(const SurfaceMesh& mesh) {
    std::vector<std::size_t> begin(mesh.points.size() + 1, 0);
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t point : triangle)
            ++begin[point + 1];
    for (std::size_t i = 1; i < begin.size(); ++i)
        begin[i] += begin[i - 1];
    std::vector<std::size_t> end(begin.begin(), begin.end() - 1);
    Ring opposite(3 * mesh.triangles.size());
    for (const auto& triangle : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            opposite[end[triangle[k]]++] = {triangle[(k + 1) % 3], triangle[(k + 2) % 3]};
    SurfaceFlaw worst = SurfaceFlaw::None;
    Ring ring;
    for (std::size_t i = 0; i + 1 < begin.size(); ++i) {
        ring.assign(opposite.begin() + std::ptrdiff_t(begin[i]),
                    opposite.begin() + std::ptrdiff_t(begin[i + 1]));
        const SurfaceFlaw flaw = flawOfRing(ring);
        if (flaw == SurfaceFlaw::NotManifold) return flaw;
        if (flaw != SurfaceFlaw::None) worst = flaw;
    }
    return worst;
}

double enclosedVolume(const SurfaceMesh& mesh) {
    double sixfold = 0;
    for (const auto& triangle : mesh.triangles) {
        std::array<ifs::Vector<3>, 3> p;
        for (std::size_t k = 0; k < 3; ++k) {
            const Point& point = mesh.points[triangle[k]];
            p[k] = {double(point[0]), double(point[1]), double(point[2])};
        }
        sixfold += p[0].x() * (p[1].y() * p[2].z() - p[1].z() * p[2].y()) +
                   p[0].y() * (p[1].z() * p[2].x() - p[1].x() * p[2].z()) +
                   p[0].z() * (p[1].x() * p[2].y() - p[1].y() * p[2].x());
    }
    return sixfold / 6;
}

} // namespace attractor
