// SPDX-License-Identifier: MIT
#include "document/edits/maps/maps_edits.h"
#include "support/named_test.h"
#include "view/panels/maps_support.h"

#include <numeric>
#include <random>
#include <set>

using namespace maps_support;

class MapsEditsTest : public QObject {
    Q_OBJECT

private slots:
    void movingIsAPermutation() {
        std::mt19937 random(7);
        for (int round = 0; round < 200; ++round) {
            const int count = 1 + static_cast<int>(random() % 8);
            const document::Fractal fractal = fractalOf(numbered(count));
            document::Rows rows;
            for (int row = 0; row < count; ++row)
                if (random() % 2) rows.push_back(row);
            const int before = static_cast<int>(random() % (count + 1U));
            const auto moved = document::withMapsMoved(fractal, rows, before);
            const auto& maps = document::system2(moved.fractal)->maps;

            // The oracle: take the rows out, count how many of the rest come before the place, put them in
            // there.
            std::vector<int> order, block;
            std::size_t place = 0;
            for (int row = 0; row < count; ++row) {
                if (std::find(rows.begin(), rows.end(), row) != rows.end()) {
                    block.push_back(row);
                } else {
                    place += row < before ? 1 : 0;
                    order.push_back(row);
                }
            }
            order.insert(order.begin() + static_cast<std::ptrdiff_t>(place), block.begin(), block.end());
            QCOMPARE(maps.size(), order.size());
            for (std::size_t i = 0; i < order.size(); ++i)
                QVERIFY(maps[i] == document::system2(fractal)->maps[static_cast<std::size_t>(order[i])]);
        }
    }

    void duplicatesGetFreshIds() {
        const auto edit = document::withDuplicates(maple(), {0, 2});
        const auto& maps = document::system2(edit.fractal)->maps;
        QCOMPARE(maps.size(), std::size_t(6));
        QVERIFY(maps[3].map == maps[0].map && maps[4].map == maps[2].map);
        std::set<ifs::MapId> ids;
        for (const auto& map : maps)
            ids.insert(map.id);
        QCOMPARE(ids.size(), std::size_t(6));
        QCOMPARE(edit.touched, (std::vector{maps[3].id, maps[4].id}));
    }

    void deletingForgetsTheColour() {
        document::Fractal fractal = maple();
        const ifs::MapId last = document::system2(fractal)->maps[3].id;
        fractal.appearance.mapColours[last] = {1, 2, 3, 255};
        const auto edit = document::withoutMaps(fractal, {3});
        QVERIFY(edit.fractal.appearance.mapColours.empty());
        QCOMPARE(document::system2(edit.fractal)->maps.size(), std::size_t(3));
    }

    void pastingReplacesKeepsIdsAndAppends() {
        const document::Fractal fractal = maple();
        const auto& old = document::system2(fractal)->maps;
        const auto pasted = document::system2(fractalOf(numbered(2)))->maps;

        const auto one = document::withMapsPasted(fractal, {1}, pasted);
        const auto& grown = document::system2(one.fractal)->maps;
        QCOMPARE(grown.size(), std::size_t(5));
        QVERIFY(grown[1].id == old[1].id && grown[1].map == pasted[0].map);
        QVERIFY(grown[2].map == pasted[1].map && grown[3].id == old[2].id);

        const auto three = document::withMapsPasted(fractal, {0, 1, 2}, pasted);
        const auto& shrunk = document::system2(three.fractal)->maps;
        QCOMPARE(shrunk.size(), std::size_t(3));
        QVERIFY(shrunk[1].map == pasted[1].map && shrunk[2].id == old[3].id);

        const auto none = document::withMapsPasted(fractal, {}, pasted);
        QCOMPARE(document::system2(none.fractal)->maps.size(), std::size_t(6));
    }

