// SPDX-License-Identifier: MIT
#include "document/fractal/fractal_geometry.h"
#include "io/exchange/flame.h"
#include "io/exchange/text_formats.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QTest>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <random>

using attractor::ColourBy;
using attractor::MapBlend;
using document::Fractal;

namespace {

QByteArray palette() {
    QByteArray hex;
    for (int i = 0; i < 256; ++i)
        hex += QByteArray::number(i, 16).rightJustified(2, '0') + "3020";
    return "<palette count=\"256\" format=\"RGB\">" + hex + "</palette>";
}

QByteArray xform(const QByteArray& attributes) {
    return "<xform weight=\"1\" linear=\"1\" coefs=\".5 0 0 .5 1 0\" " + attributes + "/>";
}

Fractal read(const QByteArray& flame) {
    const document::FractalFile file = io::readFlame(flame);
    return file.entries.isEmpty() ? Fractal() : *file.entries.first().fractal;
}

QByteArray written(const Fractal& fractal) {
    return io::writeFlame({std::make_shared<const Fractal>(fractal)});
}

std::optional<MapBlend> blendAt(const Fractal& fractal, std::size_t index) {
    const MapBlend* blend = fractal.appearance.mapBlends.find(document::system2(fractal)->maps[index].id);
    return blend ? std::optional(*blend) : std::nullopt;
}

Fractal threeMaps() {
    document::System2 system;
    for (int i = 0; i < 3; ++i)
        ifs::append(system, ifs::affineMap(0.5, 0, 0, 0.5, i, 0), 1.0);
    return support::fractalOf(std::move(system), QStringLiteral("three"));
}

} // namespace

class FlameBlendTest : public QObject {
    Q_OBJECT

private slots:
    void placesAndSpeedsAreRead() {
        const Fractal fractal =
            read("<flame name=\"a\">" + xform("color=\"0.25\" color_speed=\"0.75\"") +
                 xform("color=\"0.1 0\" symmetry=\"0.5\"") + xform("color=\"1\"") + xform("symmetry=\"-1\"") +
                 xform("") + xform("color=\"7\" color_speed=\"2\"") +
                 xform("color=\"nan\" color_speed=\"0.5\" symmetry=\"-1\"") + palette() + "</flame>");
        QVERIFY(fractal.appearance.colourBy == ColourBy::Blend);
        QVERIFY((blendAt(fractal, 0) == MapBlend{0.25, 0.75}));
        QVERIFY((blendAt(fractal, 1) == MapBlend{0.1, 0.25}));
        QVERIFY((blendAt(fractal, 2) == MapBlend{1, 0.5}));
        QVERIFY((blendAt(fractal, 3) == MapBlend{0.5, 1})); // as it is placed without a colour
        QVERIFY(!blendAt(fractal, 4));
        QVERIFY((blendAt(fractal, 5) == MapBlend{1, 1}));
        QVERIFY((blendAt(fractal, 6) == MapBlend{1, 0.5}));
    }

    // What is deeper is what programs keep: earlier versions, or notes.
    void onlyChildrenAreRead() {
        const QByteArray map = "<xform weight=\"1\" linear=\"1\" coefs=\"0.5 0 0 0.5 0 0\"/>\n";
        const QByteArray old = "<xform weight=\"3\" linear=\"1\" coefs=\"0.2 0 0 0.2 0 0\"/>";
        const QByteArray kept = "<flame name=\"old\">" + old + "<finalxform linear=\"1\"/><layer/></flame>" +
                                old + "<motion/><palette count=\"2\">0000FF</palette><symmetry kind=\"99\"/>";
        for (const QByteArray& beside : QList<QByteArray>{
                 "<edit nick=\"a\">" + kept + "</edit>", "<backup><more>" + kept + "</more></backup>",
                 QByteArray("<color index=\"0\" rgb=\"255 0 0\">") + old + "</color>",
                 "<palette count=\"1\" format=\"RGB\">FFFFFF" + old + "</palette>"}) {
            const QByteArray child =
                "<xform weight=\"1\" linear=\"1\" coefs=\"0.5 0 0 0.5 1 0\">" + beside + "</xform>\n";
            const auto file =
                io::readFlame("<flame name=\"a\">" + beside + map + beside + child + "</flame>");
            QVERIFY2(file.problems.isEmpty(), qPrintable(file.problems.value(0).message));
            QCOMPARE(file.entries.size(), 1);
            const document::System2& system = *document::system2(*file.entries.first().fractal);
            QCOMPARE(system.maps.size(), 2U);
            QCOMPARE(system.maps[1].map.translation.x(), 1.0);
        }
        const auto moving =
            io::readFlame("<flame name=\"a\">" + map +
                          "<xform weight=\"1\" linear=\"1\" coefs=\"0.5 0 0 0.5 0 0\"><motion/></xform>" +
                          "<edit>" + kept + "</edit></flame>");
        QCOMPARE(moving.problems.size(), 1);
        QVERIFY(moving.problems[0].message.contains(QStringLiteral("it has motion")));
        QVERIFY(moving.entries.isEmpty());
    }

