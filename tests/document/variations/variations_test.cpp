// SPDX-License-Identifier: MIT
#include "document/variations/variations.h"

#include "document/edits/dimension_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "support/named_test.h"

#include <QTest>

#include <algorithm>
#include <numeric>

using document::Mutation;

class VariationsTest : public QObject {
    Q_OBJECT

private slots:
    void variationsFillTheirView_data();
    void variationsFillTheirView();
    void sameSeedSameSystem();
    void strengthIsDistance();
    void onlyTheSystemChanges();
    void onlyWhatMayChangeChanges();
    void coloursDecideNothingElse();
    void weightsFollowTheMaps();
    void lockedMapsStay();
    void symmetryStays();
    void whatHasNoAttractorGetsOne();
    void thinFractalsHaveVariations();
    void nothingToVary();
};

namespace {

document::Fractal tetrahedron() {
    document::Fractal fractal;
    document::System3 system;
    for (int corner = 0; corner < 4; ++corner) {
        ifs::AffineMap<3> map{ifs::Matrix<3>::Identity() / 2, ifs::Vector<3>::Zero()};
        if (corner > 0) map.translation[corner - 1] = 0.5;
        ifs::append(system, map, 0.25);
    }
    fractal.shape = document::Shape<3>{system};
    return fractal;
}

template <int Dim>
double distance(const ifs::IteratedFunctionSystem<Dim>& a, const ifs::IteratedFunctionSystem<Dim>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < std::min(a.maps.size(), b.maps.size()); ++i)
        sum += (a.maps[i].map.linear - b.maps[i].map.linear).norm() +
               (a.maps[i].map.translation - b.maps[i].map.translation).norm();
    return sum;
}

const document::System2& varied(const document::Fractal& fractal) {
    return *document::system2(fractal);
}

document::Fractal varied(const document::Fractal& fractal, double strength, std::uint64_t seed) {
    return document::variation(fractal, {strength}, seed);
}

Mutation mutation(double strength, const document::MayChange& may) {
    return {strength, may};
}

double sumOfWeights(const document::System2& system) {
    return std::accumulate(system.maps.begin(), system.maps.end(), 0.0,
                           [](double sum, const auto& map) { return sum + map.weight.value_or(0); });
}

} // namespace

void VariationsTest::variationsFillTheirView_data() {
    QTest::addColumn<bool>("inSpace");
    QTest::newRow("plane") << false;
    QTest::newRow("space") << true;
}

void VariationsTest::variationsFillTheirView() {
    QFETCH(bool, inSpace);
    const document::Fractal fractal = inSpace ? tetrahedron() : document::sierpinskiTriangle();
    const document::Filling own = document::filling(fractal);
    const document::Filling wanted{std::min(0.12, 0.7 * own.share), std::min(0.25, 0.7 * own.aspect)};
    for (const double strength : {0.1, 0.5, 1.0})
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            const document::Fractal child = varied(fractal, strength, seed);
            QVERIFY(document::hasCertainAttractor(child));
            QVERIFY(document::fillsAs(document::filling(child), wanted) >= 1);
            QVERIFY(!document::isSameSystem(child, fractal));
            QCOMPARE(document::dimension(child), document::dimension(fractal));
        }
}

void VariationsTest::sameSeedSameSystem() {
    for (const document::Fractal& fractal : {document::sierpinskiTriangle(), tetrahedron()}) {
        const Mutation all = mutation(0.4, {true, true, true});
        QVERIFY(document::variation(fractal, all, 7) == document::variation(fractal, all, 7));
        QVERIFY(!(document::variation(fractal, all, 7) == document::variation(fractal, all, 8)));
    }
}

void VariationsTest::strengthIsDistance() {
    const document::Fractal fractal = document::sierpinskiTriangle(), solid = tetrahedron();
    double near = 0, far = 0, nearInSpace = 0, farInSpace = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        near += distance(varied(varied(fractal, 0.05, seed)), varied(fractal));
        far += distance(varied(varied(fractal, 0.9, seed)), varied(fractal));
        nearInSpace += distance(*document::system3(varied(solid, 0.05, seed)), *document::system3(solid));
        farInSpace += distance(*document::system3(varied(solid, 0.9, seed)), *document::system3(solid));
    }
    QVERIFY(near > 0 && nearInSpace > 0);
    QVERIFY(far > 4 * near && farInSpace > 4 * nearInSpace);
}

void VariationsTest::onlyTheSystemChanges() {
    document::Fractal fractal = document::sierpinskiTriangle();
    fractal.name = QStringLiteral("mine");
    fractal.comments << QStringLiteral(" kept");
    fractal.appearance.gamma = 3;
    document::plane(fractal)->cage = document::effectiveCage(fractal);
    document::plane(fractal)->cage->current[0] += ifs::Vector<2>(0.1, 0.2);
    document::Fractal child = varied(fractal, 0.5, 3);
    *document::system2(child) = *document::system2(fractal);
    QVERIFY(child == fractal);
    document::plane(fractal)->cage->current = document::plane(fractal)->cage->rest;
    QVERIFY(!document::plane(varied(fractal, 0.5, 3))->cage); // it fits the new system
}

