// SPDX-License-Identifier: MIT
#include "document/variations/crossing.h"

#include "document/fractal/fractal_geometry.h"
#include "document/variations/random_systems.h"
#include "document/variations/variations.h"
#include "ifs/canonical_systems.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QTest>

#include <algorithm>

class CrossingTest : public QObject {
    Q_OBJECT

private slots:
    void childrenHaveAnAttractor_data();
    void childrenHaveAnAttractor();
    void childrenTakeFromBoth();
    void scaleAndPlaceOfThePartnerDoNotMatter();
    void mapsThatBelongTogetherArePaired();
    void onlyWhatMayChangeIsMixed();
    void lockedMapsStay();
    void symmetryComesFromEither();
};

namespace {

using document::Fractal;
using FractalPointer = std::shared_ptr<const Fractal>;

FractalPointer pointer(Fractal fractal) {
    return std::make_shared<const Fractal>(std::move(fractal));
}

FractalPointer fern() {
    Fractal fractal = support::fractalOf(canonical::system<2>(canonical::fern(), canonical::fernWeights),
                                         QStringLiteral("fern"));
    return pointer(fractal);
}

FractalPointer triangle() {
    return pointer(document::sierpinskiTriangle());
}

const document::System2& crossedSystem(const Fractal& fractal) {
    return *document::system2(fractal);
}

} // namespace

void CrossingTest::childrenHaveAnAttractor_data() {
    QTest::addColumn<int>("dimension");
    QTest::newRow("plane") << 2;
    QTest::newRow("space") << 3;
}

void CrossingTest::childrenHaveAnAttractor() {
    QFETCH(int, dimension);
    for (std::uint64_t pair = 1; pair <= 5; ++pair) {
        const auto parent = pointer(document::randomFractal({dimension}, pair));
        const auto partner = pointer(document::randomFractal({dimension, 6}, 100 + pair));
        const document::Variations variations(parent, {0.3, {}, partner});
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            const Fractal child = variations.of(seed);
            QCOMPARE(document::dimension(child), dimension);
            QVERIFY(document::hasCertainAttractor(child));
            QVERIFY(!document::isSameSystem(child, *parent));
            QVERIFY(child == variations.of(seed));
            QCOMPARE(child.name, parent->name);
        }
    }
}

void CrossingTest::childrenTakeFromBoth() {
    const FractalPointer parent = triangle();
    const document::Crossing<2> crossing(parent, *fern());
    int mine = 0, mixed = 0;
    std::size_t fewest = 100, most = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        document::Chance chance(seed);
        const Fractal child = crossing.child({}, chance);
        const auto& maps = crossedSystem(child).maps;
        int own = 0;
        for (const auto& map : maps)
            own += std::ranges::any_of(crossedSystem(*parent).maps,
                                       [&](const auto& known) { return known.map == map.map; });
        mine += own > 0 ? 1 : 0;
        mixed += own < int(maps.size()) ? 1 : 0;
        fewest = std::min(fewest, maps.size());
        most = std::max(most, maps.size());
        std::vector<ifs::MapId> ids;
        for (const auto& map : maps)
            ids.push_back(map.id);
        std::ranges::sort(ids);
        QVERIFY(std::ranges::adjacent_find(ids) == ids.end());
    }
    QVERIFY(mine > 20);
    QVERIFY(mixed >= 55);
    QCOMPARE(fewest, std::size_t{3});
    QCOMPARE(most, std::size_t{4});
}

void CrossingTest::scaleAndPlaceOfThePartnerDoNotMatter() {
    ifs::AffineMap<2> change;
    change.linear *= 40;
    change.translation = {300, -20};
    const Fractal far = *document::conjugated(*fern(), change);
    const document::Crossing<2> near(triangle(), *fern()), distant(triangle(), far);
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        document::Chance first(seed), second(seed);
        const Fractal a = near.child({}, first), b = distant.child({}, second);
        QCOMPARE(crossedSystem(a).maps.size(), crossedSystem(b).maps.size());
        for (std::size_t i = 0; i < crossedSystem(a).maps.size(); ++i) {
            const auto& x = crossedSystem(a).maps[i].map;
            const auto& y = crossedSystem(b).maps[i].map;
            QVERIFY((x.linear - y.linear).norm() < 1e-9);
            QVERIFY((x.translation - y.translation).norm() < 1e-9);
        }
    }
}

// Crossed with itself, its maps listed in another order, it stays itself.
void CrossingTest::mapsThatBelongTogetherArePaired() {
    const FractalPointer parent = triangle();
    Fractal turned = *parent;
    auto& maps = document::system2(turned)->maps;
    std::rotate(maps.begin(), maps.begin() + 1, maps.end());
    const document::Crossing<2> crossing(parent, turned);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        document::Chance chance(seed);
        const Fractal child = crossing.child({}, chance);
        QCOMPARE(crossedSystem(child).maps.size(), std::size_t{3});
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& was = crossedSystem(*parent).maps[i];
            const auto& is = crossedSystem(child).maps[i];
            QCOMPARE(is.id, was.id);
            QVERIFY((is.map.translation - was.map.translation).norm() < 1e-9);
            QVERIFY((is.map.linear - was.map.linear).norm() < 1e-9);
        }
    }
}

void CrossingTest::onlyWhatMayChangeIsMixed() {
    Fractal partner = *fern();
    partner.appearance.palette = attractor::builtInPalettes()[3];
    partner.appearance.colourBy = attractor::ColourBy::Map;
    const document::Crossing<2> crossing(triangle(), partner);
    bool takesPalette = false;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        document::Chance chance(seed);
        const Fractal weights = crossing.child({false, false, true}, chance);
        QVERIFY(weights.appearance == triangle()->appearance);
        QCOMPARE(crossedSystem(weights).maps.size(), std::size_t{3});
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY(crossedSystem(weights).maps[i].map == crossedSystem(*triangle()).maps[i].map);
        const Fractal colours = crossing.child({false, true, false}, chance);
        QVERIFY(crossedSystem(colours) == crossedSystem(*triangle()));
        QCOMPARE(colours.appearance.colourBy, triangle()->appearance.colourBy);
        takesPalette = takesPalette || colours.appearance.palette == partner.appearance.palette;
    }
    QVERIFY(takesPalette);
}

void CrossingTest::lockedMapsStay() {
    Fractal parent = *triangle();
    const auto locked = crossedSystem(parent).maps[1];
    parent.mapLabels.set(locked.id, {{}, true});
    const document::Variations variations(pointer(parent), {0.8, {true, true, true}, fern()});
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
        QCOMPARE(std::ranges::count(crossedSystem(variations.of(seed)).maps, locked), 1);
}

void CrossingTest::symmetryComesFromEither() {
    const auto partner = pointer(document::randomFractal({2, 2, ifs::SymmetryGroup::Rotation, 4}, 3));
    const document::Crossing<2> crossing(triangle(), *partner);
    int symmetric = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        document::Chance chance(seed);
        const Fractal child = crossing.child({}, chance);
        symmetric += crossedSystem(child).symmetry.group == ifs::SymmetryGroup::Rotation ? 1 : 0;
    }
    QVERIFY(symmetric > 10 && symmetric < 30);
}

BARYCAGE_TEST(CrossingTest);
#include "crossing_test.moc"
