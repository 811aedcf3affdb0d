// SPDX-License-Identifier: MIT
#include "io/tops/picture_reader.h"

#include "attractor/colour/srgb_transfer.h"
#include "io/picture/picture_decoder.h"
#include "support/named_test.h"

#include <QBuffer>
#include <QColorSpace>
#include <QImage>
#include <QImageWriter>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

#include <algorithm>
#include <cmath>
#include <sys/resource.h>
#include <zlib.h>

// Pictures that colours are taken from.
class PictureReaderTest : public QObject {
    Q_OBJECT

private slots:
    void keepsColours();
    void convertsColourSpaces();
    void refusesWhatIsTooLarge();
    void reducesLargePictures();
    void refusesLargeInterlacedPicturesItself();
    void textsAreNotUnpacked();
    void refusesManyScans();
    void namesTheFile();
    void survivesDamage();
};

namespace {

QByteArray png(const QImage& image) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes;
}

QImage colours() {
    QImage image(7, 5, QImage::Format_ARGB32);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 7; ++x)
            image.setPixel(x, y, qRgba(40 * x, 60 * y, 99, 255));
    return image;
}

} // namespace

void PictureReaderTest::keepsColours() {
    const io::ReadPicture read = io::decodePicture(png(colours()));
    QVERIFY(!read.failure);
    QCOMPARE(read.picture.width(), 7);
    QCOMPARE(read.picture.height(), 5);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 7; ++x) {
            const auto c = read.picture.at(x + .5, y + .5, 1);
            QCOMPARE(int(attractor::encoded(c.red)), 40 * x);
            QCOMPARE(int(attractor::encoded(c.green)), 60 * y);
        }
}

void PictureReaderTest::convertsColourSpaces() {
    QImage linear = colours();
    linear.setColorSpace(QColorSpace(QColorSpace::SRgbLinear));
    const io::ReadPicture read = io::decodePicture(png(linear));
    QVERIFY(!read.failure);
    const double green = read.picture.at(3.5, 2.5, 1).green; // 120 of 255 in linear light
    QVERIFY(std::abs(green - 120 / 255.0) < .01);
}

void PictureReaderTest::refusesWhatIsTooLarge() {
    const io::ReadPicture read = io::decodePicture("P6\n8001 4000\n255\n");
    QVERIFY(read.failure);
    QCOMPARE(*read.failure,
             QStringLiteral("The picture has 8001 × 4000 pixels. At most 32 million pixels can "
                            "be read; scale it down."));
}

// A picture of a good camera: left half red, right half blue.
void PictureReaderTest::reducesLargePictures() {
    QImage large(9000, 6000, QImage::Format_RGB32);
    large.fill(Qt::red);
    for (int y = 0; y < large.height(); ++y)
        std::fill_n(reinterpret_cast<QRgb*>(large.scanLine(y)) + 4500, 4500, qRgb(0, 0, 255));
    for (const char* format : {"PNG", "JPEG"}) {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        QVERIFY(large.save(&buffer, format));
        const io::ReadPicture read = io::decodePicture(bytes);
        QVERIFY2(!read.failure, format);
        const qint64 pixels = qint64(read.picture.width()) * read.picture.height();
        QVERIFY(pixels <= io::maxDecodedPixels && pixels > io::maxDecodedPixels * 9 / 10);
        QVERIFY(std::abs(double(read.picture.width()) / read.picture.height() - 1.5) < .001);
        const double y = read.picture.height() / 2.0;
        QVERIFY(read.picture.at(read.picture.width() * .25, y, 1).red > .9);
        QVERIFY(read.picture.at(read.picture.width() * .75, y, 1).blue > .9);
        QVERIFY(io::decodedPicture(bytes).flaw); // where every pixel counts
    }
}

// 9000 × 9000 in colours, which cannot be scaled row by row: the sentence is ours, and nothing is said
// besides.
void PictureReaderTest::refusesLargeInterlacedPicturesItself() {
    const QByteArray bytes =
        QByteArray::fromHex("89504e470d0a1a0a0000000d494844520000232800002328080200000195b0d57b00000008494441"
                            "54789c030000000001480689d20000000049454e44ae426082");
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".")));
    const io::ReadPicture read = io::decodePicture(bytes);
    QVERIFY(read.failure);
    QCOMPARE(*read.failure,
             QStringLiteral("The picture has 9000 × 9000 pixels. At most 32 million pixels can "
                            "be read; scale it down."));
}

// A hundred texts of 4 MB each in 400 KB of file.
void PictureReaderTest::textsAreNotUnpacked() {
    const QByteArray text = qCompress(QByteArray(4 << 20, 'x')).mid(4); // without the length that Qt adds
    QByteArray chunk = "zTXtkey";
    chunk += QByteArray(2, '\0') + text;
    QByteArray length(4, '\0'), checksum(4, '\0');
    qToBigEndian(quint32(chunk.size() - 4), length.data());
    qToBigEndian(quint32(::crc32(0, reinterpret_cast<const Bytef*>(chunk.constData()), uInt(chunk.size()))),
                 checksum.data());
    constexpr int headerEnd = 33;
    QByteArray bytes = png(colours());
    bytes.insert(headerEnd, (length + chunk + checksum).repeated(100));
    const auto peak = [] {
        struct rusage usage {};
        ::getrusage(RUSAGE_SELF, &usage);
        return usage.ru_maxrss; // kilobytes
    };
    const long before = peak();
    const io::ReadPicture read = io::decodePicture(bytes);
    QVERIFY2(!read.failure, qPrintable(read.failure.value_or(QString())));
    QCOMPARE(read.picture.width(), 7);
    QVERIFY2(peak() - before < 100'000, qPrintable(QString::number(peak() - before)));
}

// Each scan goes over all of the picture; thousands of empty ones take minutes.
void PictureReaderTest::refusesManyScans() {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QImageWriter writer(&buffer, "jpeg");
    writer.setProgressiveScanWrite(true);
    QVERIFY(writer.write(colours().convertToFormat(QImage::Format_RGB32)));
    QVERIFY(!io::decodePicture(bytes).failure);
    const qsizetype last = bytes.lastIndexOf("\xFF\xDA"), end = bytes.size() - 2;
    bytes.insert(end, bytes.mid(last, end - last).repeated(200));
    const io::ReadPicture read = io::decodePicture(bytes);
    QVERIFY(read.failure);
    QVERIFY2(read.failure->contains(QStringLiteral("scans")), qPrintable(*read.failure));
}

void PictureReaderTest::namesTheFile() {
    const QTemporaryDir folder;
    const QString absent = folder.filePath(QStringLiteral("absent.png"));
    const io::ReadPicture read = io::readPicture(absent);
    QVERIFY(read.failure && read.failure->contains(absent));
    QVERIFY(io::readPicture(folder.path()).failure); // a folder
}

// Cut anywhere or with a byte changed: a picture or a sentence.
void PictureReaderTest::survivesDamage() {
    const QByteArray whole = png(colours());
    int failures = 0;
    for (qsizetype k = 0; k < whole.size(); ++k) {
        QByteArray damaged = whole;
        damaged[k] = char(damaged[k] ^ 0x55);
        for (const QByteArray& bytes : {whole.left(k), damaged}) {
            const io::ReadPicture read = io::decodePicture(bytes);
            QVERIFY(read.failure ? read.failure->endsWith(u'.') : read.picture.width() > 0);
            failures += read.failure ? 1 : 0;
        }
    }
    QVERIFY(failures > whole.size());
}

BARYCAGE_TEST(PictureReaderTest, QCoreApplication);
#include "picture_reader_test.moc"
