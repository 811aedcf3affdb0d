// SPDX-License-Identifier: MIT
#include "io/picture/png/png_system.h"
#include "io/picture/png/png_writer.h"
#include "support/named_test.h"

#include <QBuffer>
#include <QColorSpace>
#include <QImage>
#include <QRandomGenerator>
#include <QRgba64>
#include <QTest>

using namespace io;

namespace {

QByteArray written(const QImage& picture, PictureFormat format) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    format.width = picture.width();
    format.height = picture.height();
    PngWriter writer(buffer, format);
    for (int y = 0; y < picture.height(); ++y) {
        const auto* row = reinterpret_cast<const std::uint32_t*>(picture.constScanLine(y));
        if (writer.writeRows({row, size_t(picture.width())})) return {};
    }
    return writer.finish() ? QByteArray() : bytes;
}

QImage randomPicture(int width, int height, bool opaque) {
    QRandomGenerator random(7);
    QImage picture(width, height, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.setPixel(x, y, qPremultiply(random.generate() | (opaque ? 0xff000000u : 0u)));
    return picture;
}

// A disk that is full after `room` bytes.
class FullDisk : public QIODevice {
public:
    explicit FullDisk(qint64 room) : m_room(room) {
        open(QIODevice::WriteOnly | QIODevice::Unbuffered);
        setErrorString(QStringLiteral("No space left on device"));
    }

protected:
    qint64 readData(char*, qint64) override { return -1; }
    qint64 writeData(const char*, qint64 size) override {
        m_room -= size;
        return m_room < 0 ? -1 : size;
    }

private:
    qint64 m_room;
};

// The picture as read, which must say that it is sRGB.
QImage readBack(const QByteArray& bytes) {
    QImage picture = QImage::fromData(bytes, "PNG");
    if (picture.colorSpace() != QColorSpace(QColorSpace::SRgb)) return {};
    picture.setColorSpace({});
    return picture;
}

const QByteArray fern = "fern { ; Barnsley’s\n 0 0 0 .16 0 0 .01\n}\n";

} // namespace

class PngWriterTest : public QObject {
    Q_OBJECT

private slots:
    void opaquePictureComesBack();
    void transparentPictureComesBack();
    void resolutionIsKept();
    void systemComesBack();
    void pictureWithoutSystemSaysSo();
    void damagedPicturesAreRefused();
    void oversizedTextIsRefused();
    void aChunkTakesNoMoreMemoryThanItHas();
    void fullDiskIsReported();
    void bandsGiveTheSameBytes();
    void grainTakesLittleRoom();
    void sixteenBitsComeBack();
};

void PngWriterTest::opaquePictureComesBack() {
    const QImage picture = randomPicture(37, 21, true);
    const QImage back = readBack(written(picture, {}));
    QCOMPARE(back.hasAlphaChannel(), false);
    QCOMPARE(back.convertToFormat(QImage::Format_ARGB32_Premultiplied), picture);
}

void PngWriterTest::transparentPictureComesBack() {
    const QImage picture = randomPicture(16, 50, false);
    PictureFormat format;
    format.pixels = PictureFormat::Pixels::Transparent;
    const QImage back = readBack(written(picture, format));
    QVERIFY(back.hasAlphaChannel());
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const QRgb here = picture.pixel(x, y); // premultiplied, as stored
            QCOMPARE(qAlpha(back.pixel(x, y)), qAlpha(here));
            // Dividing by the alpha and multiplying again costs at most one step of 255.
            const QRgb there = qPremultiply(back.pixel(x, y));
            QVERIFY(std::abs(qRed(there) - qRed(here)) <= 1 && std::abs(qGreen(there) - qGreen(here)) <= 1 &&
                    std::abs(qBlue(there) - qBlue(here)) <= 1);
        }
}

void PngWriterTest::resolutionIsKept() {
    PictureFormat format;
    format.dotsPerInch = 300;
    const QImage back = QImage::fromData(written(randomPicture(4, 4, true), format), "PNG");
    QCOMPARE(back.dotsPerMeterX(), 11811);
    QCOMPARE(back.dotsPerMeterY(), 11811);
}

void PngWriterTest::systemComesBack() {
    PictureFormat format;
    format.systemText = fern;
    const QByteArray bytes = written(randomPicture(5, 5, true), format);
    const EmbeddedSystem system = readPngSystem(bytes);
    QVERIFY(!system.failure);
    QCOMPARE(system.text, fern);
    QCOMPARE(QImage::fromData(bytes).text(QLatin1String(pngSystemKeyword)),
             QString::fromUtf8(fern).trimmed() + u'\n');
}

void PngWriterTest::pictureWithoutSystemSaysSo() {
    const EmbeddedSystem system = readPngSystem(written(randomPicture(5, 5, true), {}));
    QVERIFY(system.failure);
    QVERIFY(system.text.isEmpty());
}

void PngWriterTest::damagedPicturesAreRefused() {
    PictureFormat format;
    format.systemText = fern;
    const QByteArray whole = written(randomPicture(5, 5, true), format);
    const qsizetype end = whole.indexOf("IDAT") + 4;
    for (qsizetype size = 0; size < end - 4; ++size)
        QVERIFY2(readPngSystem(whole.left(size)).failure, qPrintable(QString::number(size)));
    // A changed byte is never returned as if it were the text: the checksum of its chunk tells.
    for (qsizetype at = 0; at < end; ++at) {
        QByteArray bent = whole;
        bent[at] = char(bent[at] ^ 0x20);
        const EmbeddedSystem system = readPngSystem(bent);
        QVERIFY2(system.failure || system.text == fern, qPrintable(QString::number(at)));
    }
    QVERIFY(readPngSystem("GIF89a").failure);
    QVERIFY(readPngSystem({}).failure);
}

