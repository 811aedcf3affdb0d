// SPDX-License-Identifier: MIT
#include "ifs/extent/convex_hull_3d.h"

#include "ifs/extent/convex_hull.h"
#include "ifs/extent/polygon.h"
#include "ifs/linear/space_columns.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace ifs {

namespace {

using Points = std::vector<Vector<3>>;
using Facet = std::array<int, 3>;

// The error falls with their number, if the set is round: so many are used only to reach the tolerance.
constexpr std::size_t maxPoints = 20'000, manyPoints = 2'000;
constexpr int nodesPerFacet = 4'000, maxNodesPerFacet = 64'000;

Vector<3> outward(const Points& points, const Facet& facet) {
    const Vector<3>& a = points[std::size_t(facet[0])];
    return (points[std::size_t(facet[1])] - a).cross(points[std::size_t(facet[2])] - a);
}

Vector<3> meanOf(const Points& points) {
    Vector<3> mean = Vector<3>::Zero();
    for (const auto& point : points)
        mean += point / double(points.size());
    return mean;
}

// The directions in which the points extend, widest first, and how far from their mean.
PrincipalAxes spread(const Points& points) {
    Eigen::Matrix3Xd offsets(3, points.size());
    for (std::size_t k = 0; k < points.size(); ++k)
        offsets.col(Eigen::Index(k)) = points[k] - meanOf(points);
    return principalAxes(offsets);
}

bool areFlat(const Points& points) {
    constexpr double flat = 1e-9;
    if (points.size() < 4) return true;
    const Vector<3> extents = spread(points).lengths;
    return !(extents[2] > flat * extents[0]);
}

// A triangle of the hull, counter-clockwise seen from outside, in the plane ⟨normal,x⟩ = height of the whole
// face, which slivers do not define.
struct Face {
    Facet corners{};
    Vector<3> normal;
    double height = 0;
    double gap = 0;   // bound of how far the attractor extends beyond the face
    double reach = 0; // resulting bound of how far it extends beyond the hull
};

// Faces of the hull; none when the points do not span space.
std::vector<Face> facesOf(const Points& points) {
    if (areFlat(points)) return {};
    std::vector<coordT> coordinates;
    for (const auto& point : points)
        coordinates.insert(coordinates.end(), point.begin(), point.end());
    qhT context;
    qhT* qh = &context;
    qh_zero(qh, nullptr);
    char command[] = "qhull Qt Pp";
    const int failure =
        qh_new_qhull(qh, 3, int(points.size()), coordinates.data(), False, command, nullptr, nullptr);
    std::vector<Face> faces;
    if (failure == 0) {
        facetT* facet = nullptr;
        FORALLfacets {
            Face face;
            std::size_t k = 0;
            vertexT* vertex = nullptr;
            vertexT** vertexp = nullptr;
            FOREACHvertex_(facet->vertices) if (k < 3) face.corners[k++] = qh_pointid(qh, vertex->point);
            face.normal = Vector<3>(facet->normal[0], facet->normal[1], facet->normal[2]);
            face.height = -facet->offset;
            if (outward(points, face.corners).dot(face.normal) < 0)
                std::swap(face.corners[1], face.corners[2]);
            faces.push_back(face);
        }
    }
    qh_freeqhull(qh, qh_ALL);
    int remaining = 0, blocks = 0;
    qh_memfreeshort(qh, &remaining, &blocks);
    return faces;
}

// A point of the hull of some normals, by the weights of those that span it.
struct Combination {
    Points normals;
    std::vector<double> weights;

