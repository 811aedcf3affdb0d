// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/extent/support_function.h"
#include "ifs/system/branch.h"
#include "support/named_test.h"

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

    // The chance of a long word may be nothing in doubles.
    void unlikelyBranchesTakePart() {
        const auto system = canonical::system<2>(maple(), {1e-9, 1, 1, 1});
        const auto same = withBranchChanged<2>(system, Word(60, 0), {});
        QCOMPARE(activeMaps(same).maps.size(), same.maps.size());
    }

    // Unmoved branches leave the attractor: max of the pieces' support values is the whole's.
    void piecesMakeUpTheWhole() {
        const auto whole = *SupportFunction<2>::of(maple());
        for (const std::vector<MovedBranch<2>>& moved :
             {std::vector<MovedBranch<2>>{}, {{{2}, {}}}, {{{1, 3, 0}, {}}, {{1}, {}}, {{0, 0}, {}}}}) {
            const auto parts = pieces<2>(moved, 4);
            for (int k = 0; k < 16; ++k) {
                const double angle = k * std::numbers::pi / 8;
                const Vector<2> u(std::cos(angle), std::sin(angle));
                double farthest = -HUGE_VAL;
                for (const auto& [word, change] : parts) {
                    const AffineMap<2> map = change * composed<2>(maple(), word);
                    farthest =
                        std::max(farthest, whole(map.linear.transpose() * u).value + u.dot(map.translation));
                }
                QVERIFY(std::abs(farthest - whole(u).value) < 1e-12);
            }
        }
    }

    // Every address begins with exactly one piece, which moves by what all its beginnings are moved by, the
    // outermost last.
    void piecesMoveByTheirBeginnings() {
        Random random(7);
        for (int trial = 0; trial < 100; ++trial) {
            const std::size_t maps = 1 + random() % 4;
            const auto word = [&](std::size_t length) {
                Word result;
                while (result.size() < length)
                    result.push_back(int(random() % maps));
                return result;
            };
            std::vector<MovedBranch<2>> moved;
            for (std::size_t n = random() % 4; n > 0; --n)
                moved.push_back({word(random() % 5), similarity(0.9, double(n), double(trial), 1)});
            const auto parts = pieces<2>(moved, maps);
            std::size_t most = 1;
            for (const auto& branch : moved)
                most += (maps - 1) * branch.word.size();
            QVERIFY(parts.size() <= most);
            for (int n = 0; n < 20; ++n) {
                const Word address = word(6);
                const auto begins = [&](const MovedBranch<2>& branch) {
                    return std::equal(branch.word.begin(), branch.word.end(), address.begin());
                };
                QCOMPARE(std::ranges::count_if(parts, begins), 1);
                AffineMap<2> expected;
                for (std::size_t length = 0; length < 5; ++length)
                    for (const auto& branch : moved)
                        if (branch.word.size() == length && begins(branch))
                            expected = expected * branch.change;
                QVERIFY(begins(pieceOf<2>(parts, address)));
                QCOMPARE(pieceOf<2>(parts, address).change, expected);
            }
            for (const auto& part : pieces<2>(moved, maps, 2))
                QVERIFY(part.word.size() <= 2);
        }
    }

    // An address begins with a word if and only if the same address over the cut set begins with one of the
    // words that stand for it.
    void wordsOverACutSet() {
        QCOMPARE(overCutSet({0}, {0, 1}, 3), (std::vector<Word>{{0}, {1}, {2}}));
        QCOMPARE(overCutSet({0, 1, 2}, {0, 1}, 3), (std::vector<Word>{{0, 4}}));
        QCOMPARE(overCutSet({}, {0, 1}, 3), (std::vector<Word>{{}}));
        Random random(3);
        for (int trial = 0; trial < 200; ++trial) {
            const std::size_t maps = 2 + random() % 3;
            const auto word = [&](std::size_t length) {
                Word result;
                while (result.size() < length)
                    result.push_back(int(random() % maps));
                return result;
            };
            const Word branch = word(1 + random() % 3);
            const Word moved = word(random() % 6);
            const auto set = cutSet(branch, maps);
            const auto standIns = overCutSet(moved, branch, maps);
            for (int n = 0; n < 30; ++n) {
                Word over; // a random address over the cut set, spelled over the maps too
                Word address;
                while (over.size() < 8) {
                    over.push_back(int(random() % set.size()));
                    address.insert(address.end(), set[std::size_t(over.back())].begin(),
                                   set[std::size_t(over.back())].end());
                }
                const bool begins = std::equal(moved.begin(), moved.end(), address.begin());
                QCOMPARE(std::ranges::count_if(
                             standIns,
                             [&](const Word& w) { return std::equal(w.begin(), w.end(), over.begin()); }),
                         begins ? 1 : 0);
            }
        }
    }
};

BARYCAGE_TEST(BranchTest);
#include "branch_test.moc"
