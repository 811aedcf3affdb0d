// SPDX-License-Identifier: MIT
#include "ifs/system/links.h"

#include "ifs/extent/polygon.h"
#include "ifs/facts.h"
#include "ifs/links/linked_existence.h"
#include "ifs/links/linked_extent.h"
#include "ifs/links/linked_measure.h"
#include "ifs/links/linked_systems.h"
#include "support/named_test.h"
#include "support/near.h"

#include <QtTest>

#include <limits>
#include <random>

using namespace ifs;
using namespace linked_systems;
using support::near;

namespace {

LinkedExtent extentOf(const System& system) {
    const auto active = activeMaps(system);
    return *LinkedExtent::of(active, classifyLinked<2>(active));
}

std::vector<double> transposed(const System& system) {
    const std::size_t n = system.maps.size();
    const auto matrix = linkMatrix(system);
    std::vector<double> result(n * n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            result[j * n + i] = matrix[i * n + j];
    return result;
}

bool spans(const LinkedExtent& extent, std::size_t part, double low, double high) {
    const auto right = extent.ofPart(part, {1, 0}), left = extent.ofPart(part, {-1, 0});
    return near(right.value, high, 5e-14) && near(-left.value, low, 5e-14) && right.error < 1e-12 &&
           left.error < 1e-12;
}

} // namespace

class LinksTest : public QObject {
    Q_OBJECT

private slots:
    void weightsOfLinks() {
        System system = goldenMean();
        QCOMPARE(system.links, (std::vector<Link>{{MapId{2}, MapId{2}, 0}}));
        setLink(system, {MapId{1}, MapId{2}, 0.5});
        QCOMPARE(linkMatrix(system), (std::vector<double>{1, 0.5, 1, 0}));
        setLink(system, {MapId{1}, MapId{2}, 1});
        QCOMPARE(system, goldenMean());
        setLink(system, {MapId{1}, MapId{1}, -3});
        setLink(system, {MapId{2}, MapId{1}, std::numeric_limits<double>::quiet_NaN()});
        QCOMPARE(linkMatrix(system), (std::vector<double>{0, 1, 0, 0}));
    }

    // Rows of equal numbers are the same chain as no links at all.
    void evenRowsAreNoLinks() {
        System system = goldenMean();
        setLinks(system, std::vector<double>{1, 1, 1, 1});
        QVERIFY(system.links.empty());
        setLinks(system, std::vector<double>{2, 2, .5, .5});
        QVERIFY(!activeMaps(system).isLinked());
        QVERIFY(activeMaps(goldenMean()).isLinked());
    }

    void copiesFollowTheSameMaps() {
        System system = threeOnALine();
        const std::vector<MapId> originals{system.maps[0].id, system.maps[2].id};
        std::vector<MapId> copies;
        while (copies.size() < originals.size())
            copies.push_back(append(system, AffineMap<2>{}, 1.0));
        copyLinks(system, originals, copies);
        const auto matrix = linkMatrix(system);
        const auto like = [](std::size_t i) { return std::array<std::size_t, 5>{0, 1, 2, 0, 2}[i]; };
        const auto before = linkMatrix(threeOnALine());
        for (std::size_t i = 0; i < 5; ++i)
            for (std::size_t j = 0; j < 5; ++j)
                QCOMPARE(matrix[5 * i + j], before[3 * like(i) + like(j)]);
    }

    void deletedMapsLeaveNothing() {
        System system = threeOnALine();
        system.maps.pop_back();
        QVERIFY(freshId(system) == MapId{4}); // not an id that a link still names
        dropStaleLinks(system);
        QCOMPARE(linkMatrix(system), (std::vector<double>{0, 1, 0, 0}));
        QVERIFY(freshId(system) == MapId{3});
    }