    Vector<3> point() const {
        Vector<3> sum = Vector<3>::Zero();
        for (std::size_t k = 0; k < normals.size(); ++k)
            sum += weights[k] * normals[k];
        return sum;
    }
    // Weights of the point nearest to the origin in the plane spanned by the normals.
    std::vector<double> nearest() const {
        const auto others = Eigen::Index(normals.size()) - 1;
        Eigen::Matrix3Xd edges(3, others);
        for (Eigen::Index k = 0; k < others; ++k)
            edges.col(k) = normals[std::size_t(k) + 1] - normals[0];
        const Eigen::VectorXd along = leastSquares(edges, -normals[0]);
        std::vector<double> result{1 - along.sum()};
        result.insert(result.end(), along.begin(), along.end());
        return result;
    }
    // Moves towards that point, at most to the border of the simplex, and drops normals that the new point
    // does not need. Returns true if it was reached.
    bool approachNearest() {
        const std::vector<double> aim = nearest();
        double share = 1;
        for (std::size_t k = 0; k < aim.size(); ++k)
            if (aim[k] < 0) share = std::min(share, weights[k] / (weights[k] - aim[k]));
        for (std::size_t k = aim.size(); k-- > 0;) {
            weights[k] += share * (aim[k] - weights[k]);
            if (weights[k] > 1e-15) continue;
            weights.erase(weights.begin() + std::ptrdiff_t(k));
            normals.erase(normals.begin() + std::ptrdiff_t(k));
        }
        return share == 1;
    }
};

// The least cosine between the normals around a vertex and an axis in their middle: the point nearest to the
// origin in their hull (Wolfe, Finding the nearest point in a polytope, 1976). Any axis proves its cosine.
double minCosine(const Points& normals) {
    if (normals.empty()) return 1;
    constexpr int steps = 64;
    Combination corral{{normals.front()}, {1}};
    double best = -1;
    for (int n = 0; n < steps; ++n) {
        const Vector<3> axis = corral.point();
        const double length = axis.norm();
        if (!(length > 0)) break;
        const auto worst = std::ranges::min_element(
            normals, {}, [&axis](const Vector<3>& normal) { return normal.dot(axis); });
        const double cosine = worst->dot(axis) / length;
        best = std::max(best, cosine);
        if (cosine >= length * (1 - 1e-9) || corral.normals.size() > 3) break;
        corral.normals.push_back(*worst);
        corral.weights.push_back(0);
        while (corral.normals.size() > 1 && !corral.approachNearest()) {}
        if (corral.normals.empty()) break;
    }
    return best;
}

// Distance by which the attractor may reach outside the hull, and the part of each face in it. The nearest
// point of the hull to one outside lies in a vertex v, and the unit vector u between them is Σ λ_f n_f, λ_f ≥
// 0, over the faces around v; their distance is then at most Σ λ_f gap_f, and Σ λ_f ⟨n_f,a⟩ = ⟨u,a⟩ ≤ 1 for
// any unit a.
double certify(std::vector<Face>& faces, std::size_t pointCount) {
    std::vector<Points> normals(pointCount);
    for (const Face& face : faces)
        for (const int corner : face.corners)
            normals[std::size_t(corner)].push_back(face.normal);
    std::vector<double> cosines;
    for (const Points& around : normals)
        cosines.push_back(minCosine(around));
    double farthest = faces.empty() ? std::numeric_limits<double>::infinity() : 0;
    for (Face& face : faces) {
        double cosine = 1;
        for (const int corner : face.corners)
            cosine = std::min(cosine, cosines[std::size_t(corner)]);
        if (face.gap > 0)
            face.reach = cosine > 0 ? face.gap / cosine : std::numeric_limits<double>::infinity();
        farthest = std::max(farthest, face.reach);
    }
    return farthest;
}

struct Refined {
    Points points;
    std::vector<Face> faces;
    double error = 0; // error of the hull of the faces
};

// Extreme points, refined over the facets until none lets the attractor farther out than the tolerance, or
// none has a point that lies apart from those already there.
class Refinement {
public:
    Refinement(const SupportFunction<3>& support, double tolerance, const std::stop_token& stop)
        : m_support(support),
          m_tolerance(tolerance),
          m_stop(stop),
          m_apart(1e-13 * (support.radius() + support.centre().norm())),
          m_accuracy(closest()) {}

    // Unfinished and useless if stopped.
    Refined hull() {
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z)
                    if ((x != 0 || y != 0 || z != 0) && !m_stop.stop_requested())
                        add(m_support(Vector<3>(x, y, z).normalized(), 0, nodesPerFacet).point);
        leaveThePlane();
        do
            m_hull.faces = facesOf(m_hull.points);
        while (!m_stop.stop_requested() && refine());
        return std::move(m_hull);
    }

private:
    struct Farthest {
        double height = std::numeric_limits<double>::infinity(); // upper bound of the attractor's height
        Vector<3> point;
        double accuracy = std::numeric_limits<double>::infinity();
    };

