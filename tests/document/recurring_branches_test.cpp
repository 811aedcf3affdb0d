// SPDX-License-Identifier: MIT
#include "document/edits/cage/cage_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/recurring_branches.h"
#include "document/maps/branch_handles.h"
#include "document/maps/map_solo.h"
#include "ifs/system/map_interpolation.h"
#include "support/named_test.h"

#include <QTest>

#include <array>
#include <set>

using namespace document;
using ifs::Vector, ifs::Word;

namespace {

std::shared_ptr<const Fractal> heldFractal(const Fractal& fractal) {
    return std::make_shared<const Fractal>(fractal);
}

Fractal sierpinski() {
    Fractal fractal = sierpinskiTriangle();
    plane(fractal)->cage = ifs::ControlCage<2>{{{0, 0}, {1, 0}, {0, 1}}, {{1, 1}, {3, 1.5}, {0.5, 4}}};
    return fractal;
}

MapHandles handlesOf(const Fractal& fractal, const Word& word, BranchEdit edit) {
    return branchHandles(heldFractal(fractal), *plane(fractal)->cage, word, edit)->handles;
}

constexpr std::array<std::size_t, 1> first{0};

Fractal turned(const Fractal& fractal, const Word& word, BranchEdit edit, double angle) {
    return handlesOf(fractal, word, edit).withMapsChanged(first, ifs::swung({}, {1.2, 1.7}, angle));
}

double apart(const std::vector<Vector<2>>& a, const std::vector<Vector<2>>& b) {
    double most = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
        most = std::max(most, (a[k] - b[k]).norm());
    return most;
}

bool isNear(const Box& a, const Box& b) {
    return (a.min - b.min).norm() < 1e-5 && (a.max - b.max).norm() < 1e-5;
}

} // namespace

class RecurringBranchesTest : public QObject {
    Q_OBJECT

private slots:
    // Inside the branch the branch is moved as the whole of it is, again and again; nothing beside it moves.
    void theSameBranchMovesInsideIt() {
        for (const Word& word : {Word{1}, Word{2, 0}}) {
            const Fractal before = sierpinski();
            const Fractal after = turned(before, word, BranchEdit::Inside, 0.3);
            QVERIFY(*system2(after) == *system2(before));
            QCOMPARE(plane(after)->moved.size(), 1U);
            QVERIFY(recurs(plane(after)->moved.front().word));
            QVERIFY(isMoved(after, word) && !isMoved(before, word));
            const ifs::AffineMap<2> step = recurringMap(after, word);
            const ifs::AffineMap<2> display = ifs::displayMap(*plane(after)->cage);
            ifs::AffineMap<2> made = display;
            Word inside;
            for (int n = 0; n < 5; ++n) {
                made = made * step;
                inside.insert(inside.end(), word.begin(), word.end());
                std::vector<Vector<2>> expected;
                for (const Vector<2>& corner : plane(after)->cage->rest)
                    expected.push_back(made(corner));
                QVERIFY(apart(handlesOf(after, inside, BranchEdit::Display).corners(0), expected) < 1e-9);
            }
            const Word beside = word.size() == 1 ? Word{0, 1} : Word{2, 1};
            QVERIFY(apart(handlesOf(after, beside, BranchEdit::Display).corners(0),
                          handlesOf(before, beside, BranchEdit::Display).corners(0)) == 0);
            QVERIFY(withBranchPutBack(after, word) == before);
        }
    }