    void states() {
        using enum LinkState;
        QCOMPARE(linkStates(threeOnALine()), (std::vector<LinkState>(3, TakesPart)));
        System system = system3({1, 1, 0, 0, 0, 0, 1, 0, 0}); // 1→1, 1→2, 2 ends; 3→1, nothing leads to 3
        QCOMPARE(linkStates(system), (std::vector<LinkState>{TakesPart, Ends, Unreached}));
        QCOMPARE(activeMaps(system).index, (std::vector<std::size_t>{0}));
        system = system3({1, 1, 0, 0, 0, 1, 0, 1, 0}); // 1→1 and on to 2⇄3, from where nothing leads back
        QCOMPARE(linkStates(system), (std::vector<LinkState>{Left, TakesPart, TakesPart}));
        system.maps[2].enabled = false;
        QCOMPARE(linkStates(system), (std::vector<LinkState>{TakesPart, Ends, Off}));
        system = system3(std::vector<double>(9, 0));
        QCOMPARE(linkStates(system), (std::vector<LinkState>(3, Ends)));
        QVERIFY(activeMaps(system).maps.empty());
        QVERIFY(factsOf(system).existence.verdict == Verdict::Empty);
        QCOMPARE(countActive(system), std::size_t(0));
    }

    void chainOfThree() {
        const Transitions chain = transitions(activeMaps(threeOnALine()));
        QVERIFY(near(chain.stationary[0], .25, 1e-15) && near(chain.stationary[1], .25, 1e-15));
        QVERIFY(near(chain.stationary[2], .5, 1e-15));
        QVERIFY(near(chain.backward[2 * 3 + 1], .5, 1e-15) && near(chain.backward[2 * 3 + 2], .5, 1e-15));
        QCOMPARE(chain.backward[0 * 3 + 2], 1.0);
        QVERIFY(near(entropyRate(chain), std::log(2) / 2, 1e-15));
    }

    // In the long run every closed part has the weights of its maps.
    void partsThatNeverMeet() {
        System system = system3({1, 0, 0, 0, 1, 1, 0, 1, 1});
        system.maps[0].weight = 2;
        const Transitions chain = transitions(activeMaps(system));
        QCOMPARE(chain.closed.size(), std::size_t(2));
        for (const double share : {.5, .25})
            QVERIFY(near(chain.stationary[share == .5 ? 0 : 1], share, 1e-15));
    }

    void stationaryOfRandomChains() {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> weight(0, 1);
        for (int trial = 0; trial < 50; ++trial) {
            std::vector<double> matrix(9);
            for (double& link : matrix)
                link = std::max(0.0, weight(random) - 0.3);
            const auto active = activeMaps(system3(matrix));
            if (!active.isLinked()) continue;
            const Transitions chain = transitions(active);
            double total = 0;
            for (std::size_t j = 0; j < chain.size; ++j) {
                double inflow = 0;
                for (std::size_t i = 0; i < chain.size; ++i)
                    inflow += chain.stationary[i] * chain.forward[i * chain.size + j];
                QVERIFY(near(inflow, chain.stationary[j], 1e-14));
                total += chain.stationary[j];
            }
            QVERIFY(near(total, 1, 1e-14));
        }
    }

    // Worked out by hand: the ends of A₃ have the digits 222… and 210 210…
    void partsOfThree() {
        const auto extent = extentOf(threeOnALine());
        QVERIFY(spans(extent, 0, 7 / 26.0, 1 / 3.0));
        QVERIFY(spans(extent, 1, 11 / 26.0, 4 / 9.0));
        QVERIFY(spans(extent, 2, 21 / 26.0, 1));
        System reversed = threeOnALine();
        setLinks(reversed, transposed(reversed));
        const auto other = extentOf(reversed);
        QVERIFY(spans(other, 0, 5 / 26.0, 2 / 9.0));
        QVERIFY(spans(other, 1, 15 / 26.0, 2 / 3.0));
        QVERIFY(spans(other, 2, 19 / 26.0, 1));
    }

    void momentsOfThree() {
        const auto facts = factsOf(threeOnALine());
        QVERIFY(facts.moments.has_value());
        QVERIFY(near(facts.moments->mean.x(), 5 / 8.0, 1e-15) && facts.moments->mean.y() == 0);
        QVERIFY(facts.moments->meanError < 1e-13);
        // Second moments of the parts by the same equations, solved by iteration.
        const double mean[]{13 / 44.0, 19 / 44.0, 39 / 44.0};
        double s[]{0, 0, 0};
        for (int n = 0; n < 60; ++n) {
            const double before[]{s[2], s[0], (s[1] + s[2]) / 2};
            const double m[]{mean[2], mean[0], (mean[1] + mean[2]) / 2};
            for (int j = 0; j < 3; ++j)
                s[j] = before[j] / 9 + 2 * j * m[j] / 9 + j * j / 9.0;
        }
        const double square = (s[0] + s[1] + 2 * s[2]) / 4;
        QVERIFY(near(facts.moments->covariance(0, 0), square - 25 / 64.0, 1e-14));
        QVERIFY(facts.moments->covarianceError < 1e-12);
    }