    double closest() const { return m_tolerance / 8; }

    void add(const Vector<3>& point) {
        const bool isNew = std::ranges::none_of(
            m_hull.points, [&](const Vector<3>& known) { return (known - point).norm() <= m_apart; });
        if (isNew) m_hull.points.push_back(point);
    }

    // Adds directions for needles, whose farthest points in many directions are two or three places that span
    // no space.
    void leaveThePlane() {
        constexpr int rounds = 4;
        for (int n = 0; n < rounds && !m_stop.stop_requested() && areFlat(m_hull.points); ++n) {
            const std::size_t known = m_hull.points.size();
            const Matrix<3> axes = spread(m_hull.points).directions;
            for (int k = 0; k < 3; ++k)
                for (const double sign : {1.0, -1.0})
                    add(m_support(sign * axes.col(k), 0, nodesPerFacet).point);
            if (m_hull.points.size() == known) return;
        }
    }

    const Farthest& farthest(const Face& face, double wanted) {
        Facet key = face.corners;
        std::ranges::sort(key);
        Farthest& known = m_asked[key];
        if (wanted < known.accuracy) {
            const auto h = m_support(face.normal, wanted, nodesFor(wanted));
            const bool isFarther = std::isinf(known.height) || h.value > face.normal.dot(known.point);
            known = {std::min(known.height, h.value + h.error), isFarther ? h.point : known.point, wanted};
        }
        return known;
    }

    // Larger budget, while it lasts, for faces whose last search was not conclusive.
    int nodesFor(double wanted) {
        int nodes = nodesPerFacet;
        for (double level = closest(); wanted < level && nodes < maxNodesPerFacet; level /= 64)
            nodes *= 4;
        if (nodes == nodesPerFacet || nodes > m_nodesToSpend) return nodesPerFacet;
        m_nodesToSpend -= nodes;
        return nodes;
    }

    // Adds points of faces that the attractor may exceed by more than `reach`; false if all are known
    // already.
    bool addBeyond(double reach) {
        const std::size_t known = m_hull.points.size();
        for (const Face& face : m_hull.faces) {
            if (m_stop.stop_requested()) return false;
            const Vector<3>& point = farthest(face, closest()).point;
            const double beyond = face.normal.dot(point) - face.height;
            if (face.reach > reach && beyond > face.gap / 2) add(point);
        }
        return m_hull.points.size() > known;
    }

    void measure() {
        for (Face& face : m_hull.faces) {
            if (m_stop.stop_requested()) return;
            const double wanted = face.reach > m_tolerance ? m_accuracy : closest();
            const double height = farthest(face, wanted).height;
            // Includes rounding in the plane of the face.
            face.gap = std::max(height - face.height, 0.0) + m_apart;
        }
        m_hull.error = certify(m_hull.faces, m_hull.points.size());
    }

    // Adds points for the worst faces that can still be improved, with more work if necessary; false if there
    // were none.
    bool refine() {
        if (m_hull.faces.empty()) { // flat: nothing to refine
            m_hull.error = std::numeric_limits<double>::infinity();
            return false;
        }
        const std::size_t known = m_hull.points.size();
        for (;; m_accuracy /= 64) {
            measure();
            if (m_stop.stop_requested()) return false;
            const bool isHopeless =
                known >= manyPoints && m_hull.error * double(known) > m_tolerance * double(maxPoints);
            if (m_hull.error <= m_tolerance || isHopeless || known >= maxPoints) return false;
            if (addBeyond(std::max(m_tolerance, m_hull.error / 8)) || addBeyond(m_tolerance)) return true;
            if (m_accuracy <= m_apart) return false;
        }
    }

    const SupportFunction<3>& m_support;
    double m_tolerance;
    const std::stop_token& m_stop;
    double m_apart;    // distance within which points coincide
    double m_accuracy; // accuracy of the worst faces
    int m_nodesToSpend = maxNodesPerFacet * 64;
    Refined m_hull;
    std::map<Facet, Farthest> m_asked; // results by corners
};

