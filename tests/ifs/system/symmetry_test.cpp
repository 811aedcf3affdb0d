// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/extent/support_function.h"
#include "ifs/system/iterated_function_system.h"
#include "ifs/system/symmetry.h"
#include "support/named_test.h"

#include <QtTest>

#include <Eigen/LU>

#include <algorithm>

using namespace ifs;
using namespace canonical;

namespace {

using enum SymmetryGroup;

template <int Dim> double distance(const AffineMap<Dim>& a, const AffineMap<Dim>& b) {
    return (a.linear - b.linear).norm() + (a.translation - b.translation).norm();
}

template <int Dim> double distance(const AffineMap<Dim>& a, const std::vector<AffineMap<Dim>>& maps) {
    double least = HUGE_VAL;
    for (const auto& map : maps)
        least = std::min(least, distance(a, map));
    return least;
}

// Distinct isometries that fix the centre, closed under composition: with finitely many elements, a group.
template <int Dim> void verifyGroup(const Symmetry<Dim>& symmetry) {
    QVERIFY(isValid(symmetry));
    const auto group = elements(symmetry);
    QCOMPARE(group.size(), groupOrder(symmetry.group, symmetry.order));
    QVERIFY(group.front() == AffineMap<Dim>{});
    for (std::size_t i = 0; i < group.size(); ++i) {
        QVERIFY((group[i](symmetry.centre) - symmetry.centre).norm() < 1e-13);
        QVERIFY((group[i].linear.transpose() * group[i].linear - Matrix<Dim>::Identity()).norm() < 1e-14);
        for (std::size_t j = 0; j < group.size(); ++j) {
            if (i != j) QVERIFY(distance(group[i], group[j]) > 0.1);
            QVERIFY(distance(group[i] * group[j], group) < 1e-13);
        }
    }
}

template <int Dim> std::vector<Symmetry<Dim>> everyGroup() {
    std::vector<Symmetry<Dim>> result{{Mirror}};
    for (int n = minSymmetryOrder; n <= maxSymmetryOrder; ++n) {
        result.push_back({Rotation, n});
        result.push_back({Dihedral, n});
    }
    if (Dim == 3)
        for (const SymmetryGroup group : {Tetrahedral, Octahedral, Icosahedral})
            result.push_back({group});
    return result;
}

} // namespace

class SymmetryTest : public QObject {
    Q_OBJECT

private slots:
    void everyTableIsAGroup() {
        for (Symmetry<2> symmetry : everyGroup<2>()) {
            verifyGroup(symmetry);
            symmetry.centre = {0.3, -0.7};
            symmetry.angle = 17.3;
            verifyGroup(symmetry);
        }
        for (Symmetry<3> symmetry : everyGroup<3>()) {
            verifyGroup(symmetry);
            symmetry.centre = {0.3, -0.7, 0.2};
            symmetry.angle = 30;
            verifyGroup(symmetry);
        }
    }

    void ordersOfThePolyhedra() {
        QCOMPARE(elements(Symmetry<3>{Tetrahedral}).size(), 12);
        QCOMPARE(elements(Symmetry<3>{Octahedral}).size(), 24);
        QCOMPARE(elements(Symmetry<3>{Icosahedral}).size(), 60);
        for (const SymmetryGroup group : {Tetrahedral, Octahedral, Icosahedral})
            for (const auto& element : elements(Symmetry<3>{group}))
                QVERIFY(std::abs(element.linear.determinant() - 1) < 1e-14);
    }

    // The traces of rotations tell their angles: 1 + 2 cos θ.
    void rotationsOfTheIcosahedron() {
        int third = 0, half = 0, fifth = 0;
        for (const auto& element : elements(Symmetry<3>{Icosahedral})) {
            const double trace = element.linear.trace();
            if (std::abs(trace) < 1e-12) ++third;
            if (std::abs(trace + 1) < 1e-12) ++half;
            if (std::abs(std::abs(trace - 0.5) - std::sqrt(5.0) / 2) < 1e-12) ++fifth;
        }
        QCOMPARE(third, 20);
        QCOMPARE(half, 15);
        QCOMPARE(fifth, 24);
    }

