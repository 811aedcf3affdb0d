// SPDX-License-Identifier: MIT
#include "ifs/branch.h"
#include "ifs/canonical_systems.h"
#include "ifs/support_function.h"

#include <QtTest>

#include <numbers>

using namespace ifs;
using namespace canonical;

namespace {

void isNear(const std::optional<Vector<2>>& point, double x, double y) {
    QVERIFY(point && (*point - Vector<2>(x, y)).norm() < 1e-15 * 8);
}

} // namespace

class BranchTest : public QObject {
    Q_OBJECT

private slots:
    // The first symbol is the outermost map.
    void orderOfComposition() {
        const auto tree = maple();
        const Vector<2> image = composed<2>(tree, {3, 2, 1, 0})(Vector<2>::Zero());
        QVERIFY((image - Vector<2>(-0.04371984, 2.06404832)).norm() < 1e-15);
        isNear(addressPoint<2>(tree, {}, {0, 1, 2, 3}), -0.096822217864951205, -2.130418821464332372);
        isNear(addressPoint<2>(tree, {}, {3, 2, 1, 0}), -0.059093142881194517, 1.941945677813030930);
        isNear(addressPoint<2>(tree, {}, {2, 3}), 0.953444691594398769, 1.148102263768442392);
        isNear(addressPoint<2>(tree, {}, {3, 2}), -0.294226076510117506, 1.395488418365431543);
        isNear(addressPoint<2>(tree, {3}, {2, 3}), -0.294226076510117506, 1.395488418365431543);
        isNear(addressPoint<2>(flower(), {}, {0, 1}), 1.112817512366475760, 3.863734805287719140);
        isNear(addressPoint<2>(flower(), {}, {1, 0}), -0.926330687597530186, 3.927309785124383157);
        QVERIFY(!addressPoint<2>(Maps2{{}}, {}, {0}));
    }

    void cutSets() {
        QCOMPARE(cutSet({0, 1}, 3), (std::vector<Word>{{0, 1}, {0, 0}, {0, 2}, {1}, {2}}));
        QCOMPARE(cutSet({}, 3), (std::vector<Word>{{}}));
        Random random(1);
        for (int n = 0; n < 100; ++n) {
            const std::size_t maps = 1 + random() % 5;
            Word word;
            for (std::size_t length = random() % 6; length > 0; --length)
                word.push_back(int(random() % maps));
            const auto words = cutSet(word, maps);
            QCOMPARE(words.size(), word.size() * (maps - 1) + 1);
            Word address; // every long address begins with exactly one of them
            for (int k = 0; k < 8; ++k)
                address.push_back(k < int(word.size()) && random() % 2 ? word[std::size_t(k)]
                                                                       : int(random() % maps));
            QCOMPARE(
                std::ranges::count_if(
                    words, [&](const Word& w) { return std::equal(w.begin(), w.end(), address.begin()); }),
                1);
        }
    }

    void anUnchangedBranchChangesNothing() {
        const auto system = canonical::system<2>(maple(), {1, 2, 3, 4});
        const auto before = *SupportFunction<2>::of(maple());
        for (const Word& branch : {Word{}, Word{2}, Word{1, 3, 0}}) {
            const auto same = withBranchChanged<2>(system, branch, {});
            QVERIFY(std::abs(std::accumulate(same.maps.begin(), same.maps.end(), -1.0,
                                             [](double sum, const auto& map) { return sum + *map.weight; })) <
                    1e-15);
            if (branch.empty()) continue; // the identity alone has no attractor
            const auto after = *SupportFunction<2>::of(mapsOf(same));
            for (int k = 0; k < 16; ++k) {
                const double angle = k * std::numbers::pi / 8;
                const Vector<2> u(std::cos(angle), std::sin(angle));
                QVERIFY(std::abs(before(u).value - after(u).value) < 1e-12);
            }
        }
    }

    // Only the branch changes: w_σ becomes change∘w_σ, the rest of the cut set stays; maps that are off do
    // not count.
    void changesOneBranch() {
        auto system = canonical::system<2>(maple());
        system.maps[0].enabled = false;
        const AffineMap<2> change = similarity(1, 0.3, 0.1, 0.2);
        const auto changed = withBranchChanged<2>(system, {0, 2}, change); // of maps 2, 3, 4
        QCOMPARE(changed.maps.size(), std::size_t(5));
        QCOMPARE(changed.maps[0].map, change * (maple()[1] * maple()[3]));
        QCOMPARE(changed.maps[1].map, maple()[1] * maple()[1]);
        QCOMPARE(changed.maps[3].map, maple()[2]);
        const auto p = activeMaps(system).probabilities;
        QCOMPARE(*changed.maps[0].weight, p[0] * p[2]);
        QCOMPARE(*changed.maps[4].weight, p[2]);
    }
};

QTEST_APPLESS_MAIN(BranchTest)
#include "branch_test.moc"
