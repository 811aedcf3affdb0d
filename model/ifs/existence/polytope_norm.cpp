// SPDX-License-Identifier: MIT
#include "ifs/existence/polytope_norm.h"
#include "ifs/linear/rounding.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace ifs {

namespace {

constexpr std::size_t maxVertices = 600;
constexpr double maxReach = 1e6; // greatest norm of a vertex
constexpr double isInside = 1 + 1e-10;

// The symmetric hull of its vertices, of which the first are the unit vectors.
template <int Dim> class Polytope {
public:
    Polytope() {
        for (int k = 0; k < Dim; ++k)
            vertices.push_back(Vector<Dim>::Unit(k));
    }

    std::vector<Vector<Dim>> vertices;
    std::size_t work = 0;

    // Upper bound of the least Σ|λ| with Σ λ_j v_j = x, from Dim vertices that the simplex method chooses.
    double norm(const Vector<Dim>& x) {
        Matrix<Dim> corners = Matrix<Dim>::Identity();
        for (int k = 0; k < Dim; ++k) {
            if (x[k] < 0) corners(k, k) = -1;
        }
        double best = x.cwiseAbs().sum();
        constexpr int maxSteps = 60;
        for (int n = 0; n < maxSteps; ++n) {
            const Matrix<Dim> inverse = corners.inverse();
            const Vector<Dim> shares = inverse * x;
            best = std::min(best, certified(corners, shares, x));
            const Vector<Dim> normal = inverse.transpose() * Vector<Dim>::Ones();
            const auto [farthest, height] = extreme(normal);
            if (!(std::abs(height) > 1 + 1e-12)) break;
            const Vector<Dim> entering = height < 0 ? Vector<Dim>(-vertices[farthest]) : vertices[farthest];
            const Vector<Dim> change = inverse * entering;
            int leaving = -1;
            double least = std::numeric_limits<double>::infinity();
            for (int k = 0; k < Dim; ++k)
                if (change[k] > 1e-12 && std::max(shares[k], 0.0) / change[k] < least) {
                    least = std::max(shares[k], 0.0) / change[k];
                    leaving = k;
                }
            if (leaving < 0) break;
            corners.col(leaving) = entering;
            if (best <= 1 && n > 0) break; // inside, at whatever distance
        }
        return best;
    }

private:
    // Σ|λ| for these λ, plus the norm of the remainder of x: the polytope contains the ball of radius 1/√Dim.
    static double certified(const Matrix<Dim>& corners, const Vector<Dim>& shares, const Vector<Dim>& x) {
        const double terms = corners.cwiseAbs().maxCoeff() * shares.cwiseAbs().sum() + x.norm();
        const double rest = (corners * shares - x).norm() + 8 * Dim * roundingUnit * terms;
        const double result =
            shares.cwiseAbs().sum() * (1 + 4 * roundingUnit) + std::sqrt(double(Dim)) * rest;
        return std::isfinite(result) ? result : std::numeric_limits<double>::infinity();
    }

    std::pair<std::size_t, double> extreme(const Vector<Dim>& normal) {
        work += vertices.size();
        std::pair<std::size_t, double> result{0, 0};
        for (std::size_t k = 0; k < vertices.size(); ++k)
            if (const double height = normal.dot(vertices[k]); std::abs(height) > std::abs(result.second))
                result = {k, height};
        return result;
    }
};

} // namespace

template <int Dim>
std::optional<PolytopeNorm<Dim>> polytopeNorm(std::span<const AffineMap<Dim>> maps, double contractivity,
                                              double rounding, std::size_t maxWork) {
    if (!(contractivity > 0 && contractivity < 1)) return std::nullopt;
    Polytope<Dim> polytope;
    PolytopeNorm<Dim> result;
    double slowest = 0, reach = 1;
    for (std::size_t done = 0; done < polytope.vertices.size(); ++done)
        for (std::size_t i = 0; i < maps.size(); ++i) {
            const Vector<Dim> image = maps[i].linear * polytope.vertices[done] / contractivity;
            double norm = polytope.norm(image);
            if (polytope.work > maxWork || !std::isfinite(norm)) return std::nullopt;
            if (norm > isInside) { // new vertex, with all rounding errors that led to it
                if (polytope.vertices.size() == maxVertices || !(image.norm() < maxReach))
                    return std::nullopt;
                polytope.vertices.push_back(image);
                reach = std::max(reach, image.norm());
                norm = 1;
            }
            if (norm > slowest) {
                slowest = norm;
                result.slowest = int(i);
            }
        }
    double longest = 0;
    for (const auto& map : maps)
        longest = std::max(longest, map.linear.norm());
    result.equivalence = reach * std::sqrt(double(Dim)) * (1 + 1e-12);
    // Error of an image, of which the ball inside makes a share of the norm.
    const double error = rounding + 4 * Dim * roundingUnit * longest;
    result.contractivity = contractivity * slowest * (1 + 1e-15) + error * result.equivalence;
    if (!(result.contractivity < 1)) return std::nullopt;
    result.vertices = std::move(polytope.vertices);
    return result;
}

template std::optional<PolytopeNorm<2>> polytopeNorm<2>(std::span<const AffineMap<2>>, double, double,
                                                        std::size_t);
template std::optional<PolytopeNorm<3>> polytopeNorm<3>(std::span<const AffineMap<3>>, double, double,
                                                        std::size_t);

} // namespace ifs
