// SPDX-License-Identifier: MIT
#include "attractor/light/solid_light.h"

#include "attractor/kernels/kernels.h"
#include "attractor/light/pixel_average.h"
#include "attractor/light/surface_rows.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>
#include <functional>
#include <random>

using namespace attractor;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

using Depth = std::function<std::optional<double>(int x, int y)>; // pixels behind the plane of the target

// Depths from −range to +range pixels, a unit of the system a pixel; nothing where there is no depth.
DepthRaster rasterOf(int width, int height, double range, const Depth& depth) {
    DepthRaster raster{width, height, {}, -range, range};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::optional<double> z = depth(x, y);
            const double code = z ? (*z + range) / (2 * range) * maxDepthCode + 0.5 : 0;
            raster.keys.push_back(z ? static_cast<std::uint32_t>(code) << 8 |
                                          static_cast<std::uint32_t>((7 * x + y) & 0xFF)
                                    : emptyKey);
        }
    return raster;
}

// Hills, steps, holes and lonely pixels.
DepthRaster landscape(int width, int height, std::uint32_t seed = 5) {
    std::mt19937 random(seed);
    return rasterOf(width, height, 60, [&](int x, int y) -> std::optional<double> {
        const std::uint32_t chance = random() % 100;
        if (chance < 4 || (x / 9 + y / 7) % 5 == 0) return chance == 50 ? std::optional(3.0) : std::nullopt;
        const double step = (x / 13 + y / 11) % 2 == 0 ? 25 : -10;
        return step + 0.4 * (x % 17) - 0.7 * (y % 19) + 0.01 * chance;
    });
}

struct Surface {
    std::vector<float> shade, right, up; // of all pixels; −1, 0, 0 where there is nothing
};

Surface surfaceOf(const DepthRaster& raster, double unitsPerPixel, const Occlusion& occlusion = {}) {
    Surface result;
    SurfaceRows rows(raster, unitsPerPixel, occlusion, 0);
    for (int y = 0; y < raster.height; ++y) {
        const SurfaceRow row = rows.next();
        for (int x = 0; x < raster.width; ++x) {
            const auto at = static_cast<std::size_t>(x - row.first);
            const bool is = x >= row.first && x < row.end && row.codes[at] != kernels::emptyDepth;
            result.shade.push_back(is ? row.shade[at] : -1);
            result.right.push_back(is ? row.right[at] : 0);
            result.up.push_back(is ? row.up[at] : 0);
        }
    }
    return result;
}

// By the formula of docs/mathematics.md, "Light on a solid", in double precision.
double shadeByFormula(const DepthRaster& raster, int x, int y, const Occlusion& occlusion) {
    const double perCode = (raster.far - raster.near) / maxDepthCode;
    const auto depth = [&](int column, int row) {
        if (column < 0 || row < 0 || column >= raster.width || row >= raster.height) return inf;
        const std::uint32_t key = raster.keys[static_cast<std::size_t>(row * raster.width + column)];
        return key == emptyKey ? inf : depthCode(key) * perCode;
    };
    double exponent = 0;
    for (std::size_t k = 0; k < Occlusion::radii.size(); ++k) {
        const int radius = Occlusion::radii[k], half = (radius - 1) / 2;
        const double saturation = occlusion.saturation * radius;
        double sum = 0;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                if (dx == 0 && dy == 0) continue;
                double nearest = inf;
                for (int row = -half; row <= half; ++row)
                    for (int column = -half; column <= half; ++column)
                        nearest = std::min(nearest, depth(x + radius * dx + column, y + radius * dy + row));
                sum += std::clamp(depth(x, y) - nearest, 0.0, saturation) / saturation;
            }
        exponent += occlusion.shares[k] * sum / 8;
    }
    return std::exp(-occlusion.strength * exponent);
}

std::vector<SolidAppearance> appearances() {
    std::vector<SolidAppearance> result;
    for (const Look look : {Look::Stone, Look::Ink, Look::Depth, Look::Normals})
        result.push_back(appearanceOf(look));
    for (const SolidColour colour : {SolidColour::Map, SolidColour::Height, SolidColour::Depth}) {
        result.push_back(appearanceOf(Look::Stone));
        result.back().colourBy = colour;
        result.back().fog = 1.5;
        result.back().background = {200, 100, 50, 128};
    }
    return result;
}