    void dimensions() {
        QVERIFY(near(*linkedDimension(activeMaps(goldenMean())), 0.694241913630617, 2e-15));
        QVERIFY(near(*linkedDimension(activeMaps(dragonBoundary())), 1.523627086202492, 4e-15));
        QVERIFY(near(*linkedDimension(activeMaps(rauzy())), 2, 1e-14));
        const double root = std::pow(3, *linkedDimension(activeMaps(threeOnALine())));
        QVERIFY(near(root * root * root, root * root + 1, 1e-13));
        System bent = goldenMean();
        bent.maps[0].map.linear(0, 1) = .1;
        QVERIFY(!linkedDimension(activeMaps(bent)));
        QVERIFY(!factsOf(bent).affinityDimension && factsOf(bent).box);
        System cycle = threeOnALine(); // finitely many points
        setLinks(cycle, std::vector<double>{0, 1, 0, 0, 0, 1, 1, 0, 0});
        QCOMPARE(*linkedDimension(activeMaps(cycle)), 0.0);
    }

    // Whatever the weights, the entropy divided by the exponent is at most the dimension of the attractor.
    void dimensionOfMeasure() {
        for (const double weight : {0.2, 1.0, 1.6180339887498949, 3.0}) {
            System system = goldenMean();
            system.maps[0].weight = weight;
            const auto facts = factsOf(system);
            QVERIFY(*facts.invariants.measureDimension <= *facts.similarityDimension + 1e-12);
            if (weight == 1.6180339887498949) // the measure of greatest entropy
                QVERIFY(near(*facts.invariants.measureDimension, *facts.similarityDimension, 1e-12));
        }
    }

    // Of two parts, each with the Lebesgue measure of [0, 1] on it, one with maps of ratio ½, one of ¼.
    void partsHaveTheirOwnDimensions() {
        System system;
        for (const double shift : {0.0, 0.5})
            append(system, affineMap(0.5, 0, 0, 0.5, shift, 0), 1);
        for (const double shift : {0.0, 0.25, 0.5, 0.75})
            append(system, affineMap(0.25, 0, 0, 0.25, shift, 0), 1);
        std::vector<double> links(36, 0);
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t j = 0; j < 6; ++j)
                links[6 * i + j] = (i < 2) == (j < 2);
        setLinks(system, links);
        const auto facts = factsOf(system);
        QVERIFY(near(*facts.similarityDimension, 1, 1e-14));
        QVERIFY(near(*facts.invariants.measureDimension, 1, 1e-14));
        // Parts of different dimensions: the larger one counts, whatever the share of the smaller one.
        system.maps[2].weight = 1e9;
        const auto uneven = factsOf(system);
        QVERIFY(near(*uneven.invariants.measureDimension, 1, 1e-14));
    }

    // The bound holds what is known of such systems, and is not far above it.
    void dimensionsHaveErrors() {
        const auto check = [](const System& system, double known) {
            const auto facts = factsOf(system);
            QVERIFY(facts.affinityDimensionError > 0 && facts.affinityDimensionError < 1e-8);
            QVERIFY(std::abs(*facts.affinityDimension - known) <= facts.affinityDimensionError);
        };
        check(goldenMean(), std::log((1 + std::sqrt(5.0)) / 2) / std::log(2.0));
        check(dragonBoundary(), 1.523627086202492);
        System cycle = threeOnALine(); // finitely many points
        setLinks(cycle, std::vector<double>{0, 1, 0, 0, 0, 1, 1, 0, 0});
        QCOMPARE(factsOf(cycle).affinityDimensionError, 0.0);
    }

