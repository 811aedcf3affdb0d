// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/extent/convex_hull.h"
#include "ifs/extent/convex_hull_3d.h"
#include "ifs/extent/extent.h"
#include "ifs/extent/polygon.h"
#include "ifs/separation/piece_contacts.h"
#include "ifs/system/barycentric.h"
#include "support/named_test.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>

#include <QtTest>

using namespace ifs;
using namespace canonical;

namespace {

using Long = long double;
template <int Dim> using LongVector = Eigen::Matrix<Long, Dim, 1>;
template <int Dim> using LongMatrix = Eigen::Matrix<Long, Dim, Dim>;

template <int Dim> struct LongMap {
    LongMatrix<Dim> linear = LongMatrix<Dim>::Identity();
    LongVector<Dim> translation = LongVector<Dim>::Zero();
    LongVector<Dim> operator()(const LongVector<Dim>& x) const { return linear * x + translation; }
};

// Fixed points of all short words and an orbit, by other means than the code under test.
template <int Dim>
std::vector<LongVector<Dim>> pointsOfAttractor(const std::vector<AffineMap<Dim>>& maps, Random& random) {
    constexpr std::size_t maxWords = 1'000, samples = 3'000;
    std::vector<LongMap<Dim>> exact;
    for (const auto& map : maps)
        exact.push_back({map.linear.template cast<Long>(), map.translation.template cast<Long>()});
    std::vector<LongVector<Dim>> points;
    const auto addFixed = [&](const LongMap<Dim>& word) {
        const LongMatrix<Dim> rest = LongMatrix<Dim>::Identity() - word.linear;
        points.push_back(rest.fullPivLu().solve(word.translation));
    };
    std::vector<LongMap<Dim>> words(1);
    for (std::size_t first = 0; words.size() < maxWords; ++first)
        for (const auto& map : exact) {
            words.push_back({words[first].linear * map.linear, words[first](map.translation)});
            addFixed(words.back());
        }
    LongVector<Dim> x = points.front();
    for (std::size_t n = 0; n < samples; ++n)
        points.push_back(x = exact[random() % exact.size()](x));
    return points;
}

template <int Dim> Matrix<Dim> rotation(Random& random) {
    return Eigen::HouseholderQR<Matrix<Dim>>(randomMatrix<Dim>(random)).householderQ();
}

// Contractions seen through a shear, so that single maps and their products stretch a great deal.
template <int Dim> std::vector<AffineMap<Dim>> sheared(Random& random, double shear, double strongest) {
    Matrix<Dim> basis = Matrix<Dim>::Identity();
    basis(0, 1) = shear;
    if constexpr (Dim == 3) {
        basis(0, 2) = uniform(random, -shear, shear);
        basis(1, 2) = uniform(random, -1, 1);
    }
    basis = rotation<Dim>(random) * basis;
    const Matrix<Dim> back = basis.inverse();
    std::vector<AffineMap<Dim>> maps;
    for (std::size_t i = 0, count = 2 + random() % 3; i < count; ++i) {
        Matrix<Dim> contraction = randomMatrix<Dim>(random);
        contraction *= uniform(random, 0.2, strongest) / spectralNorm<Dim>(contraction);
        maps.push_back({basis * contraction * back, randomVector<Dim>(random, 5)});
    }
    return maps;
}

// Upper triangular maps that stretch, seen from a random side. They come as near to their diagonals as one
// likes in coordinates that stretch more and more.
template <int Dim> std::vector<AffineMap<Dim>> triangular(Random& random, double shear) {
    const Matrix<Dim> turn = rotation<Dim>(random);
    std::vector<AffineMap<Dim>> maps;
    for (std::size_t i = 0, count = 2 + random() % 2; i < count; ++i) {
        Matrix<Dim> linear = Matrix<Dim>::Zero();
        for (int row = 0; row < Dim; ++row) {
            linear(row, row) = uniform(random, -0.8, 0.8);
            for (int column = row + 1; column < Dim; ++column)
                linear(row, column) = uniform(random, -shear, shear);
        }
        maps.push_back({turn * linear * turn.transpose(), randomVector<Dim>(random, 5)});
    }
    return maps;
}

template <int Dim>
QString enclosureFault(const std::vector<AffineMap<Dim>>& maps, double maxError, Random& random,
                       double checkRounding = 0) {
    const auto support = SupportFunction<Dim>::of(maps);
    if (!support) return QStringLiteral("no support function");
    const auto box = boundingBox(*support);
    const double size = (box.max - box.min).norm();
    if (!(box.error <= maxError * size)) return QStringLiteral("box error %1 of %2").arg(box.error).arg(size);
    const auto simplex = minimalCanonicalSimplex(*support);
    if (!(simplex.error <= 10 * maxError * size))
        return QStringLiteral("simplex error %1 of %2").arg(simplex.error).arg(size);
    const double tolerance = (Dim == 2 ? 1e-5 : 1e-3) * size, most = Dim == 2 ? tolerance : 1e-2 * size;
    const auto hull = convexHull(*support, tolerance);
    if (!(hull.error <= most)) return QStringLiteral("hull error %1 of %2").arg(hull.error).arg(size);
    const double unsure = checkRounding * size, reach = support->radius() * (1 + 1e-12) + unsure;
    for (const auto& exact : pointsOfAttractor<Dim>(maps, random)) {
        const Vector<Dim> x = exact.template cast<double>();
        const double outside = std::max((box.min - x).maxCoeff(), (x - box.max).maxCoeff());
        if (!(outside <= box.error + unsure))
            return QStringLiteral("%1 outside the box of size %2").arg(outside).arg(size);
        if (!((x - support->centre()).norm() <= reach)) return QStringLiteral("outside the ball");
        if (!(barycentric<Dim>(simplex.vertices, x).minCoeff() * simplex.leg >= -simplex.error - unsure))
            return QStringLiteral("outside the simplex");
        if constexpr (Dim == 2)
            if (const double far = distanceToConvex(hull.vertices, x); !(far <= hull.error + unsure))
                return QStringLiteral("%1 outside the hull of size %2").arg(far).arg(size);
        if constexpr (Dim == 3)
            for (const auto& facet : hull.facets) {
                const auto corner = [&](std::size_t k) { return hull.vertices[std::size_t(facet[k])]; };
                const Vector<3> normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
                if (normal.norm() > 1e-9 * size * size &&
                    !(normal.normalized().dot(x - corner(0)) <= hull.error + unsure))
                    return QStringLiteral("outside the hull");
            }
    }
    return {};
}

template <int Dim> void randomShears(double shear) {
    Random random(std::uint64_t(100 * Dim + shear));
    const double checkRounding = 1e-16 * std::pow(shear, 4); // of long doubles, times the condition squared
    for (int n = 0; n < 20; ++n) {
        const auto maps = sheared<Dim>(random, shear, n < 15 ? 0.8 : 0.95);
        const QString fault = enclosureFault<Dim>(maps, 1e-6, random, checkRounding);
        QVERIFY2(fault.isEmpty(), qPrintable(QStringLiteral("system %1: %2").arg(n).arg(fault)));
    }
}

template <int Dim> void triangularSystems(double shear) {
    Random random(std::uint64_t(1000 * Dim + shear));
    const double checkRounding = 1e-17 * std::pow(shear + 1, 2 * (Dim - 1));
    for (int n = 0; n < 20; ++n) {
        const auto maps = triangular<Dim>(random, shear);
        const QString fault = enclosureFault<Dim>(maps, 1e-6, random, checkRounding);
        QVERIFY2(fault.isEmpty(), qPrintable(QStringLiteral("system %1: %2").arg(n).arg(fault)));
    }
}

void addShears() {
    QTest::addColumn<double>("shear");
    for (const double shear : {1.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0})
        QTest::addRow("%g", shear) << shear;
}

} // namespace

