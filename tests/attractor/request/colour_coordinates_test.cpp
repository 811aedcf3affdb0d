// SPDX-License-Identifier: MIT
#include "attractor/request/colour_coordinates.h"

#include "attractor/cut/address_cut.h"
#include "attractor/samples/chaos_game.h"
#include "attractor/systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <array>
#include <cmath>

using namespace attractor;

namespace {

Appearance blendOf(const ifs::IteratedFunctionSystem<2>& system, const std::vector<MapBlend>& blends) {
    Appearance appearance;
    appearance.colourBy = ColourBy::Blend;
    for (std::size_t i = 0; i < blends.size(); ++i)
        appearance.mapBlends[system.maps[i].id] = blends[i];
    return appearance;
}

ColourCoordinates coordinatesOf(const ifs::IteratedFunctionSystem<2>& system, const Appearance& appearance) {
    return colourCoordinates<2>(appearance, system, prepared(system));
}

ifs::IteratedFunctionSystem<2> tiling(int columns, int rows) {
    auto system = systems::tiling(columns, rows);
    for (std::size_t i = 0; i < system.maps.size(); ++i)
        system.maps[i].id = static_cast<ifs::MapId>(i + 1);
    return system;
}

// The blends of which colours by address are the case.
std::vector<MapBlend> addressBlends(std::size_t maps) {
    std::vector<MapBlend> blends;
    for (std::size_t i = 0; i < maps; ++i)
        blends.push_back(addressBlend(i, maps));
    return blends;
}

} // namespace

class TestColourCoordinates : public QObject {
    Q_OBJECT

private slots:
    void mapsWithoutABlendArePlacedEvenly() {
        QVERIFY((usualBlend(0, 1) == MapBlend{0, 0.5}));
        QVERIFY((usualBlend(2, 5) == MapBlend{0.5, 0.5}));
        Appearance appearance;
        appearance.mapBlends[ifs::MapId{7}] = {0.3, 0.9};
        QVERIFY((mapBlend(appearance, ifs::MapId{7}, 0, 3) == MapBlend{0.3, 0.9}));
        QVERIFY((mapBlend(appearance, ifs::MapId{8}, 2, 3) == MapBlend{1, 0.5}));
    }

    // A_σ and B_σ of the formula, map by map and for all of a word.
    void wordsFollowTheFormula() {
        const auto system = systems::fern();
        const std::array<MapBlend, 4> blends{{{0.1, 0.5}, {0.9, 0.25}, {0.4, 1}, {0.7, 0}}};
        const ColourCoordinates along =
            coordinatesOf(system, blendOf(system, {blends.begin(), blends.end()}));
        for (const std::vector<std::size_t>& word :
             {std::vector<std::size_t>{1}, {0, 1, 3}, {3, 3, 0, 1, 1}, {0, 2, 1}, {}}) {
            double start = 0, width = 1;
            PaletteInterval interval;
            for (const std::size_t map : word) {
                start += width * blends[map].speed * blends[map].coordinate;
                width *= 1 - blends[map].speed;
                interval = along.child(interval, map);
            }
            QVERIFY(std::abs(interval.start - start) < 1e-15 && std::abs(interval.width - width) < 1e-15);
            double c = 0.37; // of a point, to which the maps are applied from the innermost on
            MapBlend one{0, 0};
            for (auto map = word.rbegin(); map != word.rend(); ++map)
                c = along.next(*map, c);
            for (const std::size_t map : word)
                one = composed(one, blends[map]);
            QVERIFY(std::abs(c - (start + width * 0.37)) < 1e-15);
            QVERIFY(std::abs(1 - one.speed - width) < 1e-15);
            QVERIFY(std::abs(one.speed * one.coordinate - start) < 1e-15);
        }
    }