void VariationsTest::onlyWhatMayChangeChanges() {
    const document::Fractal fractal = document::sierpinskiTriangle();
    int recoloured = 0, reweighted = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        document::Fractal colours = document::variation(fractal, mutation(0.5, {false, true, false}), seed);
        QVERIFY(document::isSameSystem(colours, fractal));
        recoloured += colours.appearance == fractal.appearance ? 0 : 1;
        QVERIFY(colours.appearance.background == fractal.appearance.background);
        document::Fractal weights = document::variation(fractal, mutation(0.5, {false, false, true}), seed);
        QVERIFY(weights.appearance == fractal.appearance);
        QCOMPARE(distance(varied(weights), varied(fractal)), 0.0);
        reweighted += document::isSameSystem(weights, fractal) ? 0 : 1;
        QVERIFY(std::abs(sumOfWeights(varied(weights)) - 1) < 1e-12);
        const document::Fractal shape =
            document::variation(fractal, mutation(0.2, {true, false, false}), seed);
        for (const auto& map : varied(shape).maps)
            QCOMPARE(map.weight.value(), 1.0 / 3);
        QVERIFY(document::variation(fractal, mutation(1, {false, false, false}), seed) == fractal);
    }
    QCOMPARE(recoloured, 10);
    QCOMPARE(reweighted, 10);
}

void VariationsTest::coloursDecideNothingElse() {
    const document::Fractal fractal = document::sierpinskiTriangle();
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
        QVERIFY(
            document::isSameSystem(document::variation(fractal, mutation(0.6, {true, true, true}), seed),
                                   document::variation(fractal, mutation(0.6, {true, false, true}), seed)));
}

// A map that is favoured stays favoured, as far as chance allows.
void VariationsTest::weightsFollowTheMaps() {
    document::Fractal fractal = document::sierpinskiTriangle();
    document::system2(fractal)->maps[0].weight = 0.8;
    document::system2(fractal)->maps[1].weight = 0.1;
    document::system2(fractal)->maps[2].weight = 0.1;
    int favoured = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const document::System2 child = varied(varied(fractal, 0.15, seed));
        if (child.maps.size() < 3) continue;
        favoured += child.maps[0].weight > 2 * child.maps[1].weight.value() ? 1 : 0;
        QVERIFY(std::abs(sumOfWeights(child) - 1) < 1e-12);
    }
    QVERIFY(favoured >= 16);
}

void VariationsTest::lockedMapsStay() {
    document::Fractal fractal = document::sierpinskiTriangle();
    const ifs::MapId locked = varied(fractal).maps[1].id;
    fractal.mapLabels.set(locked, {QStringLiteral("stem"), true});
    document::system2(fractal)->maps[2].enabled = false;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const document::Fractal child = varied(fractal, 0.9, seed);
        QVERIFY(child.mapLabels == fractal.mapLabels);
        for (const std::size_t index : {std::size_t{1}, std::size_t{2}}) {
            const auto& maps = varied(child).maps;
            QVERIFY(std::ranges::count(maps, varied(fractal).maps[index]) == 1);
        }
    }
}

void VariationsTest::symmetryStays() {
    document::Fractal fractal = document::sierpinskiTriangle();
    document::system2(fractal)->symmetry.group = ifs::SymmetryGroup::Rotation;
    document::system2(fractal)->symmetry.order = 3;
    const document::System2 child = varied(varied(fractal, 0.5, 2));
    QVERIFY(child.symmetry == varied(fractal).symmetry);
}

void VariationsTest::whatHasNoAttractorGetsOne() {
    document::Fractal fractal = document::sierpinskiTriangle();
    document::system2(fractal)->maps[0].map.linear *= 3;
    QVERIFY(!document::hasCertainAttractor(fractal));
    for (std::uint64_t seed = 1; seed <= 12; ++seed)
        QVERIFY(document::hasCertainAttractor(varied(fractal, 0.1, seed)));
}

// What fills its view badly is not varied into itself.
void VariationsTest::thinFractalsHaveVariations() {
    document::Fractal line;
    document::System2 system;
    ifs::append(system, ifs::affineMap(0.5, 0, 0, 0.02, 0, 0), 0.5);
    ifs::append(system, ifs::affineMap(0.5, 0, 0, 0.02, 0.5, 0), 0.5);
    line.shape = document::Shape<2>{system};
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const document::Fractal child = varied(line, 0.05, seed);
        QVERIFY(!document::isSameSystem(child, line));
        QVERIFY(document::hasCertainAttractor(child));
    }
}

void VariationsTest::nothingToVary() {
    QVERIFY(document::variationObstacle(tetrahedron()).isEmpty());
    document::Fractal empty;
    QVERIFY(!document::variationObstacle(empty).isEmpty());
    empty.shape = document::Shape<2>();
    QVERIFY(!document::variationObstacle(empty).isEmpty());
}

BARYCAGE_TEST(VariationsTest, QCoreApplication);
#include "variations_test.moc"
