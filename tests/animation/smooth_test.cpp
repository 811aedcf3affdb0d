// SPDX-License-Identifier: MIT
#include "animation/animation.h"
#include "animation/paths/smooth_curve.h"
#include "animation/paths/smooth_keys.h"
#include "animation/paths/smooth_paths.h"
#include "attractor/request/orbit_camera.h"
#include "ifs/canonical_systems.h"
#include "ifs/existence/attractor_existence.h"
#include "support/named_test.h"

#include <Eigen/Geometry>
#include <QtTest>

#include <cstring>
#include <functional>
#include <numbers>
#include <random>

using namespace animation;
using namespace canonical;
using ifs::AffineMap, ifs::MapId, ifs::Matrix, ifs::Vector;

namespace {

constexpr Ease smooth{Ease::Kind::Smooth};
constexpr int length = 40;

template <class Number> bool isSameBits(const Number& a, const Number& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

using Numbers = std::vector<double>;

template <int Dim> Numbers numbersOf(const Pose<Dim>& pose) {
    Numbers numbers;
    const auto addAll = [&](const auto& matrix) {
        numbers.insert(numbers.end(), matrix.data(), matrix.data() + matrix.size());
    };
    for (const auto& map : pose.system.maps) {
        addAll(map.map.linear);
        addAll(map.map.translation);
        numbers.push_back(*map.weight);
    }
    for (const auto& vertex : pose.cage->current)
        addAll(vertex);
    for (const auto& branch : pose.moved) {
        addAll(branch.change.linear);
        addAll(branch.change.translation);
    }
    numbers.push_back(pose.appearance.brightness);
    numbers.push_back(pose.appearance.gamma);
    numbers.push_back(pose.camera->height);
    if constexpr (Dim == 2) {
        addAll(pose.camera->centre);
    } else {
        addAll(pose.camera->target);
        addAll(pose.camera->orientation.toRotationMatrix());
        numbers.push_back(pose.camera->fieldOfView);
    }
    return numbers;
}

template <int Dim> CameraPose<Dim> randomCamera(Random& random, std::mt19937_64& engine) {
    std::uniform_real_distribution<double> share(0, 1);
    CameraPose<Dim> camera;
    camera.height = std::exp(6 * share(engine) - 3);
    if constexpr (Dim == 2) {
        camera.centre = randomVector<2>(random, 2);
    } else {
        camera.target = randomVector<3>(random, 2);
        camera.orientation = attractor::orbit(360 * share(engine), 90 * share(engine), 50 * share(engine));
        camera.fieldOfView = 1 + 170 * share(engine);
    }
    return camera;
}

template <int Dim> struct Moving {
    Pose<Dim> still;
    Animation<Dim> animation;
};

// Smooth keys at uneven times in every track.
template <int Dim> Moving<Dim> moving(Random& random, Loop loop) {
    std::mt19937_64 engine(std::uint64_t(loop) + 7 * Dim);
    std::uniform_real_distribution<double> share(0, 1);
    Moving<Dim> result;
    for (const auto& map : randomContractions<Dim>(random, 3, 0.9))
        ifs::append(result.still.system, map, 0.25);
    ifs::ControlCage<Dim> cage;
    for (int i = 0; i <= Dim; ++i)
        cage.rest.push_back(i < Dim ? Vector<Dim>(Vector<Dim>::Unit(i)) : Vector<Dim>(Vector<Dim>::Zero()));
    cage.rest.push_back(1.3 * Vector<Dim>::Ones()); // it bends
    cage.current = cage.rest;
    result.still.cage = cage;
    Animation<Dim>& animation = result.animation;
    animation.length = length;
    animation.loop = loop;
    for (const auto& map : result.still.system.maps)
        animation.maps.push_back({map.id, {}});
    animation.branches.push_back({{MapId(1), MapId(2)}, {}});
    for (const int frame : {0, 4, 13, 21, 34}) {
        for (auto& track : animation.maps)
            track.keys.push_back(
                {frame, {randomContractions<Dim>(random, 1, 0.9)[0], 0.1 + share(engine)}, smooth});
        animation.branches[0].keys.push_back({frame, randomContractions<Dim>(random, 1, 2)[0], smooth});
        CagePose<Dim> pose;
        for (const auto& vertex : cage.rest)
            pose.push_back(vertex + randomVector<Dim>(random, 0.3));
        animation.cage.push_back({frame, pose, smooth});
        Look look = lookOf(result.still.appearance);
        look.brightness = 1 + 100 * share(engine);
        look.gamma = 1 + share(engine);
        animation.look.push_back({frame, look, smooth});
        animation.camera.push_back({frame, randomCamera<Dim>(random, engine), smooth});
    }
    return result;
}

template <int Dim> Numbers numbersAt(const Moving<Dim>& moving, std::int64_t at, std::int64_t parts = 1) {
    return numbersOf<Dim>(moving.animation.at(moment(at, parts), moving.still));
}

template <int Dim> void everySmoothKeyIsHit() {
    Random random(Dim);
    for (const Loop loop : {Loop::Off, Loop::Cycle, Loop::ThereAndBack}) {
        const Moving<Dim> all = moving<Dim>(random, loop);
        QVERIFY(isValid(all.animation));
        for (std::size_t k = 0; k < all.animation.cage.size(); ++k) {
            const Pose<Dim> pose = all.animation.at(moment(all.animation.cage[k].frame), all.still);
            for (std::size_t i = 0; i < all.animation.maps.size(); ++i) {
                const MapPose<Dim>& key = all.animation.maps[i].keys[k].value;
                QVERIFY(isSameBits(pose.system.maps[i].map.linear, key.map.linear));
                QVERIFY(isSameBits(pose.system.maps[i].map.translation, key.map.translation));
                QVERIFY(isSameBits(*pose.system.maps[i].weight, *key.weight));
            }
            QCOMPARE(pose.moved[0].change, all.animation.branches[0].keys[k].value);
            QCOMPARE(pose.cage->current, all.animation.cage[k].value);
            QCOMPARE(lookOf(pose.appearance), all.animation.look[k].value);
            QCOMPARE(*pose.camera, all.animation.camera[k].value);
        }
    }
}

// By how much the velocities before and after a key differ, in any number, relative to the larger one.
template <int Dim> double cornerAt(const Moving<Dim>& all, int frame) {
    constexpr std::int64_t parts = 1 << 16;
    const auto at = [&](int step) {
        const std::int64_t whole = length * parts;
        return numbersAt<Dim>(all, (frame * parts + step + whole) % whole, parts);
    };
    const Numbers before = at(-2), left = at(-1), here = at(0), right = at(1), after = at(2);
    double corner = 0;
    for (std::size_t i = 0; i < here.size(); ++i) { // one-sided, exact for parabolas
        const double coming = (3 * here[i] - 4 * left[i] + before[i]) * double(parts) / 2;
        const double going = (-3 * here[i] + 4 * right[i] - after[i]) * double(parts) / 2;
        const double speed = std::max({std::abs(going), std::abs(coming), 0.01});
        corner = std::max(corner, std::abs(going - coming) / speed);
    }
    return corner;
}

template <int Dim> void keysAreNoCorners() {
    Random random(Dim + 5);
    for (const Loop loop : {Loop::Off, Loop::Cycle}) {
        Moving<Dim> all = moving<Dim>(random, loop);
        for (const int frame : {0, 4, 13, 21, 34}) {
            const bool isEnd = loop == Loop::Off && (frame == 0 || frame == 34);
            if (isEnd) continue;
            const double corner = cornerAt<Dim>(all, frame);
            QVERIFY2(corner < 1e-5, qPrintable(QStringLiteral("%1 at %2").arg(corner).arg(frame)));
        }
        for (const int rank : {0, 1}) { // a key that is a point or a line
            Moving<Dim> open = all;
            for (auto& track : open.animation.maps)
                for (auto& key : track.keys)
                    if (key.frame == 13) key.value.map.linear.rightCols(Dim - rank).setZero();
            const double corner = cornerAt<Dim>(open, 13);
            QVERIFY2(corner < 1e-5, qPrintable(QString::number(corner)));
        }
        for (auto& track : all.animation.maps) // what the test finds in straight ways
            for (auto& key : track.keys)
                key.ease = {Ease::Kind::Linear};
        QVERIFY(cornerAt<Dim>(all, 13) > 1e-3);
    }
}

// ‖A(t)‖ ≤ the larger end, in the norm in which all four keys contract.
template <int Dim> void smoothPathsContract(int quadruples) {
    Random random(Dim + 20);
    std::mt19937_64 engine(Dim);
    std::uniform_real_distribution<double> share(0, 1);
    int missed = 0, bound = 0;
    for (int n = 0; n < quadruples; ++n) {
        std::vector<AffineMap<Dim>> maps = randomContractions<Dim>(random, 4, 0.999);
        if (n % 2 == 1) { // seen askew, norms may be above 1
            Matrix<Dim> shear = Matrix<Dim>::Identity();
            shear(0, Dim - 1) = 4 * share(engine);
            for (auto& map : maps)
                map.linear = shear * map.linear * shear.inverse();
        }
        const auto norm = commonNorm<Dim>(maps);
        if (!norm && n % 2 == 1) {
            ++missed;
            continue;
        }
        QVERIFY(norm.has_value());
        const auto size = [&](const AffineMap<Dim>& map) {
            return ifs::spectralNorm<Dim>(norm->root * map.linear * norm->inverse);
        };
        std::vector<MapPose<Dim>> keys;
        for (const auto& map : maps)
            keys.push_back({map, share(engine)});
        Segment<MapPose<Dim>> way{keys[1], keys[2], 0, true};
        if (n % 5 != 0) way.before = {&keys[0], -0.01 - 3 * share(engine)};
        if (n % 7 != 0) way.after = {&keys[3], 1.01 + 3 * share(engine)};
        const double largest = std::max(size(maps[1]), size(maps[2]));
        QVERIFY(largest < 1);
        double most = 0;
        for (int step = 0; step <= 16; ++step) {
            Segment<MapPose<Dim>> now{way.from, way.to, step / 16.0, true, way.before, way.after};
            const MapPose<Dim> pose = along<Dim>(now, Vector<Dim>::Ones(), *norm);
            most = std::max(most, size(pose.map));
            QVERIFY(*pose.weight >= std::min(*keys[1].weight, *keys[2].weight));
            QVERIFY(*pose.weight <= std::max(*keys[1].weight, *keys[2].weight));
        }
        QVERIFY2(most <= largest * (1 + 1e-12), qPrintable(QString::number(most - largest)));
        bound += most > largest * (1 - 1e-9);
    }
    qInfo("%d dimensions: no common norm for %d of %d sheared quadruples", Dim, missed, quadruples / 2);
    QVERIFY(missed < quadruples / 2 && bound > 0);
}

// Values on a circle, in a cycle.
Animation<2> circling(int keys, Ease ease) {
    Animation<2> animation;
    animation.length = 10 * keys;
    animation.loop = Loop::Cycle;
    animation.reference = Vector<2>(0, 0);
    animation.maps = {{MapId(1), {}}};
    for (int k = 0; k < keys; ++k) {
        const double angle = 2 * std::numbers::pi * k / keys;
        animation.maps[0].keys.push_back(
            {10 * k, {similarity(0.5, angle, std::cos(angle), std::sin(angle)), 1.0}, ease});
    }
    return animation;
}

Pose<2> oneMap() {
    Pose<2> still;
    ifs::append(still.system, similarity(0.5, 0, 1, 0), 1);
    return still;
}

AffineMap<2> mapAt(const Animation<2>& animation, std::int64_t at, std::int64_t parts = 1) {
    return animation.at(moment(at, parts), oneMap()).system.maps[0].map;
}

} // namespace

class SmoothTest : public QObject {
    Q_OBJECT

private slots:
    void everyKeyIsHitExactly() {
        everySmoothKeyIsHit<2>();
        everySmoothKeyIsHit<3>();
    }

