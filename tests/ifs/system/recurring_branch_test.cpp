// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/extent/support_function.h"
#include "ifs/system/recurring_branch.h"
#include "support/named_test.h"

#include <QtTest>

#include <numbers>

using namespace ifs;
using namespace canonical;

namespace {

// h of what is shown of A, which moved branches show elsewhere.
double height(const SupportFunction<2>& whole, const std::vector<AffineMap<2>>& pieces, const Vector<2>& u) {
    double farthest = -HUGE_VAL;
    for (const AffineMap<2>& map : pieces)
        farthest = std::max(farthest, whole(map.linear.transpose() * u).value + u.dot(map.translation));
    return farthest;
}

std::vector<AffineMap<2>> piecesOf(const MovedBranch<2>& branch, const Maps2& maps) {
    return pieceMaps<2>(pieces<2>(recurring<2>(branch, maps), maps.size()), maps);
}

} // namespace

class RecurringBranchTest : public QObject {
    Q_OBJECT

private slots:
    // M = change(w_σ(M)) ∪ w_τ(A), and no other set: the first change alone is another one.
    void isTheSetOfItsEquation_data() {
        QTest::addColumn<Word>("word");
        QTest::newRow("one map") << Word{3};
        QTest::newRow("two maps") << Word{1, 3};
        QTest::newRow("three maps") << Word{2, 0, 1};
    }
    void isTheSetOfItsEquation() {
        QFETCH(Word, word);
        const Maps2 maps = maple();
        const auto whole = *SupportFunction<2>::of(maps);
        const AffineMap<2> change = similarity(0.95, 0.6, 4, 1);
        const AffineMap<2> step = change * composed<2>(maps, word);
        const std::vector<AffineMap<2>> shown = piecesOf({word, change}, maps);
        std::vector<AffineMap<2>> inside;
        for (const AffineMap<2>& piece : shown)
            inside.push_back(step * piece);
        std::vector<AffineMap<2>> beside;
        for (const Word& other : cutSet(word, maps.size()))
            if (other != word) beside.push_back(composed<2>(maps, other));
        double once = 0;
        std::vector<MovedBranch<2>> first{{word, change}};
        const auto shownOnce = pieceMaps<2>(pieces<2>(first, maps.size()), maps);
        for (int k = 0; k < 64; ++k) {
            const double angle = k * std::numbers::pi / 32;
            const Vector<2> u(std::cos(angle), std::sin(angle));
            const double expected = std::max(height(whole, inside, u), height(whole, beside, u));
            QVERIFY(std::abs(height(whole, shown, u) - expected) < 1e-5);
            once = std::max(once, std::abs(height(whole, inside, u) - (height(whole, {step}, u))));
        }
        QVERIFY(once > 1e-3);
        QCOMPARE(shownOnce.size(), word.size() * (maps.size() - 1) + 1);
    }

    // The n-th piece is made by n steps and the words that leave the branch.
    void itsPiecesAreItsSteps() {
        const Maps2 maps = maple();
        const MovedBranch<2> branch{{2}, similarity(0.9, 1, 3, -1)};
        const AffineMap<2> step = branch.change * maps[2];
        const auto words = pieces<2>(recurring<2>(branch, maps), maps.size());
        const auto made = pieceMaps<2>(words, maps);
        std::size_t longest = 0;
        for (std::size_t i = 0; i < words.size(); ++i) {
            AffineMap<2> expected;
            std::size_t n = 0;
            for (; n < words[i].word.size() && words[i].word[n] == 2; ++n)
                expected = expected * step;
            for (std::size_t k = n; k < words[i].word.size(); ++k)
                expected = expected * maps[std::size_t(words[i].word[k])];
            longest = std::max(longest, n);
            QVERIFY((made[i].linear - expected.linear).norm() < 1e-7);
            QVERIFY((made[i].translation - expected.translation).norm() < 1e-6);
        }
        QVERIFY(longest > 5);
        AffineMap<2> rest; // what is left out
        for (std::size_t n = 0; n < longest; ++n)
            rest = step * rest;
        QVERIFY(spectralNorm<2>(rest.linear) <= 1e-7);
    }

    void anUnchangedOneChangesNothing() {
        const auto whole = *SupportFunction<2>::of(maple());
        const std::vector<AffineMap<2>> shown = piecesOf({{1, 2}, {}}, maple());
        for (int k = 0; k < 16; ++k) {
            const double angle = k * std::numbers::pi / 8;
            const Vector<2> u(std::cos(angle), std::sin(angle));
            QVERIFY(std::abs(height(whole, shown, u) - whole(u).value) < 1e-9);
        }
    }

    // Where there is no such set, or none that can be given, the branch itself is moved.
    void othersAreMovedOnce() {
        const Maps2 maps = maple();
        const auto countOf = [](const MovedBranch<2>& branch, const Maps2& of) {
            return recurring<2>(branch, of).size();
        };
        QCOMPARE(countOf({{0}, similarity(50, 0, 0, 0)}, maps), 1U); // does not contract
        QCOMPARE(countOf({{}, similarity(0.5, 0, 0, 0)}, maps), 1U);
        Maps2 flat = maps;
        flat[1] = affineMap(0.5, 0, 0, 0, 0, 0);
        QCOMPARE(countOf({{1}, similarity(0.9, 0.1, 0, 0)}, flat), 1U);
        QVERIFY(countOf({{0}, similarity(0.9, 0.1, 0, 0)}, flat) > 1);
        // Slow ones end, and numbers stay finite.
        const Maps2 slow{similarity(0.999, 0.1, 0, 0), affineMap(0.9, 0, 0, 1e-3, 0, 0)};
        for (const Word& word : {Word{0}, Word{1}, Word{0, 1}}) {
            const auto branches = recurring<2>({word, similarity(1, 0.2, 1, 0)}, slow);
            QVERIFY(branches.back().word.size() <= 256);
            for (const auto& branch : branches)
                QVERIFY(isFinite<2>(branch.change));
        }
    }
};

BARYCAGE_TEST(RecurringBranchTest);
#include "recurring_branch_test.moc"
