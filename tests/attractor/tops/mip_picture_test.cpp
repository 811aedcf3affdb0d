// SPDX-License-Identifier: MIT
#include "attractor/tops/mip_picture.h"

#include "attractor/colour/srgb_transfer.h"
#include "attractor/kernels/kernels.h"
#include "ifs/canonical_systems.h"
#include "support/named_test.h"

#include <QTest>

#include <cmath>

using attractor::MipPicture;
using attractor::Rgba;

// Pictures that are looked up at any size.
class MipPictureTest : public QObject {
    Q_OBJECT

private slots:
    void pixelsAreThemselvesInTheirMiddles();
    void betweenPixelsInLinearLight();
    void oneColourAtEverySize_data();
    void oneColourAtEverySize();
    void largeAreasAreAveraged();
    void nothingOutside();
    void transparentPixelsLendNoColour();
    void mixesManyAsOne_data();
    void mixesManyAsOne();
    void levelsAreHalfTheLogarithm();
};

void MipPictureTest::pixelsAreThemselvesInTheirMiddles() {
    std::vector<Rgba> pixels;
    for (int k = 0; k < 15; ++k)
        pixels.push_back({std::uint8_t(k * 17), std::uint8_t(255 - k), 7, 255});
    const MipPicture picture(5, 3, pixels);
    for (int k = 0; k < 15; ++k) {
        const auto c = picture.at(k % 5 + .5, k / 5 + .5, 1);
        QCOMPARE(attractor::encoded(c.red), pixels[std::size_t(k)].red);
        QCOMPARE(attractor::encoded(c.green), pixels[std::size_t(k)].green);
        QCOMPARE(c.alpha, 1.0);
    }
}

void MipPictureTest::betweenPixelsInLinearLight() {
    const MipPicture picture(2, 1, {{0, 0, 0, 255}, {255, 255, 255, 255}});
    QCOMPARE(picture.at(1, .5, 1).red, 0.5);
    QCOMPARE(picture.at(.75, .5, 0).red, 0.25);
    QCOMPARE(picture.at(0, .5, 1).red, 0.0);
}

void MipPictureTest::oneColourAtEverySize_data() {
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {13, 1}, {31, 17}, {64, 64}})
        QTest::addRow("%d × %d", width, height) << width << height;
}

void MipPictureTest::oneColourAtEverySize() {
    QFETCH(int, width);
    QFETCH(int, height);
    const MipPicture picture(width, height,
                             std::vector<Rgba>(std::size_t(width * height), Rgba{200, 100, 50, 255}));
    for (double area = 0; area < 1e9; area = 3 * area + 1)
        for (const double x : {0.0, .3, .99, 1.0}) {
            const auto c = picture.at(x * width, x * height, area);
            QCOMPARE(attractor::encoded(c.red), std::uint8_t(200));
            QCOMPARE(attractor::encoded(c.blue), std::uint8_t(50));
        }
}

// A checkerboard of black and white is grey from afar: half the light.
void MipPictureTest::largeAreasAreAveraged() {
    std::vector<Rgba> pixels;
    for (int k = 0; k < 32 * 32; ++k)
        pixels.push_back((k % 32 + k / 32) % 2 ? Rgba{255, 255, 255, 255} : Rgba{0, 0, 0, 255});
    const MipPicture picture(32, 32, pixels);
    for (const double area : {4.0, 100.0, 1e6, HUGE_VAL})
        QVERIFY(std::abs(picture.at(10.3, 20.8, area).green - .5) < 1e-4);
    QVERIFY(picture.at(10.5, 20.5, 1).green < .01);
}

void MipPictureTest::nothingOutside() {
    const MipPicture picture(4, 4, std::vector<Rgba>(16, Rgba{255, 255, 255, 255}));
    for (const double x : {-.01, 4.01, double(NAN), HUGE_VAL}) {
        QCOMPARE(picture.at(x, 2, 1).alpha, 0.0);
        QCOMPARE(picture.at(2, x, 100).alpha, 0.0);
    }
    QCOMPARE(picture.at(4, 0, 1).alpha, 1.0);
}

void MipPictureTest::transparentPixelsLendNoColour() {
    const MipPicture picture(2, 1, {{255, 0, 0, 0}, {0, 0, 255, 255}});
    const auto c = picture.at(1, .5, 1e3);
    QCOMPARE(c.red, 0.0);
    QVERIFY(std::abs(c.alpha - .5) < 1e-4 && std::abs(c.blue - .5) < 1e-4);
}

void MipPictureTest::mixesManyAsOne_data() {
    oneColourAtEverySize_data();
}

// In whole numbers, the same for every instruction set: what at() finds, to a few of 32767 parts.
void MipPictureTest::mixesManyAsOne() {
    QFETCH(int, width);
    QFETCH(int, height);
    canonical::Random random(5);
    std::vector<Rgba> pixels;
    for (int k = 0; k < width * height; ++k) {
        const auto code = [&] { return std::uint8_t(random()); };
        pixels.push_back({code(), code(), code(), std::uint8_t(k % 3 ? 255 : code())});
    }
    const MipPicture picture(width, height, pixels);
    struct Place {
        double x, y, area;
    };
    std::vector<Place> looked{{0, 0, 0}, {double(width), double(height), 1}, {double(width), 0, 1e9}};
    for (double area = .1; area < 1e6; area *= 1.1)
        looked.push_back(
            {width * double(random() % 10001) / 1e4, height * double(random() % 10001) / 1e4, area});
    std::vector<attractor::kernels::PicturePlace> places;
    for (const Place& at : looked)
        places.push_back(picture.place(at.x, at.y, attractor::mipLevel(at.area)));
    std::vector<std::int16_t> mixed(4 * places.size()), same(mixed.size());
    picture.mix(places, mixed);
    for (std::size_t k = 0; k < looked.size(); ++k) {
        const auto c = picture.at(looked[k].x, looked[k].y, looked[k].area);
        const double channels[] = {c.red, c.green, c.blue, c.alpha};
        for (std::size_t i = 0; i < 4; ++i)
            QVERIFY(std::abs(channels[i] * attractor::kernels::fullChannel - mixed[4 * k + i]) < 6);
    }
    const std::string chosen = attractor::simdName();
    for (const std::string& set : attractor::simdNames()) {
        QVERIFY(attractor::selectSimd(set));
        picture.mix(places, same);
        QVERIFY2(same == mixed, set.c_str());
    }
    QVERIFY(attractor::selectSimd(chosen));
}

void MipPictureTest::levelsAreHalfTheLogarithm() {
    constexpr int one = 1 << attractor::kernels::placeBits;
    QCOMPARE(attractor::mipLevel(1), 0);
    QCOMPARE(attractor::mipLevel(4), one);
    QCOMPARE(attractor::mipLevel(1 / 16.0), -2 * one);
    for (const double area : {1.3, 7.0, 1e-5, 1e200})
        QVERIFY(std::abs(attractor::mipLevel(area) - std::log2(area) * one / 2) < 1);
    const int none = attractor::mipLevel(0);
    QVERIFY(none + attractor::mipLevel(HUGE_VAL) < 0);
    QCOMPARE(attractor::mipLevel(double(NAN)), none);
}

BARYCAGE_TEST(MipPictureTest);
#include "mip_picture_test.moc"
