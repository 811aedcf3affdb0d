// SPDX-License-Identifier: MIT
#include "io/palette/palette_reader.h"

#include "attractor/colour/srgb_transfer.h"
#include "io/fractint/entry_writer.h"
#include "io/fractint/fractint_reader.h"
#include "support/named_test.h"

#include <QElapsedTimer>
#include <QRandomGenerator>
#include <QTest>

using attractor::Palette;
using attractor::Rgba;
using namespace io;

namespace {

bool similar(const Rgba& a, const Rgba& b, int levels = 1) {
    return std::abs(a.red - b.red) <= levels && std::abs(a.green - b.green) <= levels &&
           std::abs(a.blue - b.blue) <= levels && a.alpha == b.alpha;
}

std::vector<Rgba> spectrum(int colours) {
    std::vector<Rgba> result;
    for (int i = 0; i < colours; ++i) {
        const double t = 6.28318530718 * i / colours;
        const auto wave = [t](double shift) { return std::uint8_t(127.5 + 127 * std::cos(t + shift)); };
        result.push_back({wave(0), wave(2), wave(4), 255});
    }
    return result;
}

QByteArray rows(const std::vector<Rgba>& colours) {
    QByteArray text;
    for (const Rgba& c : colours)
        text += QByteArray::number(c.red) + ' ' + QByteArray::number(c.green) + ' ' +
                QByteArray::number(c.blue) + " some name\n";
    return text;
}

} // namespace

class PaletteReaderTest : public QObject {
    Q_OBJECT

private slots:
    void hexadecimalColours_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("lines") << QByteArray("#264653\n#2a9d8f\n#E9C46A\n");
        QTest::newRow("digits alone") << QByteArray("264653\r\n2a9d8f\r\ne9c46a\r\n");
        QTest::newRow("digits and a comment") << QByteArray("; by hand\n264653, 2a9d8f, e9c46a\n");
        QTest::newRow("address") << QByteArray("https://coolors.co/palette/264653-2a9d8f-e9c46a");
        QTest::newRow("short address") << QByteArray("https://coolors.co/264653-2a9d8f-e9c46a");
        QTest::newRow("opacity first") << QByteArray("0xFF264653, 0xFF2A9D8F, 0xFFE9C46A");
        QTest::newRow("JSON") << QByteArray(
            "{\"name\": \"sea\", \"colors\": [\"#264653\", \"#2a9d8f\", \"#e9c46aff\"]}");
        QTest::newRow("CSS") << QByteArray(":root {\n  --a: #264653;\n  --b: #2a9d8f;\n  --c: #e9c46a;\n}\n");
        QTest::newRow("C") << QByteArray("int c[] = {0x264653, 0x2a9d8f, 0xE9C46A};");
    }

    void hexadecimalColours() {
        QFETCH(QByteArray, text);
        const PaletteFile file = readPalettes(text, QStringLiteral("sea"));
        QVERIFY(file.problems.isEmpty());
        QCOMPARE(file.palettes.size(), std::size_t(1));
        QCOMPARE(file.palettes[0].name, std::string("sea"));
        const auto& stops = file.palettes[0].stops;
        QCOMPARE(stops.size(), std::size_t(3));
        QVERIFY((stops[0].colour == attractor::Rgba{0x26, 0x46, 0x53, 255}));
        QVERIFY((stops[1].colour == attractor::Rgba{0x2a, 0x9d, 0x8f, 255}));
        QVERIFY((stops[2].colour == attractor::Rgba{0xe9, 0xc4, 0x6a, 255}));
    }

    void aColourMapKeepsItsColours();
    void aGimpPaletteHasItsName();
    void anUltraFractalFileHasManyGradients();
    void ultraFractalGradientsGoRoundACircle();
    void smoothGradientsStayBetweenTheirKnots();
    void gimpGradientsBlendInEveryWay_data();
    void gimpGradientsBlendInEveryWay();
    void badLinesAreNamedAndLeftOut();
    void otherFilesAreRefused_data();
    void otherFilesAreRefused();
    void hostileFilesAreSurvived();
    void whatIsWrittenComesBackExactly();
    void aPaletteTravelsWithItsEntry();
};

void PaletteReaderTest::aColourMapKeepsItsColours() {
    const std::vector<Rgba> colours = spectrum(256);
    const PaletteFile file = readPalettes(rows(colours), QStringLiteral("volcano"));
    QCOMPARE(file.palettes.size(), std::size_t{1});
    QVERIFY(file.problems.isEmpty());
    QCOMPARE(file.palettes[0].name, std::string("volcano"));
    for (int i = 0; i < 256; ++i)
        QVERIFY(similar(attractor::colourAt(file.palettes[0], i / 255.0), colours[std::size_t(i)]));
    QVERIFY2(file.palettes[0].stops.size() < 64, "a smooth palette needs few stops");
    const PaletteFile hard = readPalettes("0 0 0\n255 255 255\n0 0 0\n255 255 255\n", {});
    QCOMPARE(hard.palettes[0].stops.size(), std::size_t{4});
    QCOMPARE(readPalettes("9 8 7", {}).palettes[0].stops.back().colour, (Rgba{9, 8, 7, 255}));
}

