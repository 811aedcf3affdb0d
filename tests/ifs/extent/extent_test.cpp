// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/extent/convex_hull.h"
#include "ifs/extent/extent.h"
#include "support/named_test.h"
#include "support/near.h"

#include <QtTest>

using namespace ifs;
using namespace canonical;

namespace {

using support::near;
template <int Dim> SupportFunction<Dim> supportOf(const std::vector<AffineMap<Dim>>& maps) {
    return *SupportFunction<Dim>::of(maps);
}

struct Expected {
    Orientation<2> orientation;
    double leg;
    Vector<2> corner;
};

void compare(const Maps2& maps, std::initializer_list<Expected> all, std::size_t minimal) {
    const auto support = supportOf<2>(maps);
    const auto smallest = minimalCanonicalSimplex(support);
    for (const Expected& expected : all) {
        const auto simplex = canonicalSimplex(support, expected.orientation);
        QVERIFY(near(simplex.leg, expected.leg, 1e-13 * 10));
        QVERIFY((simplex.vertices[0] - expected.corner).norm() <= 5e-14);
        for (int k = 0; k < 2; ++k) {
            const Vector<2> leg = simplex.vertices[std::size_t(k) + 1] - simplex.vertices[0];
            QVERIFY((leg - simplex.leg * expected.orientation[std::size_t(k)] * Vector<2>::Unit(k)).norm() <
                    1e-14 * 20);
        }
        QVERIFY(simplex.error < 1e-10);
        QVERIFY(smallest.leg <= simplex.leg * (1 + 1e-12));
    }
    QCOMPARE(smallest.orientation, all.begin()[minimal].orientation);
    QVERIFY(near(smallest.leg, all.begin()[minimal].leg, 1e-12));
}

// The attractor is inside box and simplices, and touches every face.
template <int Dim> void tightAroundOrbit(const std::vector<AffineMap<Dim>>& maps, Random& random) {
    const auto support = supportOf<Dim>(maps);
    const auto box = boundingBox(support);
    const auto minimal = minimalCanonicalSimplex(support);
    const double size = support.centre().norm() + support.radius();
    QVERIFY(box.error <= 1e-10 * size && minimal.error <= 1e-10 * size);
    for (const auto& x : orbit<Dim>(maps, 200, random)) {
        QVERIFY(((x - box.min).array() >= -box.error).all());
        QVERIFY(((box.max - x).array() >= -box.error).all());
        const Barycentric<Dim> lambda = barycentric<Dim>(minimal.vertices, x);
        if (minimal.leg > 1e-6 * size) QVERIFY(lambda.minCoeff() * minimal.leg >= -minimal.error);
    }
    const auto touch = [&](const Vector<Dim>& u, double face) {
        return near(support(u).value, face, 1e-11 * size);
    };
    Vector<Dim> omega;
    for (int k = 0; k < Dim; ++k) {
        QVERIFY(touch(Vector<Dim>::Unit(k), box.max[k]));
        QVERIFY(touch(-Vector<Dim>::Unit(k), -box.min[k]));
        omega[k] = minimal.orientation[std::size_t(k)];
        QVERIFY(touch(-omega[k] * Vector<Dim>::Unit(k), -omega[k] * minimal.vertices[0][k]));
    }
    QVERIFY(touch(omega, omega.dot(minimal.vertices[1])));
}

template <int Dim> void randomSystems(int count) {
    Random random(Dim + 5);
    for (int n = 0; n < count; ++n)
        tightAroundOrbit<Dim>(randomContractions<Dim>(random, 2 + int(random() % 4)), random);
}

} // namespace

class ExtentTest : public QObject {
    Q_OBJECT

private slots:
    // Two legs of a mirrored attractor are equal, whatever is known of them.
    void everyToleranceChoosesTheSameSimplex() {
        const Maps2 coral{
            affineMap(0, 0, 0, 0.3544864656725691, 0, 0),
            affineMap(0.598163139444189, -0.2789280527488616, 0.2789280527488616, 0.598163139444189, 0, 1),
            affineMap(0.598163139444189, 0.2789280527488616, -0.2789280527488616, 0.598163139444189, 0, 1),
            affineMap(0.10260604299770064, -0.2819077862357725, 0.2819077862357725, 0.10260604299770064, 0,
                      0.55),
            affineMap(0.10260604299770064, 0.2819077862357725, -0.2819077862357725, 0.10260604299770064, 0,
                      0.55)};
        const auto support = supportOf<2>(coral);
        const auto exact = minimalCanonicalSimplex(support).orientation;
        for (double tolerance = 1e-12; tolerance < 1e-3; tolerance *= 3)
            QCOMPARE(minimalCanonicalSimplex(support, tolerance).orientation, exact);
    }

