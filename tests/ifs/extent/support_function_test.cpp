// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/extent/support_function.h"
#include "support/named_test.h"
#include "support/near.h"

#include <QtTest>

#include <numbers>

using namespace ifs;
using namespace canonical;

namespace {

using support::near;
template <int Dim> SupportFunction<Dim> functionOf(const std::vector<AffineMap<Dim>>& maps) {
    return *SupportFunction<Dim>::of(maps);
}
template <int Dim> Vector<Dim> randomDirection(Random& random) {
    return randomVector<Dim>(random).normalized();
}
Vector<2> atDegrees(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return {std::cos(angle), std::sin(angle)};
}

// h(u) against numbers certified to 1e-13 and better, in 16 directions.
void compare(const Maps2& maps, const double (&axesAndDiagonals)[8], const double (&between)[8]) {
    const auto h = functionOf<2>(maps);
    const Vector<2> directions[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}};
    for (std::size_t k = 0; k < 8; ++k) {
        const auto straight = h(directions[k]);
        QVERIFY(near(straight.value, axesAndDiagonals[k], 4e-14));
        QVERIFY(straight.error >= 0 && straight.error <= 4e-11);
        QVERIFY(near(h(atDegrees(22.5 + 45 * double(k))).value, between[k], 1e-12));
    }
}

// Everything that must hold of any h_A, for random systems.
template <int Dim> void properties(const std::vector<AffineMap<Dim>>& maps, Random& random) {
    const auto h = functionOf<Dim>(maps);
    const Vector<Dim> u = randomDirection<Dim>(random), v = randomDirection<Dim>(random);
    const double size = h.centre().norm() + h.radius();
    const auto hu = h(u), hv = h(v);
    QVERIFY(near(hu.value, u.dot(hu.point), 0));
    QVERIFY(hu.error <= 4e-11 * size);

    double residual = -infinity; // h(u) = max_i ⟨u,b_i⟩ + h(A_iᵀu)
    for (const auto& map : maps)
        residual = std::max(residual, u.dot(map.translation) + h(map.linear.transpose() * u).value);
    QVERIFY(near(residual, hu.value, 1e-12 * size));
    QVERIFY(h(u + v).value <= hu.value + hv.value + 1e-12 * size);
    QVERIFY(near(h(u * 1e5).value, hu.value * 1e5, 1e-7 * size));

    for (const auto& x : orbit<Dim>(maps, 200, random)) {
        QVERIFY(u.dot(x) <= hu.value + hu.error);
        QVERIFY((x - h.centre()).norm() <= h.radius() * (1 + 1e-12) + 1e-12 * size);
    }
    Vector<Dim> x = *fixedPoint(maps[0]); // the address leads to the point
    for (auto symbol = hu.address.rbegin(); symbol != hu.address.rend(); ++symbol)
        x = maps[std::size_t(*symbol)](x);
    QVERIFY((x - hu.point).norm() <= 1e-12 * size);

    const AffineMap<Dim> t{randomWellConditioned<Dim>(random, 5), randomVector<Dim>(random, 3)};
    const auto image = functionOf<Dim>(mapsOf(*conjugate(t, canonical::system<Dim>(maps))));
    QVERIFY(near(image(u).value, u.dot(t.translation) + h(t.linear.transpose() * u).value, 1e-11 * size));

    const double coarse = 0.01 * size;
    const auto rough = h(u, coarse);
    QVERIFY(rough.error <= coarse + 1e-11 * size);
    QVERIFY(rough.value <= hu.value + hu.error && hu.value <= rough.value + rough.error);
    const auto limited = h(u, 0, 20);
    QVERIFY(limited.value <= hu.value + hu.error && hu.value <= limited.value + limited.error);
}

template <int Dim> void randomSupports(int count) {
    Random random(Dim);
    for (int n = 0; n < count; ++n)
        properties<Dim>(randomContractions<Dim>(random, 1 + int(random() % 5)), random);
}

template <int Dim> void badSystems() {
    QVERIFY(!SupportFunction<Dim>::of({}));
    for (const double bad : {quietNaN, infinity, 1e300}) {
        std::vector<AffineMap<Dim>> maps(2);
        for (auto& map : maps)
            map.linear *= 0.5;
        maps[1].linear(0, 0) = bad;
        QVERIFY(!SupportFunction<Dim>::of(maps));
        maps[1].linear(0, 0) = 0.5;
        maps[1].translation[0] = bad;
        const auto h = SupportFunction<Dim>::of(maps);
        QVERIFY(!h || std::isfinite((*h)(Vector<Dim>::Unit(0)).value));
    }
    const auto h = functionOf<Dim>({AffineMap<Dim>{Matrix<Dim>::Zero(), Vector<Dim>::Ones()}});
    QCOMPARE(h(Vector<Dim>::Zero()).value, 0.0);
    QCOMPARE(h(Vector<Dim>::Unit(0)).value, 1.0);
    QCOMPARE(h(Vector<Dim>::Constant(quietNaN)).value, 0.0);
    QCOMPARE(h(Vector<Dim>::Constant(quietNaN)).error, infinity);
    QVERIFY(std::isfinite(h(Vector<Dim>::Constant(1e308)).error));
    QVERIFY(std::isfinite(h(Vector<Dim>::Constant(1e-320)).error));
}

} // namespace

