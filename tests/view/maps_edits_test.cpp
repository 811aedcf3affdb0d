// SPDX-License-Identifier: MIT
#include "panels/maps_edits.h"
#include "view/maps_support.h"

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
            view::Rows rows;
            for (int row = 0; row < count; ++row)
                if (random() % 2) rows.push_back(row);
            const int before = static_cast<int>(random() % (count + 1U));
            const auto moved = view::withMapsMoved(fractal, rows, before);
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
        const auto edit = view::withDuplicates(maple(), {0, 2});
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
        const auto edit = view::withoutMaps(fractal, {3});
        QVERIFY(edit.fractal.appearance.mapColours.empty());
        QCOMPARE(document::system2(edit.fractal)->maps.size(), std::size_t(3));
    }

    void pastingReplacesKeepsIdsAndAppends() {
        const document::Fractal fractal = maple();
        const auto& old = document::system2(fractal)->maps;
        const auto pasted = document::system2(fractalOf(numbered(2)))->maps;

        const auto one = view::withMapsPasted(fractal, {1}, pasted);
        const auto& grown = document::system2(one.fractal)->maps;
        QCOMPARE(grown.size(), std::size_t(5));
        QVERIFY(grown[1].id == old[1].id && grown[1].map == pasted[0].map);
        QVERIFY(grown[2].map == pasted[1].map && grown[3] == old[2]);

        const auto three = view::withMapsPasted(fractal, {0, 1, 2}, pasted);
        const auto& shrunk = document::system2(three.fractal)->maps;
        QCOMPARE(shrunk.size(), std::size_t(3));
        QVERIFY(shrunk[1].map == pasted[1].map && shrunk[2] == old[3]);

        const auto none = view::withMapsPasted(fractal, {}, pasted);
        QCOMPARE(document::system2(none.fractal)->maps.size(), std::size_t(6));
    }

    void weightsByRule() {
        document::Fractal fractal = maple();
        const auto weights = [](const document::Fractal& f) {
            std::vector<double> all;
            for (const auto& map : document::system2(f)->maps)
                all.push_back(map.weight.value_or(-1));
            return all;
        };
        const auto determinant = weights(view::withWeights(fractal, view::WeightRule::Determinant));
        const std::array expected{4.0 / 157, 1891.0 / 10205, 798.0 / 2041, 4064.0 / 10205};
        for (std::size_t i = 0; i < 4; ++i)
            QVERIFY(qAbs(determinant[i] - expected[i]) < 1e-12);

        document::system2(fractal)->maps[0].weight = 3;
        document::system2(fractal)->maps[3].enabled = false;
        const auto equal = weights(view::withWeights(fractal, view::WeightRule::Equal));
        QCOMPARE(equal[1], 1.0 / 3);
        QCOMPARE(equal[3], 0.25); // off: untouched
        const auto normalised = weights(view::withWeights(fractal, view::WeightRule::Normalise));
        QVERIFY(qAbs(normalised[0] - 3 / 3.5) < 1e-15);
        QVERIFY(qAbs(normalised[0] + normalised[1] + normalised[2] - 1) < 1e-15);
    }

    void aNewMapTakesPart() {
        const auto edit = view::withNewMap(withTriangle(maple()));
        const auto& added = document::system2(edit.fractal)->maps.back();
        QCOMPARE(added.weight, std::optional(0.25));
        const auto fixed = ifs::fixedPoint(added.map);
        QVERIFY(fixed && (*fixed - ifs::Vector<2>(-1.0 / 3, 0)).norm() < 1e-12); // the middle of the triangle
    }

private:
    static std::vector<Row> numbered(int count) {
        std::vector<Row> rows;
        for (int i = 0; i < count; ++i)
            rows.push_back({0.5, 0, 0, 0.5, static_cast<double>(i), 0, 1});
        return rows;
    }
};

QTEST_APPLESS_MAIN(MapsEditsTest)
#include "maps_edits_test.moc"