    // In proportion, so that no share changes in relation to another; other sums are left alone.
    void weightsThatSumToOneDoSoAgain() {
        document::Fractal fractal = weighted({0.5, 0.25, 0.25});
        QCOMPARE(weights(document::withoutMaps(fractal, {0}).fractal), (std::vector{0.5, 0.5}));
        QCOMPARE(weights(document::withDuplicates(fractal, {1, 2}).fractal),
                 (std::vector{1.0 / 3, 1.0 / 6, 1.0 / 6, 1.0 / 6, 1.0 / 6}));
        QCOMPARE(weights(document::withNewMap(withTriangle(fractal)).fractal).back(), 0.25);
        const auto pasted = document::system2(weighted({1, 0}))->maps;
        QCOMPARE(weights(document::withMapsPasted(fractal, {}, pasted).fractal),
                 (std::vector{0.25, 0.125, 0.125, 0.5, 0.0}));
        QCOMPARE(weights(document::withMapsPasted(fractal, {0}, pasted).fractal),
                 (std::vector{2.0 / 3, 0.0, 1.0 / 6, 1.0 / 6}));

        document::system2(fractal)->maps[0].enabled = false; // they sum to 1/2 now
        QCOMPARE(weights(document::withoutMaps(fractal, {2}).fractal), (std::vector{0.5, 0.25}));
        document::system2(fractal)->maps[1].weight = 0.75;
        QCOMPARE(weights(document::withoutMaps(fractal, {2}).fractal), (std::vector{0.5, 1.0}));
        document::system2(fractal)->maps[1].weight.reset(); // the determinants rule
        QCOMPARE(weights(document::withoutMaps(fractal, {2}).fractal), (std::vector{0.5, -1.0}));
        QVERIFY(document::system2(document::withoutMaps(fractal, {0, 1, 2}).fractal)->maps.empty());
        const document::Fractal large = weighted({3, 1});
        QCOMPARE(weights(document::withDuplicates(large, {1}).fractal), (std::vector{3.0, 1.0, 1.0}));
    }

    void weightsByRule() {
        document::Fractal fractal = maple();
        const auto determinant = weights(document::withWeights(fractal, document::WeightRule::Determinant));
        const std::array expected{4.0 / 157, 1891.0 / 10205, 798.0 / 2041, 4064.0 / 10205};
        for (std::size_t i = 0; i < 4; ++i)
            QVERIFY(qAbs(determinant[i] - expected[i]) < 1e-12);

        document::system2(fractal)->maps[0].weight = 3;
        document::system2(fractal)->maps[3].enabled = false;
        const auto equal = weights(document::withWeights(fractal, document::WeightRule::Equal));
        QCOMPARE(equal[1], 1.0 / 3);
        QCOMPARE(equal[3], 0.25); // off: untouched
        const auto normalised = weights(document::withWeights(fractal, document::WeightRule::Normalise));
        QVERIFY(qAbs(normalised[0] - 3 / 3.5) < 1e-15);
        QVERIFY(qAbs(normalised[0] + normalised[1] + normalised[2] - 1) < 1e-15);
    }

    void lockedWeightsStay() {
        document::Fractal fractal = weighted({0.4, 0.4, 0.1, 0.1});
        const auto lock = [&](std::size_t index) {
            fractal.mapLabels.set(document::system2(fractal)->maps[index].id, {{}, true});
        };
        lock(0);
        const auto equal = weights(document::withWeights(fractal, document::WeightRule::Equal));
        QCOMPARE(equal[0], 0.4);
        for (std::size_t i = 1; i < 4; ++i)
            QVERIFY(qAbs(equal[i] - 0.2) < 1e-12);
        document::system2(fractal)->maps[0].weight = 3; // leaves nothing of 1: the sum stays
        const auto large = weights(document::withWeights(fractal, document::WeightRule::Equal));
        QCOMPARE(large[0], 3.0);
        QVERIFY(qAbs(large[1] - 0.2) < 1e-12);
        for (const std::size_t index : {1, 2, 3})
            lock(index);
        QVERIFY(document::withWeights(fractal, document::WeightRule::Equal) == fractal);
    }

    void aNewMapTakesPart() {
        const auto edit = document::withNewMap(withTriangle(maple()));
        const auto& added = document::system2(edit.fractal)->maps.back();
        QCOMPARE(added.weight, std::optional(0.2)); // as much as the others have now
        const auto fixed = ifs::fixedPoint(added.map);
        QVERIFY(fixed && (*fixed - ifs::Vector<2>(-1.0 / 3, 0)).norm() < 1e-12); // the middle of the triangle
    }