// Distance to a triangle: in its plane where the foot falls inside, else to an edge.
double distanceToTriangle(const Vector<3>& x, const Vector<3>& a, const Vector<3>& b, const Vector<3>& c) {
    const auto toSegment = [&x](const Vector<3>& p, const Vector<3>& q) {
        const Vector<3> chord = q - p;
        const double squared = chord.squaredNorm();
        const double t = squared > 0 ? std::clamp((x - p).dot(chord) / squared, 0.0, 1.0) : 0;
        return (x - p - t * chord).norm();
    };
    const Vector<3> normal = (b - a).cross(c - a);
    const auto inside = [&](const Vector<3>& p, const Vector<3>& q) {
        return (q - p).cross(x - p).dot(normal) >= 0;
    };
    if (normal.squaredNorm() > 0 && inside(a, b) && inside(b, c) && inside(c, a))
        return std::abs(normal.normalized().dot(x - a));
    return std::min({toSegment(a, b), toSegment(b, c), toSegment(c, a)});
}

// Distance by which the images of the vertices leave the hull, apart from rounding.
double escape(const ConvexHull3& hull, const std::vector<Face>& faces, const std::vector<AffineMap<3>>& maps,
              double rounding) {
    double result = 0;
    for (const auto& map : maps)
        for (const auto& vertex : hull.vertices) {
            const Vector<3> image = map(vertex);
            const auto isBeyond = [&](const Face& face) {
                return face.normal.dot(image) > face.height + rounding;
            };
            if (!faces.empty() && std::ranges::none_of(faces, isBeyond)) continue;
            double distance = std::numeric_limits<double>::infinity();
            for (const Facet& facet : hull.facets) {
                const auto corner = [&](std::size_t k) { return hull.vertices[std::size_t(facet[k])]; };
                distance = std::min(distance, distanceToTriangle(image, corner(0), corner(1), corner(2)));
            }
            if (hull.facets.empty()) // point or segment
                distance = distanceToTriangle(image, hull.vertices.front(), hull.vertices.back(),
                                              hull.vertices.back());
            result = std::max(result, distance);
        }
    return result + rounding;
}

// The hull of the points that are corners, numbered anew.
ConvexHull3 compact(const Points& points, const std::vector<Face>& faces) {
    ConvexHull3 hull;
    std::vector<int> number(points.size(), -1);
    for (const Face& face : faces) {
        Facet facet = face.corners;
        for (int& corner : facet) {
            int& known = number[std::size_t(corner)];
            if (known < 0) {
                known = int(hull.vertices.size());
                hull.vertices.push_back(points[std::size_t(corner)]);
            }
            corner = known;
        }
        hull.facets.push_back(facet);
    }
    for (const Facet& facet : hull.facets)
        hull.volume +=
            (hull.vertices[std::size_t(facet[0])] - hull.vertices[0]).dot(outward(hull.vertices, facet)) / 6;
    return hull;
}

// Points in a plane, on a line or all at one point: the polygon of their hull there, cut into triangles.
ConvexHull3 flatHull(const Points& points, double flatness) {
    const Matrix<3> axes = spread(points).directions;
    const Vector<3>&origin = points.front(), along = axes.col(0), across = axes.col(1);
    Polygon plane;
    for (const auto& point : points)
        plane.emplace_back(along.dot(point - origin), across.dot(point - origin));
    ConvexHull3 hull;
    for (const auto& corner : convexHull(std::move(plane), flatness))
        hull.vertices.push_back(origin + corner.x() * along + corner.y() * across);
    for (int k = 2; k < int(hull.vertices.size()); ++k)
        hull.facets.push_back({0, k - 1, k});
    return hull;
}