SolidView viewOf(double unitsPerPixel) {
    SolidView view;
    view.unitsPerPixel = unitsPerPixel;
    view.upward = {0, 0.8F, 0.6F};
    view.eyeDistance = 300 * unitsPerPixel;
    view.lowest = -50 * unitsPerPixel;
    view.highest = 50 * unitsPerPixel;
    return view;
}

std::vector<std::uint32_t> picture(const DepthRaster& raster, const SolidAppearance& appearance,
                                   const SolidView& view = viewOf(1), std::size_t threads = 1) {
    Workers workers(threads);
    return lit(raster, appearance, view, workers);
}

std::vector<Rgba16> deepPicture(const DepthRaster& raster, const SolidAppearance& appearance,
                                const SolidView& view = viewOf(1)) {
    std::vector<Rgba16> pixels(raster.keys.size());
    SolidLight(appearance, view).apply(raster, 0, raster.height, pixels);
    return pixels;
}

int channel(std::uint32_t pixel, int shift) {
    return static_cast<int>(pixel >> shift & 255U);
}

} // namespace

class TestSolidLight : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { selectSimd(m_simd); }

    void constantDepthIsNotShaded() {
        const DepthRaster raster = rasterOf(50, 40, 100, [](int, int) { return 12.5; });
        const Surface surface = surfaceOf(raster, 1);
        for (std::size_t k = 0; k < raster.keys.size(); ++k) {
            QCOMPARE(surface.shade[k], 1.0F);
            QCOMPARE(surface.right[k], 0.0F);
            QCOMPARE(surface.up[k], 0.0F);
        }
    }

    // Nor is anything before the background, however near it is.
    void emptyPixelsDarkenNothing() {
        const DepthRaster raster = rasterOf(
            50, 40, 100, [](int x, int y) { return (x + y) % 3 == 0 ? std::optional(100.0) : std::nullopt; });
        for (const float shade : surfaceOf(raster, 1).shade)
            QVERIFY(shade == 1.0F || shade == -1.0F);
    }

    void aStepDarkensOnlyItsFarSide() {
        constexpr int width = 60, edge = 30;
        const DepthRaster raster =
            rasterOf(width, 40, 100, [](int x, int) { return x < edge ? -20.0 : 20.0; });
        const Surface surface = surfaceOf(raster, 1);
        for (int y = 0; y < raster.height; ++y)
            for (int x = 0; x < width; ++x) {
                const float shade = surface.shade[static_cast<std::size_t>(y * width + x)];
                QCOMPARE(shade < 1, x >= edge && x < edge + 13); // 9 pixels, and 4 more of the minimum
                QVERIFY(shade > 0);
            }
    }

    void shadesFollowTheFormula() {
        const DepthRaster raster = landscape(70, 45);
        const Occlusion occlusion{3.2, 1.7, {0.5, 0.3, 0.2}};
        const Surface surface = surfaceOf(raster, 1, occlusion);
        int darker = 0;
        for (int y = 0; y < raster.height; ++y)
            for (int x = 0; x < raster.width; ++x) {
                const float shade = surface.shade[static_cast<std::size_t>(y * raster.width + x)];
                if (shade < 0) continue;
                const double wanted = shadeByFormula(raster, x, y, occlusion);
                QVERIFY2(
                    std::abs(shade - wanted) < 1e-5,
                    qPrintable(QStringLiteral("%1, %2: %3 for %4").arg(x).arg(y).arg(shade).arg(wanted)));
                darker += shade < 0.8F ? 1 : 0;
            }
        QVERIFY(darker > 300);
    }

    void flatSlopesHaveTheirNormals() {
        for (const double right : {0.0, 0.5, -2.7})
            for (const double up : {0.0, -0.3, 1.0, 2.7}) {
                const DepthRaster raster =
                    rasterOf(30, 20, 150, [&](int x, int y) { return right * (x - 15) - up * (y - 10); });
                const auto pixels = deepPicture(raster, appearanceOf(Look::Normals));
                const double length = std::sqrt(right * right + up * up + 1);
                for (const Rgba16& pixel : pixels) {
                    QVERIFY(std::abs(pixel.red - 65535 * (right / length + 1) / 2) < 3);
                    QVERIFY(std::abs(pixel.green - 65535 * (up / length + 1) / 2) < 3);
                    QVERIFY(std::abs(pixel.blue - 65535 * (1 / length + 1) / 2) < 3);
                    QCOMPARE(pixel.alpha, std::uint16_t(65535));
                }
            }
    }

    // At an edge the normal is that of the surface on the pixel's own side.
    void slopesStopAtSteps() {
        const DepthRaster raster = rasterOf(
            40, 30, 200, [](int x, int y) { return (x < 20 ? 0.5 * x : 60 - 0.25 * x) + (y < 15 ? 0 : 70); });
        const Surface surface = surfaceOf(raster, 1);
        for (int y = 0; y < 30; ++y)
            for (int x = 0; x < 40; ++x) {
                const auto at = static_cast<std::size_t>(y * 40 + x);
                QVERIFY(std::abs(surface.right[at] - (x < 20 ? 0.5 : -0.25)) < 1e-3);
                QVERIFY(std::abs(surface.up[at]) < 1e-3);
            }
    }

    void lightIsHalfOfLambert() {
        const kernels::Lamps lamps{lampAt(-40, 40), 0.4F};
        std::mt19937 random(8);
        std::uniform_real_distribution<float> slope(-4, 4), shade(0, 1);
        std::array<float, 64> right{}, up{}, shades{}, light{};
        for (std::size_t k = 0; k < light.size(); ++k) {
            right[k] = slope(random);
            up[k] = slope(random);
            shades[k] = shade(random);
        }
        right[0] = up[0] = 0;
        right[1] = 1e30F;
        up[2] = -1e30F;
        kernels::illuminate(right.data(), up.data(), shades.data(), lamps, light.size(), light.data());
        for (std::size_t k = 0; k < light.size(); ++k) {
            const double p = std::clamp(right[k], -1e6F, 1e6F), q = std::clamp(up[k], -1e6F, 1e6F);
            const double length = std::sqrt(p * p + q * q + 1);
            const double cosine = (p * lamps.key.right + q * lamps.key.up + lamps.key.towards) / length;
            const double wanted =
                shades[k] * (0.4 * std::pow((1 / length + 1) / 2, 2) + 0.6 * std::pow((cosine + 1) / 2, 2));
            QVERIFY(std::abs(light[k] - wanted) < 2e-5);
        }
    }

    void scalingSceneAndCameraChangesNoPixel() {
        const DepthRaster raster = landscape(90, 60);
        for (const SolidAppearance& appearance : appearances()) {
            const auto pixels = picture(raster, appearance);
            const auto deep = deepPicture(raster, appearance);
            for (const double factor : {2.0, 3.0, 0.1, 1e-12, 7e9}) {
                DepthRaster scaled = raster;
                scaled.near *= factor;
                scaled.far *= factor;
                QVERIFY(picture(scaled, appearance, viewOf(factor)) == pixels);
                QVERIFY(deepPicture(scaled, appearance, viewOf(factor)) == deep);
            }
        }
    }

    void everyInstructionSetGivesTheSameBytes() {
        for (const int width : {1, 3, 16, 17, 61, 100}) {
            const DepthRaster raster = landscape(width, 70);
            for (const SolidAppearance& appearance : appearances()) {
                std::vector<std::uint32_t> pixels;
                std::vector<Rgba16> deep;
                for (const std::string& name : simdNames()) {
                    QVERIFY(selectSimd(name));
                    if (pixels.empty()) {
                        pixels = picture(raster, appearance);
                        deep = deepPicture(raster, appearance);
                    }
                    QVERIFY2(picture(raster, appearance) == pixels, name.c_str());
                    QVERIFY2(deepPicture(raster, appearance) == deep, name.c_str());
                }
            }
        }
    }

    void threadsAndBandsChangeNoByte() {
        const DepthRaster raster = landscape(75, 400);
        for (const SolidAppearance& appearance : appearances()) {
            const auto pixels = picture(raster, appearance);
            for (const std::size_t threads : {2U, 3U, 5U})
                QVERIFY(picture(raster, appearance, viewOf(1), threads) == pixels);
            std::vector<std::uint32_t> banded(pixels.size());
            std::vector<Rgba16> deep(pixels.size());
            const SolidLight light(appearance, viewOf(1));
            for (int row = 0; row < raster.height; row += 29) {
                const auto at = static_cast<std::size_t>(row * raster.width);
                const int end = std::min(row + 29, raster.height);
                light.apply(raster, row, end, std::span(banded).subspan(at));
                light.apply(raster, row, end, std::span(deep).subspan(at));
            }
            QVERIFY(banded == pixels);
            QVERIFY(deep == deepPicture(raster, appearance));
        }
    }

    void nothingIsTheBackground() {
        const DepthRaster raster = rasterOf(33, 21, 1, [](int, int) { return std::nullopt; });
        for (SolidAppearance appearance : appearances()) {
            appearance.background = {255, 128, 0, 51};
            for (const std::uint32_t pixel : picture(raster, appearance))
                QCOMPARE(pixel, 0x33331A00U); // premultiplied
            for (const Rgba16& pixel : deepPicture(raster, appearance))
                QVERIFY((pixel == Rgba16{65535, 32896, 0, 13107}));
            QVERIFY(picture({}, appearance).empty());
        }
    }

    void onePixelFacesTheEye() {
        const DepthRaster raster = rasterOf(
            40, 40, 10, [](int x, int y) { return x == 20 && y == 20 ? std::optional(-5.0) : std::nullopt; });
        const Surface surface = surfaceOf(raster, 1);
        QCOMPARE(surface.shade[20 * 40 + 20], 1.0F);
        QCOMPARE(surface.right[20 * 40 + 20], 0.0F);
        QCOMPARE(surface.up[20 * 40 + 20], 0.0F);
        const DepthRaster plane = rasterOf(1, 1, 10, [](int, int) { return 0.0; });
        const SolidAppearance stone = appearanceOf(Look::Stone);
        const auto pixels = picture(raster, stone);
        QCOMPARE(pixels[20 * 40 + 20], picture(plane, stone)[0]);
        QCOMPARE(std::count(pixels.begin(), pixels.end(), pixels[0]), 40 * 40 - 1);
    }

    // Without a finite range of depths, or a finite pixel, all is flat: the light that a plane has.
    void hostileNumbersAreFlat() {
        const DepthRaster raster = landscape(50, 40);
        DepthRaster plane = raster;
        plane.near = plane.far = 0;
        struct Case {
            double near, far, unitsPerPixel;
        };
        for (const Case& c : {Case{0, inf, 1},
                              {-inf, inf, 1},
                              {notANumber, 1, 1},
                              {0, notANumber, 1},
                              {3, 3, 1},
                              {5, -5, 1},
                              {0, 1, 0},
                              {0, 1, notANumber},
                              {0, 1, inf},
                              {0, 1, -1}}) {
            DepthRaster hostile = raster;
            hostile.near = c.near;
            hostile.far = c.far;
            for (const Look look : {Look::Stone, Look::Ink, Look::Normals})
                QVERIFY(picture(hostile, appearanceOf(look), viewOf(c.unitsPerPixel)) ==
                        picture(plane, appearanceOf(look)));
            for (const SolidAppearance& appearance : appearances()) { // defined, whatever it is
                const auto pixels = picture(hostile, appearance, viewOf(c.unitsPerPixel));
                QVERIFY(picture(hostile, appearance, viewOf(c.unitsPerPixel)) == pixels);
                deepPicture(hostile, appearance, viewOf(c.unitsPerPixel));
            }
        }
        DepthRaster steep = raster; // saturated, and finite
        steep.near = -1e300;
        steep.far = 1e300;
        for (const float shade : surfaceOf(steep, 1e-300).shade)
            QVERIFY(shade == -1 || (shade > 0 && shade <= 1));
        for (const double value : {inf, notANumber, -1.0, 1e300}) {
            SolidAppearance appearance = appearances().back();
            appearance.fog = value;
            appearance.keyLight = {static_cast<float>(value), 0, 1};
            picture(raster, appearance);
            deepPicture(raster, appearance);
        }
    }

    void fogGrowsWithDepth() {
        SolidAppearance appearance = appearanceOf(Look::Stone);
        appearance.background = {255, 255, 255, 255};
        const DepthRaster raster =
            rasterOf(3, 1, 0.5, [](int x, int) { return 0.5 * x - 0.5; }); // too shallow for any shade
        SolidView view = viewOf(1000);
        const auto clear = picture(raster, appearance, view);
        QCOMPARE(clear[0], clear[2]);
        appearance.fog = 2;
        const auto misty = picture(raster, appearance, view);
        const auto deep = deepPicture(raster, appearance, view);
        QCOMPARE(misty[0], clear[0]);
        for (int x = 0; x < 3; ++x)
            for (const int shift : {0, 8, 16}) {
                const double left = std::exp(-2 * x / 2.0);
                const double wanted = left * channel(clear[0], shift) + (1 - left) * 255;
                const auto k = static_cast<std::size_t>(x);
                QVERIFY(std::abs(channel(misty[k], shift) - wanted) <= 1);
                const std::uint16_t wide = shift == 0   ? deep[k].blue
                                           : shift == 8 ? deep[k].green
                                                        : deep[k].red;
                QVERIFY(std::abs(wide / 257.0 - wanted) <= 1);
            }
    }

    void coloursComeFromMapDepthAndHeight() {
        DepthRaster raster = rasterOf(2, 256, 128, [](int, int y) { return y - 128.0; });
        SolidAppearance appearance = appearanceOf(Look::Stone);
        appearance.palette = {"test", {{0, {255, 0, 0, 255}}, {1, {0, 0, 255, 255}}}};
        SolidView view;
        view.unitsPerPixel = 1e6; // flat
        view.lowest = -128e6;
        view.highest = 128e6;
        appearance.colourBy = SolidColour::Depth;
        const auto byDepth = picture(raster, appearance, view);
        appearance.colourBy = SolidColour::Height;
        const auto byHeight = picture(raster, appearance, view);
        for (const auto* pixels : {&byDepth, &byHeight}) {
            const bool isDepth = pixels == &byDepth; // nearest above, and highest above
            QCOMPARE(channel(pixels->front(), 16) > 100, isDepth);
            QCOMPARE(channel(pixels->back(), 0) > 100, isDepth);
            QCOMPARE(channel(pixels->front(), 0) > 100, !isDepth);
            QCOMPARE(channel(pixels->back(), 16) > 100, !isDepth);
        }
        appearance.colourBy = SolidColour::Map;
        appearance.mapColours = {{0, 255, 0, 255}};
        for (std::uint32_t& key : raster.keys)
            key &= 0xFFFFFF00U;
        const auto byMap = picture(raster, appearance, view);
        QCOMPARE(channel(byMap[0], 16), 0);
        QVERIFY(channel(byMap[0], 8) > 100);
        for (std::uint32_t& key : raster.keys)
            key |= 3U;
        SolidAppearance third = appearance;
        third.colourBy = SolidColour::Plain;
        third.plain = categoricalColour(3);
        for (const int shift : {0, 8, 16})
            QVERIFY(std::abs(channel(picture(raster, appearance, view)[0], shift) -
                             channel(picture(raster, third, view)[0], shift)) <= 1);
    }

    // Sixteen bits say what eight do, more finely.
    void deepPicturesLookAlike() {
        const DepthRaster raster = landscape(60, 50);
        for (const SolidAppearance& appearance : appearances()) {
            const auto pixels = picture(raster, appearance);
            const auto deep = deepPicture(raster, appearance);
            for (std::size_t k = 0; k < pixels.size(); ++k) {
                const double alpha = deep[k].alpha / 65535.0;
                QVERIFY(std::abs(alpha * deep[k].red / 257 - channel(pixels[k], 16)) < 2.5);
                QVERIFY(std::abs(alpha * deep[k].green / 257 - channel(pixels[k], 8)) < 2.5);
                QVERIFY(std::abs(alpha * deep[k].blue / 257 - channel(pixels[k], 0)) < 2.5);
                QVERIFY(std::abs(255 * alpha - channel(pixels[k], 24)) < 1);
            }
        }
    }

    // The mean of what is opaque, in linear light, by as much as it covers.
    void averagesAreOfLight() {
        const std::vector<std::uint32_t> fine = {0xFFFFFFFFU, 0xFF000000U, 0xFF102030U, 0xFF102030U,
                                                 0xFFFFFFFFU, 0xFF000000U, 0xFF102030U, 0xFF102030U,
                                                 0,           0xFF8040C0U, 0,           0,
                                                 0xFF8040C0U, 0,           0,           0};
        std::vector<std::uint32_t> pixels(4);
        averagePixels(std::span(fine), 2, 2, std::span(pixels));
        QCOMPARE(pixels, (std::vector<std::uint32_t>{0xFFBCBCBCU, 0xFF102030U, 0x80402060U, 0U}));
        std::vector<Rgba16> deep;
        for (const std::uint32_t pixel : fine) // those here are opaque or nothing
            deep.push_back({static_cast<std::uint16_t>(channel(pixel, 16) * 257),
                            static_cast<std::uint16_t>(channel(pixel, 8) * 257),
                            static_cast<std::uint16_t>(channel(pixel, 0) * 257),
                            static_cast<std::uint16_t>(channel(pixel, 24) * 257)});
        std::vector<Rgba16> deepPixels(4);
        averagePixels(std::span<const Rgba16>(deep), 2, 2, std::span(deepPixels));
        QVERIFY(std::abs(deepPixels[0].green - 257 * 188) < 257);
        QVERIFY((deepPixels[1] == Rgba16{16 * 257, 32 * 257, 48 * 257, 65535}));
        QCOMPARE(deepPixels[2].alpha, std::uint16_t(32768));
        QVERIFY(std::abs(deepPixels[2].blue - 257 * 192) <= 1);
        QVERIFY((deepPixels[3] == Rgba16{}));
    }

    void depthValuesAreLinear() {
        DepthRaster raster{4, 1, {0x00000005U, 0xFFFFFE00U, 0x7FFFFF00U, emptyKey}, 2, 4};
        std::vector<std::uint16_t> values(4);
        depthValues(raster, 0, 1, values);
        QCOMPARE(values[0], std::uint16_t(0));
        QCOMPARE(values[1], std::uint16_t(65534));
        QCOMPARE(values[2], std::uint16_t(32767));
        QCOMPARE(values[3], std::uint16_t(65535));
    }

    void lampsStandWhereTheyAreSaidToBe() {
        QVERIFY((lampAt(0, 0) == ViewVector{0, 0, 1}));
        for (double azimuth = -400; azimuth < 400; azimuth += 13.7)
            for (double elevation = -90; elevation <= 90; elevation += 11.3) {
                const ViewVector lamp = lampAt(azimuth, elevation);
                const double a = azimuth * std::acos(-1.0) / 180, e = elevation * std::acos(-1.0) / 180;
                QVERIFY(std::abs(lamp.right - std::cos(e) * std::sin(a)) < 1e-7);
                QVERIFY(std::abs(lamp.up - std::sin(e)) < 1e-7);
                QVERIFY(std::abs(lamp.towards - std::cos(e) * std::cos(a)) < 1e-7);
            }
    }

    // The key light stands at the upper left.
    void surfacesToTheUpperLeftAreBrightest() {
        const auto brightness = [](double right, double up) {
            const DepthRaster raster =
                rasterOf(9, 9, 60, [&](int x, int y) { return right * (x - 4) - up * (y - 4); });
            SolidAppearance appearance = appearanceOf(Look::Stone);
            return channel(picture(raster, appearance)[4 * 9 + 4], 8);
        };
        QVERIFY(brightness(-0.5, 0.5) > brightness(0.5, 0.5));
        QVERIFY(brightness(-0.5, 0.5) > brightness(-0.5, -0.5));
        QVERIFY(brightness(0.5, 0.5) > brightness(0.5, -0.5));
    }

private:
    const std::string m_simd = simdName();
};

BARYCAGE_TEST(TestSolidLight, QCoreApplication);
#include "solid_light_test.moc"
