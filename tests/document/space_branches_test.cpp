// SPDX-License-Identifier: MIT
#include "document/branches/shown_branch.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/maps/branch_handles.h"
#include "ifs/cage/cage_surface.h"
#include "ifs/system/branch.h"
#include "ifs/system/links.h"
#include "support/named_test.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>

using namespace document;
using ifs::Vector;
using Corners = SpaceMapHandles::Corners;

namespace {

// Four pieces in the corners of a tetrahedron, turned a little so that no two maps are alike.
Fractal fourPieces() {
    Fractal fractal;
    Shape<3> shape;
    for (int k = 0; k < 4; ++k) {
        ifs::AffineMap<3> map;
        map.linear = 0.4 * Eigen::AngleAxisd(0.1 * k, Vector<3>::UnitY()).toRotationMatrix();
        map.translation = k == 0 ? Vector<3>::Zero().eval() : Vector<3>::Unit(k - 1).eval();
        ifs::append<3>(shape.system, map, 0.1 + 0.1 * k);
    }
    shape.cage = ifs::ControlCage<3>{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}},
                                     {{1, 0, 0}, {3, 0.5, 0}, {1, 2.5, 0.5}, {0.5, 0, 3}}};
    fractal.shape = shape;
    return fractal;
}

std::shared_ptr<const Fractal> heldInSpace(const Fractal& fractal) {
    return std::make_shared<const Fractal>(fractal);
}

const ifs::ControlCage<3>& cageOf(const Fractal& fractal) {
    return *space(fractal)->cage;
}

Corners seen(const Fractal& fractal, const ifs::Word& branch) {
    return *SpaceMapHandles(heldInSpace(fractal), cageOf(fractal)).corners(branch);
}

constexpr std::array edits{BranchEdit::OwnMap, BranchEdit::LastMap, BranchEdit::Display, BranchEdit::Inside};

// A box around it of which one corner is pulled out.
void bendIn(Fractal& fractal) {
    ifs::ControlCage<3> cage;
    for (int k = 0; k < 8; ++k)
        cage.rest.emplace_back((k & 1) != 0 ? 2.0 : -1.0, (k & 2) != 0 ? 2.0 : -1.0,
                               (k & 4) != 0 ? 2.0 : -1.0);
    cage.current = cage.rest;
    cage.current[7] += Vector<3>(1, 0.5, -0.3);
    space(fractal)->cage = cage;
}

double farthest(const Corners& a, const Corners& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, (a[i] - b[i]).norm());
    return most;
}

} // namespace