// The hull of an attractor in the plane of those points, by its maps there. How far they are from what the
// maps do counts as error, as in a collage. nullopt where they are not seen to contract, or when stopped.
std::optional<ConvexHull3> hullInPlane(const SupportFunction<3>& support, const Points& points,
                                       double tolerance, const std::stop_token& stop) {
    const Eigen::Matrix<double, 3, 2> axes = spread(points).directions.leftCols<2>();
    const Vector<3> origin = meanOf(points);
    std::vector<AffineMap<2>> maps;
    for (const auto& map : support.maps())
        maps.push_back({axes.transpose() * map.linear * axes, axes.transpose() * (map(origin) - origin)});
    const auto inPlane = SupportFunction<2>::of(maps);
    const auto polygon = inPlane ? convexHull(*inPlane, tolerance, stop) : std::nullopt;
    if (!polygon) return std::nullopt;
    ConvexHull3 hull;
    for (const auto& corner : polygon->vertices)
        hull.vertices.push_back(origin + axes * corner);
    for (int k = 2; k < int(hull.vertices.size()); ++k)
        hull.facets.push_back({0, k - 1, k});
    double off = 0;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const AffineMap<3>& map = support.maps()[i];
        const double leaving = (map.linear * axes - axes * maps[i].linear).norm();
        for (const auto& corner : polygon->vertices)
            off = std::max(off, (map(origin + axes * corner) - origin - axes * maps[i](corner)).norm() +
                                    leaving * polygon->error);
    }
    hull.error = polygon->error + support.normEquivalence() / (1 - support.contractivity()) * off +
                 support.roundingError(64);
    return hull;
}

// The better hull of points that span no space: the known one, or that of their plane.
std::optional<ConvexHull3> hullOfFlat(const SupportFunction<3>& support, const Points& points,
                                      ConvexHull3 known, double tolerance, const std::stop_token& stop) {
    if (known.error <= tolerance || points.size() < 3) return known;
    auto inPlane = hullInPlane(support, points, tolerance, stop);
    if (stop.stop_requested()) return std::nullopt;
    return inPlane && inPlane->error < known.error ? std::move(inPlane) : std::optional(std::move(known));
}

} // namespace

ConvexHull3 convexHull(const SupportFunction<3>& support, double tolerance) {
    return *convexHull(support, tolerance, {});
}

std::optional<ConvexHull3> convexHull(const SupportFunction<3>& support, double tolerance,
                                      const std::stop_token& stop) {
    if (const auto* better = support.conditioning()) {
        auto hull = convexHull(better->support, tolerance / spectralNorm<3>(better->image.linear), stop);
        if (!hull) return std::nullopt;
        for (auto& vertex : hull->vertices)
            vertex = better->image(vertex);
        hull->volume *= determinant<3>(better->image.linear);
        hull->error = better->errorOf(hull->error);
        if (hull->error <= tolerance) return hull;
        // Repeats here, because the attractor may be a needle only in the other coordinates.
        const Refined refined = Refinement(support, tolerance, stop).hull();
        if (stop.stop_requested()) return std::nullopt;
        if (!(refined.error < hull->error)) return hull;
        ConvexHull3 direct = compact(refined.points, refined.faces);
        direct.error = refined.error;
        return direct;
    }
    const double size = support.radius() + support.centre().norm(), flatness = 1e-12 * size;
    const double widening = support.normEquivalence() / (1 - support.contractivity());
    const Refined refined = Refinement(support, std::max(tolerance, 1e-11 * size), stop).hull();
    if (stop.stop_requested()) return std::nullopt;
    ConvexHull3 hull =
        refined.faces.empty() ? flatHull(refined.points, flatness) : compact(refined.points, refined.faces);
    // W(P + rB) ⊂ P + rB for r = e/(1 − γ), in the norm in which the maps contract.
    hull.error =
        std::min(refined.error, widening * escape(hull, refined.faces, support.maps(), 1e-14 * size) +
                                    support.roundingError(64));
    if (refined.faces.empty()) return hullOfFlat(support, refined.points, std::move(hull), tolerance, stop);
    return hull;
}

double volumeError(const ConvexHull3& hull) {
    constexpr double pi = std::numbers::pi;
    double surface = 0;
    Vector<3> low = Vector<3>::Zero(), high = low;
    for (const auto& facet : hull.facets) {
        const auto corner = [&](std::size_t k) { return hull.vertices[std::size_t(facet[k])]; };
        surface += (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2;
    }
    if (!hull.vertices.empty()) low = high = hull.vertices.front();
    for (const auto& vertex : hull.vertices) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    const double e = hull.error, diameter = (high - low).norm();
    if (hull.volume == 0) surface = 2 * diameter * diameter; // both sides of a set within a plane
    const double error = (surface + (2 * pi * diameter + 4 * pi / 3 * e) * e) * e * (1 + 1e-12);
    return e > 0 ? std::max(error, std::numeric_limits<double>::denorm_min()) : 0;
}

} // namespace ifs
