// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/separation/piece_contacts.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>

using namespace ifs;
using namespace canonical;

namespace {

template <int Dim> PieceContacts contactsOf(const std::vector<AffineMap<Dim>>& maps) {
    return pieceContacts(*SupportFunction<Dim>::of(maps));
}

Maps2 dust(double ratio) {
    Maps2 maps;
    for (const double x : {0., 1.})
        for (const double y : {0., 1.})
            maps.push_back(affineMap(ratio, 0, 0, ratio, x * (1 - ratio), y * (1 - ratio)));
    return maps;
}

template <int Dim>
std::vector<AffineMap<Dim>> seenThrough(const AffineMap<Dim>& image, std::vector<AffineMap<Dim>> maps) {
    for (auto& map : maps)
        map = *conjugate(image, map);
    return maps;
}

} // namespace

class PieceContactsTest : public QObject {
    Q_OBJECT

private slots:
    void touchingPieces() {
        for (const Maps2& maps : {sierpinskiRight(), heighway(), levy(), square()}) {
            const PieceContacts found = contactsOf<2>(maps);
            QCOMPARE(found.separation, Separation::Unknown);
            QCOMPARE(found.connectedness, Connectedness::Connected);
            QVERIFY(found.overlaps.empty());
        }
        const PieceContacts found = contactsOf<3>(tetrahedron());
        QCOMPARE(found.separation, Separation::Unknown);
        QCOMPARE(found.connectedness, Connectedness::Connected);
    }

    // Thirds and square roots are no doubles: the pieces of these codes miss each other by rounding, or not.
    void touchingToRounding() {
        QCOMPARE(contactsOf<2>(koch()).connectedness, Connectedness::ConnectedToRounding);
        const auto leaning = seenThrough<2>(affineMap(1, 30.1, 0, .7, 3, 4), sierpinskiRight());
        const PieceContacts found = contactsOf<2>(leaning);
        QVERIFY(found.separation != Separation::Strong);
        QVERIFY(found.connectedness == Connectedness::Connected ||
                found.connectedness == Connectedness::ConnectedToRounding);
    }

    void disjointPieces() {
        for (const double ratio : {0.1, 0.25, 0.4, 0.49}) {
            const PieceContacts found = contactsOf<2>(dust(ratio));
            QCOMPARE(found.separation, Separation::Strong);
            QCOMPARE(found.connectedness, Connectedness::Disconnected);
            QVERIFY(found.overlaps.empty());
        }
        for (const double ratio : {0.1, 0.25, 0.4}) {
            const auto leaning = seenThrough<2>(affineMap(1, 3, 0, 1, 3, 4), dust(ratio));
            QCOMPARE(contactsOf<2>(leaning).separation, Separation::Strong);
        }
        QCOMPARE(contactsOf<2>(dust(0.5)).separation, Separation::Unknown);
        QCOMPARE(contactsOf<2>(dust(0.5)).connectedness, Connectedness::Connected);
    }

    void aPieceOfItsOwn() {
        Maps2 maps = sierpinskiRight();
        for (auto& map : maps)
            map.linear *= 0.9;
        maps.push_back(affineMap(.1, 0, 0, .1, 30, 0));
        const PieceContacts found = contactsOf<2>(maps);
        QVERIFY(found.separation != Separation::Strong);
        QCOMPARE(found.connectedness, Connectedness::Disconnected);
    }

    void aMapWrittenTwice() {
        Maps2 maps = sierpinskiRight();
        maps.push_back(maps[1]);
        const PieceContacts found = contactsOf<2>(maps);
        QCOMPARE(found.separation, Separation::Overlapping);
        QVERIFY(!found.overlaps.empty());
        QCOMPARE(found.overlaps[0].first, Word{1});
        QCOMPARE(found.overlaps[0].second, Word{3});
        QVERIFY(found.overlaps[0].isExact);
        QCOMPARE(found.connectedness, Connectedness::Connected);
        Maps3 inSpace = tetrahedron();
        inSpace.push_back(inSpace[0]);
        QCOMPARE(contactsOf<3>(inSpace).separation, Separation::Overlapping);
    }

    // r² + r = 1: the words 1 2 2 and 2 1 1 shift by r + r² and 1.
    void wordsOfTheGoldenMean() {
        const double r = (std::sqrt(5) - 1) / 2;
        const PieceContacts found =
            contactsOf<2>(Maps2{affineMap(r, 0, 0, r, 0, 0), affineMap(r, 0, 0, r, 1, 0)});
        QCOMPARE(found.separation, Separation::Overlapping);
        QCOMPARE(found.overlaps[0].first, (Word{0, 1, 1}));
        QCOMPARE(found.overlaps[0].second, (Word{1, 0, 0}));
        // With quarters: x/2 and x/2 + ¼ and x/2 + ½ share 1 3 = 2 1 = … without rounding.
        const PieceContacts quarters = contactsOf<2>(Maps2{
            affineMap(.5, 0, 0, .5, 0, 0), affineMap(.5, 0, 0, .5, .25, 0), affineMap(.5, 0, 0, .5, .5, 0)});
        QCOMPARE(quarters.separation, Separation::Overlapping);
        QCOMPARE(quarters.overlaps[0].first, (Word{0, 2}));
        QCOMPARE(quarters.overlaps[0].second, (Word{1, 0}));
        QVERIFY(quarters.overlaps[0].isExact);
    }

