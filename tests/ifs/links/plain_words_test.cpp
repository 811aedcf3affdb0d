// SPDX-License-Identifier: MIT
#include "ifs/links/plain_words.h"

#include "ifs/dimension/dimension.h"
#include "ifs/extent/extent.h"
#include "ifs/links/linked_systems.h"
#include "support/named_test.h"

#include <QTest>

#include <cmath>

using namespace ifs;
using namespace linked_systems;
using Words = std::vector<std::vector<std::size_t>>;

// Linked maps as plain ones.
class PlainWordsTest : public QObject {
    Q_OBJECT

private slots:
    // A = f₀(A) ∪ f₁f₀(A)
    void theGoldenMeanIsTwoWords() {
        const auto active = activeMaps(goldenMean());
        const auto plain = plainWords(active, 100);
        QVERIFY(plain);
        QCOMPARE(plain->words, (Words{{0}, {1, 0}}));
        // π = (2/3, 1/3) for equal weights
        QVERIFY(std::abs(plain->weights[0] - 2 / 3.0) < 1e-14 &&
                std::abs(plain->weights[1] - 1 / 3.0) < 1e-14);
        QVERIFY(!plain->keepsMeasure); // after 1, 0 is certain
        const std::vector<AffineMap<2>> maps{active.maps[0], active.maps[1] * active.maps[0]};
        QVERIFY(std::abs(*similarityDimension<2>(maps) - 0.694241913630617) < 1e-12);
        QVERIFY(std::abs(boundingBox(*SupportFunction<2>::of(maps)).max.x() - 2 / 3.0) < 1e-12);
    }

    void positiveLinksAreEachMap() {
        System system = threeOnALine();
        setLinks(system, std::vector<double>{1, 2, 3, 2, 4, 6, .5, 1, 1.5}); // of rank one
        const auto plain = plainWords(activeMaps(system), 100);
        QVERIFY(plain && plain->keepsMeasure);
        QCOMPARE(plain->words, (Words{{0}, {1}, {2}}));
        for (std::size_t k = 0; k < 3; ++k)
            QVERIFY(std::abs(plain->weights[k] - (double(k) + 1) / 6) < 1e-14);
        setLinks(system, std::vector<double>{1, 2, 3, 2, 4, 6, .5, 1, 1});
        const auto other = plainWords(activeMaps(system), 100);
        QVERIFY(other && !other->keepsMeasure && other->words.size() == 3);
    }

    void unlinkedMapsStay() {
        System system = threeOnALine();
        system.links.clear();
        const auto plain = plainWords(activeMaps(system), 100);
        QVERIFY(plain && plain->keepsMeasure && plain->words.size() == 3);
    }

    // Each map follows all before it, so that the last is the end of 2ⁿ⁻¹ words.
    void tooManyAreNotListed() {
        constexpr std::size_t size = 12;
        System system;
        std::vector<double> links(size * size);
        for (std::size_t to = 0; to < size; ++to) {
            append(system, affineMap(.5, 0, 0, .5, double(to), 0), 1);
            for (std::size_t from = 0; from < size; ++from)
                links[from * size + to] = to == 0 || from < to ? 1 : 0;
        }
        setLinks(system, links);
        const auto active = activeMaps(system);
        QVERIFY(!plainWords(active, 2047) && hasPlainWords(active));
        const auto plain = plainWords(active, 2048);
        QVERIFY(plain && plain->words.size() == 2048);
        for (const auto& other : {threeOnALine(), dragonBoundary(), System()})
            QVERIFY(!hasPlainWords(activeMaps(other)));
        QVERIFY(hasPlainWords(activeMaps(goldenMean())));
    }

    void theRestHasNone() {
        QVERIFY(!plainWords(activeMaps(threeOnALine()), 100)); // 3 → 3 → 3 …
        QVERIFY(!plainWords(activeMaps(dragonBoundary()), 100));
        QVERIFY(!plainWords(activeMaps(System()), 100));
    }

    // R₂ = βR₁ + 1 and R₃ = βR₂ + 1 lead back to R₁, which may follow all.
    void rauzyIsThreeWords() {
        const auto plain = plainWords(activeMaps(rauzy()), 100);
        QVERIFY(plain);
        QCOMPARE(plain->words, (Words{{0}, {1, 0}, {2, 1, 0}}));
    }

    void noMoreThanAllowed() {
        QVERIFY(plainWords(activeMaps(goldenMean()), 2));
        QVERIFY(!plainWords(activeMaps(goldenMean()), 1));
    }
};

BARYCAGE_TEST(PlainWordsTest);
#include "plain_words_test.moc"
