// SPDX-License-Identifier: MIT
#include "document/fractal/fractal_geometry.h"
#include "document/moments/animated_fractal.h"
#include "support/named_test.h"

#include <QtTest>

using namespace document;

namespace {

Fractal animated(const std::vector<ifs::AffineMap<2>>& maps, const animation::Animation<2>& animation) {
    Shape<2> shape;
    for (const auto& map : maps)
        ifs::append(shape.system, map, 0.5);
    shape.animation = animation;
    Fractal fractal;
    fractal.shape = std::move(shape);
    return fractal;
}

animation::Key<animation::MapPose<2>> key(int frame, const ifs::AffineMap<2>& map) {
    return {frame, {map, 0.5}, {}};
}

const ifs::AffineMap<2> half = ifs::affineMap(.5, 0, 0, .5, 0, 0);

} // namespace

class AnimatedFractalTest : public QObject {
    Q_OBJECT

private slots:
    void framesAreOrdinaryFractals() {
        animation::Animation<2> moving;
        moving.length = 8;
        moving.maps = {{ifs::MapId(2), {key(0, half), key(8, ifs::affineMap(.25, 0, 0, .25, 1, 0))}}};
        const Fractal fractal = animated({half, half}, moving);
        const Fractal frame = frameAt(fractal, animation::moment(4)).fractal;
        QVERIFY(!plane(frame)->animation);
        QCOMPARE(system2(frame)->maps[1].map.linear(0, 0), 0.375);
        QCOMPARE(system2(frame)->maps[0].map, half);
        QCOMPARE(frameAt(frame, animation::moment(3)).fractal, frame);
        QVERIFY(!animationFacts(frame));
        QCOMPARE(animationFacts(fractal)->tracks, 1);
        QVERIFY(!firstWithoutAttractor(fractal));
        QVERIFY(!firstWithoutAttractor(frame));
    }

    // Without a cage of its own the picture goes round by its canonical one.
    void orbitsNeedNoStoredCage() {
        animation::Animation<2> moving;
        moving.length = 4;
        moving.motions = {animation::Orbit<2>{1, {0, 0}}};
        const Fractal fractal = animated(
            {half, ifs::affineMap(.5, 0, 0, .5, .5, 0), ifs::affineMap(.5, 0, 0, .5, 0, .5)}, moving);
        const Fractal frame = frameAt(fractal, animation::moment(1)).fractal;
        const ifs::Vector<2> shown = placement(frame)(ifs::Vector<2>(1, 0));
        QVERIFY((shown - ifs::Vector<2>(0, 1)).norm() < 1e-12);
        QCOMPARE(system2(frame)->maps, system2(fractal)->maps);
    }

    // Both ends have an attractor, each in a norm of its own, and the middle has none.
    void namesTheFirstMomentWithoutAttractor() {
        const auto up = ifs::affineMap(.5, 3, 0, .5, 0, 0), down = ifs::affineMap(.5, 0, 3, .5, 0, 0);
        animation::Animation<2> moving;
        moving.length = 32;
        moving.maps = {{ifs::MapId(1), {key(0, up), key(32, down)}},
                       {ifs::MapId(2), {key(0, up), key(32, down)}}};
        moving.maps[0].keys[0].ease.kind = animation::Ease::Kind::Hold; // the second is ahead
        const Fractal fractal = animated({up, up}, moving);
        QVERIFY(!animation::commonNorm(moving, *system2(fractal)));
        const auto lost = firstWithoutAttractor(fractal);
        QVERIFY(lost.has_value());
        QVERIFY(lost->moment.numerator > 0);
        const auto verdictAt = [&](std::int64_t frame) {
            const Fractal still = frameAt(fractal, animation::moment(frame)).fractal;
            return ifs::classify<2>(ifs::mapsOf(*system2(still))).verdict;
        };
        QCOMPARE(verdictAt(lost->moment.numerator), lost->verdict);
        QCOMPARE(verdictAt(lost->moment.numerator - 1), ifs::Verdict::EventuallyContractive);
        QCOMPARE(verdictAt(31), ifs::Verdict::None); // the product of the two expands
    }

    // Between evenly spaced moments: at a key, and where a motion comes back to where it was at each of them.
    void lossesBetweenEvenMomentsAreFound() {
        animation::Animation<2> moving;
        moving.length = 200;
        const auto wide = ifs::affineMap(1.3, 0, 0, 1.3, 0, 0);
        moving.maps = {{ifs::MapId(1), {key(101, half), key(103, wide), key(105, half)}}};
        auto lost = firstWithoutAttractor(animated({half, half}, moving));
        QVERIFY(lost.has_value());
        QVERIFY(lost->moment.numerator == 102 || lost->moment.numerator == 103);

        animation::Animation<2> breathing;
        breathing.length = 48;
        breathing.motions = {animation::Breathe<2>{{}, 0.9, 16, {0, 0}}};
        const auto large = ifs::affineMap(.8, 0, 0, .8, 0, 0);
        const Fractal fractal = animated({large, large}, breathing);
        lost = firstWithoutAttractor(fractal);
        QVERIFY(lost.has_value());
        QCOMPARE(lost->moment, animation::moment(1));
        QVERIFY(!firstWithoutAttractor(withSafeStrength(fractal, 0)));
    }

    void strengthStopsWhereTheAttractorWouldBeLost() {
        animation::Animation<2> moving;
        moving.length = 32;
        moving.motions = {animation::Breathe<2>{{}, 0.5, 1, {0, 0}}};
        const auto wide = ifs::affineMap(.8, 0, 0, .8, 0, 0);
        const Fractal fractal = animated({wide, ifs::affineMap(.8, 0, 0, .8, 1, 0)}, moving);
        QVERIFY(firstWithoutAttractor(fractal).has_value());
        const Fractal safe = withSafeStrength(fractal, 0);
        QVERIFY(!firstWithoutAttractor(safe));
        const double strength = std::get<animation::Breathe<2>>(plane(safe)->animation->motions[0]).strength;
        QVERIFY2(strength < 0.25 && strength > 0.249, qPrintable(QString::number(strength))); // 0.8·1.25 = 1
        QCOMPARE(withSafeStrength(safe, 0), safe);
    }
};

BARYCAGE_TEST(AnimatedFractalTest);
#include "animated_fractal_test.moc"