// Attractors of maps that are far from normal, whose extents a table in the coordinates of the maps misses.
class ShearedExtentTest : public QObject {
    Q_OBJECT

private slots:
    void aShearInThePlane() {
        const Maps2 maps{affineMap(3.2, -102, .1, -3.2, 91, 3), affineMap(-3.2, 84.7, -.1, 2.6, -89, -3)};
        Random random(1);
        QCOMPARE(enclosureFault<2>(maps, 1e-9, random), QString());
        const auto box = boundingBox(supportOf2(maps));
        QVERIFY(box.min.x() < -143.755 && box.max.x() > 132.328);
    }
    void aShearInSpace() {
        Matrix<3> first, second;
        first << .6, -2.3, 5.9, .9, -2.4, 5.8, .2, -.5, 1.1;
        second << -1, 2.2, -5.1, -.3, 1.7, -5.2, 0, .4, -1.4;
        Random random(2);
        QCOMPARE(enclosureFault<3>({map3(first, {0, 7, 2}), map3(second, {-9, -2, 0})}, 1e-9, random),
                 QString());
    }

    void inThePlane_data() { addShears(); }
    void inThePlane() {
        QFETCH(double, shear);
        randomShears<2>(shear);
    }
    void inSpace_data() { addShears(); }
    void inSpace() {
        QFETCH(double, shear);
        randomShears<3>(shear);
    }

    void triangularMaps() {
        const Maps2 maps{affineMap(.4, 1, 0, .1, 1, -2), affineMap(-.4, 2, 0, .8, 3, 0)};
        Random random(3);
        QCOMPARE(enclosureFault<2>(maps, 1e-9, random), QString());
        const PieceContacts contacts = pieceContacts(supportOf2(maps));
        QCOMPARE(contacts.separation, Separation::Strong);
        QVERIFY(contacts.overlaps.empty());
    }
    void triangularInThePlane_data() { addShears(); }
    void triangularInThePlane() {
        QFETCH(double, shear);
        triangularSystems<2>(shear);
    }
    void triangularInSpace_data() { addShears(); }
    void triangularInSpace() {
        QFETCH(double, shear);
        triangularSystems<3>(shear);
    }

private:
    static SupportFunction<2> supportOf2(const Maps2& maps) { return *SupportFunction<2>::of(maps); }
};

BARYCAGE_TEST(ShearedExtentTest);
#include "sheared_extent_test.moc"