    // The mean over the measure is a fixed point: Σ p_i ((1 − s_i) m + s_i c_i) = m.
    void theMeanStays() {
        const auto system = systems::fern();
        const ColourCoordinates along =
            coordinatesOf(system, blendOf(system, {{0, 0.2}, {0.9, 0.5}, {0.4, 1}, {0.7, 0.05}}));
        const PreparedSystem drawable = prepared(system);
        const double mean = along.middle({});
        double next = 0;
        for (std::size_t i = 0; i < drawable.maps.size(); ++i)
            next += drawable.probabilities[i] * along.next(i, mean);
        QVERIFY(std::abs(next - mean) < 1e-14);
        // One place for all of them: one colour, and no word to divide.
        const ColourCoordinates one =
            coordinatesOf(system, blendOf(system, {{0.3, 0.2}, {0.3, 0.5}, {0.3, 1}, {0.9, 0}}));
        QVERIFY(std::abs(one.middle({}) - 0.3) < 1e-15 && !one.isMixed({}));
        const ColourCoordinates none =
            coordinatesOf(system, blendOf(system, {{0.3, 0}, {0.3, 0}, {0.3, 0}, {0.9, 0}}));
        QCOMPARE(none.middle({}), 0.5);
        QVERIFY(!none.isMixed({}));
    }

    // Colours by address are a blend: words and orbits have the same coordinates.
    void theAddressIsASpecialCase() {
        for (const auto& system : {systems::sierpinski(), tiling(2, 2), tiling(1, 2)}) {
            const std::size_t n = system.maps.size();
            const ColourCoordinates blend = coordinatesOf(system, blendOf(system, addressBlends(n)));
            Appearance byAddress;
            byAddress.colourBy = ColourBy::Address;
            const ColourCoordinates address = coordinatesOf(system, byAddress);
            CutSettings settings;
            for (std::size_t words = 1; words < 64; words *= n)
                ++settings.minDepth;
            const Camera camera = systems::camera(system, 300, 200);
            const PreparedSystem drawable = prepared(system);
            settings.colours = address;
            const AddressCut wanted = addressCut(drawable, projection(camera, {}, 1), settings);
            settings.colours = blend;
            const AddressCut found = addressCut(drawable, projection(camera, {}, 1), settings);
            QCOMPARE(found.words.size(), wanted.words.size());
            for (std::size_t k = 0; k < found.words.size(); ++k) {
                QCOMPARE(found.words[k].offset, wanted.words[k].offset);
                QVERIFY(std::abs(found.words[k].addressCoordinate - wanted.words[k].addressCoordinate) <
                        1e-14);
            }
            Orbit first(drawable, 3, 0, address), second(drawable, 3, 60, blend);
            for (int k = 0; k < 60; ++k)
                first.next();
            for (int k = 0; k < 100; ++k) {
                const Orbit::Point a = first.next(), b = second.next();
                QCOMPARE(a.colourCoordinate, a.addressCoordinate);
                QVERIFY(a.x == b.x && std::abs(a.colourCoordinate - b.colourCoordinate) < 1e-12);
            }
        }
    }

    // As many words as that takes, where they have samples; without blends the cut is the one it was.
    void wordsAreDividedUntilTheyHaveOneColour() {
        const auto system = tiling(2, 2);
        const PreparedSystem drawable = prepared(system);
        const auto place = projection(systems::camera(system, 300, 200), {}, 1);
        CutSettings settings;
        settings.words = 128;
        const std::size_t usual = addressCut(drawable, place, settings).words.size();
        settings.colours = coordinatesOf(system, blendOf(system, {})); // 2^−depth ≤ 1/64
        const AddressCut fine = addressCut(drawable, place, settings);
        QCOMPARE(usual, std::size_t{256});
        QCOMPARE(fine.words.size(), std::size_t{4096});
        QVERIFY(!fine.isThinned && std::abs(fine.probability - 1) < 1e-12);
        // Speeds so slow that no budget would do.
        settings.colours =
            coordinatesOf(system, blendOf(system, {{0, 0.01}, {1, 0.01}, {0, 0.01}, {1, 0.01}}));
        const AddressCut most = addressCut(drawable, place, settings);
        QVERIFY(most.words.size() > 4096 && most.words.size() <= 65536 && !most.isThinned);
        // Words of few samples stay as they are.
        settings.samples = 32 * 1000;
        QVERIFY(addressCut(drawable, place, settings).words.size() <= 1024);
    }
};

BARYCAGE_TEST(TestColourCoordinates);
#include "colour_coordinates_test.moc"