    void knownElements() {
        const auto sixth = elements(Symmetry<2>{Rotation, 6})[1].linear;
        QCOMPARE(sixth(0, 0), 0.5);
        QCOMPARE(sixth(1, 0), std::sqrt(3.0) / 2);
        const auto quarter = elements(Symmetry<2>{Rotation, 4, 0, {1, 0}})[1];
        QVERIFY(quarter == affineMap(0, -1, 1, 0, 1, -1));
        // The mirror at 45° swaps x and y.
        QVERIFY(distance(elements(Symmetry<2>{Mirror, 1, 45})[1], affineMap(0, 1, 1, 0, 0, 0)) < 1e-15);
    }

    void whatIsNotAllowed() {
        QVERIFY(!isValid(Symmetry<2>{Rotation, 1}));
        QVERIFY(!isValid(Symmetry<2>{Rotation, 25}));
        QVERIFY(!isValid(Symmetry<2>{Dihedral, -3}));
        QVERIFY(!isValid(Symmetry<2>{Mirror, 2}));
        QVERIFY(!isValid(Symmetry<2>{Octahedral}));
        QVERIFY(!isValid(Symmetry<2>{Mirror, 1, HUGE_VAL}));
        QVERIFY(!isValid(Symmetry<2>{Mirror, 1, 0, {0, std::nan("")}}));
        QVERIFY(!isValid(Symmetry<2>{Mirror, 1, 0, {0, 0}, Matrix<2>::Zero()}));
    }