    void mapleSimplices() {
        compare(maple(),
                {{{1, 1}, 12.562310339608054, {-3.30009395647353, -3.17305096113017}},
                 {{-1, 1}, 12.625291176633127, {3.34421444954056, -3.17305096113017}},
                 {{1, -1}, 11.851392810187051, {-3.30009395647353, 5.07246376811594}},
                 {{-1, -1}, 11.704657475156326, {3.34421444954056, 5.07246376811594}}},
                3);
    }
    void flowerSimplices() {
        compare(flower(),
                {{{1, 1}, 5.400600294561484, {-2.24031644660197, 2.11397256199447}},
                 {{-1, 1}, 5.477199850609201, {2.30114102748516, 2.11397256199447}},
                 {{1, -1}, 6.135763610785167, {-2.24031644660197, 3.92730978512465}},
                 {{-1, -1}, 6.069849359318270, {2.30114102748516, 3.92730978512465}}},
                0);
    }
    void fernSimplices() {
        compare(fern(),
                {{{1, 1}, 14.799833782015830, {-2.18192115030976, 0}},
                 {{-1, 1}, 10.793878466453615, {2.65578322708985, 0}},
                 {{1, -1}, 12.797502539872340, {-2.18192115030976, 9.99826503661828}},
                 {{-1, -1}, 12.654048263708133, {2.65578322708985, 9.99826503661828}}},
                1);
    }
    void tiesGoToTheFirstOrientation() {
        compare(sierpinskiRight(), {{{1, 1}, 1, {0, 0}}}, 0);
        compare(sierpinskiEquilateral(),
                {{{1, 1}, (1 + std::sqrt(3)) / 2, {0, 0}}, {{-1, 1}, (1 + std::sqrt(3)) / 2, {1, 0}}}, 0);
        compare(square(),
                {{{1, 1}, 2, {0, 0}}, {{-1, 1}, 2, {1, 0}}, {{1, -1}, 2, {0, 1}}, {{-1, -1}, 2, {1, 1}}}, 0);
    }
    void eachOrientationCanBeMinimal() {
        for (const Orientation<2>& orientation : {Orientation<2>{1, 1}, {-1, 1}, {1, -1}, {-1, -1}}) {
            Maps2 maps = sierpinskiRight();
            const AffineMap<2> mirror = affineMap(orientation[0], 0, 0, orientation[1], 0, 0);
            for (auto& map : maps)
                map = *conjugate(mirror, map);
            compare(maps, {{orientation, 1, {0, 0}}}, 0);
        }
    }
    void simplicesInSpace() {
        const auto tetra = minimalCanonicalSimplex(supportOf<3>(tetrahedron()));
        QVERIFY(near(tetra.leg, 1, 1e-14) && tetra.orientation == (Orientation<3>{1, 1, 1}));
        const auto cubic = minimalCanonicalSimplex(supportOf<3>(cube()));
        QVERIFY(near(cubic.leg, 3, 1e-14) && cubic.orientation == (Orientation<3>{1, 1, 1}));

        const auto support = supportOf<3>(fern3());
        for (const int x : {1, -1}) {
            QVERIFY(near(canonicalSimplex<3>(support, {x, 1, 1}).leg, 11.82496211315, 1e-11));
            QVERIFY(near(canonicalSimplex<3>(support, {x, 1, -1}).leg, 14.26677051774, 1e-11));
            QVERIFY(near(canonicalSimplex<3>(support, {x, -1, 1}).leg, 14.61992685383, 1e-11));
        }
        const auto minimal = minimalCanonicalSimplex(support);
        QCOMPARE(minimal.orientation, (Orientation<3>{1, -1, -1}));
        QVERIFY(near(std::pow(minimal.leg, 3) / 6, 183.5457949798, 1e-9));
        const auto box = boundingBox(support);
        QVERIFY((box.max - Vector<3>(1.623248571865150, 7.997725100771707, 0)).norm() < 1e-13);
        QVERIFY((box.min - Vector<3>(-1.623248571865150, 0, -4.998953181197701)).norm() < 1e-13);
    }

