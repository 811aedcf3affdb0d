// SPDX-License-Identifier: MIT
#include "io/tops/picture_reader.h"

#include "attractor/colour/srgb_transfer.h"
#include "io/picture/decoding/picture_decoder.h"
#include "support/named_test.h"

#include <QBuffer>
#include <QColorSpace>
#include <QImage>
#include <QImageWriter>
#include <QRandomGenerator>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

#include <algorithm>
#include <cmath>
#include <stop_token>
#include <sys/resource.h>
#include <vector>
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
    void swollenPngsAreRefused();
    void swollenGifsAreRefused();
    void stopsEndReading();
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

QByteArray chunkOf(const QByteArray& type, const QByteArray& data) {
    const QByteArray checked = type + data;
    QByteArray length(4, '\0'), checksum(4, '\0');
    qToBigEndian(quint32(data.size()), length.data());
    qToBigEndian(
        quint32(::crc32(0, reinterpret_cast<const Bytef*>(checked.constData()), uInt(checked.size()))),
        checksum.data());
    return length + checked + checksum;
}

// 64 MB of zeros, compressed such that it may stand anywhere in a stream, any number of times.
QByteArray zeros() {
    z_stream stream{};
    deflateInit2(&stream, 9, Z_DEFLATED, -15, 9, Z_DEFAULT_STRATEGY);
    QByteArray plain(1 << 20, '\0'), packed(1 << 17, '\0');
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = uInt(packed.size());
    for (int k = 0; k < 64; ++k) {
        stream.next_in = reinterpret_cast<Bytef*>(plain.data());
        stream.avail_in = uInt(plain.size());
        deflate(&stream, k < 63 ? Z_NO_FLUSH : Z_FULL_FLUSH);
    }
    packed.truncate(packed.size() - qsizetype(stream.avail_out));
    deflateEnd(&stream);
    return packed;
}

// A GIF of two colours of which all pixels are of the first, and that goes on with so many of the longest
// codes.
QByteArray flatGif(int side, int more) {
    QByteArray codes;
    quint32 bits = 0;
    int count = 0, size = 3;
    const auto put = [&](int code) {
        bits |= quint32(code) << count;
        for (count += size; count >= 8; count -= 8, bits >>= 8)
            codes += char(bits);
    };
    constexpr int clear = 4, end = 5;
    int next = clear + 2;
    const auto putAndLearn = [&](int code) { // as readers do, from the second code on
        put(code);
        if (next < 4096 && ++next == 1 << size && size < 12) ++size;
    };
    put(clear);
    put(0);
    int left = side * side - 1;
    for (int length = 2; left >= length && next < 4096; left -= length++)
        putAndLearn(next); // one more than the code before
    const int longest = next - 1;
    for (; left > 0; --left)
        putAndLearn(0);
    for (int k = 0; k < more; ++k)
        putAndLearn(longest);
    put(end);
    codes += char(bits);
    QByteArray gif = QByteArray::fromHex("474946383961") + QByteArray(4, '\0') +
                     QByteArray::fromHex("800000ff000000000021f9040000000000") + "\x2c" +
                     QByteArray(9, '\0') + '\2';
    for (const int at : {6, 8, 32, 34})
        qToLittleEndian(quint16(side), gif.data() + at);
    for (qsizetype at = 0; at < codes.size(); at += 255) {
        const QByteArray block = codes.mid(at, 255);
        gif += char(block.size()) + block;
    }
    return gif + QByteArray(1, '\0') + ';';
}

QImage noise(int width, int height) {
    QRandomGenerator random(7);
    QImage image(width, height, QImage::Format_RGB32);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.setPixel(x, y, random.generate() | 0xff000000U);
    return image;
}

const QString damagedSentence = QStringLiteral("The picture is damaged or incomplete.");

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
    const QByteArray chunk = chunkOf("zTXt", "key" + QByteArray(2, '\0') + text);
    constexpr int headerEnd = 33;
    QByteArray bytes = png(colours());
    bytes.insert(headerEnd, chunk.repeated(100));
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

// One pixel, and behind it a gigabyte that the library would unpack. A picture of its size that needs all
// that it has is read.
void PictureReaderTest::swollenPngsAreRefused() {
    QByteArray bytes = png(colours());
    const qsizetype data = bytes.indexOf("IDAT") - 4;
    const QByteArray stream = QByteArray::fromHex("789c") + zeros().repeated(20);
    QVERIFY(stream.size() > 1 << 20);
    bytes = bytes.first(data) + chunkOf("IDAT", stream) + chunkOf("IEND", {});
    QCOMPARE(io::decodedPicture(bytes).flaw.value_or(QString()), damagedSentence);
    QCOMPARE(io::decodedFrame(bytes).flaw.value_or(QString()), damagedSentence);
    const QImage image = noise(900, 600);
    const QByteArray whole = png(image);
    QVERIFY(whole.size() > 1 << 20);
    QCOMPARE(io::decodedPicture(whole).image.convertToFormat(QImage::Format_RGB32), image);
    QCOMPARE(io::decodedFrame(whole).image.convertToFormat(QImage::Format_RGB32), image);
}

void PictureReaderTest::swollenGifsAreRefused() {
    for (const int side : {1, 50, 1000}) {
        const io::DecodedPicture flat = io::decodedPicture(flatGif(side, 0));
        QVERIFY2(!flat.flaw, qPrintable(flat.flaw.value_or(QString())));
        QCOMPARE(flat.image.size(), QSize(side, side));
        for (const int at : {0, side / 2, side - 1})
            QCOMPARE(flat.image.pixel(at, at), qRgb(255, 0, 0));
    }
    QCOMPARE(io::decodedPicture(flatGif(1000, 20'000)).flaw.value_or(QString()), damagedSentence);
}

void PictureReaderTest::stopsEndReading() {
    std::stop_source stop;
    const QImage image = noise(200, 100);
    std::vector<QByteArray> pictures{flatGif(300, 0)};
    for (const char* format : {"PNG", "JPEG", "BMP", "PPM", "PGM", "PBM"}) {
        QBuffer buffer;
        buffer.open(QIODevice::WriteOnly);
        QVERIFY(image.save(&buffer, format));
        pictures.push_back(buffer.data());
    }
    for (const QByteArray& bytes : pictures)
        QVERIFY(!io::decodePicture(bytes, stop.get_token()).failure);
    stop.request_stop();
    for (const QByteArray& bytes : pictures)
        QVERIFY2(io::decodePicture(bytes, stop.get_token()).failure, bytes.first(4).constData());
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
