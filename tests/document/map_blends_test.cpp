// SPDX-License-Identifier: MIT
#include "attractor/request/colour_coordinates.h"
#include "document/edits/maps/maps_edits.h"
#include "document/edits/maps/symmetry_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/maps/branch_handles.h"
#include "document/maps/map_solo.h"
#include "document/variations/chance.h"
#include "document/variations/varied_colours.h"
#include "support/named_test.h"

#include <QTest>

#include <array>
#include <cmath>
#include <memory>

using namespace document;
using attractor::ColourBy;
using attractor::MapBlend;

namespace {

Fractal blended() {
    Fractal fractal = sierpinskiTriangle();
    fractal.appearance.colourBy = ColourBy::Blend;
    const auto& maps = system2(fractal)->maps;
    fractal.appearance.mapBlends[maps[0].id] = {0.1, 0.75};
    fractal.appearance.mapBlends[maps[2].id] = {0.9, 0.25};
    return fractal;
}

MapBlend blendAt(const Fractal& fractal, std::size_t index) {
    const auto& maps = system2(fractal)->maps;
    return attractor::mapBlend(fractal.appearance, maps[index].id, index, maps.size());
}

bool isNear(const MapBlend& a, const MapBlend& b) {
    return std::abs(a.coordinate - b.coordinate) < 1e-14 && std::abs(a.speed - b.speed) < 1e-14;
}

} // namespace

// Blends of maps are copied, composed and forgotten with them.
class MapBlendsTest : public QObject {
    Q_OBJECT

private slots:
    void mapsThatAreGoneLeaveNone() {
        const Fractal fractal = withoutMaps(blended(), {0}).fractal;
        QVERIFY(isNear(blendAt(fractal, 0), {0, 0.5})); // of two
        QVERIFY(isNear(blendAt(fractal, 1), {0.9, 0.25}));
        QVERIFY(!fractal.appearance.mapBlends.find(system2(blended())->maps[0].id));
    }

    void copiesOfASymmetryBlendAsTheirMap() {
        Fractal fractal = blended();
        system2(fractal)->symmetry = {.group = ifs::SymmetryGroup::Rotation, .order = 3};
        const auto shown = attractor::colourCoordinates<2>(fractal.appearance, *system2(fractal),
                                                           ifs::activeMaps(*system2(fractal)));
        const Fractal listed = expanded(fractal);
        QCOMPARE(system2(listed)->maps.size(), std::size_t{9});
        const auto all = attractor::colourCoordinates<2>(listed.appearance, *system2(listed),
                                                         ifs::activeMaps(*system2(listed)));
        for (std::size_t i = 0; i < 9; ++i) {
            QVERIFY(isNear(blendAt(listed, i), blendAt(fractal, i / 3)));
            QCOMPARE(shown.next(i, 0.3), all.next(i, 0.3));
        }
    }

    // A word of maps does at once what its maps do one after the other.
    void aBranchBlendsAsItsWord() {
        Fractal fractal = blended();
        plane(fractal)->cage = ifs::polygonAtRest<2>({{0, 0}, {1, 0}, {0, 1}});
        const auto taken = branchHandles(std::make_shared<const Fractal>(fractal), *plane(fractal)->cage,
                                         {2, 0}, BranchEdit::OwnMap);
        QVERIFY(taken);
        const std::array<std::size_t, 1> first{taken->index};
        const Fractal after = taken->handles.withMapsMoved(first, {0.1, 0});
        QVERIFY(isNear(blendAt(after, 0), attractor::composed(blendAt(fractal, 2), blendAt(fractal, 0))));
        QVERIFY(isNear(blendAt(after, 1), attractor::composed(blendAt(fractal, 2), blendAt(fractal, 1))));
        QVERIFY(isNear(blendAt(after, 3), blendAt(fractal, 0)));
    }

    // A branch that becomes a map changes place and number of the maps, but no colour.
    void aBranchKeepsTheColoursOfAddresses_data() {
        QTest::addColumn<ifs::Word>("branch");
        QTest::addRow("two maps") << ifs::Word{2, 0};
        QTest::addRow("three maps") << ifs::Word{1, 2, 0};
        QTest::addRow("one map twice") << ifs::Word{1, 1};
    }
    void aBranchKeepsTheColoursOfAddresses() {
        QFETCH(const ifs::Word, branch);
        Fractal fractal = blended(); // with blends that do not show
        fractal.appearance.colourBy = ColourBy::Address;
        system2(fractal)->maps[1].weight = 5;
        plane(fractal)->cage = ifs::polygonAtRest<2>({{0, 0}, {1, 0}, {0, 1}});
        const auto taken = branchHandles(std::make_shared<const Fractal>(fractal), *plane(fractal)->cage,
                                         branch, BranchEdit::OwnMap);
        QVERIFY(taken);
        const std::array<std::size_t, 1> first{taken->index};
        const Fractal after = taken->handles.withMapsMoved(first, {0.1, 0});
        const auto active = ifs::activeMaps(*system2(after));
        const auto colours = attractor::colourCoordinates<2>(after.appearance, *system2(after), active);
        const std::vector<ifs::Word> words = ifs::cutSet(branch, 3);
        QCOMPARE(words.size(), active.maps.size());
        for (std::size_t i = 0; i < words.size(); ++i)
            for (const double c : {0.0, 0.3, 1.0}) {
                double wanted = c;
                for (auto letter = words[i].rbegin(); letter != words[i].rend(); ++letter)
                    wanted = (*letter + wanted) / 3;
                QVERIFY(std::abs(colours.next(i, c) - wanted) < 1e-14);
            }
    }

    // One map alone has the colours that its piece had.
    void aMapAloneKeepsItsColours() {
        const Fractal fractal = blended();
        for (std::size_t i = 0; i < 3; ++i) {
            const Fractal alone = soloed(fractal, system2(fractal)->maps[i].id);
            const MapBlend blend = blendAt(fractal, i);
            for (int k = 0; k <= 20; ++k) {
                const double c = k / 20.0;
                const auto got = attractor::colourAt(alone.appearance.palette, c);
                const auto wanted = attractor::colourAt(
                    fractal.appearance.palette, (1 - blend.speed) * c + blend.speed * blend.coordinate);
                QVERIFY(std::abs(got.red - wanted.red) <= 1 && std::abs(got.green - wanted.green) <= 1 &&
                        std::abs(got.blue - wanted.blue) <= 1);
            }
        }
    }

    // Mutations change them only where they make the colours, and without a new number by chance elsewhere.
    void mutationsChangeThemWhereTheyColour() {
        Fractal fractal = blended();
        Chance chance(5);
        varyColours(fractal, 0.5, chance);
        QVERIFY(!(fractal.appearance.mapBlends == blended().appearance.mapBlends));
        for (std::size_t i = 0; i < 3; ++i) {
            const MapBlend blend = blendAt(fractal, i);
            QVERIFY(blend.coordinate >= 0 && blend.coordinate <= 1 && blend.speed > 0 && blend.speed <= 1);
        }
        Fractal other = blended();
        other.appearance.colourBy = ColourBy::Map;
        varyColours(other, 0.5, chance);
        QVERIFY(other.appearance.mapBlends == blended().appearance.mapBlends);
    }
};

BARYCAGE_TEST(MapBlendsTest, QCoreApplication);
#include "map_blends_test.moc"
