// SPDX-License-Identifier: MIT
#include "io/exchange/text_formats.h"
#include "io/fractint/entry_writer.h"
#include "io/fractint/fractint_reader.h"
#include "io/fractint/fractint_writer.h"
#include "io/fractint/metadata_comments.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QTest>

#include <cmath>
#include <random>

using attractor::ColourBy;
using attractor::MapBlend;
using document::Fractal;

namespace {

Fractal fern(int maps) {
    document::System2 system;
    for (int i = 0; i < maps; ++i)
        ifs::append(system, ifs::affineMap(.5, 0, 0, .5, i, 0), 1.0 / maps);
    return support::fractalOf(std::move(system), QStringLiteral("fern"));
}

Fractal inSpace() {
    document::System3 system;
    for (int i = 0; i < 3; ++i)
        ifs::append<3>(system, {ifs::Matrix<3>::Identity() / 2, {double(i), 0, 0}}, 0.25);
    return support::fractalOf(std::move(system), QStringLiteral("solid"));
}

Fractal blendReadBack(const QByteArray& text) {
    const document::FractalFile file = io::readFractint(text);
    return file.entries.isEmpty() ? Fractal() : *file.entries.first().fractal;
}

ifs::MapId idAt(const Fractal& fractal, std::size_t index) {
    return document::system2(fractal)->maps[index].id;
}

} // namespace

class BlendCommentsTest : public QObject {
    Q_OBJECT

private slots:
    void readableInTheFile() {
        Fractal fractal = fern(3);
        QVERIFY(!io::writeEntry(fractal).contains("barycage"));
        fractal.appearance.colourBy = ColourBy::Blend;
        fractal.appearance.mapBlends[idAt(fractal, 0)] = {0.25, 1};
        fractal.appearance.mapBlends[idAt(fractal, 2)] = {1, 0.1};
        const QByteArray text = io::writeEntry(fractal);
        QVERIFY2(text.contains("; barycage: colour-by blend\n"), text.constData());
        QVERIFY2(text.contains("; barycage: map-blend 1 0.25 1\n; barycage: map-blend 3 1 0.1\n"),
                 text.constData());
        QVERIFY(blendReadBack(text).appearance == io::asStored(fractal).appearance);
        QVERIFY(!io::lossOf(io::TextFormat::Fractint, fractal));
        QVERIFY(io::lossOf(io::TextFormat::Csv, fractal));
    }

    void everyNumberComesBack() {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> number(0, 1);
        for (int round = 0; round < 200; ++round) {
            Fractal fractal = fern(5);
            for (std::size_t i = 0; i < 5; ++i)
                if (number(random) < 0.7)
                    fractal.appearance.mapBlends[idAt(fractal, i)] = {
                        std::pow(number(random), round % 3 == 0 ? 200 : 1), number(random)};
            const QByteArray text = io::writeEntry(fractal);
            for (const QByteArray& line : text.split('\n'))
                QVERIFY2(line.size() < 70, line.constData());
            const Fractal back = blendReadBack(text);
            QVERIFY(back.appearance == io::asStored(fractal).appearance);
            QCOMPARE(io::writeEntry(back), text);
        }
    }

    void mapsInSpaceHaveThemToo() {
        Fractal fractal = inSpace();
        fractal.appearance.mapBlends[document::system3(fractal)->maps[1].id] = {0.5, 0};
        const QByteArray text = io::writeEntry(fractal);
        QVERIFY2(text.contains("; barycage: map-blend 2 0.5 0\n"), text.constData());
        QVERIFY(blendReadBack(text).appearance == io::asStored(fractal).appearance);
    }

    // What is not understood stays as it is; nothing of it is applied.
    void strict() {
        for (const char* wrong :
             {"map-blend 1", "map-blend 1 0.5 0.5 0.5", "map-blend 0 0.5 0.5", "map-blend one 0.5 0.5",
              "map-blend 1 1.5 0.5", "map-blend 1 0.5 -0.1", "map-blend 1 nan 0.5", "map-blend 1 0.5 x"}) {
            const QByteArray line = QByteArray("; barycage: ") + wrong + '\n';
            const QByteArray text = "fern {\n  " + line + " .5 0 0 .5 0 0 1\n}\n";
            const document::FractalFile file = io::readFractint(text);
            QCOMPARE(file.entries.size(), 1);
            const Fractal& read = *file.entries.first().fractal;
            QVERIFY2(read.appearance.mapBlends.empty(), wrong);
            QVERIFY2(io::writeFractint(file).contains(line.trimmed()), wrong);
        }
        // A map that is not there says nothing, and a second blend of a map does not count.
        const Fractal read =
            blendReadBack("fern {\n ; barycage: map-blend 9 0.5 0.5\n"
                          " ; barycage: map-blend 1 0.25 0.75\n ; barycage: map-blend 1 0 0\n"
                          " .5 0 0 .5 0 0 1\n}\n");
        const MapBlend* blend = read.appearance.mapBlends.find(idAt(read, 0));
        QVERIFY(blend != nullptr && (*blend == MapBlend{0.25, 0.75}));
    }

    // Files of other versions, and entries that were not edited, keep their bytes.
    void bytesStay() {
        const QByteArray text = "; head\n\nfern {\n ; barycage: version 1\n ; barycage: colour-by blend\n"
                                " ; barycage: map-blend 1 .50 1e-1\n .5 0 0 .5 0 0 1\n .5 0 0 .5 1 0 1\n}\n";
        const document::FractalFile file = io::readFractint(text);
        QCOMPARE(io::writeFractint(file), text);
        const attractor::Appearance& read = file.entries.first().fractal->appearance;
        QVERIFY(read.colourBy == ColourBy::Blend);
        QVERIFY((*read.mapBlends.find(idAt(*file.entries.first().fractal, 0)) == MapBlend{0.5, 0.1}));
    }
};

BARYCAGE_TEST(BlendCommentsTest);
#include "blend_comments_test.moc"