void PaletteReaderTest::aGimpPaletteHasItsName() {
    const PaletteFile file = readPalettes("GIMP Palette\r\nName: Abend\xc3\xb6"
                                          "d\r\nColumns: 3\r\n# a comment\r\n"
                                          "255   0   0\tRed\r\n  0 128   0\r\n\r\n  0   0 255 Blue\r\n",
                                          QStringLiteral("file"));
    QVERIFY(file.problems.isEmpty());
    QCOMPARE(QString::fromStdString(file.palettes[0].name), QStringLiteral("Abendöd"));
    QCOMPARE(attractor::colourAt(file.palettes[0], 0.5), (Rgba{0, 128, 0, 255}));
    QCOMPARE(readPalettes("GIMP Palette\n1 2 3\n4 5 6\n", QStringLiteral("file")).palettes[0].name,
             std::string("file"));
}

void PaletteReaderTest::anUltraFractalFileHasManyGradients() {
    const PaletteFile file =
        readPalettes("; a header comment\n"
                     "blatte10 {\ngradient:\n"
                     "  title=\"Blatte 10 {a}\" smooth=no index=0 color=3085069 index=25\n"
                     "  color=3216141 index=399 color=144\n"
                     "opacity:\n  smooth=no index=0 opacity=255\n}\n"
                     "two words { gradient: index=0 color=255 ; red\n index=200 color=65280 }\n"
                     "empty {\n}\n",
                     QStringLiteral("file"));
    QCOMPARE(file.palettes.size(), std::size_t{2});
    QCOMPARE(file.palettes[0].name, std::string("Blatte 10 {a}"));
    QCOMPARE(attractor::colourAt(file.palettes[0], 0), (Rgba{0x0d, 0x13, 0x2f, 255})); // 0x2f130d
    QCOMPARE(attractor::colourAt(file.palettes[0], 1), (Rgba{144, 0, 0, 255}));
    QCOMPARE(file.palettes[1].name, std::string("two words"));
    QVERIFY(similar(attractor::colourAt(file.palettes[1], 200 / 399.0), {0, 255, 0, 255}));
}

void PaletteReaderTest::ultraFractalGradientsGoRoundACircle() {
    const QByteArray text = "g { gradient: smooth=no %1 index=100 color=0 index=300 color=200 }";
    const Palette plain = readPalettes(QByteArray(text).replace("%1", ""), {}).palettes[0];
    QVERIFY(similar(attractor::colourAt(plain, 200 / 399.0), {100, 0, 0, 255}));
    QVERIFY(similar(attractor::colourAt(plain, 0), {100, 0, 0, 255})); // between 300 and 100 + 400
    QVERIFY(similar(attractor::colourAt(plain, 350 / 399.0), {150, 0, 0, 255}));
    const Palette turned = readPalettes(QByteArray(text).replace("%1", "rotation=-300"), {}).palettes[0];
    QVERIFY(similar(attractor::colourAt(turned, 0), {200, 0, 0, 255}));
    const Palette wrapped =
        readPalettes("g { gradient: index=-100 color=200 index=900 color=90 }", {}).palettes[0];
    QVERIFY(similar(attractor::colourAt(wrapped, 300 / 399.0), {200, 0, 0, 255}));
    QVERIFY(similar(attractor::colourAt(wrapped, 100 / 399.0), {90, 0, 0, 255}));
}

void PaletteReaderTest::smoothGradientsStayBetweenTheirKnots() {
    const Palette palette =
        readPalettes("g { gradient: smooth=yes index=0 color=10 index=40 color=250 index=80 "
                     "color=250 index=120 color=10 }",
                     {})
            .palettes[0];
    for (int place = 0; place < 400; ++place) {
        const Rgba colour = attractor::colourAt(palette, place / 399.0);
        QVERIFY(colour.red >= 9 && colour.red <= 251);
        if (place >= 40 && place <= 80) QVERIFY(colour.red >= 249);
        if (place >= 120) QVERIFY(colour.red <= 11);
    }
    QVERIFY(
        similar(attractor::colourAt(palette, 20 / 399.0), {130, 0, 0, 255}, 2)); // the middle, by symmetry
    QVERIFY(attractor::colourAt(palette, 5 / 399.0).red < 25); // flat at its ends, unlike a straight line

    // Rises of 0.6, 1.8, −1.2 and −1.2 a place: their harmonic means 0, 0.9, 0 and −1.2 are the slopes of the
    // knots.
    const Palette uneven = readPalettes("g { gradient: smooth=yes index=0 color=0 index=100 color=60 "
                                        "index=200 color=240 index=300 color=120 }",
                                        {})
                               .palettes[0];
    QVERIFY(similar(attractor::colourAt(uneven, 50 / 399.0), {19, 0, 0, 255}, 1));
    QVERIFY(similar(attractor::colourAt(uneven, 150 / 399.0), {161, 0, 0, 255}, 1));
    QVERIFY(similar(attractor::colourAt(uneven, 250 / 399.0), {195, 0, 0, 255}, 1));
    QVERIFY(similar(attractor::colourAt(uneven, 350 / 399.0), {45, 0, 0, 255}, 1));
}