    // Without colours in the file, nothing is coloured by them.
    void aPaletteIsNeeded() {
        const Fractal fractal = read("<flame name=\"a\">" + xform("color=\"0.25\"") + "</flame>");
        QVERIFY(fractal.appearance.colourBy == ColourBy::Density);
        const Fractal plain = read("<flame name=\"a\">" + xform("") + palette() + "</flame>");
        QVERIFY(plain.appearance.colourBy == ColourBy::Density && plain.appearance.mapBlends.empty());
    }

    void blendsComeBackExactly() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> number(0, 1);
        for (const ColourBy colourBy :
             {ColourBy::Blend, ColourBy::Density, ColourBy::Address, ColourBy::Plain}) {
            for (int round = 0; round < 50; ++round) {
                Fractal fractal = threeMaps();
                fractal.appearance.colourBy = colourBy;
                for (const auto& map : document::system2(fractal)->maps)
                    if (number(random) < 0.7)
                        fractal.appearance.mapBlends[map.id] = {number(random), number(random)};
                const Fractal back = read(written(fractal));
                QVERIFY(back.appearance.colourBy == colourBy);
                QVERIFY(back.appearance.mapBlends == fractal.appearance.mapBlends);
                QVERIFY(!io::lossOf(io::TextFormat::Flame, fractal));
            }
        }
    }

    // A flame of another program is read and written with the numbers it had, and nothing is lost.
    void flamesOfOthersKeepTheirNumbers() {
        const Fractal fractal = read("<flame name=\"a\">" + xform("color=\"0.3\" color_speed=\"0.1\"") +
                                     xform("color=\"0.6\" symmetry=\"0\"") + palette() + "</flame>");
        const QByteArray text = written(fractal);
        QVERIFY2(text.contains("color=\"0.3\" color_speed=\"0.1\"") &&
                     text.contains("color=\"0.6\" color_speed=\"0.5\""),
                 text.constData());
        QVERIFY(!io::lossOf(io::TextFormat::Flame, fractal));
        const Fractal back = read(text);
        QVERIFY(back.appearance.mapBlends == fractal.appearance.mapBlends);
        for (const auto& map : document::system2(fractal)->maps) {
            const attractor::Rgba* now = back.appearance.mapColours.find(map.id);
            const attractor::Rgba* before = fractal.appearance.mapColours.find(map.id);
            QVERIFY(now && before); // the stops of a palette may be off by 1 between them
            QVERIFY(std::abs(now->red - before->red) <= 1 && std::abs(now->green - before->green) <= 1 &&
                    std::abs(now->blue - before->blue) <= 1);
        }
        QVERIFY(back.appearance.colourBy == ColourBy::Blend);
    }

    // Where the places are those of the colours of the maps, blends have none, and it is said.
    void coloursByMapTakeTheirPlace() {
        Fractal fractal = threeMaps();
        fractal.appearance.colourBy = ColourBy::Map;
        const QByteArray before = written(fractal);
        QVERIFY(!before.contains("color_speed"));
        QVERIFY(!io::lossOf(io::TextFormat::Flame, fractal));
        fractal.appearance.mapBlends[document::system2(fractal)->maps[0].id] = {0.3, 0.3};
        QCOMPARE(written(fractal), before);
        QVERIFY(io::lossOf(io::TextFormat::Flame, fractal));
        QVERIFY(read(before).appearance.mapBlends.empty());
    }
};

BARYCAGE_TEST(FlameBlendTest);
#include "flame_blend_test.moc"
