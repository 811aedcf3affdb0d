// SPDX-License-Identifier: MIT
#include "attractor/light/pixel_average.h"

#include "attractor/colour/srgb_transfer.h"
#include "support/named_test.h"

#include <QtTest>

using namespace attractor;

// What several pixels, or several moments of one, show together.
class PixelAverageTest : public QObject {
    Q_OBJECT

private slots:
    void whatStaysKeepsItsBytes() {
        std::vector<std::uint32_t> picture;
        std::vector<Rgba16> deep;
        for (std::uint32_t code = 0; code < 256; ++code) {
            picture.push_back(0xff000000U | code << 16 | (255 - code) << 8 | code / 2);
            deep.push_back(
                {std::uint16_t(code * 257), std::uint16_t(code * 7), 65535, std::uint16_t(1 + code * 256)});
        }
        picture.push_back(0);
        PictureAverage<std::uint32_t> average;
        PictureAverage<Rgba16> deepAverage;
        for (int n = 0; n < 5; ++n) {
            average.add(picture);
            deepAverage.add(deep);
        }
        std::vector<std::uint32_t> mean(picture.size());
        std::vector<Rgba16> deepMean(deep.size());
        average.mean(mean);
        deepAverage.mean(deepMean);
        QVERIFY(mean == picture);
        QVERIFY(deepMean == deep);
    }

    // Half the light of white is sRGB 188; what is seen half of the time is half opaque.
    void lightAddsUp() {
        const std::vector<std::uint32_t> white{0xffffffffU, 0xffffffffU}, other{0xff000000U, 0};
        PictureAverage<std::uint32_t> average;
        average.add(white);
        average.add(other);
        std::vector<std::uint32_t> mean(2);
        average.mean(mean);
        QCOMPARE(mean[0], 0xffbcbcbcU);
        QCOMPARE(mean[1] >> 24, 0x80U); // white, premultiplied
        QVERIFY((mean[1] & 0xff) >= 0x7f && (mean[1] & 0xff) <= 0x80);
        QCOMPARE(int(encoded(0.5)), 0xbc);
    }
};

BARYCAGE_TEST(PixelAverageTest);
#include "pixel_average_test.moc"