    void onePoint() {
        const PieceContacts found = contactsOf<2>(Maps2{affineMap(.5, 0, 0, .5, 1, 2)});
        QCOMPARE(found.connectedness, Connectedness::Connected);
        QVERIFY(found.overlaps.empty());
    }

    // There rounding is a hundredth of the size, and short words seem to have the same maps.
    void smallAndFarAway() {
        const Maps2 small{affineMap(.5, 0, 0, .5, 0, 0), affineMap(.5, 0, 0, .5, 5e-11, 0),
                          affineMap(.5, 0, 0, .5, 0, 5e-11)};
        Maps2 far = small;
        for (auto& map : far)
            map.translation += Vector<2>(1, 1);
        for (const Maps2& maps : {small, far}) {
            const PieceContacts found = contactsOf<2>(maps);
            QCOMPARE(found.separation, Separation::Unknown);
            QVERIFY(found.overlaps.empty());
        }
        QCOMPARE(contactsOf<2>(small).connectedness, Connectedness::Connected);
        far.push_back(far[1]);
        QCOMPARE(contactsOf<2>(far).separation, Separation::Overlapping);
    }

    // What the last digits of a double can be blamed for, and what they cannot.
    void roundingIsAFewUlps() {
        for (const double gap : {0x1p-40, 0x1p-45, 0x1p-48, 0x1p-50})
            for (const double size : {1., 1e-6, 3e8}) {
                const PieceContacts found = contactsOf<2>(scaled<2>(dust(0.5 - gap), size));
                QVERIFY(found.connectedness != Connectedness::Connected);
                QVERIFY(found.connectedness != Connectedness::ConnectedToRounding);
            }
        Maps2 wide = dust(0.5 - 0x1p-45); // along the other axis, numbers are larger
        for (auto& map : wide)
            map.translation.x() += 1000;
        QVERIFY(contactsOf<2>(wide).connectedness != Connectedness::ConnectedToRounding);
        Maps2 thirds = dust(1 / 3.);
        thirds.push_back(affineMap(1 / 3., 0, 0, 1 / 3., 1 / 3., 1 / 3.)); // a Vicsek fractal
        QCOMPARE(contactsOf<2>(thirds).connectedness, Connectedness::ConnectedToRounding);
        // Two of its three pieces meet without rounding.
        QCOMPARE(contactsOf<2>(Maps2{affineMap(.5, 0, 0, .5, -2.563477, -.000003),
                                     affineMap(.5, 0, 0, .5, 2.436544, -.000003),
                                     affineMap(0, -.5, .5, 0, 4.873085, 7.563492)})
                     .connectedness,
                 Connectedness::ConnectedToRounding);
        for (const double typed : {.6180339887499, .61803398874988, .618034}) {
            const Maps2 maps{affineMap(typed, 0, 0, typed, 0, 0), affineMap(typed, 0, 0, typed, 1, 0)};
            QVERIFY(contactsOf<2>(maps).overlaps.empty());
            QVERIFY(contactsOf<2>(maps).separation == Separation::Unknown);
        }
        const double r = (std::sqrt(5) - 1) / 2;
        for (const double golden : {r, std::nextafter(r, 0), std::nextafter(r, 1)}) {
            const Maps2 maps{affineMap(golden, 0, 0, golden, 0, 0), affineMap(golden, 0, 0, golden, 1, 0)};
            QCOMPARE(contactsOf<2>(maps).separation, Separation::Overlapping);
            QVERIFY(!contactsOf<2>(maps).overlaps[0].isExact);
        }
        Maps2 twice = sierpinskiRight(); // a map, and nearly the same
        twice.push_back(affineMap(.5, 0, 0, .5, .5 + 0x1p-45, 0));
        QVERIFY(contactsOf<2>(twice).overlaps.empty());
        twice.back() = affineMap(.5, 0x1p-46, 0, .5, 0, .5);
        QVERIFY(contactsOf<2>(twice).overlaps.empty());
    }

    // Of what moves apart by 10⁻⁹, nothing is said that is not so.
    void almostTouching() {
        for (const double gap : {1e-3, 1e-6, 1e-9, -1e-9}) {
            const PieceContacts found = contactsOf<2>(dust(0.5 - gap));
            if (gap < 0)
                QVERIFY(found.separation != Separation::Strong);
            else
                QVERIFY(found.connectedness != Connectedness::Connected);
        }
    }
};

BARYCAGE_TEST(PieceContactsTest);
#include "piece_contacts_test.moc"