    void velocitiesAreContinuous() {
        keysAreNoCorners<2>();
        keysAreNoCorners<3>();
    }

    // A point has no turn of its own: the maps on both sides keep theirs.
    void nothingTurnsOnTheWayToAPoint() {
        const auto turned = [](double degrees) {
            return MapPose<2>{similarity(0.5, degrees * std::numbers::pi / 180, 0, 0), 1};
        };
        const MapPose<2> first = turned(40), point{AffineMap<2>{Matrix<2>::Zero(), {0, 0}}, 1},
                         last = turned(100);
        const auto norm = commonNorm<2>(std::vector{first.map, last.map});
        QVERIFY(norm.has_value());
        for (const double t : {0.1, 0.5, 0.9}) {
            Segment<MapPose<2>> to{first, point, t, true}, from{point, last, t, true};
            to.before = {&first, -1};
            to.after = {&last, 2};
            from.before = {&first, -1};
            from.after = {&last, 2};
            const Matrix<2> shrinking = along<2>(to, {0, 0}, *norm).map.linear;
            const Matrix<2> growing = along<2>(from, {0, 0}, *norm).map.linear;
            QVERIFY((shrinking / shrinking.col(0).norm() - 2 * first.map.linear).norm() < 1e-12);
            QVERIFY((growing / growing.col(0).norm() - 2 * last.map.linear).norm() < 1e-12);
        }
    }

