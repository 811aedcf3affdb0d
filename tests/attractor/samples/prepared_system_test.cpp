// SPDX-License-Identifier: MIT
#include "attractor/samples/prepared_system.h"
#include "attractor/systems.h"
#include "ifs/extent/extent.h"
#include "ifs/extent/support_function.h"
#include "support/named_test.h"

#include <QtTest>

#include <random>

using namespace attractor;

namespace {

ifs::IteratedFunctionSystem<2> randomSystem(int maps, double reach) {
    std::mt19937 random(static_cast<unsigned>(maps));
    std::uniform_real_distribution<double> u(-1, 1);
    ifs::IteratedFunctionSystem<2> result;
    for (int i = 0; i < maps; ++i)
        ifs::append<2>(result, ifs::affineMap(reach * u(random), reach * u(random), reach * u(random),
                                              reach * u(random), u(random), 3 * u(random)));
    return result;
}

// The longer, the thinner, and the more its maps stretch one by one.
ifs::IteratedFunctionSystem<2> sheared(double length) {
    ifs::IteratedFunctionSystem<2> result;
    ifs::append<2>(result, ifs::affineMap(3.2, -102 * length, .1 / length, -3.2, 91, 3 / length));
    ifs::append<2>(result, ifs::affineMap(-3.2, 84.7 * length, -.1 / length, 2.6, -89, -3 / length));
    return result;
}

} // namespace

class PreparedSystemTest : public QObject {
    Q_OBJECT

private slots:
    void theBoxHoldsTheAttractor_data() {
        QTest::addColumn<ifs::IteratedFunctionSystem<2>>("system");
        QTest::newRow("Sierpiński") << systems::sierpinski();
        QTest::newRow("fern") << systems::fern();
        QTest::newRow("maple") << systems::maple();
        QTest::newRow("20 maps") << randomSystem(20, 0.3);
        QTest::newRow("3000 maps") << randomSystem(3000, 0.02); // most of which do not matter
        QTest::newRow("300 wide maps") << randomSystem(300, 0.4);
        QTest::newRow("a shear") << sheared(1);
        QTest::newRow("a strong shear") << sheared(20);
    }
    void theBoxHoldsTheAttractor() {
        QFETCH(ifs::IteratedFunctionSystem<2>, system);
        const PreparedSystem drawn = prepared(system);
        QVERIFY(drawn.note == RenderNote::None);
        const auto support = ifs::SupportFunction<2>::of(drawn.maps);
        const auto box = ifs::boundingBox(*support, 1e-6 * support->radius());
        const ifs::Vector<2> low = drawn.centre - drawn.halfExtent;
        const ifs::Vector<2> high = drawn.centre + drawn.halfExtent;
        const double size = (box.max - box.min).maxCoeff();
        QVERIFY((low.array() <= box.min.array()).all() && (high.array() >= box.max.array()).all());
        QVERIFY((box.min - low).maxCoeff() < 0.03 * size && (high - box.max).maxCoeff() < 0.03 * size);
    }

    void probabilitiesAddUp() {
        auto system = systems::fern();
        system.maps[1].weight = 0;
        const PreparedSystem drawn = prepared(system);
        QCOMPARE(drawn.maps.size(), std::size_t(3));
        QCOMPARE(drawn.index, (std::vector<std::size_t>{0, 2, 3}));
        double sum = 0;
        for (const double p : drawn.probabilities)
            sum += p;
        QVERIFY(std::abs(sum - 1) < 1e-15);
    }

    void notes() {
        QVERIFY(prepared({}).note == RenderNote::NoMaps);
        ifs::IteratedFunctionSystem<2> system;
        ifs::append<2>(system, ifs::affineMap(2, 0, 0, 2, 0, 0));
        QVERIFY(prepared(system).note == RenderNote::NoAttractor);
    }
};

BARYCAGE_TEST(PreparedSystemTest);
#include "prepared_system_test.moc"
