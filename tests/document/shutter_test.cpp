// SPDX-License-Identifier: MIT
#include "document/moments/shutter.h"

#include "animation/motions/motion_presets.h"
#include "attractor/render/banded_rendering.h"
#include "document/fractal/fractal_geometry.h"
#include "ifs/canonical_systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>

using namespace document;
using animation::Loop;
using animation::Moment;
using animation::moment;

// When the shutter is open, and between which moments exposures are interpolated.
class ShutterTest : public QObject {
    Q_OBJECT

private slots:
    void partsLieEvenlyAroundTheFrame() {
        const AnimationFacts facts{{}, 10, Loop::Off, 0, 0};
        QCOMPARE(shutterMiddles(facts, 5, 360'000, 2), (std::vector<Moment>{moment(19, 4), moment(21, 4)}));
        QCOMPARE(shutterEdges(facts, 5, 180'000, 1), (std::vector<Moment>{moment(19, 4), moment(21, 4)}));
        QCOMPARE(shutterMiddles(facts, 5, 90'000, 1), (std::vector<Moment>{moment(5)}));
        QCOMPARE(shutterEdges(facts, 5, 360'000, 4),
                 (std::vector<Moment>{moment(9, 2), moment(19, 4), moment(5), moment(21, 4), moment(11, 2)}));
    }

    // At the ends it stays, goes round or turns back.
    void theShutterStaysWithinTheAnimation() {
        const auto edges = [](Loop loop, int frame) {
            return shutterEdges({{}, 10, loop, 0, 0}, frame, 360'000, 1);
        };
        QCOMPARE(edges(Loop::Off, 0), (std::vector<Moment>{moment(0), moment(1, 2)}));
        QCOMPARE(edges(Loop::Off, 10), (std::vector<Moment>{moment(19, 2), moment(10)}));
        QCOMPARE(edges(Loop::Cycle, 0), (std::vector<Moment>{moment(19, 2), moment(1, 2)}));
        QCOMPARE(edges(Loop::Cycle, 10), edges(Loop::Cycle, 0));
        QCOMPARE(edges(Loop::ThereAndBack, 0), (std::vector<Moment>{moment(1, 2), moment(1, 2)}));
        QCOMPARE(edges(Loop::ThereAndBack, 10), (std::vector<Moment>{moment(19, 2), moment(19, 2)}));
    }

    // Both cameras in one picture would be two pictures, the one that shows less of the attractor the darker.
    void theShutterDoesNotOpenAcrossACut() {
        const auto edges = [](Loop loop, int frame) {
            AnimationFacts facts;
            facts.length = 10;
            facts.loop = loop;
            facts.cuts = {0, 4};
            return shutterEdges(facts, frame, 360'000, 1);
        };
        QCOMPARE(edges(Loop::Cycle, 0), (std::vector<Moment>{moment(0), moment(1, 2)}));
        QCOMPARE(edges(Loop::Cycle, 10), edges(Loop::Cycle, 0));
        QCOMPARE(edges(Loop::Off, 4), (std::vector<Moment>{moment(4), moment(9, 2)}));
        QCOMPARE(edges(Loop::ThereAndBack, 4), edges(Loop::Off, 4));
        QCOMPARE(edges(Loop::ThereAndBack, 16), (std::vector<Moment>{moment(9, 2), moment(4)}));
        QCOMPARE(edges(Loop::Cycle, 3), (std::vector<Moment>{moment(5, 2), moment(7, 2)}));
        Fractal fractal;
        Shape<2> shape;
        shape.animation.emplace();
        shape.animation->length = 10;
        shape.animation->loop = Loop::Cycle;
        attractor::View far, near;
        near.height = far.height / 2;
        shape.animation->camera = {{0, far, {}}, {10, near, {}}};
        fractal.shape = shape;
        QCOMPARE(animationFacts(fractal)->cuts, std::vector<int>{0});
        shape.animation->camera = {{0, far, {}}, {10, far, {}}};
        fractal.shape = shape;
        QVERIFY(animationFacts(fractal)->cuts.empty());
        shape.animation->camera = {{0, far, {animation::Ease::Kind::Hold}}, {6, near, {}}};
        fractal.shape = shape;
        QCOMPARE(animationFacts(fractal)->cuts, std::vector<int>{6});
    }

    void pilotsAreKeysAndMiddles() {
        Shape<2> shape;
        ifs::append(shape.system, ifs::affineMap(.5, 0, 0, .5, 0, 0), 1);
        shape.animation = animation::Animation<2>{};
        shape.animation->length = 12;
        shape.animation->camera = {{3, {}, {}}, {8, {}, {}}};
        Fractal fractal;
        fractal.shape = shape;
        QCOMPARE(exposurePilots(fractal),
                 (std::vector<Moment>{moment(0), moment(3, 2), moment(3), moment(11, 2), moment(8),
                                      moment(10), moment(12)}));
        shape.animation->loop = Loop::Cycle;
        shape.animation->camera = {{0, {}, {}}, {12, {}, {}}}; // jumps back: frame 12 shows frame 0
        fractal.shape = shape;
        QCOMPARE(exposurePilots(fractal),
                 (std::vector<Moment>{moment(0), moment(11, 2), moment(11), moment(23, 2), moment(12)}));
        shape.animation->loop = Loop::Off;
        shape.animation->camera = {{3, {}, {}}, {8, {}, {}}};
        shape.animation->motions = {animation::PaletteCycle{}};
        fractal.shape = shape;
        const auto pilots = exposurePilots(fractal);
        QVERIFY(pilots.size() > 17);
        QVERIFY(std::ranges::is_sorted(
            pilots, {}, [](const Moment& m) { return double(m.numerator) / double(m.denominator); }));
        shape.animation->length = 10'000;
        for (int frame = 0; frame < 5000; ++frame)
            shape.animation->look.push_back({frame, {}, {}});
        fractal.shape = shape;
        QCOMPARE(exposurePilots(fractal).size(), std::size_t(255));
        QCOMPARE(exposurePilots(fractal).back(), moment(10'000));
    }

    // Between a pilot before a jump and one behind it, a picture that stays would grow brighter or darker.
    void jumpsLieBetweenPilots() {
        using animation::Ease;
        Shape<2> shape;
        const ifs::MapId id = ifs::append(shape.system, ifs::affineMap(.5, 0, 0, .5, 0, 0), 1);
        const animation::MapPose<2> pose{shape.system.maps[0].map, 1};
        animation::Animation<2>& animation = shape.animation.emplace();
        animation.length = 12;
        const auto pilotsOf = [&](const animation::Keys<animation::MapPose<2>>& keys) {
            animation.maps = {{id, keys}};
            Fractal fractal;
            fractal.shape = shape;
            return exposurePilots(fractal);
        };
        QCOMPARE(pilotsOf({{0, pose, {Ease::Kind::Hold}}, {6, pose, {}}}),
                 (std::vector<Moment>{moment(0), moment(5, 2), moment(5), moment(11, 2), moment(6), moment(9),
                                      moment(12)}));
        animation.loop = Loop::Cycle;
        QCOMPARE(pilotsOf({{4, pose, {}}, {6, pose, {Ease::Kind::Hold}}}), // until frame 4
                 (std::vector<Moment>{moment(0), moment(3, 2), moment(3), moment(7, 2), moment(4), moment(5),
                                      moment(6), moment(9), moment(12)}));
        for (const auto& [frame, ease] : {std::pair(12, Ease::Kind::Both), std::pair(6, Ease::Kind::Hold)}) {
            const auto pilots = pilotsOf({{0, pose, {}}, {frame, pose, {ease}}}); // until the end
            QCOMPARE(pilots[pilots.size() - 3], moment(11));
        }
    }

    void exposuresGoGeometrically() {
        const std::vector<Moment> pilots{moment(0), moment(2), moment(4)};
        const BetweenPilots at = betweenPilots(pilots, moment(5, 2));
        QCOMPARE(at.before, std::size_t(1));
        QCOMPARE(at.after, std::size_t(2));
        QCOMPARE(at.share, 0.25);
        for (std::size_t i = 0; i < pilots.size(); ++i) {
            const BetweenPilots exactly = betweenPilots(pilots, pilots[i]);
            QVERIFY(exactly.before == i && exactly.after == i && exactly.share == 0);
        }
        QCOMPARE(betweenPilots(pilots, moment(9)).before, std::size_t(2));
        const attractor::Exposure from{1e-6, 4, 1}, to{16e-6, 9, 2};
        const attractor::Exposure half = interpolated(from, to, 0.5);
        QVERIFY(std::abs(half.meanDensity / 4e-6 - 1) < 1e-12);
        QVERIFY(std::abs(half.whitePoint - 6) < 1e-12);
        QVERIFY(std::abs(half.gain - std::sqrt(2)) < 1e-12);
        QVERIFY(interpolated(from, to, 0) == from);
    }

    // Pictures of few samples measure an exposure that trembles; what is interpolated follows it evenly.
    void exposuresDoNotFlicker() {
        constexpr int frames = 96;
        Fractal fractal;
        Shape<2>& shape = fractal.shape.emplace<Shape<2>>();
        shape.system = canonical::system<2>(canonical::maple(), {});
        shape.animation.emplace();
        shape.animation->length = frames;
        shape.animation->loop = Loop::Cycle;
        shape.animation->motions = {animation::swayOf<2>(animation::swayPresets()[1], {}, {0, -1})};
        const auto measured = [&](const Moment& at) {
            attractor::RenderRequest request = renderRequest(
                frameAt(fractal, at).fractal, attractor::cameraOf(attractor::View{{0, 2.5}, 11}, {80, 60}));
            request.samples = 5'000;
            return *attractor::BandedRendering(request).measuredExposure();
        };
        const std::vector<Moment> pilots = exposurePilots(fractal);
        std::vector<double> each, smooth; // logarithms of what a picture is divided by
        for (int frame = 0; frame < frames; ++frame) {
            const BetweenPilots at = betweenPilots(pilots, moment(frame));
            const attractor::Exposure one = measured(moment(frame));
            const attractor::Exposure other =
                interpolated(measured(pilots[at.before]), measured(pilots[at.after]), at.share);
            each.push_back(std::log(one.meanDensity * one.whitePoint));
            smooth.push_back(std::log(other.meanDensity * other.whitePoint));
            QVERIFY(std::abs(each.back() - smooth.back()) < 0.3); // the same brightness on the whole
        }
        const auto trembling = [](const std::vector<double>& levels) {
            double sum = 0;
            for (std::size_t i = 2; i < levels.size(); ++i)
                sum += std::abs(levels[i] - 2 * levels[i - 1] + levels[i - 2]);
            return sum / double(levels.size() - 2);
        };
        const QString found = QStringLiteral("%1, %2").arg(trembling(smooth)).arg(trembling(each));
        QVERIFY2(trembling(smooth) < 0.4 * trembling(each), qPrintable(found));
    }
};

BARYCAGE_TEST(ShutterTest);
#include "shutter_test.moc"