    // A branch that is moved in both ways follows the pointer in either.
    void itFollowsThePointer() {
        const Word word{1}, inner{1, 1};
        Fractal fractal = turned(sierpinski(), word, BranchEdit::Inside, 0.3);
        for (const Word& branch : {word, inner, word}) {
            for (const BranchEdit edit : {BranchEdit::Display, BranchEdit::Inside, BranchEdit::Display}) {
                const MapHandles handles = handlesOf(fractal, branch, edit);
                QVERIFY(apart(handles.corners(0),
                              handlesOf(fractal, branch, BranchEdit::Display).corners(0)) < 1e-9);
                const Vector<2> offset(0.03, -0.02);
                std::vector<Vector<2>> expected = handles.corners(0);
                for (Vector<2>& corner : expected)
                    corner += offset;
                fractal = handles.withMapsMoved(first, offset);
                QVERIFY(apart(handlesOf(fractal, branch, edit).corners(0), expected) < 1e-9);
            }
        }
        QCOMPARE(plane(fractal)->moved.size(), 4U);
        QCOMPARE(plane(withBranchPutBack(fractal, word))->moved.size(), 2U);
    }

    // Where change∘w_σ does not contract, the branch itself is moved, and the picture stays bounded.
    void onlyWhatContractsGoesOn() {
        const MapHandles handles = handlesOf(sierpinski(), {1}, BranchEdit::Inside);
        const Fractal larger = handles.withMapsChanged(first, ifs::affineMap(3, 0, 0, 3, 0, 0));
        QVERIFY(ifs::spectralRadius<2>(recurringMap(larger, {1}).linear) > 1);
        QCOMPARE(movedBranches(larger).size(), 1U);
        const Fractal smaller = handles.withMapsChanged(first, ifs::affineMap(0.9, 0, 0, 0.9, 0, 0));
        QVERIFY(movedBranches(smaller).size() > 10);
    }

    // The picture stays when the code is written anew: baked, or over the cut set of another branch.
    void itStaysWhenTheCodeIsRewritten() {
        Fractal fractal = turned(sierpinski(), {1}, BranchEdit::Inside, 0.5);
        fractal = turned(fractal, {1, 1}, BranchEdit::Display, -0.4);
        fractal = turned(fractal, {2, 0}, BranchEdit::Inside, 0.7);
        const Box box = *displayedBox(fractal);
        Fractal once = fractal;
        for (auto& branch : plane(once)->moved)
            if (recurs(branch.word)) branch.word.erase(branch.word.begin());
        QVERIFY(!isNear(box, *displayedBox(once)));
        QVERIFY(isNear(box, *displayedBox(*baked(fractal))));
        for (const Word& word : {Word{0, 1}, Word{1, 2}, Word{2, 2}, Word{2, 0}, Word{1, 1}}) {
            const auto branch =
                branchHandles(heldFractal(fractal), *plane(fractal)->cage, word, BranchEdit::OwnMap);
            const std::array<std::size_t, 1> index{branch->index};
            const Fractal own = branch->handles.withMapsChanged(index, ifs::affineMap(1, 0, 0, 1, 1e-14, 0));
            QVERIFY(*system2(own) != *system2(fractal));
            QVERIFY(isNear(box, *displayedBox(own)));
            std::set<std::vector<ifs::MapId>> words;
            for (const auto& moved : plane(own)->moved)
                QVERIFY(words.insert(moved.word).second); // each once
        }
    }

    // The part that one map makes is what the whole shows of it.
    void aMapShownAloneKeepsIt() {
        const Fractal fractal = turned(sierpinski(), {1}, BranchEdit::Inside, 0.5);
        const ifs::MapId id = system2(fractal)->maps[1].id;
        const Fractal alone = soloed(fractal, id);
        std::set<std::size_t> lengths;
        for (const auto& branch : movedBranches(alone))
            lengths.insert(branch.word.size());
        QVERIFY(lengths.size() > 10 && lengths.contains(0) && lengths.contains(1));
        Fractal whole = fractal;
        const Vector<2> within = *ifs::fixedPoint<2>(recurringMap(fractal, {1}));
        for (const std::size_t index : {std::size_t(0), std::size_t(2)}) // the others, to a point of this one
            plane(whole)->moved.push_back(
                {{system2(whole)->maps[index].id}, {ifs::Matrix<2>::Zero(), within}});
        QVERIFY(isNear(*displayedBox(alone), *displayedBox(whole)));
    }
};

BARYCAGE_TEST(RecurringBranchesTest);
#include "recurring_branches_test.moc"