    void nothingTurnsOnTheWayToAPointInSpace() {
        const auto turned = [](double degrees) {
            const Vector<3> axis = Vector<3>(1, 2, 3).normalized();
            const Matrix<3> turn =
                Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis).toRotationMatrix();
            return MapPose<3>{AffineMap<3>{0.5 * turn, {0, 0, 0}}, 1};
        };
        const MapPose<3> first = turned(40), point{AffineMap<3>{Matrix<3>::Zero(), {0, 0, 0}}, 1},
                         last = turned(100);
        const auto norm = commonNorm<3>(std::vector{first.map, last.map});
        QVERIFY(norm.has_value());
        for (const double t : {0.1, 0.5, 0.9}) {
            Segment<MapPose<3>> to{first, point, t, true}, from{point, last, t, true};
            to.before = from.before = {&first, -1};
            to.after = from.after = {&last, 2};
            const Matrix<3> shrinking = along<3>(to, {0, 0, 0}, *norm).map.linear;
            const Matrix<3> growing = along<3>(from, {0, 0, 0}, *norm).map.linear;
            QVERIFY((shrinking / shrinking.col(0).norm() - 2 * first.map.linear).norm() < 1e-12);
            QVERIFY((growing / growing.col(0).norm() - 2 * last.map.linear).norm() < 1e-12);
        }
    }