void PaletteReaderTest::badLinesAreNamedAndLeftOut() {
    const PaletteFile file = readPalettes("1 2 3\noops\n4 5 256\n7 8\n\n; remark\n9 9 9\n", {});
    QCOMPARE(file.palettes.size(), std::size_t{1});
    QCOMPARE(file.problems.size(), 3);
    QCOMPARE(file.problems[0].line, 2);
    QCOMPARE(file.problems[1].line, 3);
    QCOMPARE(file.problems[2].line, 4);
    QCOMPARE(attractor::colourAt(file.palettes[0], 1), (Rgba{9, 9, 9, 255}));
    const PaletteFile gradient = readPalettes("g {\ngradient:\n index=0 color=7\n index=x color=9\n", {});
    QCOMPARE(gradient.palettes.size(), std::size_t{1});
    QCOMPARE(gradient.problems[0].line, 4);
    QCOMPARE(gradient.problems.size(), 2); // and it is not closed
}

void PaletteReaderTest::gimpGradientsBlendInEveryWay_data() {
    QTest::addColumn<QByteArray>("segments");
    QTest::addColumn<double>("position");
    QTest::addColumn<attractor::Rgba>("expected");
    const auto row = [](const char* what, const QByteArray& segments, double position,
                        attractor::Rgba colour) { QTest::newRow(what) << segments << position << colour; };
    const QByteArray ramp = "0 .25 1 0 0 0 1 1 1 1 1 ";
    row("linear, at its middle", "1\n" + ramp + "0 0", 0.25, {128, 128, 128});
    row("linear, beyond it", "1\n" + ramp + "0 0", 0.625, {191, 191, 191});
    row("curved", "1\n" + ramp + "1 0", 0.5, {180, 180, 180}); // 0.5 to the power of a half
    row("sine", "1\n0 .5 1 0 0 0 1 1 1 1 1 2 0", 0.25, {37, 37, 37});
    row("increasing sphere", "1\n0 .5 1 0 0 0 1 1 1 1 1 3 0", 0.5, {221, 221, 221});
    row("decreasing sphere", "1\n0 .5 1 0 0 0 1 1 1 1 1 4 0", 0.5, {34, 34, 34});
    row("step, before it", "1\n" + ramp + "5 0", 0.2, {0, 0, 0});
    row("step, after it", "1\n" + ramp + "5 0", 0.3, {255, 255, 255});
    // Red to blue, by way of green or not.
    row("hue, up", "1\n0 .5 1 1 0 0 1 0 0 1 1 0 1", 0.5, {0, 255, 0});
    row("hue, down", "1\n0 .5 1 1 0 0 1 0 0 1 1 0 2", 0.5, {255, 0, 255});
    row("colours of the toolbox", "1\n0 .5 1 1 0 0 1 0 1 0 1 0 0 1 3", 1, {255, 255, 255});
    row("two segments", "2\n0 .2 .4 1 0 0 1 1 0 0 1 0 0\n.4 .7 1 0 0 1 1 0 0 1 1 0 0", 0.7, {0, 0, 255});
}

// By the formulas of GIMP's own source, worked out by hand.
void PaletteReaderTest::gimpGradientsBlendInEveryWay() {
    QFETCH(const QByteArray, segments);
    QFETCH(const double, position);
    QFETCH(const attractor::Rgba, expected);
    const PaletteFile file = readPalettes("GIMP Gradient\nName: A gradient\n" + segments + "\n", {});
    QVERIFY(file.problems.isEmpty());
    QCOMPARE(file.palettes.size(), std::size_t{1});
    QCOMPARE(file.palettes[0].name, std::string("A gradient"));
    QVERIFY(similar(attractor::colourAt(file.palettes[0], position), expected, 2));
}