    // Facts of the corpus's certified boxes.
    void boxes() {
        const auto fernBox = boundingBox(supportOf<2>(fern()));
        QVERIFY((fernBox.min - Vector<2>(-2.18192115030976, 0)).norm() < 1e-13);
        QVERIFY((fernBox.max - Vector<2>(2.65578322708985, 9.99826503661828)).norm() < 1e-13);
        const Maps2 fractintTriangle = halves({{0, 0}, {0, 1}, {1, 1}});
        const auto box = boundingBox(supportOf<2>(fractintTriangle));
        QVERIFY(box.min.norm() < 1e-14 && (box.max - Vector<2>(2, 2)).norm() < 1e-14);
    }

    void aPointHasUnitLegs() {
        const Maps2 maps{affineMap(.5, .1, 0, .3, 1, 2)};
        const Vector<2> point = *fixedPoint(maps[0]);
        const auto simplex = minimalCanonicalSimplex(supportOf<2>(maps));
        QCOMPARE(simplex.leg, 1.0);
        QVERIFY((simplex.vertices[0] - point).norm() < 1e-14);
        QVERIFY(isAffineBasis<2>(simplex.vertices));
        const auto box = boundingBox(supportOf<2>(maps));
        QVERIFY((box.max - point).norm() < 1e-14 && (box.min - point).norm() < 1e-14);
    }

    // Contractive by a hair, and not at all in the Euclidean norm: still tight.
    void aSlowContractionIsTight() {
        const Maps2 maps{affineMap(.2829, .0423, .9483, -.1686, 1.6766, -.0541),
                         affineMap(-.2755, .1632, -.8314, .1676, .2849, -.7903),
                         affineMap(.9501, .2355, -.0029, .2693, -.1145, -1.4914),
                         affineMap(-.9764, .2739, .1157, .6737, -.1021, -.6795)};
        const auto support = supportOf<2>(maps);
        const auto box = boundingBox(support);
        const double size = (box.max - box.min).norm();
        QVERIFY2(box.error < 1e-9 * size, qPrintable(QString::number(box.error / size)));
        for (const auto& simplex : canonicalSimplices(support)) {
            QVERIFY(simplex.leg >= (box.max - box.min).maxCoeff() - 1e-9 * size);
            QVERIFY(simplex.error < 1e-8 * size);
        }
        QVERIFY(convexHull(support, 1e-6 * size).error <= 1e-6 * size);
    }

    void mirroringMirrorsTheBox() {
        Random random(3);
        for (int n = 0; n < 200; ++n) {
            Maps2 maps = randomContractions<2>(random, 3), mirrored = maps;
            for (auto& map : mirrored)
                map = *conjugate(affineMap(1, 0, 0, -1, 0, 0), map);
            const auto box = boundingBox(supportOf<2>(maps)), other = boundingBox(supportOf<2>(mirrored));
            QVERIFY(near(box.min.y(), -other.max.y(), 1e-13 * 50) &&
                    near(box.max.y(), -other.min.y(), 1e-13 * 50));
            QVERIFY(near(box.min.x(), other.min.x(), 1e-13 * 50) &&
                    near(box.max.x(), other.max.x(), 1e-13 * 50));
        }
    }

    void relabellingChangesNothing() {
        Random random(4);
        for (int n = 0; n < 200; ++n) {
            Maps2 maps = randomContractions<2>(random, 4), relabelled = maps;
            std::rotate(relabelled.begin(), relabelled.begin() + 1, relabelled.end());
            const auto simplex = minimalCanonicalSimplex(supportOf<2>(maps));
            const auto other = minimalCanonicalSimplex(supportOf<2>(relabelled));
            QVERIFY(near(simplex.leg, other.leg, simplex.error + other.error));
        }
    }

    void randomPlaneSystems() { randomSystems<2>(1000); }
    void randomSpaceSystems() { randomSystems<3>(200); }
    void eventuallyContractiveSystem() {
        Random random(6);
        tightAroundOrbit<2>(eventual(), random);
    }
};

BARYCAGE_TEST(ExtentTest);
#include "extent_test.moc"
