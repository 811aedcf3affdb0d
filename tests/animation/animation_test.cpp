// SPDX-License-Identifier: MIT
#include "animation/animation.h"
#include "animation/motions/motion_presets.h"
#include "ifs/canonical_systems.h"
#include "support/named_test.h"

#include <QElapsedTimer>
#include <QtTest>

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>

using namespace animation;
using namespace canonical;
using ifs::AffineMap, ifs::MapId, ifs::Matrix, ifs::Vector;

namespace {

template <int Dim> ifs::IteratedFunctionSystem<Dim> systemOf(const std::vector<AffineMap<Dim>>& maps) {
    ifs::IteratedFunctionSystem<Dim> system;
    for (const auto& map : maps)
        ifs::append(system, map, 0.25);
    return system;
}

template <int Dim> bool isSameBits(const AffineMap<Dim>& a, const AffineMap<Dim>& b) {
    return std::memcmp(a.linear.data(), b.linear.data(), sizeof(double) * Dim * Dim) == 0 &&
           std::memcmp(a.translation.data(), b.translation.data(), sizeof(double) * Dim) == 0;
}

template <int Dim> bool isSameBits(const Pose<Dim>& a, const Pose<Dim>& b) {
    if (!(a.system == b.system && a.cage == b.cage && a.appearance == b.appearance)) return false;
    for (std::size_t i = 0; i < a.system.maps.size(); ++i)
        if (!isSameBits<Dim>(a.system.maps[i].map, b.system.maps[i].map)) return false;
    const attractor::OrbitCamera camera;
    return orbited(camera, a.orbit) == orbited(camera, b.orbit) && a.camera == b.camera;
}

// Random keys for every track, and every motion.
template <int Dim> Animation<Dim> randomAnimation(Random& random, const Pose<Dim>& still, Loop loop) {
    Animation<Dim> animation;
    animation.length = 40;
    animation.loop = loop;
    std::uniform_real_distribution<double> share(0, 1);
    std::mt19937_64 engine(std::uint64_t(loop) + Dim);
    for (const auto& map : still.system.maps) {
        MapTrack<Dim> track{map.id, {}};
        for (const int frame : {0, 7, 13, 40}) {
            if (loop == Loop::Cycle && frame == 40) continue;
            const Ease ease = cubicEase(share(engine), share(engine), share(engine), share(engine));
            const double weight = 0.1 + share(engine);
            track.keys.push_back({frame, {randomContractions<Dim>(random, 1, 0.9)[0], weight}, ease});
        }
        animation.maps.push_back(track);
    }
    for (const int frame : {0, 20}) {
        CagePose<Dim> pose;
        for (std::size_t i = 0; i < still.cage->rest.size(); ++i)
            pose.push_back(randomVector<Dim>(random, 2));
        animation.cage.push_back({frame, pose, {}});
        Look look = lookOf(still.appearance);
        look.palette = attractor::builtInPalettes()[frame == 0 ? 0 : 2];
        look.brightness = 5 + frame;
        look.contrast = 1 + frame / 10.0;
        look.vibrancy = 1 - frame / 40.0;
        animation.look.push_back({frame, look, {}});
        CameraPose<Dim> camera;
        camera.height = 1 + frame;
        animation.camera.push_back({frame, camera, {Ease::Kind::Both}});
    }
    return animation;
}

template <int Dim> Pose<Dim> stillPose(Random& random) {
    Pose<Dim> still{systemOf<Dim>(randomContractions<Dim>(random, 3, 0.9))};
    ifs::ControlCage<Dim> cage;
    cage.rest.push_back(Vector<Dim>::Zero());
    for (int i = 0; i < Dim; ++i)
        cage.rest.push_back(Vector<Dim>::Unit(i));
    cage.current = cage.rest;
    still.cage = cage;
    return still;
}

// Between two keys of a cage that rests in the first of them.
template <int Dim>
CagePose<Dim> cageAt(const CagePose<Dim>& from, const CagePose<Dim>& to, int frame, int length) {
    Animation<Dim> animation;
    animation.length = length;
    animation.cage = {{0, from, {}}, {length, to, {}}};
    Pose<Dim> still;
    still.cage = ifs::ControlCage<Dim>{from, from};
    return animation.at(moment(frame), still).cage->current;
}

template <int Dim> void addMotions(Animation<Dim>& animation) {
    for (const SwayPreset& preset : swayPresets())
        animation.motions.push_back(swayOf<Dim>(preset, {}, Vector<Dim>::Ones()));
    animation.motions.push_back(Turn<Dim>{{}, 2});
    animation.motions.push_back(Turn<Dim>{{MapId(2)}, -3, Vector<Dim>::Ones()});
    animation.motions.push_back(Orbit<Dim>{1});
    animation.motions.push_back(Breathe<Dim>{{}, 0.1, 3});
    animation.motions.push_back(PaletteCycle{1});
}

template <int Dim> void everyKeyIsHit() {
    Random random(Dim);
    const Pose<Dim> still = stillPose<Dim>(random);
    for (const Loop loop : {Loop::Off, Loop::Cycle, Loop::ThereAndBack}) {
        const Animation<Dim> animation = randomAnimation<Dim>(random, still, loop);
        QVERIFY(isValid(animation));
        for (std::size_t i = 0; i < animation.maps.size(); ++i)
            for (const auto& key : animation.maps[i].keys) {
                const Pose<Dim> pose = animation.at(moment(key.frame), still);
                QVERIFY(isSameBits<Dim>(pose.system.maps[i].map, key.value.map));
                QCOMPARE(pose.system.maps[i].weight, key.value.weight);
            }
        for (std::size_t k = 0; k < 2; ++k) {
            const Pose<Dim> pose = animation.at(moment(animation.cage[k].frame), still);
            QCOMPARE(pose.cage->current, animation.cage[k].value);
            QCOMPARE(lookOf(pose.appearance), animation.look[k].value);
            QCOMPARE(*pose.camera, animation.camera[k].value);
        }
    }
}

// With motions: frame L is frame 0 in every bit, and so is frame 2L there and back.
template <int Dim> void loopsClose() {
    Random random(Dim + 10);
    const Pose<Dim> still = stillPose<Dim>(random);
    for (const Loop loop : {Loop::Cycle, Loop::ThereAndBack}) {
        Animation<Dim> animation = randomAnimation<Dim>(random, still, loop);
        addMotions(animation);
        QVERIFY(isValid(animation));
        const Pose<Dim> first = animation.at(moment(0), still);
        QVERIFY(isSameBits(animation.at(moment(lastFrame(loop, animation.length)), still), first));
        QVERIFY(!isSameBits(animation.at(moment(11), still), first));
        QVERIFY(isSameBits(animation.at(moment(11), still), animation.at(moment(22, 2), still)));
        const int mirrored = loop == Loop::Cycle ? 40 + 11 : 80 - 11;
        QVERIFY(isSameBits(animation.at(moment(mirrored), still), animation.at(moment(11), still)));
    }
    // Motions alone begin with the entry as it stands, but for the phases of the wind.
    Animation<Dim> motions;
    motions.length = 7;
    motions.motions = {Turn<Dim>{{}, 5}, Orbit<Dim>{-2}, Breathe<Dim>{{}, 0.5, 2}, PaletteCycle{3},
                       swayOf<Dim>(swayPresets().back(), {}, Vector<Dim>::Ones())};
    QVERIFY(isSameBits(motions.at(moment(0), still), still));
    QVERIFY(isSameBits(motions.at(moment(7), still), still));
}

// ‖A(t)‖ ≤ the larger end, in the norm in which both ends contract.
template <int Dim> void pathsContract(int pairs) {
    Random random(Dim + 20);
    std::mt19937_64 engine(Dim);
    std::uniform_real_distribution<double> share(0, 1);
    int missed = 0;
    for (int n = 0; n < pairs; ++n) {
        const auto ends = randomContractions<Dim>(random, 2, 0.999);
        Matrix<Dim> shear = Matrix<Dim>::Identity();
        if (n % 2 == 1) shear(0, Dim - 1) = 4 * share(engine); // seen askew, norms may be above 1
        const auto seen = [&](const AffineMap<Dim>& map) {
            return AffineMap<Dim>{shear * map.linear * shear.inverse(), shear * map.translation};
        };
        const std::vector<AffineMap<Dim>> maps{seen(ends[0]), seen(ends[1])};
        const auto norm = commonNorm<Dim>(maps);
        if (!norm && n % 2 == 1) { // not every pair that has one shows it
            ++missed;
            continue;
        }
        QVERIFY(norm.has_value());
        const auto length = [&](const AffineMap<Dim>& map) {
            return ifs::spectralNorm<Dim>(norm->root * map.linear * norm->inverse);
        };
        const double largest = std::max(length(maps[0]), length(maps[1]));
        QVERIFY(largest < 1);
        const double t = share(engine);
        const auto map = between<Dim>({maps[0], 0.5}, {maps[1], 0.7}, t, Vector<Dim>::Ones(), *norm);
        QVERIFY2(length(map.map) <= largest * (1 + 1e-12), qPrintable(QString::number(length(map.map))));
        QVERIFY(length(straight<Dim>(maps[0], maps[1], t)) <= largest * (1 + 1e-12));
        QCOMPARE(*map.weight, (1 - t) * 0.5 + t * 0.7);
        const Vector<Dim> image = (1 - t) * maps[0](Vector<Dim>::Ones()) + t * maps[1](Vector<Dim>::Ones());
        QVERIFY((map.map(Vector<Dim>::Ones()) - image).norm() < 1e-10);
    }
    qInfo("in %d dimensions, no common norm found for %d of %d sheared pairs", Dim, missed, pairs / 2);
    QVERIFY(missed < pairs / 2);
}

} // namespace

