// SPDX-License-Identifier: MIT
#include "ifs/extent/extreme_points.h"

#include "ifs/extent/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace ifs {

namespace {

constexpr int maxSteps = 400; // steps of an itinerary
constexpr double sameRay = 1e-9;

Vector<2> outward(const Vector<2>& edge) {
    return Vector<2>(edge.y(), -edge.x()).normalized();
}

bool isSameRay(const Vector<2>& u, const Vector<2>& v) {
    return u.dot(v) > 0 && std::abs(cross(u, v)) <= sameRay * u.norm() * v.norm();
}

// The corner of a convex polygon that is farthest in a direction.
class Corners {
public:
    explicit Corners(const Polygon& polygon) : m_polygon(polygon) {
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const Vector<2> normal = outward(polygon[(k + 1) % polygon.size()] - polygon[k]);
            m_angles.emplace_back(std::atan2(normal.y(), normal.x()), k);
        }
        std::ranges::sort(m_angles);
    }

    std::size_t farthest(const Vector<2>& v) const {
        const std::pair wanted(std::atan2(v.y(), v.x()), std::size_t{0});
        const auto next = std::ranges::lower_bound(m_angles, wanted);
        std::size_t best = (next == m_angles.end() ? m_angles.front() : *next).second;
        const std::size_t n = m_polygon.size();
        // Neighbours as well, in case rounding chose the wrong edge.
        for (const std::size_t way : {std::size_t{1}, n - 1})
            while (v.dot(m_polygon[(best + way) % n]) > v.dot(m_polygon[best]))
                best = (best + way) % n;
        return best;
    }

    // Direction in the middle of the normals at a corner.
    Vector<2> middle(std::size_t k) const {
        const std::size_t n = m_polygon.size();
        const Vector<2> before = (m_polygon[k] - m_polygon[(k + n - 1) % n]).normalized(),
                        after = (m_polygon[(k + 1) % n] - m_polygon[k]).normalized();
        const Vector<2> along = before + after; // zero at the end of a segment
        return along.norm() > 1e-9 ? outward(along) : before;
    }

private:
    const Polygon& m_polygon;
    std::vector<std::pair<double, std::size_t>> m_angles;
};

// Follows directions u → A_iᵀu, where i is the map that leads to the point of the attractor farthest in u.
class Itineraries {
public:
    Itineraries(const SupportFunction<2>& support, const ConvexHull& fine)
        : m_maps(support.maps()),
          m_outer(support.mapsToTheHull()),
          m_polygon(fine.vertices),
          m_corners(m_polygon),
          m_error(fine.error),
          m_size(support.radius() + support.centre().norm()) {
        for (const auto& map : m_maps)
            m_transposed.push_back(map.linear.transpose());
    }

    std::optional<PeriodicPoint> through(const Vector<2>& start) const {
        Word word;
        std::map<std::size_t, std::size_t> seen; // number of symbols that lead to each corner
        Vector<2> v = start.normalized();
        for (std::size_t corner = m_corners.farthest(v); !seen.contains(corner);) {
            seen[corner] = word.size();
            const auto symbol = winner(v);
            if (!symbol || word.size() > maxSteps) return std::nullopt;
            word.push_back(*symbol);
            v = transposed(*symbol, v);
            if (v.norm() == 0) return std::nullopt;
            corner = m_corners.farthest(v);
            if (!seen.contains(corner)) continue;
            const auto cut = word.begin() + std::ptrdiff_t(seen[corner]);
            PeriodicPoint found{{word.begin(), cut}, {cut, word.end()}, Vector<2>::Zero()};
            return settled(std::move(found), start);
        }
        return std::nullopt;
    }

