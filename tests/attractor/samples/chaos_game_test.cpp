// SPDX-License-Identifier: MIT
#include "attractor/samples/chaos_game.h"

#include "attractor/kernels/kernels.h"
#include "attractor/systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>
#include <limits>
#include <random>

using namespace attractor;

namespace {

struct Known {
    const char* name;
    ifs::IteratedFunctionSystem<2> system;
    ifs::Vector<2> mean;
    ifs::Vector<2> longRun; // Γ_xx, Γ_yy
};

std::vector<Known> known() {
    return {{"sierpinski", systems::sierpinski(), {1 / 3.0, 1 / 3.0}, {2 / 9.0, 2 / 9.0}},
            {"flower", systems::flower(), {0.060221295120623980, 3.323235987665517867}, {6.546792, 0.744559}},
            {"maple", systems::maple(), {0.173497302602363578, 1.889554379976506070}, {9.148866, 5.128550}},
            {"fern", systems::fern(), {0.796833224540832, 6.167579195598532}, {10.425670, 45.059712}}};
}

// One step as the contract says, one orbit at a time.
void plainStep(kernels::Lanes& lanes, const kernels::ChaosTables& t, std::size_t lane) {
    auto& [s0, s1, s2, s3] = lanes.random;
    const auto rotated = [](std::uint32_t x, int k) { return (x << k) | (x >> (32 - k)); };
    const std::uint32_t random = rotated(s0[lane] + s3[lane], 7) + s0[lane];
    const std::uint32_t shifted = s1[lane] << 9;
    s2[lane] ^= s0[lane];
    s3[lane] ^= s1[lane];
    s1[lane] ^= s2[lane];
    s0[lane] ^= s3[lane];
    s2[lane] ^= shifted;
    s3[lane] = rotated(s3[lane], 11);
    const std::uint32_t slot = random % static_cast<std::uint32_t>(t.size);
    const std::uint32_t map = static_cast<std::int32_t>(random) < t.threshold[slot]
                                  ? slot
                                  : static_cast<std::uint32_t>(t.alias[slot]);
    const auto& [a, b, c, d, e, f] = t.coefficients;
    const float x = lanes.x[lane];
    const float y = lanes.y[lane];
    const float nextX = a[map] * x + b[map] * y + e[map];
    const float nextY = c[map] * x + d[map] * y + f[map];
    const bool inside = std::abs(nextX) < t.escapeRadius && std::abs(nextY) < t.escapeRadius;
    lanes.x[lane] = inside ? nextX : 0;
    lanes.y[lane] = inside ? nextY : 0;
}

} // namespace

class TestChaosGame : public QObject {
    Q_OBJECT

private slots:
    void aliasTableKeepsTheProbabilities() {
        std::mt19937 random(3);
        for (const std::size_t count : {1U, 2U, 4U, 15U, 16U, 17U, 100U}) {
            std::vector<double> p(count);
            for (double& value : p)
                value = std::uniform_real_distribution<double>(0, 1)(random);
            p[0] = 1e-6;
            double total = 0;
            for (const double value : p)
                total += value;
            for (double& value : p)
                value /= total;
            const AliasTable table(p);
            std::vector<double> found(count, 0);
            const double slot = 1 / static_cast<double>(table.size());
            for (std::size_t s = 0; s < table.size(); ++s) {
                const double share = table.thresholds()[s] * 0x1p-32 + 0.5;
                const auto alias = static_cast<std::size_t>(table.aliases()[s]);
                QVERIFY(s < count || share == 0);
                QVERIFY(alias < count);
                if (s < count) found[s] += share * slot;
                found[alias] += (1 - share) * slot;
            }
            for (std::size_t i = 0; i < count; ++i)
                QVERIFY(std::abs(found[i] - p[i]) < 1e-8);
        }
    }

