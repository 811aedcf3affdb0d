// SPDX-License-Identifier: MIT
#include "io/picture/solid_picture.h"

#include "attractor/light/solid_light.h"
#include "attractor/render/solid_rendering.h"
#include "attractor/space_systems.h"
#include "support/named_test.h"

#include <QBuffer>
#include <QImage>
#include <QRgba64>
#include <QSet>
#include <QTest>

#include <cmath>

using namespace io;

namespace {

constexpr int width = 70, height = 50;

SolidPicture pictureOf(const systems::System3& system, attractor::Look look, double azimuth = 30,
                       double elevation = 20) {
    SolidPicture picture;
    picture.request = systems::spaceRequest(system, width, height, azimuth, elevation);
    picture.appearance = attractor::appearanceOf(look);
    return picture;
}

SolidPicture menger(attractor::Look look) {
    return pictureOf(systems::menger(), look);
}

systems::System3 cube() { // solid
    systems::System3 result;
    for (int k = 0; k < 8; ++k)
        ifs::append<3>(result, systems::scaled(0.5, (k & 1) * 0.5, (k >> 1 & 1) * 0.5, (k >> 2 & 1) * 0.5));
    return result;
}

struct Written {
    ExportOutcome outcome;
    QByteArray bytes;
    QImage image;
};

Written written(const SolidPicture& picture, const std::stop_token& stop = {}) {
    Written result;
    QBuffer buffer(&result.bytes);
    buffer.open(QIODevice::WriteOnly);
    PictureFormat format;
    format.width = picture.request.camera.size.width;
    format.height = picture.request.camera.size.height;
    format.depth = picture.depth;
    format.pixels = picture.appearance.background.alpha == 255 ? PictureFormat::Pixels::Opaque
                                                               : PictureFormat::Pixels::Transparent;
    PngWriter writer(buffer, format);
    result.outcome = writeSolid(picture, writer, {}, stop);
    result.image = QImage::fromData(result.bytes, "PNG");
    return result;
}

} // namespace

class SolidPictureTest : public QObject {
    Q_OBJECT

private slots:
    void pixelsAreThoseOfTheLight() {
        for (const attractor::Look look : {attractor::Look::Stone, attractor::Look::Ink}) {
            const SolidPicture picture = menger(look);
            attractor::SolidRendering rendering(picture.request);
            QVERIFY(rendering.draw());
            attractor::Workers workers(1);
            const auto pixels = attractor::lit(rendering.raster(), picture.appearance,
                                               attractor::solidView(picture.request.camera, 0, 1), workers);
            const Written result = written(picture);
            QVERIFY(!result.outcome.failure && !result.outcome.stopped);
            QCOMPARE(result.image.size(), QSize(width, height));
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    QCOMPARE(result.image.pixel(x, y), pixels[std::size_t(y * width + x)]);
        }
    }

    void heightsRunOverTheAttractor() {
        SolidPicture picture = menger(attractor::Look::Stone);
        picture.appearance.colourBy = attractor::SolidColour::Height;
        picture.appearance.palette = {"test", {{0, {255, 0, 0, 255}}, {1, {0, 0, 255, 255}}}};
        const QImage image = written(picture).image;
        int red = 0, blue = 0; // of the lowest and the highest rows in which there is something
        for (int x = 0; x < width; ++x) {
            red = std::max(red, qRed(image.pixel(x, height - 6)));
            blue = std::max(blue, qBlue(image.pixel(x, 5)));
        }
        QVERIFY2(red > 120 && blue > 120, qPrintable(QStringLiteral("%1, %2").arg(red).arg(blue)));
    }

    // A square, and nothing: only between the two are there other colours.
    void supersamplingSmoothsEdges() {
        SolidPicture picture = pictureOf(cube(), attractor::Look::Stone, 0, 0);
        const auto colours = [](const QImage& image) {
            QSet<QRgb> found;
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    found << image.pixel(x, y);
            return found;
        };
        const QSet<QRgb> rough = colours(written(picture).image);
        QCOMPARE(rough.size(), 2);
        picture.supersample = 3;
        const QSet<QRgb> smooth = colours(written(picture).image);
        QVERIFY(smooth.size() > 2);
        QVERIFY(smooth.contains(rough));
    }

    void aHugePictureNeedsLittleMemory() {
        SolidPicture picture = menger(attractor::Look::Stone);
        picture.request.camera.size = {60'000, 60'000};
        picture.supersample = 2;
        QVERIFY(memoryFor(picture) < 1ULL << 30);
    }

    void bandsMakeNoDifference() {
        for (const attractor::Look look :
             {attractor::Look::Stone, attractor::Look::Ink, attractor::Look::Normals})
            for (const auto depth : {PictureFormat::Depth::Bits8, PictureFormat::Depth::Bits16}) {
                SolidPicture picture = menger(look);
                picture.request.camera.size = {90, 300};
                picture.request.camera.height *= 6;
                picture.supersample = 2;
                picture.depth = depth;
                QCOMPARE(rowsTogether(picture), 300);
                const QByteArray whole = written(picture).bytes;
                picture.bandBytes = 1;
                QCOMPARE(rowsTogether(picture), 64);
                QVERIFY(!whole.isEmpty());
                QVERIFY(written(picture).bytes == whole);
            }
    }

    void normalsAreNotAveraged() {
        SolidPicture picture = pictureOf(cube(), attractor::Look::Normals, 30, 0);
        picture.depth = PictureFormat::Depth::Bits16;
        const Written once = written(picture);
        QCOMPARE(once.image.format(), QImage::Format_RGBA64);
        picture.supersample = 4;
        QCOMPARE(written(picture).bytes, once.bytes);
        QCOMPARE(once.image.pixelColor(0, 0).alpha(), 0);
        // The middle of the face that looks along +x, which is to the right by cos 30° and towards the eye.
        const double right = 0.5 * std::cos(M_PI / 6) * attractor::pixelsPerUnit(picture.request.camera);
        const QRgba64 face = once.image.pixelColor(int(width / 2 + right), height / 2).rgba64();
        QVERIFY(std::abs(face.red() - 65535 * (std::cos(M_PI / 6) + 1) / 2) < 2500);
        QVERIFY(std::abs(face.green() - 32768) < 2500);
    }

    void threadsChangeNoByte() {
        SolidPicture picture = menger(attractor::Look::Stone);
        picture.supersample = 2;
        const QByteArray one = written(picture).bytes;
        picture.request.threads = 3;
        QCOMPARE(written(picture).bytes, one);
    }

    void canBeStopped() {
        std::stop_source source;
        source.request_stop();
        const Written result = written(menger(attractor::Look::Stone), source.get_token());
        QVERIFY(result.outcome.stopped);
        QVERIFY(result.image.isNull());
    }
};

BARYCAGE_TEST(SolidPictureTest, QCoreApplication);
#include "solid_picture_test.moc"