    void editsAreTheSameInSpace() {
        const document::Fractal fern = withTetrahedron(fernInSpace());
        const auto& old = document::system3(fern)->maps;

        const auto added = document::withNewMap(fern);
        const auto& grown = document::system3(added.fractal)->maps;
        QCOMPARE(grown.size(), std::size_t(5));
        QCOMPARE(grown.back().weight, std::optional(0.2));
        const auto fixed = ifs::fixedPoint(grown.back().map);
        QVERIFY(fixed && (*fixed - ifs::Vector<3>(2, 2, 2)).norm() < 1e-12); // the middle of the cage
        QCOMPARE(added.touched, std::vector{grown.back().id});
        QVERIFY(grown.back().id != old[3].id);

        const auto doubled = document::withDuplicates(fern, {0, 2});
        const auto& twice = document::system3(doubled.fractal)->maps;
        QCOMPARE(twice.size(), std::size_t(6));
        QVERIFY(twice[3].map == old[0].map && twice[4].map == old[2].map && twice[5].id == old[3].id);
        QCOMPARE(doubled.touched, (std::vector{twice[3].id, twice[4].id}));

        document::Fractal coloured = fern;
        coloured.appearance.mapColours[old[3].id] = {1, 2, 3, 255};
        const auto less = document::withoutMaps(coloured, {1, 3});
        const auto& kept = document::system3(less.fractal)->maps;
        QVERIFY(kept.size() == 2 && kept[0].id == old[0].id && kept[1].id == old[2].id);
        QVERIFY(less.fractal.appearance.mapColours.empty());
        QCOMPARE(less.touched, std::vector{old[2].id});

        const auto moved = document::withMapsMoved(fern, {0, 1}, 4);
        const auto& order = document::system3(moved.fractal)->maps;
        QVERIFY(order[0] == old[2] && order[1] == old[3] && order[2] == old[0] && order[3] == old[1]);
        QCOMPARE(moved.touched, (std::vector{old[0].id, old[1].id}));
    }

    void weightsInSpace() {
        document::Fractal fern = fernInSpace();
        for (auto& map : document::system3(fern)->maps)
            map.weight.reset();
        const auto before = ifs::probabilities(*document::system3(fern));
        const document::Fractal weighted = document::withWeight(fern, 1, 0.5);
        const auto& maps = document::system3(weighted)->maps;
        QCOMPARE(maps[1].weight, std::optional(0.5));
        QCOMPARE(maps[2].weight, std::optional(before[2]));
        const document::Fractal equal = document::withWeights(fern, document::WeightRule::Equal);
        for (const auto& map : document::system3(equal)->maps)
            QCOMPARE(map.weight, std::optional(0.25));
        const document::Fractal byVolume = document::withWeights(fern, document::WeightRule::Determinant);
        const auto& volumes = document::system3(byVolume)->maps;
        const auto volume = [&](std::size_t i) {
            return std::abs(ifs::determinant<3>(volumes[i].map.linear));
        };
        QVERIFY(qAbs(*volumes[1].weight / *volumes[2].weight - volume(1) / volume(2)) < 1e-9);
    }

private:
    static std::vector<double> weights(const document::Fractal& fractal) {
        std::vector<double> all;
        for (const auto& map : document::system2(fractal)->maps)
            all.push_back(map.weight.value_or(-1));
        return all;
    }

    static document::Fractal weighted(const std::vector<double>& weights) {
        document::Fractal fractal = fractalOf(numbered(int(weights.size())));
        for (std::size_t i = 0; i < weights.size(); ++i)
            document::system2(fractal)->maps[i].weight = weights[i];
        return fractal;
    }

    static std::vector<Row> numbered(int count) {
        std::vector<Row> rows;
        for (int i = 0; i < count; ++i)
            rows.push_back({0.5, 0, 0, 0.5, static_cast<double>(i), 0, 1});
        return rows;
    }
};

BARYCAGE_TEST(MapsEditsTest);
#include "maps_edits_test.moc"
