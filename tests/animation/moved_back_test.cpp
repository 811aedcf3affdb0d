// SPDX-License-Identifier: MIT
#include "animation/keys/key_edits.h"
#include "animation/motions/motion_presets.h"
#include "animation/motions/moved_back.h"
#include "support/named_test.h"

#include <QtTest>

#include <random>

using namespace animation;

namespace {

template <int Dim> ifs::IteratedFunctionSystem<Dim> randomSystem(std::mt19937& random) {
    std::uniform_real_distribution<double> number(-0.6, 0.6);
    ifs::IteratedFunctionSystem<Dim> system;
    for (int i = 0; i < 4; ++i) {
        ifs::AffineMap<Dim> map;
        for (int k = 0; k < Dim * Dim; ++k)
            map.linear(k) = number(random);
        for (int k = 0; k < Dim; ++k)
            map.translation(k) = number(random);
        ifs::append(system, map, 0.25);
    }
    return system;
}

template <int Dim> std::vector<Motion<Dim>> allMotions() {
    const ifs::Vector<Dim> root = ifs::Vector<Dim>::Constant(0.25);
    return {swayOf<Dim>(swayPresets()[2], {}, root), Turn<Dim>{{ifs::MapId(2)}, 3, root},
            Breathe<Dim>{{}, 0.4, 2, root}, Orbit<Dim>{}, PaletteCycle{}};
}

template <int Dim> void movesBack() {
    std::mt19937 random(7);
    const std::vector<Motion<Dim>> motions = allMotions<Dim>();
    constexpr int length = 36;
    for (int frame = 0; frame < length; ++frame) {
        const auto still = randomSystem<Dim>(random);
        auto moved = still;
        for (const Motion<Dim>& motion : motions)
            moveMaps<Dim>(motion, moment(frame), length, moved);
        const auto back = movedBack<Dim>(motions, moment(frame), length, moved);
        for (std::size_t i = 0; i < still.maps.size(); ++i) {
            const auto &a = still.maps[i].map, &b = back.maps[i].map;
            QVERIFY((a.linear - b.linear).norm() + (a.translation - b.translation).norm() < 1e-12);
        }
        if (frame != 0) QVERIFY(moved.maps[1].map != still.maps[1].map);
    }
}

} // namespace

class MovedBackTest : public QObject {
    Q_OBJECT

private slots:
    void undoesMotionsOfThePlane() { movesBack<2>(); }
    void undoesMotionsInSpace() { movesBack<3>(); }

    void leavesTheBitsOfWhatStands() {
        std::mt19937 random(3);
        const auto system = randomSystem<2>(random);
        const std::vector<Motion<2>> one{Turn<2>{{ifs::MapId(2)}, 1}};
        const auto back = movedBack<2>(one, moment(5), 12, system);
        QCOMPARE(back.maps[0].map, system.maps[0].map);
        QVERIFY(back.maps[1].map != system.maps[1].map);
        QCOMPARE(movedBack<2>(one, moment(0), 12, system), system);
    }

    void turnsTheCageBack() {
        auto cage = ifs::polygonAtRest<2>({{0, 0}, {1, 0}, {0, 1}});
        const auto rest = cage;
        const std::vector<Motion<2>> orbit{Orbit<2>{1, {2, 3}}};
        turnCage(cage, {2, 3}, orbitAngle<2>(orbit[0], moment(5), 12));
        QVERIFY((cage.current[0] - rest.current[0]).norm() > 1);
        turnBack(orbit, moment(5), 12, cage);
        for (int i = 0; i < 3; ++i)
            QVERIFY((cage.current[i] - rest.current[i]).norm() < 1e-12);
    }

    void keysAreSetInOrder() {
        Keys<double> keys;
        setFirstKey(keys, 8, 1.5);
        QCOMPARE(keys, (Keys<double>{{0, 1.5, {Ease::Kind::Both}}, {8, 1.5, {Ease::Kind::Both}}}));
        keys[0].ease = {Ease::Kind::Hold};
        setKey(keys, 4, 2.0); // as the key before it
        setKey(keys, 8, 3.0); // which keeps its ease
        QCOMPARE(keys, (Keys<double>{{0, 1.5, {Ease::Kind::Hold}},
                                     {4, 2.0, {Ease::Kind::Hold}},
                                     {8, 3.0, {Ease::Kind::Both}}}));
        Keys<double> atStart;
        setFirstKey(atStart, 0, 7.0);
        QCOMPARE(atStart.size(), std::size_t(1));
    }
};

BARYCAGE_TEST(MovedBackTest);
#include "moved_back_test.moc"