    // C6 of a map is the list of its six images, and the probabilities are shared.
    void expandedIsListed() {
        IteratedFunctionSystem<2> system;
        append<2>(system, affineMap(.3, .1, -.2, .4, 1, 2), 3.0);
        append<2>(system, affineMap(.5, 0, 0, .5, 0, 1), 1.0);
        system.maps[1].enabled = false;
        append<2>(system, affineMap(.2, 0, 0, .1, 3, 1), 1.0);
        const IteratedFunctionSystem<2> plain = system;
        system.symmetry = {Rotation, 6, 0, {0.5, 0.25}};
        const auto listed = expanded(system);
        const auto group = elements(system.symmetry);
        QCOMPARE(listed.maps.size(), 18);
        QCOMPARE(listed.symmetry, Symmetry<2>{});
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t k = 0; k < 6; ++k) {
                QVERIFY(listed.maps[6 * i + k].map == group[k] * system.maps[i].map);
                QCOMPARE(listed.maps[6 * i + k].weight, *system.maps[i].weight / 6);
                QCOMPARE(listed.maps[6 * i + k].enabled, i != 1);
            }
        QCOMPARE(listed.maps[6].id, system.maps[1].id);
        const auto active = activeMaps(system), activeOfListed = activeMaps(listed);
        QCOMPARE(active.maps.size(), 12);
        QVERIFY(active.maps == activeOfListed.maps);
        QCOMPARE(active.probabilities, activeOfListed.probabilities);
        QCOMPARE(active.index, (std::vector<std::size_t>{0, 0, 0, 0, 0, 0, 2, 2, 2, 2, 2, 2}));
        QCOMPARE(probabilities(system), probabilities(plain));
        QCOMPARE(countActive(system), 12);
    }

    // Without weights the determinant rule speaks of the listed maps, not of 1 % of a crowd.
    void unweightedMapsShareTheirProbability() {
        IteratedFunctionSystem<2> system;
        append<2>(system, affineMap(.5, 0, 0, .5, 1, 2));
        append<2>(system, affineMap(0, 0, 0, .1, 0, 1));
        const auto before = probabilities(system);
        system.symmetry = {Dihedral, 24};
        const auto active = activeMaps(system);
        QCOMPARE(active.maps.size(), 96);
        QVERIFY(std::abs(active.probabilities.front() - before[0] / 48) < 1e-16);
        QVERIFY(std::abs(active.probabilities.back() - before[1] / 48) < 1e-16);
    }

    void tooManyMapsLoseTheirSymmetry() {
        IteratedFunctionSystem<3> system;
        system.maps.resize(maxSymmetricMaps / 60 + 1);
        system.symmetry = {Icosahedral};
        QCOMPARE(copiesOfEachMap(system), 1);
        QCOMPARE(expanded(system).maps.size(), system.maps.size());
        QCOMPARE(activeMaps(system).maps.size(), system.maps.size());
        system.maps.pop_back();
        QCOMPARE(copiesOfEachMap(system), 60);
        QCOMPARE(activeMaps(system).maps.size(), 60 * system.maps.size());
    }

    // γ(A) = A: the support function is the same in directions that the group turns into each other.
    void theAttractorIsInvariant() {
        Random random(5);
        for (const Symmetry<2>& group : everyGroup<2>()) {
            auto system = canonical::system<2>(randomContractions<2>(random, 2));
            system.symmetry = group;
            system.symmetry.angle = 20;
            const auto support = SupportFunction<2>::of(activeMaps(system).maps);
            QVERIFY(support.has_value());
            const Vector<2> u(0.6, 0.8);
            const auto h = (*support)(u, 1e-8);
            for (const auto& element : elements(system.symmetry)) {
                const auto image = (*support)(element.linear.transpose() * u, 1e-8);
                QVERIFY(std::abs(h.value - image.value) <= h.error + image.error + 1e-12);
            }
        }
    }

    // The group of T(A) is T∘Γ∘T⁻¹, also in a frame that keeps no angles.
    void conjugationMovesTheGroup() {
        Random random(7);
        for (int n = 0; n < 200; ++n) {
            const AffineMap<2> t{randomWellConditioned<2>(random), randomVector<2>(random, 3)};
            Symmetry<2> symmetry{Dihedral, 5, 13, {0.2, 0.4}};
            symmetry = conjugate(t, symmetry);
            for (const auto& element : elements(Symmetry<2>{Dihedral, 5, 13, {0.2, 0.4}}))
                QVERIFY(distance(*conjugate(t, element), elements(symmetry)) < 1e-10);
        }
        const AffineMap<2> turnedOver = affineMap(0, 2, 2, 0, 1, 0); // a mirror image, twice as large
        for (const Symmetry<2>& group : everyGroup<2>()) {
            Symmetry<2> symmetry = group;
            symmetry.angle = group.group == Rotation ? 0 : 7;
            symmetry.centre = {1, 2};
            const Symmetry<2> moved = conjugate(turnedOver, symmetry);
            QVERIFY(moved.frame == Matrix<2>::Identity());
            QVERIFY(moved.centre == Vector<2>(5, 2));
            for (const auto& element : elements(symmetry))
                QVERIFY(distance(*conjugate(turnedOver, element), elements(moved)) < 1e-12);
        }
        const AffineMap<3> away{Matrix<3>::Identity(), {1, 2, 3}};
        QCOMPARE(conjugate(away, Symmetry<3>{Icosahedral}).centre, Vector<3>(1, 2, 3));
        QVERIFY(conjugate(away, Symmetry<3>{Icosahedral}).frame == Matrix<3>::Identity());
    }

    void flippingIsExact() {
        const Symmetry<2> symmetry{Dihedral, 7, 11, {1, 2}};
        QCOMPARE(flipped(flipped(symmetry)), symmetry);
        for (const auto& element : elements(symmetry))
            QVERIFY(distance(flipped(element), elements(flipped(symmetry))) < 1e-13);
    }

    void liftedActsOnTheFloor() {
        const Symmetry<2> flat{Dihedral, 3, 10, {1, 2}};
        const auto group = elements(flat);
        const auto solid = elements(lifted(flat));
        for (std::size_t i = 0; i < group.size(); ++i)
            for (const double z : {0.0, 2.0}) {
                const Vector<3> image = solid[i](Vector<3>(0.3, 0.4, z));
                QVERIFY((image.head<2>() - group[i](Vector<2>(0.3, 0.4))).norm() < 1e-14);
                QCOMPARE(image.z(), z);
            }
    }

    void recognisedFromItsElements() {
        for (Symmetry<2> symmetry : everyGroup<2>()) {
            symmetry.angle = symmetry.group == Rotation ? 0 : 5;
            symmetry.centre = {0.5, -0.25};
            auto group = elements(symmetry);
            std::ranges::reverse(group);
            const Symmetry<2> found = symmetryOf(group, 1e-9);
            QCOMPARE(found.group, symmetry.group);
            QCOMPARE(found.order, symmetry.order);
            for (const auto& element : elements(found))
                QVERIFY(distance(element, group) < 1e-12);
            group.pop_back();
            if (group.size() > 2) QCOMPARE(symmetryOf(group, 1e-9).group, None);
        }
        QCOMPARE(symmetryOf({AffineMap<2>{}, affineMap(.5, 0, 0, .5, 0, 0)}, 1e-9).group, None);
        QCOMPARE(symmetryOf({}, 1e-9).group, None);
    }
};

BARYCAGE_TEST(SymmetryTest);
#include "symmetry_test.moc"