    // Three maps of a line, which the linked attractor does not leave either.
    void measureOnALineHasDimensionOneAtMost() {
        System line = system(
            {affineMap(.9, 0, 0, .9, 0, 0), affineMap(.9, 0, 0, .9, 1, 0), affineMap(.9, 0, 0, .9, 2, 0)},
            {1, 1, 1});
        setLinks(line, std::vector<double>{1, 0, 1, 1, 1, 1, 0, 1, 1});
        const auto facts = factsOf(line);
        QVERIFY(facts.existence.exists());
        QCOMPARE(facts.invariants.measureDimension, std::optional(1.0));
        QVERIFY(facts.invariants.isMeasureDimensionCapped);
    }

    // Nothing that is known of the maps without their links is claimed of them.
    void noFactsOfTheUnlinkedMaps() {
        const auto facts = factsOf(goldenMean());
        QVERIFY(!facts.support && !facts.invariants.contacts && !facts.invariants.jointSpectralRadius);
        QVERIFY(near(facts.box->max.x(), 2 / 3.0, 1e-14)); // .101010… in binary digits
        QVERIFY(std::ranges::none_of(facts.extremePoints, [](const auto& p) { return p.has_value(); }));
        const auto moved = ifs::moved(affineMap(0, -2, 2, 0, 1, 1), facts);
        QVERIFY(near(moved.box->max.y(), 1 + 4 / 3.0, 1e-13) && near(moved.box->max.x(), 1, 1e-13));
        QVERIFY(near(moved.mean->point.y(), 1 + 2 * facts.mean->point.x(), 1e-13));
        const auto unlinked = factsOf(system({facts.active.maps[0], facts.active.maps[1]}, {1, 1, 1, 1}));
        QVERIFY(unlinked.support && unlinked.invariants.contacts);
    }

    // A map that stretches is no harm where another always follows that shrinks more.
    void existence() {
        const std::vector<AffineMap<2>> maps{affineMap(2, 0, 0, 2, 1, 0), affineMap(.3, 0, 0, .3, 0, 1)};
        const auto alternating = activeMaps(system(maps, {0, 1, 1, 0}));
        const Existence found = classifyLinked<2>(alternating);
        QVERIFY(found.verdict == Verdict::EventuallyContractive);
        QCOMPARE(found.wordLength, 2);
        const auto extent = LinkedExtent::of(alternating, found);
        // x = 2y + 1, y = .3x: x = 2.5, y = .75
        QVERIFY(near((*extent)({1, 0}).value, 2.5, 1e-13) && near(-(*extent)({-1, 0}).value, .75, 1e-13));
        const Existence free = classifyLinked<2>(activeMaps(system(maps, {1, 1, 1, 0})));
        QVERIFY(free.verdict == Verdict::None);
        QCOMPARE(free.witness, std::vector<int>{0});
        const std::vector<AffineMap<2>> larger{affineMap(4, 0, 0, 4, 1, 0), maps[1]};
        const Existence cycle = classifyLinked<2>(activeMaps(system(larger, {0, 1, 1, 0})));
        QVERIFY(cycle.verdict == Verdict::None);
        QCOMPARE(cycle.witness.size(), std::size_t(2));
        QVERIFY(near(cycle.contractivity, std::sqrt(1.2), 1e-12));
    }

    // Heights and hull hold every point of long admissible words, and are reached.
    void hullOfTheRauzyTile() {
        const auto active = activeMaps(rauzy());
        const auto extent = extentOf(rauzy());
        const auto hull = convexHull(extent, 1e-6);
        QVERIFY(hull->error <= 1e-6);
        std::mt19937 random(2);
        std::size_t last = 0;
        Vector<2> x = extent.pointOf(0);
        double farthest = 0;
        for (int n = 0; n < 20'000; ++n) {
            std::size_t next = random() % 3;
            while (!(active.links[3 * last + next] > 0))
                next = random() % 3;
            last = next;
            x = active.maps[last](x);
            farthest = std::max(farthest, x.x());
            QVERIFY(distanceToConvex(hull->vertices, x) <= hull->error + 1e-12);
            QVERIFY((x - extent.centre()).norm() <= extent.radius() * (1 + 1e-12));
        }
        const auto right = extent({1, 0});
        QVERIFY(farthest <= right.value + right.error && right.value - farthest < 0.02);
    }

private:
    static System system3(const std::vector<double>& matrix) {
        System result = threeOnALine();
        setLinks(result, matrix);
        return result;
    }
};

BARYCAGE_TEST(LinksTest);
#include "links_test.moc"