    // Extreme point at which others accumulate: it is farthest in one direction alone, which only its map
    // determines.
    std::optional<PeriodicPoint> fixedAt(const Vector<2>& corner, const Vector<2>& direction) const {
        for (const std::size_t i : m_outer)
            if (const auto fixed = fixedPoint(m_maps[i]); fixed && (*fixed - corner).norm() <= 1e-12 * m_size)
                if (auto found = settled({{}, {int(i)}, *fixed}, direction)) return found;
        return std::nullopt;
    }

private:
    // Unit vector along Aᵀv, since only the direction counts; 0 if the map leaves none.
    Vector<2> transposed(int symbol, const Vector<2>& v) const {
        const Vector<2> next = m_transposed[std::size_t(symbol)] * v;
        const double length = next.norm();
        return length > 1e-300 ? Vector<2>(next / length) : Vector<2>(Vector<2>::Zero());
    }

    // Margin by which a symbol wins over all others that lead elsewhere; not positive if that is unproved.
    double margin(const Vector<2>& v, int symbol) const {
        const auto reach = [&](std::size_t i) { return Vector<2>(m_transposed[i] * v); };
        const auto pointOf = [&](std::size_t i) {
            const Vector<2> turned = reach(i);
            return m_maps[i](m_polygon[turned.norm() > 0 ? m_corners.farthest(turned) : 0]);
        };
        const Vector<2> chosen = pointOf(std::size_t(symbol));
        double least = m_size;
        for (const std::size_t i : m_outer) {
            if (int(i) == symbol) continue;
            const Vector<2> other = pointOf(i);
            if ((other - chosen).norm() <= 1e-13 * m_size) continue; // same point by another address
            least = std::min(least, v.dot(chosen - other) - m_error * reach(i).norm() - 1e-14 * m_size);
        }
        return least;
    }

    std::optional<int> winner(const Vector<2>& v) const {
        int best = 0;
        double most = -std::numeric_limits<double>::infinity();
        for (const std::size_t i : m_outer) {
            const Vector<2> turned = m_transposed[i] * v;
            const double height = v.dot(m_maps[i](m_polygon[m_corners.farthest(turned)]));
            if (height > most) {
                most = height;
                best = int(i);
            }
        }
        return margin(v, best) > 0 ? std::optional(best) : std::nullopt;
    }

    // Direction to which a word leads if it wins at each step; `least` receives the smallest margin.
    std::optional<Vector<2>> led(Vector<2> v, const Word& word, double& least) const {
        for (const int symbol : word) {
            least = std::min(least, margin(v, symbol));
            v = transposed(symbol, v);
            if (!(least > 0) || v.norm() == 0) return std::nullopt;
        }
        return v;
    }

    // Directions fixed by the period: eigenvectors of positive eigenvalues, dominant first. For a multiple of
    // the identity, all directions.
    std::vector<Vector<2>> returning(const Word& period, const Vector<2>& direction) const {
        Matrix<2> total = Matrix<2>::Identity();
        for (const int symbol : period) {
            total = m_transposed[std::size_t(symbol)] * total;
            const double size = total.cwiseAbs().maxCoeff();
            if (!(size > 0)) return {};
            total /= size;
        }
        const double mean = total.trace() / 2;
        const double discriminant = mean * mean - determinant<2>(total);
        constexpr double nothing = 1e-12;
        if ((total - mean * Matrix<2>::Identity()).norm() <= nothing)
            return mean > 0 ? std::vector{direction} : std::vector<Vector<2>>{};
        if (!(discriminant > nothing)) return {};
        std::vector<Vector<2>> result;
        for (const double sign : {1.0, -1.0}) {
            const double eigenvalue = mean + sign * std::sqrt(discriminant);
            if (!(eigenvalue > nothing)) continue;
            const Matrix<2> rest = total - (mean - sign * std::sqrt(discriminant)) * Matrix<2>::Identity();
            const Vector<2> vector = rest.col(rest.col(0).norm() < rest.col(1).norm() ? 1 : 0).normalized();
            result.push_back(vector);
            result.push_back(-vector);
        }
        return result;
    }

