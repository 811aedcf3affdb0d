// SPDX-License-Identifier: MIT
#include "document/edits/maps/map_shape.h"
#include "support/named_test.h"

#include <QTest>

#include <cstring>
#include <random>

using document::MapShape;

namespace {

bool isSame(const ifs::Matrix<2>& a, const ifs::Matrix<2>& b) {
    return std::memcmp(a.data(), b.data(), 4 * sizeof(double)) == 0;
}

ifs::Matrix<2> randomLinear(std::mt19937_64& random) {
    std::uniform_real_distribution<double> number(-1, 1);
    ifs::Matrix<2> linear;
    linear << number(random), number(random), number(random), number(random);
    return linear;
}

} // namespace

class MapShapeTest : public QObject {
    Q_OBJECT

private slots:
    void aChangeKeepsWhatItDoesNotConcern();
    void scalesOfMapsWithoutRotationStayApart();
    void goingBackGivesTheSameBits();
    void undoneChangesShowWhatWasTyped();
    void quarterTurnsAreExact();
    void changesInSpaceKeepWhatTheyDoNotConcern();
};

// The first column is scaleX·(cos, sin): neither scaleY nor the shear is in it.
void MapShapeTest::aChangeKeepsWhatItDoesNotConcern() {
    std::mt19937_64 random(1);
    for (int i = 0; i < 2000; ++i) {
        const ifs::Matrix<2> before = randomLinear(random);
        for (const MapShape::Part part : {MapShape::ScaleY, MapShape::Shear}) {
            MapShape shape;
            shape.show(before);
            const ifs::Matrix<2> after = shape.changed(part, 0.3);
            QCOMPARE(after(0, 0), before(0, 0));
            QCOMPARE(after(1, 0), before(1, 0));
            QVERIFY(after != before);
        }
    }
}

void MapShapeTest::scalesOfMapsWithoutRotationStayApart() {
    ifs::Matrix<2> linear;
    linear << 0.61, 0, 0, 0.31;
    MapShape shape;
    shape.show(linear);
    ifs::Matrix<2> wider;
    wider << 0.7, 0, 0, 0.31;
    QVERIFY(isSame(shape.changed(MapShape::ScaleX, 0.7), wider));
    wider(1, 1) = 0.1;
    QVERIFY(isSame(shape.changed(MapShape::ScaleY, 0.1), wider));
}

void MapShapeTest::goingBackGivesTheSameBits() {
    std::mt19937_64 random(2);
    for (int i = 0; i < 500; ++i) {
        const ifs::Matrix<2> before = randomLinear(random);
        MapShape shape;
        shape.show(before);
        const MapShape::Parts parts = shape.parts();
        for (int part = 0; part < MapShape::PartCount; ++part) {
            shape.show(shape.changed(MapShape::Part(part), 0.45));
            shape.show(shape.changed(MapShape::Part(part), 0.4));
        }
        ifs::Matrix<2> back = before;
        for (int part = 0; part < MapShape::PartCount; ++part)
            back = shape.changed(MapShape::Part(part), parts[std::size_t(part)]);
        QVERIFY(isSame(back, before));
    }
}

void MapShapeTest::undoneChangesShowWhatWasTyped() {
    MapShape shape;
    ifs::Matrix<2> before;
    before << 0.65, 0.32, -0.3, 0.48;
    shape.show(before);
    const MapShape::Parts parts = shape.parts();
    const ifs::Matrix<2> turned = shape.changed(MapShape::Rotation, 45);
    shape.show(turned);
    shape.show(shape.changed(MapShape::Shear, 0));
    shape.show(turned); // undo
    QCOMPARE(shape.parts()[MapShape::Rotation], 45.0);
    QCOMPARE(shape.parts()[MapShape::Shear], parts[MapShape::Shear]);
    QVERIFY(isSame(shape.changed(MapShape::Rotation, parts[MapShape::Rotation]), before));
}

void MapShapeTest::quarterTurnsAreExact() {
    ifs::Matrix<2> linear;
    linear << 0.61, 0, 0, 0.31;
    MapShape shape;
    shape.show(linear);
    ifs::Matrix<2> turned;
    turned << 0, -0.31, 0.61, 0;
    QVERIFY(isSame(shape.changed(MapShape::Rotation, 90), turned));
    QVERIFY(isSame(shape.changed(MapShape::Rotation, -270), turned));
    turned << -0.61, 0, 0, -0.31;
    QVERIFY(isSame(shape.changed(MapShape::Rotation, 180), turned));
    QCOMPARE(shape.changed(MapShape::Rotation, 30)(1, 0), 0.305);
    QVERIFY(isSame(shape.changed(MapShape::Rotation, 360), linear));
}

// A scale or a shear is in no column before its own.
void MapShapeTest::changesInSpaceKeepWhatTheyDoNotConcern() {
    using document::MapShape3;
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> number(-1, 1);
    for (int i = 0; i < 500; ++i) {
        const ifs::Matrix<3> before = ifs::Matrix<3>::NullaryExpr([&] { return number(random); });
        MapShape3 shape;
        shape.show(before);
        const MapShape3::Parts parts = shape.parts();
        const auto change = [&](MapShape3::Part part, int firstColumn) {
            const ifs::Matrix<3> after = shape.changed(part, 0.3);
            shape.show(after);
            QVERIFY(after.leftCols(firstColumn) == before.leftCols(firstColumn));
            QVERIFY(after.col(2) != before.col(2));
            shape.show(shape.changed(part, parts[part]));
        };
        change(MapShape3::ScaleY, 1);
        change(MapShape3::ScaleZ, 2);
        change(MapShape3::ShearXZ, 2);
        change(MapShape3::ShearYZ, 2);
        shape.show(shape.changed(MapShape3::AxisY, 0.9));
        shape.show(shape.changed(MapShape3::Angle, 20));
        QVERIFY(shape.changed(MapShape3::Angle, parts[MapShape3::Angle]) != before);
        QVERIFY(shape.changed(MapShape3::AxisY, parts[MapShape3::AxisY]) == before);
    }
}

BARYCAGE_TEST(MapShapeTest, QGuiApplication);
#include "map_shape_test.moc"