    void meansAreThoseOfTheInvariantMeasure() {
        for (const Known& k : known()) {
            const PreparedSystem system = prepared(k.system);
            SampleSet samples;
            ifs::Vector<2> sum = ifs::Vector<2>::Zero();
            constexpr int sets = 40;
            for (int pass = 0; pass < sets; ++pass) {
                drawSamples(system, 11, static_cast<std::uint64_t>(pass), samples);
                for (std::size_t i = 0; i < SampleSet::size; ++i)
                    sum += system.centre +
                           system.halfExtent.cwiseProduct(ifs::Vector<2>(samples.x[i], samples.y[i]));
            }
            const double n = sets * static_cast<double>(SampleSet::size);
            for (int axis = 0; axis < 2; ++axis)
                QVERIFY2(std::abs(sum[axis] / n - k.mean[axis]) <= 5 * std::sqrt(k.longRun[axis] / n),
                         k.name);
        }
    }

    void everyInstructionSetGivesTheSameOrbits() {
        std::mt19937 random(9);
        const std::string chosen = simdName();
        for (const std::size_t count : {3U, 16U, 30U, 70U}) {
            std::vector<double> p(count, 1.0 / static_cast<double>(count));
            const AliasTable table(p);
            std::array<std::vector<float>, 6> coefficients;
            kernels::ChaosTables tables;
            tables.size = table.size();
            tables.threshold = table.thresholds().data();
            tables.alias = table.aliases().data();
            for (std::size_t k = 0; k < 6; ++k) {
                coefficients[k].resize(table.size());
                for (float& value : coefficients[k])
                    value = std::uniform_real_distribution<float>(-0.9F, 0.9F)(random);
                tables.coefficients[k] = coefficients[k].data();
            }
            tables.escapeRadius = 1.5F; // so that some escape
            kernels::Lanes start;
            for (auto& word : start.random)
                for (std::uint32_t& value : word)
                    value = static_cast<std::uint32_t>(random());
            kernels::Lanes plain = start;
            constexpr std::size_t steps = 300;
            for (std::size_t lane = 0; lane < kernels::Lanes::count; ++lane)
                for (std::size_t step = 0; step < steps; ++step)
                    plainStep(plain, tables, lane);
            kernels::ChaosTables boundless = tables;
            boundless.escapeRadius = std::numeric_limits<float>::infinity();
            kernels::Lanes free = start;
            for (std::size_t lane = 0; lane < kernels::Lanes::count; ++lane)
                for (std::size_t step = 0; step < 20; ++step)
                    plainStep(free, boundless, lane);
            for (const char* name : {"scalar", "sse4", "avx2", "avx512"}) {
                if (!selectSimd(name)) continue;
                kernels::Lanes unguarded = start;
                kernels::iterate(unguarded, tables, kernels::Guard::Off, 20, nullptr, nullptr);
                QVERIFY2(unguarded.x == free.x && unguarded.y == free.y, name);
                kernels::Lanes lanes = start;
                kernels::iterate(lanes, tables, kernels::Guard::On, steps, nullptr, nullptr);
                QVERIFY2(lanes.x == plain.x && lanes.y == plain.y && lanes.random == plain.random, name);
            }
        }
        QVERIFY(selectSimd(chosen));
    }

    void paperModeDropsFourteenPoints() {
        const PreparedSystem system =
            prepared(systems::system({{{0.5, 0, 0, 0.5, 0, 0}}, {{0.5, 0, 0, 0.5, 0.5, 0}}}));
        Orbit orbit(system, 4);
        // x_0 = 0 is fixed by the first map; every later point is Σ of binary digits, newest first: its
        // address.
        for (int n = 0; n < 2000; ++n) {
            const Orbit::Point point = orbit.next();
            QVERIFY(std::abs(point.x.x() - point.addressCoordinate) < 1e-12);
            QCOMPARE(point.x.x() >= 0.5, point.lastMap == 1);
        }
    }

    void addressCoordinateReadsTheNewestMapFirst() {
        const PreparedSystem system = prepared(systems::sierpinski());
        Orbit orbit(system, 1);
        Orbit::Point before = orbit.next();
        for (int n = 0; n < 100; ++n) {
            const Orbit::Point now = orbit.next();
            QVERIFY(std::abs(now.addressCoordinate - (now.lastMap + before.addressCoordinate) / 3) < 1e-15);
            before = now;
        }
    }
};

BARYCAGE_TEST(TestChaosGame);
#include "chaos_game_test.moc"