    std::optional<PeriodicPoint> settled(PeriodicPoint found, const Vector<2>& start) const {
        double least = m_size;
        const auto arrived = led(start.normalized(), found.prefix, least);
        if (!arrived) return std::nullopt;
        for (const Vector<2>& own : returning(found.period, *arrived)) {
            double margin = m_size;
            const auto back = led(own, found.period, margin);
            if (!back || !isSameRay(*back, own)) continue;
            if (!isSameRay(*arrived, own) && !leadsThrough(found.prefix, own) &&
                !convergesTo(own, margin, *arrived, found.period))
                continue;
            shorten(found);
            const auto point = addressPoint<2>(m_maps, found.prefix, found.period);
            if (!point) return std::nullopt;
            found.point = *point;
            return found;
        }
        return std::nullopt;
    }

    // Returns true if the direction that the prefix takes to `own` leads there.
    bool leadsThrough(const Word& prefix, Vector<2> own) const {
        for (auto symbol = prefix.rbegin(); symbol != prefix.rend(); ++symbol) {
            const auto back = inverse<2>({m_transposed[std::size_t(*symbol)], Vector<2>::Zero()});
            if (!back) return false;
            own = back->linear * own;
            own.normalize();
        }
        double least = m_size;
        return led(own, prefix, least).has_value();
    }

    // Returns true if a direction comes so close to `own` that no symbol can change any more: heights change
    // by at most 2·size·angle.
    bool convergesTo(const Vector<2>& own, double margin, Vector<2> v, const Word& period) const {
        constexpr int rounds = 60;
        double distance = 2;
        for (int n = 0; n < rounds; ++n) {
            const double next = (v - own).norm();
            if (!(next < distance)) return false;
            distance = next;
            if (8 * m_size * distance < margin) return true;
            double least = m_size;
            const auto led = this->led(v, period, least);
            if (!led) return false;
            v = *led;
        }
        return false;
    }

    static void shorten(PeriodicPoint& found) {
        Word& period = found.period;
        for (std::size_t length = 1; length < period.size(); ++length)
            if (period.size() % length == 0 &&
                std::equal(period.begin() + std::ptrdiff_t(length), period.end(), period.begin())) {
                period.resize(length);
                break;
            }
        while (!found.prefix.empty() && found.prefix.back() == period.back()) {
            std::rotate(period.rbegin(), period.rbegin() + 1, period.rend());
            found.prefix.pop_back();
        }
    }

    const std::vector<AffineMap<2>>& m_maps;
    const std::vector<std::size_t>& m_outer; // maps that can lead to an extreme point
    std::vector<Matrix<2>> m_transposed;
    const Polygon& m_polygon;
    Corners m_corners;
    double m_error;
    double m_size;
};

} // namespace

std::vector<std::optional<PeriodicPoint>> periodicExtremePoints(const SupportFunction<2>& support,
                                                                const ConvexHull& hull,
                                                                const std::stop_token& stop) {
    std::vector<std::optional<PeriodicPoint>> result(hull.vertices.size());
    if (hull.vertices.size() == 1) { // fixed point of all maps
        result.front() = PeriodicPoint{{}, {0}, support.pointOfAttractor()};
        return result;
    }
    // Limit of the corners of a self-similar hull at the finer tolerance. A round hull has too many, and none
    // of them is periodic.
    constexpr double fineTolerance = 1e-12;
    constexpr double maxCorners = 10'000;
    const double tolerance = std::clamp(hull.error / support.radius(), 1e-16, 0.5);
    const double expected = std::pow(hull.vertices.size(), std::log(fineTolerance) / std::log(tolerance));
    if (expected > maxCorners) return result;
    const auto finer = convexHull(support, fineTolerance * support.radius(), stop);
    if (!finer) return result;
    const ConvexHull& fine = *finer;
    const Itineraries itineraries(support, fine);
    const Corners corners(hull.vertices);
    const double near = 4 * (hull.error + fine.error);
    for (std::size_t k = 0; k < hull.vertices.size() && !stop.stop_requested(); ++k) {
        const Vector<2> direction = corners.middle(k);
        result[k] = itineraries.fixedAt(hull.vertices[k], direction);
        if (!result[k]) result[k] = itineraries.through(direction);
        if (result[k] && (result[k]->point - hull.vertices[k]).norm() > near) result[k].reset();
    }
    return result;
}

} // namespace ifs