class SupportFunctionTest : public QObject {
    Q_OBJECT

private slots:
    void mapleValues() {
        compare(maple(),
                {3.34421444954055796920, 3.30009395647353114235, 5.07246376811594202899,
                 3.17305096113017083712, 6.08916542200435192294, 6.10802576596239869167,
                 3.47883508559757826957, 3.28797925749982599970},
                {3.6490301373016, 4.9282780891357, 4.8633002889253, 3.8165132243299, 2.5458756261912,
                 2.9754912068959, 2.8875602690427, 2.9951656181161});
    }
    void flowerValues() {
        compare(flower(),
                {2.30114102748516340150, 2.24031644660197148078, 3.92730978512464660029,
                 -2.11397256199446667946, 5.27425640995397969726, 5.29003138511850473399,
                 -0.03186262094145062034, -0.15860145329153969695},
                {3.1385404368864, 3.9954823314391, 3.9828826402625, 3.1437107128843, 1.1226836821639,
                 -1.2868412756994, -1.1722031057611, 1.1961153096591});
    }
    void fernValues() {
        compare(fern(),
                {2.65578322708984917131, 2.18192115030976087016, 9.99826503661828422427, 0,
                 12.61791263170606876660, 8.13809523936376591566, 0.61731635294429451098, 0},
                {6.2651083025011, 10.2270703177820, 8.3377153764815, 3.6223419968210, 0.6795707513107, 0, 0,
                 1.1732564709282});
    }

    void fernInSpaceValues() {
        const auto h = functionOf<3>(fern3());
        for (const double x : {1.0, -1.0}) {
            QVERIFY(near(h({x, 1, 1}).value, 5.202760360089555, 1e-13));
            QVERIFY(near(h({x, 1, -1}).value, 12.643521945871724, 1e-13));
            QVERIFY(near(h({x, -1, -1}).value, 0.705813577663085, 1e-13));
            QVERIFY(near(h({x, -1, 1}).value, 0, 1e-13));
        }
    }

    // FLOWER's topmost point is not the periodic one its address seems to have for 45 symbols.
    void longDeviation() {
        const auto top = functionOf<2>(flower())({0, 1});
        QVERIFY(top.value > 3.927309785124383 + 2e-13);
        for (std::size_t k = 0; k < 45; ++k)
            QCOMPARE(top.address[k], k % 2 == 0 ? 1 : 0);
    }

    // Rotations of finite order tie exponentially; merging equal states keeps the search small.
    void equalStatesAreMerged() {
        constexpr int fewNodes = 5000;
        const auto levyRight = functionOf<2>(levy())({1, 0}, 0, fewNodes);
        QVERIFY(near(levyRight.value, 1.5, 1e-14) && levyRight.error <= 1e-11);
        const auto heighwayTop = functionOf<2>(heighway())({0, 1}, 0, fewNodes);
        QVERIFY(near(heighwayTop.value, 2.0 / 3, 1e-14) && heighwayTop.error <= 1e-11);
        const auto twinRight = functionOf<2>(twin())({1, 0}, 0, fewNodes);
        QVERIFY(near(twinRight.value, 4.0 / 3, 1e-14) && twinRight.error <= 1e-11);
        const auto cubeCorner = functionOf<3>(cube())({1, 1, 1}, 0, fewNodes);
        QVERIFY(near(cubeCorner.value, 3, 1e-14) && cubeCorner.error <= 1e-11);
    }

    void eventuallyContractiveSystem() {
        Random random(1);
        for (int n = 0; n < 50; ++n)
            properties<2>(eventual(), random);
    }
    void randomPlaneSystems() { randomSupports<2>(1000); }
    void randomSpaceSystems() { randomSupports<3>(300); }