void PngWriterTest::oversizedTextIsRefused() {
    PictureFormat format;
    format.systemText = QByteArray(9 * 1024 * 1024, 'x');
    const EmbeddedSystem system = readPngSystem(written(randomPicture(5, 5, true), format));
    QVERIFY(system.failure);
    QVERIFY(system.text.isEmpty());
}

void PngWriterTest::aChunkTakesNoMoreMemoryThanItHas() {
    PictureFormat format;
    format.systemText = fern;
    QByteArray bytes = written(randomPicture(5, 5, true), format);
    bytes[bytes.indexOf("iTXt") - 4] = '\x74'; // nearly 2 GB
    const auto peak = [] { // of the address space: memory that is asked for and never written counts
        QFile status(QStringLiteral("/proc/self/status"));
        if (!status.open(QIODevice::ReadOnly)) return 0LL;
        const QByteArray text = status.readAll();
        return text.mid(text.indexOf("VmPeak:") + 7).trimmed().split(' ').first().toLongLong() * 1024;
    };
    const qint64 before = peak();
    QVERIFY(before > 0);
    QVERIFY(readPngSystem(bytes).failure);
    QVERIFY(peak() - before < 100'000'000);
}

void PngWriterTest::fullDiskIsReported() {
    const QImage picture = randomPicture(300, 300, true);
    for (const qint64 room : {0, 20, 5000, 200'000}) {
        FullDisk disk(room);
        PictureFormat format;
        format.width = picture.width();
        format.height = picture.height();
        PngWriter writer(disk, format);
        for (int y = 0; y < picture.height(); ++y)
            writer.writeRows({reinterpret_cast<const std::uint32_t*>(picture.constScanLine(y)), 300});
        const Failure failure = writer.finish();
        QVERIFY(failure);
        QVERIFY(failure->contains(QStringLiteral("No space left on device")));
    }
}

void PngWriterTest::bandsGiveTheSameBytes() {
    const QImage picture = randomPicture(64, 64, true);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    PictureFormat format;
    format.width = 64;
    format.height = 64;
    PngWriter writer(buffer, format);
    const auto* pixels = reinterpret_cast<const std::uint32_t*>(picture.constBits());
    QVERIFY(!writer.writeRows({pixels, 64 * 5}));
    QVERIFY(!writer.writeRows({pixels + 64 * 5, 64 * 59}));
    QVERIFY(!writer.finish());
    QCOMPARE(bytes, written(picture, {}));
}

// The grain of a density has few colours: no more than twice what they take.
void PngWriterTest::grainTakesLittleRoom() {
    constexpr int side = 256, colours = 16;
    QRandomGenerator random(5);
    QImage picture(side, side, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const int tone = int(random.bounded(colours));
            picture.setPixel(x, y, qRgb(tone * 16, 255 - tone * 5, tone * tone));
        }
    const QByteArray bytes = written(picture, {});
    QCOMPARE(readBack(bytes), picture.convertToFormat(readBack(bytes).format()));
    const qsizetype needed = side * side * 4 / 8;
    QVERIFY2(bytes.size() < 2 * needed, qPrintable(QString::number(bytes.size())));
}

void PngWriterTest::sixteenBitsComeBack() {
    QRandomGenerator random(3);
    std::vector<attractor::Rgba16> pixels(23 * 17);
    for (auto& pixel : pixels) {
        const quint64 bits = random.generate64();
        pixel = {std::uint16_t(bits), std::uint16_t(bits >> 16), std::uint16_t(bits >> 32),
                 std::uint16_t(bits >> 48)};
    }
    for (const auto kind : {PictureFormat::Pixels::Opaque, PictureFormat::Pixels::Transparent}) {
        PictureFormat format{23, 17, kind, PictureFormat::Depth::Bits16, 600, fern};
        QByteArray bytes;
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        PngWriter writer(buffer, format);
        QVERIFY(!writer.writeRows(std::span<const attractor::Rgba16>(pixels)));
        QVERIFY(!writer.finish());
        for (const char* chunk : {"sRGB", "gAMA", "cHRM", "pHYs"})
            QVERIFY2(bytes.contains(chunk), chunk);
        const bool transparent = kind == PictureFormat::Pixels::Transparent;
        const QImage back =
            readBack(bytes).convertToFormat(transparent ? QImage::Format_RGBA64 : QImage::Format_RGBX64);
        for (int i = 0; i < 23 * 17; ++i) {
            const QRgba64 here = reinterpret_cast<const QRgba64*>(back.constScanLine(i / 23))[i % 23];
            const attractor::Rgba16& there = pixels[std::size_t(i)];
            QCOMPARE(here.red(), there.red);
            QCOMPARE(here.green(), there.green);
            QCOMPARE(here.blue(), there.blue);
            QCOMPARE(here.alpha(), transparent ? there.alpha : std::uint16_t{65535});
        }
        QCOMPARE(readPngSystem(bytes).text, fern);
    }
}

BARYCAGE_TEST(PngWriterTest, QCoreApplication);
#include "png_writer_test.moc"
