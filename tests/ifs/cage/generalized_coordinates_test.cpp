// SPDX-License-Identifier: MIT
#include "ifs/cage/generalized_coordinates.h"

#include "ifs/cage/mean_value_coordinates.h"
#include "ifs/canonical_systems.h"
#include "ifs/system/barycentric.h"
#include "support/named_test.h"

#include <QtTest>

#include <algorithm>

using namespace ifs;
using namespace canonical;

namespace {

using Polygon2 = std::vector<Vector<2>>;

const Polygon2 unitSquare{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const Polygon2 pentagon{{0, 0}, {2, 0}, {3, 1}, {2, 3}, {0, 2}};
const Polygon2 lShape{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

// Corners on a circle (convex) or at distances of their own (star-shaped), counter-clockwise.
Polygon2 randomPolygon(Random& random, std::size_t corners, bool convex) {
    for (;;) {
        std::vector<double> angles;
        for (std::size_t j = 0; j < corners; ++j)
            angles.push_back(uniform(random, 0, 2 * std::numbers::pi));
        std::ranges::sort(angles);
        Polygon2 polygon;
        double narrowest = angles.front() + 2 * std::numbers::pi - angles.back();
        double widest = narrowest;
        for (std::size_t j = 0; j < corners; ++j) {
            const double r = convex ? 2 : uniform(random, 1, 3);
            polygon.emplace_back(r * std::cos(angles[j]), r * std::sin(angles[j]));
            if (j == 0) continue;
            narrowest = std::min(narrowest, angles[j] - angles[j - 1]);
            widest = std::max(widest, angles[j] - angles[j - 1]);
        }
        if (narrowest > 0.02 && widest < 0.9 * std::numbers::pi) return polygon;
    }
}

Vector<2> combined(const std::vector<double>& weights, const Polygon2& points) {
    Vector<2> result = Vector<2>::Zero();
    for (std::size_t j = 0; j < points.size(); ++j)
        result += weights[j] * points[j];
    return result;
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
    double result = a.size() == b.size() ? 0 : 1;
    for (std::size_t j = 0; j < a.size() && j < b.size(); ++j)
        result = std::max(result, std::abs(a[j] - b[j]));
    return result;
}

Vector<2> insidePoint(Random& random, const Polygon2& polygon) { // of a convex one: a random average
    Vector<2> sum = Vector<2>::Zero();
    double total = 0;
    for (const auto& corner : polygon) {
        const double weight = uniform(random, 0.01, 1);
        sum += weight * corner;
        total += weight;
    }
    return sum / total;
}

void checkCoordinates(Coordinates kind, const Polygon2& polygon, const Vector<2>& x) {
    const auto lambda = generalizedCoordinates(kind, polygon, x);
    double sum = 0;
    double largest = 1;
    for (const double l : lambda) {
        sum += l;
        largest = std::max(largest, std::abs(l));
    }
    QVERIFY(std::abs(sum - 1) <= 1e-14 * largest);
    const double error = (combined(lambda, polygon) - x).norm();
    QVERIFY2(error <= 1e-13 * 6 * largest, qPrintable(QString::number(error)));
}

} // namespace

class GeneralizedCoordinatesTest : public QObject {
    Q_OBJECT

private slots:
    void knownValues() {
        using std::vector;
        const auto wachspress = [](const Polygon2& p, double x, double y) {
            return generalizedCoordinates(Coordinates::Wachspress, p, {x, y});
        };
        const auto meanValue = [](const Polygon2& p, double x, double y) {
            return generalizedCoordinates(Coordinates::MeanValue, p, {x, y});
        };
        QVERIFY(difference(wachspress(unitSquare, .25, .25), {9. / 16, 3. / 16, 1. / 16, 3. / 16}) <= 1e-15);
        QVERIFY(difference(meanValue(unitSquare, .25, .25), {0.572949016875158, 0.177050983124842,
                                                             0.072949016875158, 0.177050983124842}) <= 1e-14);
        QVERIFY(difference(wachspress(pentagon, 1, 1), {24. / 71, 12. / 71, 9. / 71, 10. / 71, 16. / 71}) <=
                1e-15);
        QVERIFY(
            difference(meanValue(pentagon, 1, 1), {0.297991128705569, 0.210711547841141, 0.108753239626176,
                                                   0.126158592719595, 0.256385491107519}) <= 1e-14);
        QVERIFY(difference(meanValue(lShape, .5, .5), {0.542705098312, 0.146352549156, 0.042705098312,
                                                       0.079179606750, 0.042705098312, 0.146352549156}) <=
                1e-12);
        QVERIFY(std::abs(meanValue(lShape, .5, 1.9)[2] + 0.001992808431164) <= 1e-14);
    }

    void trianglesGiveTheBarycentricCoordinates() {
        Random random(1);
        for (int n = 0; n < 500; ++n) {
            const Polygon2 polygon = randomPolygon(random, 3, true);
            const Vector<2> x = insidePoint(random, polygon);
            const Barycentric<2> expected = barycentric<2>({polygon[0], polygon[1], polygon[2]}, x);
            for (const auto kind : {Coordinates::Wachspress, Coordinates::MeanValue}) {
                const auto lambda = generalizedCoordinates(kind, polygon, x);
                for (std::size_t j = 0; j < 3; ++j)
                    QVERIFY(std::abs(lambda[j] - expected[int(j)]) <= 1e-12);
            }
        }
    }

    void properties() {
        Random random(2);
        for (int n = 0; n < 1000; ++n) {
            const std::size_t corners = 3 + random() % 22;
            const Polygon2 convex = randomPolygon(random, corners, true);
            const Polygon2 star = randomPolygon(random, corners, false);
            const Vector<2> x = insidePoint(random, convex);
            checkCoordinates(Coordinates::Wachspress, convex, x);
            checkCoordinates(Coordinates::MeanValue, convex, x);
            checkCoordinates(Coordinates::MeanValue, star, randomVector<2>(random, 4));
            for (const auto kind : {Coordinates::Wachspress, Coordinates::MeanValue})
                for (const double l : generalizedCoordinates(kind, convex, x))
                    QVERIFY(l >= -1e-15);
        }
    }

    void cornersAndEdges() {
        Random random(3);
        for (int n = 0; n < 300; ++n) {
            const std::size_t corners = 3 + random() % 22;
            const bool convex = n % 2 == 0;
            const Polygon2 polygon = randomPolygon(random, corners, convex);
            const std::size_t j = random() % corners;
            const std::size_t next = (j + 1) % corners;
            const double share = uniform(random, 0.05, 0.95);
            const Vector<2> edge = polygon[next] - polygon[j];
            const Vector<2> inward = Vector<2>(-edge.y(), edge.x()) / edge.norm();
            for (const auto kind : {Coordinates::MeanValue, Coordinates::Wachspress}) {
                if (kind == Coordinates::Wachspress && !convex) continue;
                std::vector<double> unit(corners, 0.0);
                unit[j] = 1;
                QVERIFY(difference(generalizedCoordinates(kind, polygon, polygon[j]), unit) <= 1e-12);
                std::vector<double> linear(corners, 0.0);
                linear[j] = 1 - share;
                linear[next] = share;
                const Vector<2> onEdge = polygon[j] + share * edge;
                QVERIFY(difference(generalizedCoordinates(kind, polygon, onEdge), linear) <= 1e-12);
                for (const double distance : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 1e-300}) {
                    checkCoordinates(kind, polygon, onEdge + distance * inward);
                    if (kind == Coordinates::MeanValue)
                        checkCoordinates(kind, polygon, onEdge - distance * inward);
                }
                // Continuous across the edge.
                const auto here = generalizedCoordinates(kind, polygon, onEdge + 1e-10 * inward);
                const auto there = generalizedCoordinates(kind, polygon, onEdge - 1e-10 * inward);
                QVERIFY(difference(here, there) <= 1e-5);
            }
        }
    }

    void invariance() {
        Random random(4);
        double changed = 0;
        for (int n = 0; n < 300; ++n) {
            const Polygon2 polygon = randomPolygon(random, 4 + random() % 8, true);
            const Vector<2> x = insidePoint(random, polygon);
            const AffineMap<2> turn = similarity(uniform(random, 0.1, 9), uniform(random, 0, 6), 3, -2);
            const AffineMap<2> shear = affineMap(1, 1.5, 0.2, 1, -1, 4);
            const auto image = [&](const AffineMap<2>& map) {
                Polygon2 result;
                for (const auto& corner : polygon)
                    result.push_back(map(corner));
                return result;
            };
            for (const auto kind : {Coordinates::Wachspress, Coordinates::MeanValue})
                QVERIFY(difference(generalizedCoordinates(kind, image(turn), turn(x)),
                                   generalizedCoordinates(kind, polygon, x)) <= 1e-12);
            const auto sheared = [&](Coordinates kind) {
                return difference(generalizedCoordinates(kind, image(shear), shear(x)),
                                  generalizedCoordinates(kind, polygon, x));
            };
            QVERIFY(sheared(Coordinates::Wachspress) <= 1e-12);
            changed = std::max(changed, sheared(Coordinates::MeanValue));
        }
        QVERIFY(changed > 1e-3); // mean value coordinates are not affine-invariant
    }

    void neverNaN() {
        const double huge = 1e150;
        const std::vector<Polygon2> polygons{unitSquare,
                                             lShape,
                                             {{0, 0}, {1, 0}, {2, 0}, {3, 0}},
                                             {{1, 1}, {1, 1}, {1, 1}, {1, 1}},
                                             {{0, 0}, {1, 1}, {1, 0}, {0, 1}},
                                             {{0, 0}, {1, 0}, {1, 0}, {0, 1}},
                                             {{0, 0}, {huge, 0}, {huge, huge}, {0, huge}},
                                             {{0, 0}, {1e-160, 0}, {1e-160, 1e-160}, {0, 1e-160}}};
        Random random(5);
        for (const Polygon2& polygon : polygons)
            for (const auto kind : {Coordinates::Wachspress, Coordinates::MeanValue}) {
                Polygon2 moved = polygon;
                moved[0] += Vector<2>(0.3, -0.2);
                const PolygonDeformation deformation(kind, polygon, moved);
                std::vector<Vector<2>> points{{0.5, 0}, {1e9, -1e9}, {2, 0}, {1e100, 0}};
                points.insert(points.end(), polygon.begin(), polygon.end());
                for (int n = 0; n < 50; ++n)
                    points.push_back(randomVector<2>(random, 3));
                for (const Vector<2>& x : points) {
                    for (const double l : generalizedCoordinates(kind, polygon, x))
                        QVERIFY(std::isfinite(l));
                    QVERIFY(deformation(x).allFinite());
                    if (const auto expansion = deformation.expansion(x))
                        QVERIFY(expansion->value.allFinite() && expansion->linear.allFinite());
                }
            }
    }

    void polygonsAreTold() {
        QVERIFY(isSimplePolygon(unitSquare) && isStrictlyConvex(unitSquare));
        QVERIFY(isSimplePolygon(lShape) && !isStrictlyConvex(lShape));
        QVERIFY(!isSimplePolygon(Polygon2{{0, 0}, {1, 1}, {1, 0}, {0, 1}}));         // crosses itself
        QVERIFY(!isSimplePolygon(Polygon2{{0, 0}, {2, 0}, {1, 0}, {1, 1}}));         // folds back
        QVERIFY(!isSimplePolygon(Polygon2{{0, 0}, {2, 0}, {2, 1}, {1, 0}, {0, 1}})); // touches an edge
        QVERIFY(!isSimplePolygon(Polygon2{{0, 0}, {1, 0}}));
        const Polygon2 withStraightCorner{{0, 0}, {1, 0}, {2, 0}, {1, 2}};
        QVERIFY(isSimplePolygon(withStraightCorner) && !isStrictlyConvex(withStraightCorner));
        Polygon2 clockwise(unitSquare.rbegin(), unitSquare.rend());
        QVERIFY(isStrictlyConvex(clockwise));
        QCOMPARE(signedArea(clockwise), -1.0);
    }

    void derivativesAreThoseOfTheDeformation() {
        Random random(6);
        for (int n = 0; n < 300; ++n) {
            const Polygon2 from = randomPolygon(random, 3 + random() % 10, true);
            Polygon2 to = from;
            for (auto& corner : to)
                corner += randomVector<2>(random, 0.5);
            const Vector<2> x = insidePoint(random, from);
            for (const auto kind : {Coordinates::Wachspress, Coordinates::MeanValue}) {
                const PolygonDeformation f(kind, from, to);
                const auto e = f.expansion(x);
                QVERIFY(e.has_value());
                QVERIFY((e->value - f(x)).norm() <= 1e-13);
                QVERIFY((f(x) - combined(generalizedCoordinates(kind, from, x), to)).norm() <= 1e-12);
                // Each order against differences of the one before it.
                constexpr double h = 1e-5;
                const auto right = f.expansion(x + Vector<2>(h, 0));
                const auto left = f.expansion(x - Vector<2>(h, 0));
                const auto above = f.expansion(x + Vector<2>(0, h));
                const auto below = f.expansion(x - Vector<2>(0, h));
                double scale = 1;
                for (const auto& v : e->third)
                    scale += v.norm();
                const auto agree = [&](const Vector<2>& low, const Vector<2>& high, const Vector<2>& slope) {
                    const double error = ((high - low) / (2 * h) - slope).norm();
                    QVERIFY2(error <= 1e-5 * scale * scale, qPrintable(QString::number(error / scale)));
                };
                agree(left->value, right->value, e->linear.col(0));
                agree(below->value, above->value, e->linear.col(1));
                agree(left->linear.col(0), right->linear.col(0), e->second[0]);
                agree(left->linear.col(1), right->linear.col(1), e->second[1]);
                agree(below->linear.col(1), above->linear.col(1), e->second[2]);
                for (std::size_t k = 0; k < 3; ++k) {
                    agree(left->second[k], right->second[k], e->third[k]);
                    agree(below->second[k], above->second[k], e->third[k + 1]);
                }
            }
        }
    }

    void affineImagesAreReachedExactly() {
        Random random(7);
        for (int n = 0; n < 300; ++n) {
            const Polygon2 from = randomPolygon(random, 4 + random() % 8, false);
            const AffineMap<2> map{randomWellConditioned<2>(random), randomVector<2>(random, 5)};
            Polygon2 to;
            for (const auto& corner : from)
                to.push_back(map(corner));
            const AffineMap<2> fit = affineFit<2>(from, to);
            QVERIFY((fit.linear - map.linear).norm() <= 1e-12);
            QVERIFY((fit.translation - map.translation).norm() <= 1e-12);
            const PolygonDeformation f(Coordinates::MeanValue, from, to);
            const Vector<2> x = randomVector<2>(random, 4);
            QVERIFY((f(x) - map(x)).norm() <= 1e-11);
        }
    }

    void leastSquares() {
        Polygon2 to = unitSquare;
        to[2] = {2, 2};
        const AffineMap<2> fit = affineFit<2>(unitSquare, to);
        QVERIFY((fit.linear - affineMap(1.5, .5, .5, 1.5, 0, 0).linear).norm() <= 1e-12);
        QVERIFY((fit.translation - Vector<2>(-.25, -.25)).norm() <= 1e-12);
        // The normal equations, and three points are reached exactly.
        Random random(8);
        for (int n = 0; n < 200; ++n) {
            const Polygon2 from = randomPolygon(random, 3 + random() % 9, false);
            Polygon2 target;
            for (std::size_t j = 0; j < from.size(); ++j)
                target.push_back(randomVector<2>(random, 3));
            const AffineMap<2> map = affineFit<2>(from, target);
            Vector<2> sum = Vector<2>::Zero();
            Matrix<2> moments = Matrix<2>::Zero();
            for (std::size_t j = 0; j < from.size(); ++j) {
                const Vector<2> residual = target[j] - map(from[j]);
                sum += residual;
                moments += residual * from[j].transpose();
                if (from.size() == 3) QVERIFY(residual.norm() <= 1e-11);
            }
            QVERIFY(sum.norm() <= 1e-11 && moments.norm() <= 1e-10);
        }
        // On one line, nothing is known across it: what was before stays.
        const Polygon2 line{{0, 0}, {1, 0}, {2, 0}, {3, 0}};
        const Polygon2 stretched{{0, 1}, {2, 1}, {4, 1}, {6, 1}};
        const AffineMap<2> kept = affineFit<2>(line, stretched, affineMap(1, 0, 0, 7, 0, 0).linear);
        QVERIFY((kept.linear - affineMap(2, 0, 0, 7, 0, 0).linear).norm() <= 1e-12);
        std::vector<Vector<3>> tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        std::vector<Vector<3>> image{{1, 1, 1}, {3, 1, 1}, {1, 4, 1}, {1, 1, 5}};
        const AffineMap<3> space = affineFit<3>(tetrahedron, image);
        QVERIFY((space.linear - Matrix<3>(Vector<3>(2, 3, 4).asDiagonal())).norm() <= 1e-12);
    }

    void meanValueInSpace() {
        const std::vector<Vector<3>> octahedron{{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                                {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
        const std::vector<std::array<int, 3>> faces{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
        QVERIFY(difference(meanValueCoordinates(octahedron, faces, {.1, .2, .3}),
                           {0.186524520073729, 0.086524520073729, 0.263924386724053, 0.063924386724052,
                            0.349551093202218, 0.049551093202219}) <= 1e-12);
        QVERIFY(difference(meanValueCoordinates(octahedron, faces, Vector<3>::Zero()),
                           std::vector<double>(6, 1. / 6)) <= 1e-15);
        const std::vector<Vector<3>> tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        const std::vector<std::array<int, 3>> sides{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
        QVERIFY(difference(meanValueCoordinates(tetrahedron, sides, {.2, .3, .1}), {.4, .2, .3, .1}) <=
                1e-14);
        Random random(9);
        for (int n = 0; n < 500; ++n) { // linear precision: anywhere, and very near a face
            const Vector<3> near = Vector<3>(.2, .3, .5) + Vector<3>::Constant(std::pow(10, -n % 15));
            for (const Vector<3>& x : {randomVector<3>(random, 1.5), near}) {
                const auto lambda = meanValueCoordinates(octahedron, faces, x);
                Vector<3> point = Vector<3>::Zero();
                for (std::size_t j = 0; j < 6; ++j)
                    point += lambda[j] * octahedron[j];
                QVERIFY((point - x).norm() <= 1e-12);
            }
        }
        QVERIFY(difference(meanValueCoordinates(octahedron, faces, {.2, .3, .5}), {.2, 0, .3, 0, .5, 0}) <=
                1e-12);
        QVERIFY(difference(meanValueCoordinates(octahedron, faces, {0, 0, 1}), {0, 0, 0, 0, 1, 0}) == 0);
    }
};

BARYCAGE_TEST(GeneralizedCoordinatesTest);
#include "generalized_coordinates_test.moc"