    void slowContractions() {
        const Maps2 spiral{similarity(0.999, 0.1, 1, 0), similarity(0.2, 1, 3, 3)};
        const auto value = functionOf<2>(spiral)({1, 0});
        QVERIFY(value.error < 1e-10);
        const Maps2 slower{similarity(1 - 1e-9, 0.1, 1, 0), similarity(0.2, 1, 3, 3)};
        const auto rough = functionOf<2>(slower)({1, 0}, 0, 10'000);
        QVERIFY(std::isfinite(rough.value) && rough.error >= 0);
    }

    void manyMaps() {
        Random random(4);
        const auto maps = randomContractions<2>(random, 10'000, 0.05);
        const auto h = functionOf<2>(maps);
        const auto value = h({1, 0}, 1e-9);
        for (const auto& x : orbit<2>(maps, 100'000, random))
            QVERIFY(x.x() <= value.value + value.error);
    }

    // So many that those which do not lead to the hull are left out.
    void manySmallMaps() {
        Random random(9);
        for (const int count : {257, 1000}) {
            auto maps = randomContractions<2>(random, count, 0.1);
            const auto outer = functionOf<2>(maps).mapsToTheHull();
            QVERIFY(!outer.empty() && outer.size() < maps.size() / 2);
            properties<2>(maps, random);
            maps.push_back(affineMap(.9, 0, 0, .9, 0, 0)); // reaches beyond the hull of its own fixed point
            properties<2>(maps, random);
        }
        Maps2 onOneLine(300, affineMap(.1, 0, 0, .1, 0, 0));
        for (std::size_t i = 0; i < onOneLine.size(); ++i)
            onOneLine[i].translation.x() = double(i);
        properties<2>(onOneLine, random);
    }

    // Images as large as a half of the attractor, which no ellipsoid tells from those that matter.
    void manyLargeMaps() {
        Random random(3);
        for (const int side : {20, 100, 316}) {
            Maps2 maps;
            for (int i = 0; i < side * side; ++i)
                maps.push_back({Matrix<2>::Identity() / 2, Vector<2>(i % side, i / side) / (2 * (side - 1))});
            const auto square = functionOf<2>(maps); // of side 1
            QVERIFY(square.mapsToTheHull().size() <= std::size_t(std::max(256, 5 * side)));
            for (const auto& u : {Vector<2>(1, 0), Vector<2>(-1, 0), Vector<2>(0.6, 0.8)}) {
                const auto value = square(u, 1e-9);
                QVERIFY2(value.error < 1e-8, qPrintable(QString::number(value.error)));
                const double exact = std::max(u.x(), 0.0) + std::max(u.y(), 0.0);
                QVERIFY(value.value <= exact + 1e-12 && exact <= value.value + value.error);
            }
        }
        for (const int count : {1000, 20'000}) {
            const auto maps = randomContractions<2>(random, count, 0.6);
            const auto h = functionOf<2>(maps);
            QVERIFY(h.mapsToTheHull().size() < 300);
            for (const auto& u : {Vector<2>(1, 0), Vector<2>(-0.6, 0.8)}) {
                const auto value = h(u, 1e-9 * h.radius());
                QVERIFY(value.error < 1e-8 * h.radius());
                double farthest = -HUGE_VAL;
                for (const auto& x : orbit<2>(maps, 100'000, random))
                    farthest = std::max(farthest, u.dot(x));
                QVERIFY(farthest <= value.value + value.error);
            }
        }
    }

    void equalMaps() {
        const Maps2 maps(50, affineMap(.5, .1, -.2, .4, 1, 1));
        const auto h = functionOf<2>(maps);
        const Vector<2> point = *fixedPoint(maps[0]);
        QVERIFY(near(h({1, 0}, 0, 1000).value, point.x(), 1e-14));
        QVERIFY(h({1, 0}, 0, 1000).error < 1e-11);
    }

    void farFromTheOrigin() {
        Maps2 maps = maple();
        AffineMap<2> shift;
        shift.translation << 1e9, -1e9;
        for (auto& map : maps)
            map = *conjugate(shift, map);
        const auto value = functionOf<2>(maps)({1, 0});
        QVERIFY(near(value.value, 1e9 + 3.34421444954055796920, value.error + 1e-6));
        QVERIFY(value.error < 1e-4);
    }

    // A point is found without a symbol, and no rounding of symbols is charged for it.
    void aPointCostsNoSymbols() {
        const auto h = functionOf<2>({affineMap(.5, 0, 0, .5, 1e6, 2e6)});
        const auto value = h({1, 0});
        QVERIFY(value.error < h.roundingError(1) && h.roundingError(0) < h.roundingError(1));
        QVERIFY(near(value.value, 2e6, value.error));
    }

    void badSystems2() { badSystems<2>(); }
    void badSystems3() { badSystems<3>(); }
};

BARYCAGE_TEST(SupportFunctionTest);
#include "support_function_test.moc"