class SpaceBranchesTest : public QObject {
    Q_OBJECT

private slots:
    void aBranchIsSeenUnderTheProductOfItsMaps() {
        const Fractal fractal = fourPieces();
        const auto& maps = system3(fractal)->maps;
        const ifs::AffineMap<3> placed = ifs::displayMap(cageOf(fractal));
        const Corners corners = seen(fractal, {2, 1});
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vector<3> image = placed(maps[2].map(maps[1].map(cageOf(fractal).rest[i])));
            QVERIFY((corners[i] - image).norm() < 1e-13);
        }
        QVERIFY(!SpaceMapHandles(heldInSpace(fractal), cageOf(fractal)).corners(ifs::Word{0, 4}));
    }

    // As a map of its own, a branch is moved alone; its neighbours and the attractor's other points stay.
    void aBranchBecomesTheFirstMap() {
        Fractal fractal = fourPieces();
        const ifs::MapId third = system3(fractal)->maps[2].id;
        fractal.appearance.mapColours[third] = {1, 2, 3};
        const auto branch = branchHandles(heldInSpace(fractal), cageOf(fractal), {2, 1}, BranchEdit::OwnMap);
        QVERIFY(branch);
        QCOMPARE(branch->index, std::size_t(0));
        QCOMPARE(branch->handles.count(), std::size_t(7));
        QVERIFY(farthest(branch->handles.corners(0), seen(fractal, {2, 1})) < 1e-12);

        const Vector<3> by(0.02, -0.01, 0.03);
        const Fractal after = branch->handles.withCornersMoved(
            0, {Vector<3>::Zero(), by, Vector<3>::Zero(), Vector<3>::Zero()});
        Corners wanted = seen(fractal, {2, 1});
        wanted[1] += by;
        QVERIFY(farthest(seen(after, {0}), wanted) < 1e-12);
        const auto& maps = system3(after)->maps;
        QCOMPARE(maps.size(), std::size_t(7));
        QVERIFY(attractor::mapColour(after.appearance, maps[0].id, 0) == (attractor::Rgba{1, 2, 3}));
        double sum = 0, before = 0;
        for (const auto& map : maps)
            sum += map.weight.value_or(0);
        for (const auto& map : system3(fractal)->maps)
            before += map.weight.value_or(0);
        QVERIFY(std::abs(sum - 1) < 1e-12 && std::abs(before - 1) < 1e-12);
        // With the branch where it was, the attractor is that of before.
        Fractal unmoved = after;
        const auto& old = system3(fractal)->maps;
        system3(unmoved)->maps[0].map = old[2].map * old[1].map;
        const auto reach = spaceSupport(fractal), same = spaceSupport(unmoved);
        QVERIFY(reach && same);
        for (const Vector<3>& u : {Vector<3>(1, 0, 0), Vector<3>(-1, 2, 0.5), Vector<3>(0.3, -1, -2)})
            QVERIFY(std::abs((*reach)(u, 1e-10).value - (*same)(u, 1e-10).value) < 1e-8);
    }

    // The system keeps its maps; what is pulled on the screen is the branch.
    void theLastMapOfAnAddressIsMoved() {
        const Fractal fractal = fourPieces();
        const auto branch =
            branchHandles(heldInSpace(fractal), cageOf(fractal), {2, 0, 1}, BranchEdit::LastMap);
        QVERIFY(branch);
        QCOMPARE(branch->index, std::size_t(1));
        const Corners before = seen(fractal, {2, 0, 1});
        QVERIFY(farthest(branch->handles.corners(1), before) < 1e-12);
        const Vector<3> by(0.01, 0.02, -0.01);
        const Fractal after = branch->handles.withCornersMoved(
            1, {Vector<3>::Zero(), Vector<3>::Zero(), by, Vector<3>::Zero()});
        Corners wanted = before;
        wanted[2] += by;
        QVERIFY(farthest(seen(after, {2, 0, 1}), wanted) < 1e-12);
        for (std::size_t i = 0; i < 4; ++i)
            QCOMPARE(system3(after)->maps[i].map == system3(fractal)->maps[i].map, i != 1);
    }

    // Branches that are moved in the file stay what they were, over the new maps.
    void movedBranchesAreKept() {
        Fractal fractal = fourPieces();
        const auto& old = system3(fractal)->maps;
        const ifs::AffineMap<3> change{ifs::Matrix<3>::Identity(), Vector<3>(1, 2, 3)};
        space(fractal)->moved = {{{old[2].id, old[1].id, old[3].id}, change}};
        const auto branch = branchHandles(heldInSpace(fractal), cageOf(fractal), {2, 1}, BranchEdit::OwnMap);
        const Fractal after = branch->handles.withCornersMoved(
            0, {Vector<3>::Constant(0.01), Vector<3>::Zero(), Vector<3>::Zero(), Vector<3>::Zero()});
        const auto moved = movedBranches(*space(after));
        QCOMPARE(moved.size(), std::size_t(1));
        QVERIFY(moved[0].change == change);
        const auto maps = ifs::mapsOf(*system3(after));
        QCOMPARE(moved[0].word.front(), 0);
        QVERIFY((maps[std::size_t(moved[0].word.back())].linear - old[3].map.linear).norm() < 1e-15);
    }

    // Only here: the code stays, the branch goes where it is pulled, again and again, and can be put back.
    void aBranchIsShownElsewhere() {
        const Fractal fractal = fourPieces();
        const ifs::Word word{2, 1};
        const auto branch = branchHandles(heldInSpace(fractal), cageOf(fractal), word, BranchEdit::Display);
        QVERIFY(branch);
        QCOMPARE(branch->handles.count(), std::size_t(1));
        const Vector<3> by(0.3, -0.2, 0.4);
        const Fractal once = branch->handles.withCornersMoved(
            0, {Vector<3>::Zero(), by, Vector<3>::Zero(), Vector<3>::Zero()});
        Corners wanted = seen(fractal, word);
        wanted[1] += by;
        QVERIFY(farthest(seen(once, word), wanted) < 1e-12);
        QVERIFY(isSameSystem(once, fractal));
        QCOMPARE(space(once)->moved.size(), std::size_t(1));
        // What is in it goes along, what is beside it stays.
        QVERIFY(farthest(seen(once, {2, 1, 0}), seen(fractal, {2, 1, 0})) > 0.01);
        QVERIFY(farthest(seen(once, {2, 0}), seen(fractal, {2, 0})) == 0);
        const auto again = branchHandles(heldInSpace(once), cageOf(once), word, BranchEdit::Display);
        const Fractal twice = again->handles.withCornersMoved(0, {by, by, by, by});
        for (Vector<3>& corner : wanted)
            corner += by;
        QVERIFY(farthest(seen(twice, word), wanted) < 1e-12);
        QCOMPARE(space(twice)->moved.size(), std::size_t(1));
        QVERIFY(isMoved(twice, word) && !isMoved(twice, {2}) && !isMoved(fractal, word));
        QVERIFY(withBranchPutBack(twice, word) == fractal);
        QVERIFY(withBranchPutBack(twice, {2}) == twice);
        // A part of it is pulled where it is shown.
        const auto part = branchHandles(heldInSpace(twice), cageOf(twice), {2, 1, 3}, BranchEdit::LastMap);
        Corners partly = seen(twice, {2, 1, 3});
        const Fractal after = part->handles.withCornersMoved(
            3, {Vector<3>::Zero(), Vector<3>::Zero(), 0.1 * by, Vector<3>::Zero()});
        partly[2] += 0.1 * by;
        QVERIFY(farthest(seen(after, {2, 1, 3}), partly) < 1e-12);
    }

    // Here and inside it: the branch in the branch moves alike.
    void aBranchMovesInsideItself() {
        const Fractal fractal = fourPieces();
        const auto branch = branchHandles(heldInSpace(fractal), cageOf(fractal), {3}, BranchEdit::Inside);
        const Vector<3> by(0.1, 0.2, -0.1);
        const Fractal after = branch->handles.withCornersMoved(0, {by, by, by, by});
        const auto& map = system3(fractal)->maps[3].map;
        const ifs::AffineMap<3> step = recurringMap(*space(after), {3});
        QVERIFY((step.linear - map.linear).norm() < 1e-12);
        const ifs::AffineMap<3> placed = ifs::displayMap(cageOf(after));
        Corners inner;
        for (std::size_t i = 0; i < inner.size(); ++i)
            inner[i] = placed(step(step(cageOf(after).rest[i])));
        QVERIFY(farthest(seen(after, {3, 3}), inner) < 1e-12);
        QVERIFY(farthest(seen(fractal, {3, 3}), inner) > 0.1);
        QVERIFY(isSameSystem(after, fractal));
        QVERIFY(isMoved(after, {3}));
        QVERIFY(withBranchPutBack(after, {3}) == fractal);
    }

    // Where the cage bends, what is pulled goes along as well.
    void branchesBendWithTheCage() {
        Fractal fractal = fourPieces();
        bendIn(fractal);
        const ifs::CageDeformation bend(cageOf(fractal).rest, cageOf(fractal).current);
        // Every other corner of the box.
        const auto& box = cageOf(fractal).rest;
        const Corners rest{box[0], box[3], box[6], box[5]};
        const auto& maps = system3(fractal)->maps;
        const Corners before = seen(fractal, {2, 1});
        for (std::size_t i = 0; i < rest.size(); ++i)
            QVERIFY((before[i] - bend(maps[2].map(maps[1].map(rest[i])))).norm() < 1e-12);
        const Vector<3> by(0.02, -0.03, 0.01);
        for (const BranchEdit edit : edits) {
            const auto branch = branchHandles(heldInSpace(fractal), cageOf(fractal), {2, 1}, edit);
            QVERIFY(branch && branch->handles.canBeMoved());
            const Fractal after = branch->handles.withCornersMoved(
                branch->index, {Vector<3>::Zero(), Vector<3>::Zero(), by, Vector<3>::Zero()});
            Corners wanted = before;
            wanted[2] += by;
            const Corners is = seen(after, edit == BranchEdit::OwnMap ? ifs::Word{0} : ifs::Word{2, 1});
            QVERIFY2(farthest(is, wanted) < 1e-7, qPrintable(QString::number(farthest(is, wanted))));
        }
    }

    // A map turns about the image of the lowest point, as it is seen.
    void aMapSwingsAboutItsRoot() {
        const Fractal fractal = fourPieces();
        const Vector<3> up = Vector<3>(0, 1, 0), axis = Vector<3>(1, 2, 2) / 3;
        const auto root = rootInSpace(fractal, up);
        QVERIFY(root);
        const Extent height = extentAlong(fractal, up);
        const ifs::AffineMap<3> placed = ifs::displayMap(cageOf(fractal));
        QVERIFY(std::abs(placed(*root).y() - height.low) < 1e-6);
        const SpaceMapHandles handles(heldInSpace(fractal), cageOf(fractal));
        const std::vector<std::size_t> second{2};
        const Fractal swung = handles.withMapsSwung(second, *root, axis, 0.3);
        const ifs::AffineMap<3>& was = system3(fractal)->maps[2].map;
        const ifs::AffineMap<3>& is = system3(swung)->maps[2].map;
        QVERIFY((is(*root) - was(*root)).norm() < 1e-12);
        const Vector<3> before = placed(was({1, 1, 0})) - placed(was(*root));
        const Vector<3> after = placed(is({1, 1, 0})) - placed(is(*root));
        QVERIFY(std::abs(after.norm() - before.norm()) < 1e-12);
        QVERIFY(std::abs((after - before).dot(axis)) < 1e-12);
        const Vector<3> across = before - before.dot(axis) * axis;
        QVERIFY(std::abs(axis.dot(before.cross(after)) - std::sin(0.3) * across.squaredNorm()) < 1e-12);
        QVERIFY(handles.withMapsSwung(second, *root, axis, 0) == fractal);
        QVERIFY(system3(swung)->maps[1].map == system3(fractal)->maps[1].map);
        // Of several, each about its own root.
        const std::vector<std::size_t> first{1}, both{1, 2};
        const Fractal turned = handles.withMapsSwung(both, *root, axis, 0.3);
        const auto& together = system3(turned)->maps;
        QVERIFY(together[2].map == is);
        const Fractal alone = handles.withMapsSwung(first, *root, axis, 0.3);
        QVERIFY(together[1].map == system3(alone)->maps[1].map);
        QVERIFY(together[0].map == system3(fractal)->maps[0].map);
    }

    void whatCannotBeMoved() {
        Fractal fractal = fourPieces();
        const auto taken = [&](const ifs::Word& word, BranchEdit edit) {
            return branchHandles(heldInSpace(fractal), cageOf(fractal), word, edit).has_value();
        };
        for (const BranchEdit edit : edits)
            QVERIFY(!taken({}, edit));
        system3(fractal)->maps[1].weight = 0; // takes no part
        for (const BranchEdit edit : edits) {
            QVERIFY(!taken({2, 1}, edit));
            QVERIFY(taken({2, 3}, edit));
        }
        fractal = fourPieces();
        const auto& maps = system3(fractal)->maps;
        system3(fractal)->links = {{maps[0].id, maps[1].id, 0.5}};
        QVERIFY(!taken({2, 1}, BranchEdit::OwnMap));
        QVERIFY(taken({2, 1}, BranchEdit::LastMap));
        QVERIFY(taken({2}, BranchEdit::OwnMap)); // it is one already
    }
};

BARYCAGE_TEST(SpaceBranchesTest);
#include "space_branches_test.moc"
