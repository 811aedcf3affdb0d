// SPDX-License-Identifier: MIT
#include "document/tops/map_faces.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QTest>

using document::Fractal;
using document::MapFace;

namespace {

Fractal withMaps(int maps) {
    document::System2 system;
    for (int i = 0; i < maps; ++i)
        ifs::append(system, ifs::affineMap(.4, 0, 0, .4, i, 0));
    return support::fractalOf(system);
}

attractor::Rgba colourOf(const Fractal& fractal, std::size_t index) {
    return attractor::mapColour(fractal.appearance, document::system2(fractal)->maps[index].id, index);
}

} // namespace

// The maps of a partner look like their counterparts.
class MapFacesTest : public QObject {
    Q_OBJECT

private slots:
    void thoseThatTakePartCorrespond() {
        Fractal from = withMaps(4), to = withMaps(4);
        document::system2(from)->maps[1].enabled = false;
        document::system2(to)->maps[0].weight = 0;
        from.appearance.mapColours[document::system2(from)->maps[2].id] = {1, 2, 3, 255};
        to.appearance.mapColours[document::system2(to)->maps[0].id] = {4, 5, 6, 255};
        const document::MapFaces faces = document::facesOfPartner(from, to);
        const document::MapFaces expected{
            {{4, 5, 6, 255}, 0}, {colourOf(from, 0), 1}, {{1, 2, 3, 255}, 3}, {colourOf(from, 3), 4}};
        QVERIFY(faces == expected);
    }

    void copiesUnderASymmetryCount() {
        Fractal from = withMaps(2);
        document::system2(from)->symmetry.group = ifs::SymmetryGroup::Mirror;
        const Fractal to = withMaps(4);
        const document::MapFaces faces = document::facesOfPartner(from, to);
        QCOMPARE(faces.size(), std::size_t{4});
        for (std::size_t i = 0; i < 4; ++i)
            QVERIFY(faces[i] == (MapFace{colourOf(from, i / 2), i / 2 + 1}));
        const document::MapFaces back = document::facesOfPartner(to, from);
        QVERIFY(back == (document::MapFaces{{colourOf(to, 0), 1}, {colourOf(to, 2), 3}}));
    }

    void otherNumbersDoNotCorrespond() {
        QVERIFY(document::facesOfPartner(withMaps(2), withMaps(3)).empty());
        QVERIFY(document::facesOfPartner(withMaps(2), Fractal()).empty());
        QVERIFY(!document::facesOfPartner(withMaps(2), withMaps(2)).empty());
    }
};

BARYCAGE_TEST(MapFacesTest);
#include "map_faces_test.moc"
