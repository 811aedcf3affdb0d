// SPDX-License-Identifier: MIT
#include "attractor/colour/srgb_transfer.h"
#include "attractor/tops/stolen_picture.h"
#include "ifs/canonical_systems.h"
#include "ifs/tops/top_systems.h"
#include "support/named_test.h"

#include <QTest>

#include <array>
#include <cmath>

using attractor::CoupledSystem;
using tops::Maps;
using Light = std::array<double, 3>;

// How much of a picture a pixel averages, against a picture of many smaller pixels that is averaged
// afterwards.
class TheftFootprintTest : public QObject {
    Q_OBJECT

private slots:
    void wholeRatios_data();
    void wholeRatios();
    void pixelsAverageWhatTheyCover_data();
    void pixelsAverageWhatTheyCover();
};

namespace {

Maps conjugated(const Maps& maps, const ifs::AffineMap<2>& change) {
    Maps result;
    for (const auto& map : maps)
        result.push_back(*ifs::conjugate<2>(change, map));
    return result;
}

Maps scaled(const Maps& maps, double factor) {
    return conjugated(maps, ifs::affineMap(factor, 0, 0, factor, 0, 0));
}

CoupledSystem coupledMaps(const Maps& from, const Maps& to) {
    return {tops::attractorOf(from), tops::attractorOf(to), ifs::determinantWeights<2>(from)};
}

// Squares of random colours.
attractor::MipPicture mosaic(int side, int grain) {
    std::vector<attractor::Rgba> pixels;
    for (int k = 0; k < side * side; ++k) {
        canonical::Random random(std::uint32_t(k / side / grain * side + k % side / grain + 1));
        const auto code = [&] { return std::uint8_t(random() >> 8 & 255); };
        pixels.push_back({code(), code(), code(), 255});
    }
    return {side, side, pixels};
}

constexpr int columns = 32;

// The unit square in columns·finer pixels a side.
std::vector<Light> stolenLight(const CoupledSystem& system, const attractor::MipPicture& picture,
                               const ifs::AffineMap<2>& toPicture, bool isExact, int finer) {
    attractor::TheftRequest request;
    const int side = columns * finer;
    request.camera = {{.5, .5}, double(side), side, side, attractor::YAxis::Up};
    request.toPicture = toPicture;
    request.isExact = isExact;
    request.points = 3'000'000;
    std::vector<Light> result;
    attractor::steal(system, picture, request,
                     [&](std::span<const std::uint32_t> pixels) {
                         for (const std::uint32_t pixel : pixels)
                             result.push_back({attractor::linearLight(std::uint8_t(pixel >> 16)),
                                               attractor::linearLight(std::uint8_t(pixel >> 8)),
                                               attractor::linearLight(std::uint8_t(pixel))});
                         return true;
                     },
                     {});
    return result;
}

std::vector<Light> averaged(const std::vector<Light>& fine, int finer) {
    std::vector<Light> result(columns * columns, Light{});
    const int side = columns * finer;
    for (int k = 0; k < side * side; ++k)
        for (std::size_t c = 0; c < 3; ++c)
            result[std::size_t(k / side / finer * columns + k % side / finer)][c] +=
                fine[std::size_t(k)][c] / (finer * finer);
    return result;
}

double differenceOf(const std::vector<Light>& a, const std::vector<Light>& b) { // root mean square
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c)
            sum += (a[k][c] - b[k][c]) * (a[k][c] - b[k][c]);
    return std::sqrt(sum / double(3 * a.size()));
}

} // namespace

void TheftFootprintTest::wholeRatios_data() {
    QTest::addColumn<Maps>("from");
    QTest::addColumn<Maps>("to");
    QTest::addColumn<double>("ratio");
    const Maps square = tops::square(.5, .5), triangle = tops::triangle(.5, .5, .5);
    QTest::newRow("itself") << square << square << 1.0;
    QTest::newRow("ten times as large") << square << scaled(tops::square(.3, .6), 10) << 100.0;
    QTest::newRow("a tenth") << scaled(square, 10) << square << .01;
    QTest::newRow("half a square") << square << triangle << .5;
    QTest::newRow("without area") << canonical::sierpinskiEquilateral()
                                  << scaled(canonical::sierpinskiEquilateral(), 10) << 100.0;
    const ifs::AffineMap<2> shear = ifs::affineMap(3, 40, .01, .4, 7, 8); // det 0.8, long and thin
    QTest::newRow("sheared") << canonical::fern() << conjugated(canonical::fern(), shear) << .8;
    QTest::newRow("flat") << tops::interval(.5) << scaled(tops::interval(.3), 10) << 100.0;
    QTest::newRow("a point") << Maps{tops::onLine(.5, 1), tops::onLine(.25, 1.5)}
                             << Maps{tops::onLine(.5, 1), tops::onLine(.25, 1.5)} << 1.0;
}

void TheftFootprintTest::wholeRatios() {
    QFETCH(Maps, from);
    QFETCH(Maps, to);
    QFETCH(double, ratio);
    const double found = coupledMaps(from, to).wholeRatio;
    QVERIFY2(std::abs(found / ratio - 1) < .02, qPrintable(QString::number(found)));
}

void TheftFootprintTest::pixelsAverageWhatTheyCover_data() {
    QTest::addColumn<Maps>("from");
    QTest::addColumn<double>("scale");
    QTest::addColumn<int>("side");  // of the picture on G
    QTest::addColumn<int>("grain"); // of the picture
    QTest::addColumn<bool>("isExact");
    QTest::addColumn<double>("most"); // of the root mean square of light
    for (const bool isExact : {true, false}) {
        const char* how = isExact ? "exactly" : "by samples";
        // 10 × 10 pixels of the picture for one of F, on the whole; or one.
        QTest::addRow("ten times as large, %s", how)
            << tops::square(.5, .5) << 10.0 << 320 << 1 << isExact << .04;
        QTest::addRow("uneven, %s", how) << tops::square(.45, .55) << 10.0 << 320 << 1 << isExact << .04;
        QTest::addRow("a tenth, %s", how) << tops::square(.5, .5) << .1 << 32 << 4 << isExact << .12;
    }
}

void TheftFootprintTest::pixelsAverageWhatTheyCover() {
    QFETCH(Maps, from);
    QFETCH(double, scale);
    QFETCH(int, side);
    QFETCH(int, grain);
    QFETCH(bool, isExact);
    QFETCH(double, most);
    constexpr int finer = 16; // then a pixel covers less than one of the picture
    CoupledSystem system = coupledMaps(from, scaled(tops::square(.5, .5), scale));
    const attractor::MipPicture picture = mosaic(side, grain);
    const double zoom = side / scale;
    const ifs::AffineMap<2> toPicture = ifs::affineMap(zoom, 0, 0, -zoom, 0, side);
    const auto fine = stolenLight(system, picture, toPicture, true, finer);
    QCOMPARE(fine.size(), std::size_t(columns * columns * finer * finer));
    const auto expected = averaged(fine, finer);
    const double found = differenceOf(stolenLight(system, picture, toPicture, isExact, 1), expected);
    system.wholeRatio = 1; // as if the attractors were as large
    const double without = differenceOf(stolenLight(system, picture, toPicture, isExact, 1), expected);
    QVERIFY2(found < most && found < without / 2,
             qPrintable(QStringLiteral("%1, without %2").arg(found).arg(without)));
}

BARYCAGE_TEST(TheftFootprintTest);
#include "theft_footprint_test.moc"