void PaletteReaderTest::otherFilesAreRefused_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("prose") << QByteArray("Dear Sir,\nhere are no colours.\n");
    QTest::newRow("GIMP gradient without segments") << QByteArray("GIMP Gradient\nName: x\n");
    QTest::newRow("GIMP gradient with too few")
        << QByteArray("GIMP Gradient\n2\n0 .3 .5 0 0 0 1 1 1 1 1 0 0\n");
    QTest::newRow("GIMP gradient with a gap")
        << QByteArray("GIMP Gradient\n1\n.2 .5 1 0 0 0 1 1 1 1 1 0 0\n");
    QTest::newRow("GIMP gradient of no known kind")
        << QByteArray("GIMP Gradient\n1\n0 .5 1 0 0 0 1 1 1 1 1 6 0\n");
    QTest::newRow("GIMP gradient with numbers that are none")
        << QByteArray("GIMP Gradient\n1\n0 .5 nan 0 0 0 1 1 1 1 1 0 0\n");
    QTest::newRow("binary") << QByteArray("8BCB\0\0\1", 7);
    QTest::newRow("system") << QByteArray("fern {\n 0 0 0 .16 0 0 .01\n}\n");
    QTest::newRow("too large") << QByteArray(17 * 1024 * 1024, ' ');
}

void PaletteReaderTest::otherFilesAreRefused() {
    QFETCH(const QByteArray, bytes);
    const PaletteFile file = readPalettes(bytes, QStringLiteral("x"));
    QVERIFY(file.palettes.empty());
    QVERIFY(!file.problems.isEmpty());
    QCOMPARE(file.problems.back().severity, document::Problem::Severity::Error);
}

void PaletteReaderTest::hostileFilesAreSurvived() {
    QByteArray endless = "g { gradient:";
    for (int i = 0; i < 200'000; ++i)
        endless += " index=" + QByteArray::number(i) + " color=" + QByteArray::number(i * 7919);
    QVERIFY(readPalettes(endless, {}).palettes[0].stops.size() <= 400);
    QByteArray many;
    for (int i = 0; i < 5000; ++i)
        many += "g { gradient: index=0 color=1 index=9 color=2 }\n";
    QCOMPARE(readPalettes(many, {}).palettes.size(), std::size_t{4000});
    QByteArray tall;
    for (int i = 0; i < 100'000; ++i)
        tall += QByteArray::number(i % 256) + " 0 0\n";
    QVERIFY(readPalettes(tall, {}).palettes[0].stops.size() <= 4096);
    for (const char* text :
         {"{", "}", "{{{{", "g{gradient:index=0", "g{gradient:color=}", "g{gradient:title=\"",
          "g{gradient:index=99999999999999999999 color=-1}", "GIMP Palette", ";", "\"{"})
        readPalettes(text, {});
    const QByteArray whole =
        "a {\ngradient:\n title=\"x\" smooth=yes rotation=3 index=0 color=12 index=7 color=99\n}\n";
    QRandomGenerator random(5);
    for (int i = 0; i < 3000; ++i) {
        QByteArray bent = whole.left(random.bounded(int(whole.size()) + 1));
        for (int k = 0; k < 4 && !bent.isEmpty(); ++k)
            bent[random.bounded(int(bent.size()))] = char(random.bounded(256));
        const PaletteFile file = readPalettes(bent, {});
        QVERIFY(!file.palettes.empty() || !file.problems.isEmpty());
    }
}

void PaletteReaderTest::whatIsWrittenComesBackExactly() {
    for (Palette palette : attractor::builtInPalettes()) {
        palette.stops[1].colour.alpha = 77;
        palette.stops[1].position = 0.0123456789012345;
        const PaletteFile back = readPalettes(writeGimpPalette(palette), QStringLiteral("x"));
        QVERIFY(back.problems.isEmpty());
        QCOMPARE(back.palettes.size(), std::size_t{1});
        QVERIFY(back.palettes[0] == palette);
    }
    // Without our comments the colours are still there.
    const Palette maple = attractor::builtInPalettes().front();
    QByteArray text = writeGimpPalette(maple);
    text.replace("# barycage: stop", "# nothing");
    const Palette back = readPalettes(text, {}).palettes[0];
    for (double t = 0; t <= 1; t += 0.01)
        QVERIFY(similar(attractor::colourAt(back, t), attractor::colourAt(maple, t), 3));
}

void PaletteReaderTest::aPaletteTravelsWithItsEntry() {
    document::Fractal fractal = document::sierpinskiTriangle();
    fractal.appearance.palette =
        readPalettes(rows(spectrum(256)), QStringLiteral("A long name; with } in it")).palettes[0];
    const QByteArray text = writeEntry(fractal);
    for (const QByteArray& line : text.split('\n'))
        QVERIFY(line.size() < 70 || !line.contains("barycage:"));
    const document::FractalFile file = readFractint(text);
    QCOMPARE(file.entries.size(), std::size_t{1});
    QVERIFY(file.entries[0].fractal->appearance.palette == fractal.appearance.palette);
}

BARYCAGE_TEST(PaletteReaderTest, QCoreApplication);
#include "palette_reader_test.moc"