    void pathsStayContractive() {
        smoothPathsContract<2>(10'000);
        smoothPathsContract<3>(1'000);
    }

    void frameLIsFrame0() {
        Random random(3);
        for (const Loop loop : {Loop::Cycle, Loop::ThereAndBack}) {
            const Moving<2> all = moving<2>(random, loop);
            QCOMPARE(numbersAt<2>(all, lastFrame(loop, length)), numbersAt<2>(all, 0));
            QCOMPARE(numbersAt<2>(all, length + 3), numbersAt<2>(all, loop == Loop::Cycle ? 3 : length - 3));
            QVERIFY(numbersAt<2>(all, 11) != numbersAt<2>(all, 0));
        }
    }

    // Maps that contract in a common norm only, with an attractor at every frame between.
    void everyFrameHasAnAttractor() {
        Random random(4);
        int tried = 0;
        for (int n = 0; n < 40; ++n) {
            Matrix<2> shear = Matrix<2>::Identity();
            shear(0, 1) = 6;
            Animation<2> animation;
            animation.length = length;
            Pose<2> still;
            for (int map = 0; map < 3; ++map) {
                animation.maps.push_back({ifs::append(still.system, similarity(0.5, 0, 1, 0), 1), {}});
                for (const int frame : {0, 5, 20, 40}) {
                    auto value = randomContractions<2>(random, 1, 0.8)[0];
                    value.linear = shear * value.linear * shear.inverse();
                    animation.maps.back().keys.push_back({frame, {value, 1.0}, smooth});
                }
            }
            const auto norm = commonNorm(animation, still.system);
            if (!norm || norm->isEuclidean) continue;
            ++tried;
            for (int frame = 0; frame <= length; ++frame) {
                std::vector<AffineMap<2>> maps;
                for (const auto& map : animation.at(moment(frame), still).system.maps)
                    maps.push_back(map.map);
                const ifs::Verdict verdict = ifs::classify<2>(maps).verdict;
                QVERIFY(verdict == ifs::Verdict::Hyperbolic ||
                        verdict == ifs::Verdict::EventuallyContractive);
            }
        }
        QVERIFY(tried > 10);
    }

    // Halfway between two keys of a polygon the straight path is at cos(π/n), the curve near the circle; the
    // angle runs evenly through all turns.
    void pathsBend() {
        const Animation<2> round = circling(8, smooth);
        for (int at = 0; at < 160; ++at) {
            const AffineMap<2> map = mapAt(round, at, 2);
            QVERIFY(std::abs(map.translation.norm() - 1) < 0.01);
            const double angle = 2 * std::numbers::pi * at / 160;
            QVERIFY((map.linear - similarity(0.5, angle, 0, 0).linear).norm() < 1e-12);
        }
        QVERIFY(mapAt(circling(8, {}), 5).translation.norm() < 0.93);
        // Half a turn and half a turn: which way round is settled once.
        const Animation<2> halves = circling(2, smooth);
        for (int at = 0; at < 20; ++at)
            QVERIFY((mapAt(halves, at).linear - similarity(0.5, 2 * std::numbers::pi * at / 20, 0, 0).linear)
                        .norm() < 1e-12);
    }

    // A last key at the end of a cycle is the first one: no corner there, and none made up where they differ.
    void theSeamOfACycleIsNoCorner() {
        Animation<2> round = circling(8, smooth);
        Animation<2> doubled = round;
        doubled.maps[0].keys.push_back({80, doubled.maps[0].keys[0].value, smooth});
        QVERIFY(isValid(doubled));
        for (int at = 0; at < 160; ++at) {
            const AffineMap<2> one = mapAt(round, at, 2), other = mapAt(doubled, at, 2);
            QVERIFY((one.linear - other.linear).norm() + (one.translation - other.translation).norm() <
                    1e-14);
        }
        doubled.maps[0].keys.back().value.map.translation.x() += 1;
        const Clock start{moment(3), Loop::Cycle, 80}, end{moment(77), Loop::Cycle, 80};
        const auto first = wayAt(doubled.maps[0].keys, start), last = wayAt(doubled.maps[0].keys, end);
        QVERIFY(!first.before.value && first.after.value && last.before.value && !last.after.value);
    }

    // Nobody comes from a key that holds, or goes on from one.
    void keysThatHoldAreEnds() {
        Keys<double> keys{{0, 1.0, {Ease::Kind::Hold}},
                          {10, 2.0, smooth},
                          {20, 3.0, smooth},
                          {30, 5.0, {Ease::Kind::Hold}},
                          {40, 4.0, smooth}};
        const auto at = [&](int frame, Loop loop) { return wayAt(keys, Clock{moment(frame), loop, 50}); };
        QVERIFY(!at(15, Loop::Off).before.value && *at(15, Loop::Off).after.value == 5);
        QVERIFY(*at(25, Loop::Off).before.value == 2 && !at(25, Loop::Off).after.value);
        QVERIFY(*at(25, Loop::Off).before.value == 2);
        QCOMPARE(at(25, Loop::Off).before.time, -1.0);
        QVERIFY(!at(45, Loop::Off).isSmooth); // after the last key
        QVERIFY(at(45, Loop::Cycle).isSmooth && !at(45, Loop::Cycle).before.value &&
                !at(45, Loop::Cycle).after.value);
        keys[3].ease = smooth;
        QVERIFY(*at(45, Loop::Cycle).before.value == 5);
        QCOMPARE(at(45, Loop::Cycle).before.time, -1.0);
    }

    // Corner by corner: each stops smoothly before a way on which it stays. About one corner: that one stays.
    void verticesThatStayDoNotMove() {
        const CagePose<2> corners{{0, 0}, {1, 0}, {0, 1}};
        Moving<2> all;
        all.still.cage = ifs::ControlCage<2>{corners, corners};
        all.animation.length = 40;
        const CagePose<2> second{corners[0], corners[1], {0.4, 2}}, third{corners[0], {1.5, 0.3}, {0.4, 2}};
        all.animation.cage = {{0, corners, smooth}, {10, second, smooth}, {25, third, smooth}};
        const auto at = [&](std::int64_t time, std::int64_t parts = 1) {
            return all.animation.at(moment(time, parts), all.still).cage->current;
        };
        for (int frame = 0; frame <= 40; ++frame) {
            QCOMPARE(at(frame)[0], corners[0]);
            QCOMPARE(at(frame)[frame <= 10 ? 1 : 2], second[frame <= 10 ? 1 : 2]);
        }
        constexpr std::int64_t parts = 1 << 16;
        for (std::size_t corner : {1U, 2U}) // no speed at the key
            for (int step : {-1, 1})
                QVERIFY((at(10 * parts + step, parts)[corner] - second[corner]).norm() * parts < 1e-4);
        QVERIFY((at(5)[2] - (corners[2] + second[2]) / 2).norm() > 0.01); // it bends

        CagePose<2> turned = second;
        for (std::size_t i : {1U, 2U})
            turned[i] = Vector<2>(-second[i].y(), second[i].x());
        all.animation.cage[2].value = turned; // about the first corner, from there on
        for (int frame = 0; frame <= 40; ++frame)
            QCOMPARE(at(frame)[0], corners[0]);
        QVERIFY(std::abs(at(17)[1].norm() - 1) < 1e-12);

        // Where curves would turn the cage over, straight ways are taken.
        const CagePose<2> far{corners[0], corners[1], {0, 30}}, low{corners[0], corners[1], {0, 0.1}};
        all.animation.cage = {{0, far, smooth}, {10, low, smooth}, {20, low, smooth}, {30, far, smooth}};
        all.animation.cage[2].value[2].x() = 1;
        for (int frame = 0; frame <= 30; ++frame)
            QVERIFY(at(frame)[2].y() > 0);
    }

    void numbersStayBetweenTheirEnds() {
        KeysAround<double> keys{1, 2, 0.0, 0.5, -1, 1.1};
        double last = 1;
        for (int n = 0; n <= 100; ++n) {
            const double now = smoothNumber(keys, n / 100.0);
            QVERIFY(now >= last && now <= 2);
            last = now;
        }
        QCOMPARE(smoothNumber({3, 3, 1.0, 9.0}, 0.4), 3.0);
        // Evenly spaced on a line: nothing to bend, and the largest share is all of it.
        QVERIFY(std::abs(smoothNumber({1, 2, 0.0, 3.0}, 0.3) - 1.3) < 1e-15);
        // A parabola without limits: the tangents of Catmull and Rom are its own.
        const KeysAround<double> parabola{0, 1, 1.0, 4.0};
        QVERIFY(std::abs(smoothCurve<Flat<double>>(parabola, 0.3) - 0.09) < 1e-15);
        QVERIFY(std::abs(largestShare([](double share) { return share <= 0.7; }) - 0.7) < 1e-8);
    }

    // Keys on one zoom into a point: the point stays where it is in the picture.
    void zoomsStayOnTheirPoint() {
        const Vector<2> point(0.3, -0.7);
        const auto at = [&](double height) {
            return attractor::View{point + height * Vector<2>(0.2, 0.1), height};
        };
        const attractor::View views[] = {at(4), at(1), at(1e-6), at(1e-7)};
        for (int n = 0; n <= 20; ++n) {
            const Segment<attractor::View> way{views[1], views[2],          n / 20.0,
                                               true,     {&views[0], -0.4}, {&views[3], 3}};
            const attractor::View now = along(way);
            QVERIFY((point + now.height * Vector<2>(0.2, 0.1) - now.centre).norm() < 1e-8 * now.height);
            QVERIFY(now.height <= 4 && now.height >= 0.5e-7);
        }
    }

    // The shorter way, through half a turn where it leads there; in the keys to the bit.
    void viewsTurnTheShorterWay() {
        using attractor::rotationOf;
        const auto at = [](double degrees) {
            return attractor::View{{0, 0}, 1, attractor::YAxis::Up, rotationOf(degrees)};
        };
        const attractor::View views[] = {at(140), at(170), at(-160), at(-130)};
        for (int n = 0; n <= 10; ++n) {
            const Segment<attractor::View> straight{views[1], views[2], n / 10.0, false, {}, {}};
            const Segment<attractor::View> curved{views[1], views[2],        n / 10.0,
                                                  true,     {&views[0], -1}, {&views[3], 2}};
            for (const auto& way : {straight, curved}) { // all are 30 degrees apart
                const double turned = turnBetween(rotationOf(170), along(way).rotation);
                QVERIFY(std::abs(turned - rotationOf(3.0 * n)) < 1e-12);
            }
        }
        const attractor::View upright = between(at(0), at(0), 0.3);
        QCOMPARE(upright.rotation, 0.0);
    }

    // A stranger's numbers: what overflows goes the straight way.
    void hugeNumbersStayNumbers() {
        const double most = std::numeric_limits<double>::max();
        const MapPose<2> keys[] = {{ifs::affineMap(most, 0, 0, most, most, 0), most},
                                   {ifs::affineMap(-most, 0, 0, most, -most, 0), 0.0},
                                   {ifs::affineMap(0.5, 0, 0, 0.5, most, most), 1.0}};
        const attractor::View views[] = {{{most, -most}, 1e-300}, {{-most, most}, 1e300}, {{0, 0}, 1}};
        for (int n = 0; n <= 10; ++n) {
            const Segment<MapPose<2>> way{keys[1], keys[2],           n / 10.0,
                                          true,    {&keys[0], -1e-6}, {&keys[0], 1e6}};
            QVERIFY(std::isfinite(*along<2>(way, {0, 0}, {}).weight));
            const Segment<attractor::View> seen{views[1], views[2],           n / 10.0,
                                                true,     {&views[0], -1e-6}, {&views[0], 1e6}};
            QVERIFY(along(seen).height > 0 && std::isfinite(along(seen).height));
        }
    }
};

BARYCAGE_TEST(SmoothTest);
#include "smooth_test.moc"