class AnimationTest : public QObject {
    Q_OBJECT

private slots:
    void everyKeyIsHitExactly() {
        everyKeyIsHit<2>();
        everyKeyIsHit<3>();
    }

    void frameLIsFrame0() {
        loopsClose<2>();
        loopsClose<3>();
    }

    void pathsStayContractive() {
        pathsContract<2>(10'000);
        pathsContract<3>(1'000);
    }

    // P = [[15/2, 35/2], [35/2, 100]] of maps that contract together, but not in the Euclidean norm.
    void commonNormOfASum() {
        const auto norm = commonNorm<2>(eventual());
        QVERIFY(norm && !norm->isEuclidean);
        Matrix<2> form;
        form << 7.5, 17.5, 17.5, 100;
        QVERIFY((norm->root * norm->root - form).norm() < 1e-9);
    }

    void noCommonNormOfMapsThatExpandTogether() {
        const std::vector<AffineMap<2>> maps{ifs::affineMap(.5, 2, 0, .5, 0, 0),
                                             ifs::affineMap(.5, 0, 2, .5, 0, 0)};
        QVERIFY(!commonNorm<2>(maps)); // their product expands
        QVERIFY(commonNorm<2>(std::vector{maps[0]}));
    }

    // That of the animation before is remembered, and is not taken for that of another one.
    void theCommonNormIsThatOfTheKeys() {
        ifs::IteratedFunctionSystem<2> system;
        const ifs::MapId id = ifs::append(system, ifs::affineMap(.5, 2, 0, .5, 0, 0), 1);
        const auto turning = [&](double shear) {
            Animation<2> animation;
            animation.length = 2;
            animation.maps = {{id,
                               {{0, {ifs::affineMap(.5, shear, 0, .5, 0, 0), 1}, {}},
                                {2, {ifs::affineMap(.25, shear, 0, .5, 0, 0), 1}, {}}}}};
            return animation;
        };
        const auto normOf = [&](double shear) { return commonNorm(turning(shear), system); };
        const auto rootOf = [&](double shear) { return normOf(shear)->root; };
        const Matrix<2> two = rootOf(2), three = rootOf(3);
        QVERIFY(two != three);
        QCOMPARE(two, commonNorm<2>(std::vector{ifs::affineMap(.5, 2, 0, .5, 0, 0),
                                                ifs::affineMap(.25, 2, 0, .5, 0, 0)})
                          ->root);
        for (int round = 0; round < 3; ++round) {
            QVERIFY(rootOf(2) == two);
            QVERIFY(rootOf(2) == two);
            QVERIFY(rootOf(3) == three);
            QVERIFY(normOf(0)->isEuclidean);
            ifs::IteratedFunctionSystem<2> more = system;
            ifs::append(more, ifs::affineMap(.5, 0, 2, .5, 0, 0), 1);
            QVERIFY(!commonNorm(turning(2), more));
        }
    }

    void halfwayInMaple() {
        ifs::IteratedFunctionSystem<2> system = systemOf<2>(maple());
        Animation<2> animation;
        animation.length = 2;
        animation.maps = {{MapId(3), {{0, {maple()[2], 0.25}, {}}, {2, {maple()[3], 0.25}, {}}}}};
        const Matrix<2> linear = animation.at(moment(1), {system}).system.maps[2].map.linear;
        Matrix<2> expected;
        expected << 0.682530784204, 0.011884611023, -0.061757061898, 0.595299372995;
        QVERIFY((linear - expected).cwiseAbs().maxCoeff() < 1e-12);
    }

    // The share of the centre's way at half time.
    void cameraZoomsGeometrically() {
        const auto share = [](double ratio) {
            const attractor::View view =
                between(attractor::View{{0, 0}, 2}, attractor::View{{1, 0}, 2 * ratio}, 0.5);
            if (std::abs(view.height - 2 * std::sqrt(ratio)) > 1e-12) return -1.0;
            return double(view.centre.x());
        };
        QVERIFY(std::abs(share(4) - 1.0 / 3) < 1e-14);
        QVERIFY(std::abs(share(100) - 1.0 / 11) < 1e-14);
        QVERIFY(std::abs(share(0.25) - 2.0 / 3) < 1e-14);
        QCOMPARE(share(1), 0.5);
        for (const double near : {1e-3, 1e-4, 1.1e-5, 0.9e-5, 1e-9, -1e-5})
            QVERIFY(std::abs(share(1 + near) - 1 / (std::sqrt(1 + near) + 1)) < 1e-9);
        for (const double u : {0.25, 0.5, 0.75}) { // (−1/3, 0) stays in its place
            const auto view = between(attractor::View{{0, 0}, 2}, attractor::View{{1, 0}, 8}, u);
            QVERIFY((Vector<2>(-1.0 / 3, 0) - view.centre - view.height * Vector<2>(-1.0 / 6, 0)).norm() <
                    1e-14);
        }
        attractor::OrbitCamera camera;
        camera.orientation = attractor::orbit(10, 20);
        QVERIFY(orbited(camera, CameraTurn{90}).orientation.angularDistance(attractor::orbit(100, 20)) <
                1e-7);
        attractor::OrbitCamera far = camera;
        far.orientation = attractor::orbit(70, 20);
        far.height = 4;
        QVERIFY(std::abs(between(camera, far, 0.5).height - 2) < 1e-14);
    }

    // What is at the pivot stays in its place of the picture, and so does everything that turns with the
    // camera.
    void camerasGoRoundTheirPivot() {
        std::mt19937_64 random(7);
        std::uniform_real_distribution<double> number(-3, 3);
        const auto point = [&] { return Vector<3>(number(random), number(random), number(random)); };
        for (int i = 0; i < 200; ++i) {
            attractor::OrbitCamera camera;
            camera.size = {640, 480};
            camera.target = point();
            camera.height = 4;
            camera.orientation = attractor::orbit(60 * number(random), 20 * number(random), 10);
            std::vector<CameraTurn> turns;
            for (int k = 0; k < 3; ++k)
                turns.push_back({120 * number(random), point().normalized(), point()});
            const attractor::OrbitCamera once = orbited(camera, turns[0]);
            const Vector<2> before = toScreen(camera, *turns[0].pivot).pixel;
            QVERIFY((toScreen(once, *turns[0].pivot).pixel - before).norm() < 1e-9);
            const attractor::OrbitCamera after = orbited(camera, turns);
            const Vector<3> seen = point();
            const Vector<3> moved = (*motionOf(turns))(seen);
            QVERIFY((toScreen(after, moved).pixel - toScreen(camera, seen).pixel).norm() < 1e-8);
            const attractor::OrbitCamera back = orbitedBack(after, turns);
            QVERIFY((back.target - camera.target).norm() < 1e-12);
            QVERIFY(back.orientation.angularDistance(camera.orientation) < 1e-7);
            turns[1].pivot.reset(); // about the target, wherever that is
            QVERIFY(!motionOf(turns));
            QVERIFY((orbited(camera, turns[1]).target - camera.target).norm() == 0);
        }
        QVERIFY(motionOf({})->linear == Matrix<3>::Identity());
        const std::vector<CameraTurn> none{{0, Vector<3>::UnitX(), point()}};
        QVERIFY(orbited(attractor::OrbitCamera(), none) == attractor::OrbitCamera());
    }

    // In space the orientation takes the shorter great circle, evenly, whichever sign its quaternion has.
    void camerasInSpaceTurnEvenly() {
        const ifs::Vector<3> axis = ifs::Vector<3>(1, 2, 3).normalized();
        const auto turned = [&](double degrees) {
            return attractor::Orientation(Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis));
        };
        attractor::OrbitCamera from, to;
        from.orientation = turned(0);
        from.height = 1;
        from.target = {0, 0, 0};
        to.orientation = turned(120);
        to.height = 4;
        to.target = {3, 0, -6};
        for (const double sign : {1.0, -1.0}) {
            to.orientation.coeffs() *= sign;
            const attractor::OrbitCamera half = between(from, to, 0.5), quarter = between(from, to, 0.25);
            QVERIFY(half.orientation.angularDistance(turned(60)) < 1e-7);
            QVERIFY(quarter.orientation.angularDistance(turned(30)) < 1e-7);
            QVERIFY(std::abs(half.orientation.norm() - 1) < 1e-12);
            QVERIFY((half.target - ifs::Vector<3>(1, 0, -2)).norm() < 1e-12); // a third of the way
            QVERIFY(std::abs(quarter.height - std::sqrt(2.0)) < 1e-12);
        }
    }

    void looksMixInOklab() {
        Look dark = lookOf({}), light = dark;
        dark.plain = {0, 0, 0, 255};
        light.plain = {255, 255, 255, 255};
        dark.brightness = 1;
        light.brightness = 100;
        dark.contrast = 0.5;
        light.contrast = 8;
        dark.vibrancy = 0.2;
        const Look middle = between(dark, light, 0.5);
        // Oklab lightness ½ is linear light ⅛.
        QCOMPARE(middle.plain, (attractor::Rgba{99, 99, 99, 255}));
        QVERIFY(std::abs(middle.brightness - 10) < 1e-12);
        QVERIFY(std::abs(middle.contrast - 2) < 1e-12);
        QVERIFY(std::abs(middle.vibrancy - 0.6) < 1e-12);
        QCOMPARE(lookOf(withLook({}, middle)), middle);
        const attractor::Palette palette = attractor::builtInPalettes()[1];
        QCOMPARE(cycled(palette, 0), palette);
        const attractor::Palette half = cycled(palette, 0.5); // at its far end, and on its way back
        QCOMPARE(half.stops.front().colour, palette.stops.back().colour);
        QCOMPARE(half.stops.back().colour, palette.stops.front().colour);
        QCOMPARE(half.stops.size(), palette.stops.size());
        QCOMPARE(cycled(palette, 0.3).stops.front().position, 0.0);
        QCOMPARE(cycled(palette, 0.3).stops.back().position, 1.0);
    }

    void looksInSpaceMix() {
        using attractor::LookInSpace, attractor::SpaceAppearance, attractor::SpaceClip;
        constexpr double open = std::numeric_limits<double>::infinity();
        SpaceAppearance first, last;
        first.lightAzimuth = 170.1;
        last.lightAzimuth = -160.3; // 29.6° on
        first.lightElevation = 1.0 / 3;
        last.lightElevation = 2.0 / 3;
        first.fog = 0.1;
        last.fog = 0.7;
        last.look = LookInSpace::Ink;
        last.colourBy = attractor::SolidColour::Height;
        first.clip = SpaceClip{{1, 0, 0}, -1, 3};
        last.clip = SpaceClip{{0, 1, 0}, 0, 1};
        const Look from = lookOf({}, first), to = lookOf({}, last);
        QVERIFY(*between(from, to, 0).inSpace == first);
        QVERIFY(*between(from, to, 1).inSpace == last);
        const SpaceAppearance half = *between(from, to, 0.5).inSpace;
        QVERIFY(std::abs(half.lightAzimuth - 184.9) < 1e-9);
        QVERIFY(std::abs(half.lightElevation - 0.5) < 1e-12);
        QVERIFY(std::abs(half.fog - 0.4) < 1e-12);
        QVERIFY(half.look == LookInSpace::Stone && !half.colourBy); // these change at the end
        QVERIFY((*half.clip == SpaceClip{{0.5, 0.5, 0}, -0.5, 2}));
        QVERIFY(*between(from, from, 0.3).inSpace == first); // in every bit
        // Between planes that nothing leads through, and where only one is there, the first stays.
        first.clip = SpaceClip{{1, 0, 0}, 0, open};
        for (const auto& clip : {std::optional(SpaceClip{{1, 0, 0}, 0, 1}), std::optional<SpaceClip>(),
                                 std::optional(SpaceClip{{-1, 0, 0}, 0, open})}) {
            last.clip = clip;
            QVERIFY(between(lookOf({}, first), lookOf({}, last), 0.5).inSpace->clip == first.clip);
        }
    }

    // Keys that do not say how it looks in space have what the entry has, and what they have is valid.
    void keysInSpaceMayLeaveItToTheEntry() {
        Pose<3> still;
        still.inSpace.fog = 2;
        Animation<3> animation;
        animation.length = 10;
        Look later = lookOf({}, still.inSpace);
        later.inSpace->fog = 4;
        animation.look = {{0, lookOf({}), {Ease::Kind::Linear}}, {10, later, {}}};
        QVERIFY(isValid(animation));
        QCOMPARE(animation.at(moment(0), still).inSpace.fog, 2.0);
        QCOMPARE(animation.at(moment(5), still).inSpace.fog, 3.0);
        QCOMPARE(animation.at(moment(10), still).inSpace.fog, 4.0);
        animation.look[1].value.inSpace->fog = 101;
        QVERIFY(!isValid(animation));
        Animation<2> flat;
        flat.look = {{0, later, {}}};
        QVERIFY(!isValid(flat));
    }

    void motionsKeepTheirPivots() {
        Random random(7);
        const Pose<2> still = stillPose<2>(random);
        Animation<2> animation;
        animation.length = 9;
        const Vector<2> root(0.4, -2);
        animation.motions = {Turn<2>{{MapId(2)}, 1, root}};
        for (int frame = 0; frame < 9; ++frame) {
            const Pose<2> pose = animation.at(moment(frame), still);
            QCOMPARE(pose.system.maps[0].map, still.system.maps[0].map);
            const auto& map = pose.system.maps[1].map;
            QVERIFY((map(root) - still.system.maps[1].map(root)).norm() < 1e-14);
            const double angle = 2 * std::numbers::pi * frame / 9;
            const Matrix<2> turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
            QVERIFY((map.linear - turn * still.system.maps[1].map.linear).norm() < 1e-14);
        }
        animation.motions = {Sway<2>{{}, 30, root, Vector<3>::UnitZ(), {{1, 1, 90, 0}}}};
        const Pose<2> pose = animation.at(moment(0), still);
        const Matrix<2> turn = Eigen::Rotation2Dd(std::numbers::pi / 6).toRotationMatrix();
        QVERIFY((pose.system.maps[0].map.linear - turn * still.system.maps[0].map.linear).norm() < 1e-14);
        // A cage that is carried once round turns the picture, and keeps its size half way.
        animation.motions = {Orbit<2>{1, {1, 1}}};
        animation.length = 4;
        const auto cage = *animation.at(moment(1), still).cage;
        QVERIFY((cage.current[0] - Vector<2>(2, 0)).norm() < 1e-15);
    }

    void cagesTurnWithoutShrinking() {
        Random random(8);
        Pose<2> still = stillPose<2>(random);
        Animation<2> animation;
        animation.length = 2;
        const std::vector<Vector<2>> rest = still.cage->rest;
        std::vector<Vector<2>> turned;
        for (const auto& vertex : rest)
            turned.emplace_back(-vertex.y(), vertex.x());
        animation.cage = {{0, rest, {}}, {2, turned, {}}};
        const auto half = animation.at(moment(1), still).cage->current;
        QVERIFY(std::abs((half[1] - half[0]).norm() - 1) < 1e-14);
        QVERIFY(std::abs((half[2] - half[1]).norm() - std::numbers::sqrt2) < 1e-14);
        still.cage.reset(); // nothing to move
        QVERIFY(!animation.at(moment(1), still).cage);
    }

    void verticesThatStayDoNotMove() {
        const CagePose<2> corners{{0.1, 0.2}, {3, -0.3}, {0.7, 2}};
        CagePose<2> after = corners;
        after[2] = {-1.3, 0.9}; // one is dragged
        for (int frame = 1; frame < 10; ++frame) {
            const CagePose<2> now = cageAt<2>(corners, after, frame, 10);
            QCOMPARE(now[0], corners[0]);
            QCOMPARE(now[1], corners[1]);
            QVERIFY((now[2] - (corners[2] + frame / 10.0 * (after[2] - corners[2]))).norm() < 1e-14);
        }
        after[2] = {0.7, -2}; // across the line of the others: every path is flat somewhere
        QCOMPARE(cageAt<2>(corners, after, 3, 10)[1], corners[1]);
        // Turned by 120° about a corner: it stays, and the cage does not shrink.
        const Matrix<2> turn = Eigen::Rotation2Dd(2 * std::numbers::pi / 3).toRotationMatrix();
        for (std::size_t i = 0; i < 3; ++i)
            after[i] = corners[1] + turn * (corners[i] - corners[1]);
        for (int frame = 1; frame < 10; ++frame) {
            const CagePose<2> now = cageAt<2>(corners, after, frame, 10);
            QCOMPARE(now[1], corners[1]);
            QVERIFY(std::abs((now[2] - now[0]).norm() - (corners[2] - corners[0]).norm()) < 1e-13);
        }
        // A polygon that bends.
        const CagePose<2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        CagePose<2> bent = square;
        bent[2] = {1.4, 1.7};
        const CagePose<2> now = cageAt<2>(square, bent, 1, 2);
        QVERIFY((now[2] - Vector<2>(1.2, 1.35)).norm() < 1e-15);
        for (std::size_t i : {0U, 1U, 3U})
            QCOMPARE(now[i], square[i]);
    }

    // A solid cage that is turned by 180° about one of its edges would be flat half way on straight ways.
    void doorsDoNotFlatten() {
        const CagePose<3> shut{{0, 0, 0}, {0, 0, 1}, {1, 0, 0.2}, {0.5, 1, 0.3}};
        const auto open = [&](double degrees) {
            CagePose<3> pose = shut;
            const double angle = degrees * std::numbers::pi / 180, sine = std::sin(angle);
            for (std::size_t i : {2U, 3U})
                pose[i].head<2>() << std::cos(angle) * shut[i].x() - sine * shut[i].y(),
                    sine * shut[i].x() + std::cos(angle) * shut[i].y();
            return pose;
        };
        const auto volume = [](const CagePose<3>& pose) {
            Matrix<3> edges;
            edges << pose[1] - pose[0], pose[2] - pose[0], pose[3] - pose[0];
            return edges.determinant();
        };
        const CagePose<3> ajar = cageAt<3>(shut, open(40), 1, 2);
        QCOMPARE(ajar[1], shut[1]);
        QVERIFY((ajar[2] - (shut[2] + open(40)[2]) / 2).norm() < 1e-15);
        const CagePose<3> wide = cageAt<3>(shut, open(180), 1, 2);
        QCOMPARE(wide[0], shut[0]);
        QVERIFY(std::abs(volume(wide) - volume(shut)) < 1e-12);
    }

    void strangersMoveNothing() {
        Random random(9);
        const Pose<2> still = stillPose<2>(random);
        Animation<2> animation;
        animation.maps = {{MapId(77), {{0, {maple()[0], 1.0}, {}}}}};
        animation.cage = {{0, {{0, 0}}, {}}};
        QVERIFY(isSameBits(animation.at(moment(3), still), still));
    }

    void invalidAnimationsAreKnown() {
        const auto key = [](int frame) { return Key<MapPose<2>>{frame, {maple()[0], 1.0}, {}}; };
        Animation<2> good;
        good.maps = {{MapId(1), {key(0), key(48)}}};
        QVERIFY(isValid(good));
        const auto isBad = [&](auto change) {
            Animation<2> bad = good;
            change(bad);
            return !isValid(bad);
        };
        QVERIFY(isBad([](auto& a) { a.length = 0; }));
        QVERIFY(isBad([](auto& a) { a.length = 47; }));
        QVERIFY(isBad([](auto& a) { a.rate.seconds = 0; }));
        QVERIFY(isBad([](auto& a) { a.maps[0].keys[0].frame = -1; }));
        QVERIFY(isBad([](auto& a) { a.maps[0].keys[0].frame = 48; }));
        QVERIFY(isBad([](auto& a) { a.maps[0].keys[0].value.map.linear(0, 0) = NAN; }));
        QVERIFY(isBad([](auto& a) { a.maps[0].keys[0].ease = {Ease::Kind::Cubic, 1, 0, 0, 1}; }));
        QVERIFY(isBad([](auto& a) { a.maps[0].keys.clear(); }));
        QVERIFY(isBad([](auto& a) { a.maps.push_back(a.maps[0]); }));
        QVERIFY(isBad([](auto& a) { a.motions = {Turn<2>{{}, 0}}; }));
        QVERIFY(isBad([](auto& a) { a.motions = {Breathe<2>{{}, 1, 1}}; }));
        QVERIFY(isBad([](auto& a) { a.motions = {Sway<2>()}; }));
        QVERIFY(isBad([](auto& a) { a.camera = {{0, {{0, 0}, 0}, {}}}; }));
    }

    // 64 tracks with 100 keys each.
    void evaluationIsFast() {
        Random random(11);
        Pose<2> still{systemOf<2>(randomContractions<2>(random, 64, 0.9))};
        Animation<2> animation;
        animation.length = 990;
        for (const auto& map : still.system.maps) {
            MapTrack<2> track{map.id, {}};
            for (int k = 0; k < 100; ++k)
                track.keys.push_back(
                    {10 * k, {randomContractions<2>(random, 1, 0.9)[0], 0.5}, {Ease::Kind::Both}});
            animation.maps.push_back(track);
        }
        qint64 best = std::numeric_limits<qint64>::max();
        for (int n = 0; n < 50; ++n) {
            QElapsedTimer timer;
            timer.start();
            const Pose<2> pose = animation.at(moment(17 * n + 3), still);
            best = std::min(best, timer.nsecsElapsed());
            QVERIFY(pose.system.maps.size() == 64);
        }
        qInfo("time.at_us: %.1f", double(best) / 1000);
        QVERIFY(best < 2'000'000);
    }
};

BARYCAGE_TEST(AnimationTest);
#include "animation_test.moc"
