// SPDX-License-Identifier: MIT
#include "document/fractal/fractal_geometry.h"
#include "document/variations/filling.h"
#include "document/variations/random_systems.h"
#include "support/named_test.h"
#include "support/thorough.h"

#include <QTest>

#include <set>

using enum ifs::SymmetryGroup;
using document::RandomChoice;

class RandomSystemsTest : public QObject {
    Q_OBJECT

private slots:
    void systemsFillTheirView_data();
    void systemsFillTheirView();
    void singularValuesKeepTheRule();
    void sameSeedSameSystem();
    void anyNumberOfMaps();
    void linesAndDustDoNotFillAView();
    void pointsInSpaceDoNotFillAView();

private:
    const std::uint64_t m_seeds = support::isThorough() ? 25 : 6;
};

namespace {

const document::System2& systemOf(const document::Fractal& fractal) {
    return *document::system2(fractal);
}

// Σ(σ₁ + 2σ₂) over all maps, counted with the symmetry.
template <int Dim> double sumOf(const ifs::IteratedFunctionSystem<Dim>& system) {
    double sum = 0;
    for (const auto& map : ifs::expanded(system).maps) {
        const ifs::Vector<Dim> values = ifs::singularValues<Dim>(map.map.linear);
        sum += values[0] + 2 * values[1];
    }
    return sum;
}

} // namespace

void RandomSystemsTest::systemsFillTheirView_data() {
    QTest::addColumn<RandomChoice>("choice");
    QTest::newRow("any") << RandomChoice{};
    QTest::newRow("two") << RandomChoice{2, 2};
    QTest::newRow("sixteen") << RandomChoice{2, 16};
    QTest::newRow("mirror") << RandomChoice{2, 2, Mirror};
    QTest::newRow("single, five times") << RandomChoice{2, 1, Rotation, 5};
    QTest::newRow("dihedral") << RandomChoice{2, 0, Dihedral, 6};
    QTest::newRow("space") << RandomChoice{3};
    QTest::newRow("space, four") << RandomChoice{3, 4};
    QTest::newRow("space, icosahedral") << RandomChoice{3, 1, Icosahedral};
}

void RandomSystemsTest::systemsFillTheirView() {
    QFETCH(RandomChoice, choice);
    for (std::uint64_t seed = 1; seed <= m_seeds; ++seed) {
        const document::Fractal fractal = document::randomFractal(choice, seed);
        QCOMPARE(document::dimension(fractal), choice.dimension);
        QVERIFY(document::hasCertainAttractor(fractal));
        QVERIFY(document::fillsAs(document::filling(fractal), document::wellFilled) >= 1);
        const std::size_t maps =
            choice.dimension == 2 ? systemOf(fractal).maps.size() : document::system3(fractal)->maps.size();
        if (choice.maps > 0) QCOMPARE(maps, std::size_t(choice.maps));
    }
}

void RandomSystemsTest::singularValuesKeepTheRule() {
    int checked = 0;
    for (const ifs::SymmetryGroup group : {None, Mirror, Rotation, Dihedral})
        for (const int maps : {1, 2, 3, 5, 8, 16})
            for (std::uint64_t seed = 1; seed <= m_seeds; ++seed) {
                if (group == None && maps == 1) continue;
                const bool hasOrder = group == Rotation || group == Dihedral;
                const int order = hasOrder ? 2 + int(seed % 6) : 1;
                const RandomChoice choice{2, maps, group, order};
                const document::System2 system = systemOf(document::randomFractal(choice, seed));
                QCOMPARE(int(system.symmetry.group), int(group));
                const double n = double(ifs::expanded(system).maps.size());
                QCOMPARE(n, double(maps) * double(ifs::groupOrder(group, order)));
                QVERIFY(sumOf(system) >= (5 + n) / 2);
                QVERIFY(sumOf(system) <= (6 + n) / 2);
                ++checked;
            }
    QCOMPARE(checked, 23 * int(m_seeds));
    for (std::uint64_t seed = 1; seed <= m_seeds; ++seed) {
        const document::Fractal solid = document::randomFractal({3, 3, Tetrahedral}, seed);
        const document::System3& system = *document::system3(solid);
        QVERIFY(sumOf(system) >= (5 + 36) / 2.0 && sumOf(system) <= (6 + 36) / 2.0);
        for (const auto& map : system.maps) {
            const ifs::Vector<3> values = ifs::singularValues<3>(map.map.linear);
            QVERIFY(values[2] > 0.299 * values[1]);
        }
    }
}

void RandomSystemsTest::sameSeedSameSystem() {
    for (const RandomChoice& choice : {RandomChoice{}, RandomChoice{3}, RandomChoice{2, 3, Rotation, 4}}) {
        QVERIFY(document::randomFractal(choice, 5) == document::randomFractal(choice, 5));
        QVERIFY(!(document::randomFractal(choice, 5) == document::randomFractal(choice, 6)));
    }
}

void RandomSystemsTest::anyNumberOfMaps() {
    std::set<std::size_t> alone, symmetric;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        alone.insert(systemOf(document::randomFractal({}, seed)).maps.size());
        symmetric.insert(systemOf(document::randomFractal({2, 0, Rotation, 3}, seed)).maps.size());
    }
    QVERIFY(alone == (std::set<std::size_t>{2, 3, 4, 5}));
    QVERIFY(symmetric == (std::set<std::size_t>{1, 2, 3}));
}

void RandomSystemsTest::linesAndDustDoNotFillAView() {
    document::Fractal fractal;
    document::System2 line;
    ifs::append(line, ifs::affineMap(0.5, 0, 0, 0.5, 0, 0));
    ifs::append(line, ifs::affineMap(0.5, 0, 0, 0.5, 0.5, 0.5));
    fractal.shape = document::Shape<2>{line};
    QVERIFY(document::fillsAs(document::filling(fractal), document::wellFilled) < 1); // a diagonal
    document::System2 dust;
    for (const double x : {0.0, 0.9})
        for (const double y : {0.0, 0.9})
            ifs::append(dust, ifs::affineMap(0.1, 0, 0, 0.1, x, y));
    fractal.shape = document::Shape<2>{dust};
    QVERIFY(document::fillsAs(document::filling(fractal), document::wellFilled) < 1);
    QVERIFY(document::fillsAs(document::filling(document::sierpinskiTriangle()), document::wellFilled) >= 1);
}

void RandomSystemsTest::pointsInSpaceDoNotFillAView() {
    document::Fractal fractal;
    document::System3 dust, cube;
    for (int corner = 0; corner < 8; ++corner) {
        const ifs::Vector<3> at(corner & 1, (corner >> 1) & 1, corner >> 2);
        ifs::append(dust, ifs::AffineMap<3>{ifs::Matrix<3>::Identity() / 20, at});
        ifs::append(cube, ifs::AffineMap<3>{ifs::Matrix<3>::Identity() / 2, at / 2});
    }
    fractal.shape = document::Shape<3>{dust};
    QVERIFY(document::fillsAs(document::filling(fractal), document::wellFilled) < 1);
    fractal.shape = document::Shape<3>{cube};
    QVERIFY(document::filling(fractal).share > 0.5);
    QVERIFY(document::filling(fractal).aspect > 0.999);
}

BARYCAGE_TEST(RandomSystemsTest);
#include "random_systems_test.moc"
