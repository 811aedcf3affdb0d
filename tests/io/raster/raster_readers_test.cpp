// SPDX-License-Identifier: MIT
#include "io/picture/decoding/picture_decoder.h"
#include "io/picture/picture_writers.h"
#include "support/named_test.h"

#include <QBuffer>
#include <QColorSpace>
#include <QImage>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <tiffio.h>

#include <cstring>
#include <stop_token>

#include <sys/resource.h>

using namespace io;
using attractor::Rgba16;
using Depth = PictureFormat::Depth;
using Kind = PictureFormat::Pixels;

namespace {

constexpr int readWidth = 23, readHeight = 17;
const QString damaged = QStringLiteral("The picture is damaged or incomplete.");
const QString unreadable =
    QStringLiteral("The picture stores its pixels in a way that cannot be read. Save it as a PNG picture.");

// Of bytes, not premultiplied; whole alpha or none, so that nothing is rounded.
std::vector<QRgb> randomPixels(bool isOpaque) {
    QRandomGenerator random(11);
    std::vector<QRgb> pixels(readWidth * readHeight);
    for (QRgb& pixel : pixels)
        pixel = isOpaque || random.bounded(3) ? random.generate() | 0xff000000U : 0U;
    return pixels;
}

QByteArray written(PictureFile file, Depth depth, Kind kind, const std::vector<QRgb>& pixels,
                   const QByteArray& system = {}) {
    PictureFormat format;
    format.width = readWidth;
    format.height = readHeight;
    format.depth = depth;
    format.pixels = kind;
    format.systemText = system;
    QBuffer buffer;
    buffer.open(QIODevice::ReadWrite);
    const auto writer = pictureWriter(file, buffer, format);
    Failure failure;
    if (depth == Depth::Bits16) {
        std::vector<Rgba16> words;
        for (const QRgb pixel : pixels) {
            const auto word = [](int code) { return std::uint16_t(code * 257); };
            words.push_back(
                {word(qRed(pixel)), word(qGreen(pixel)), word(qBlue(pixel)), word(qAlpha(pixel))});
        }
        failure = writer->writeRows(words);
    } else {
        failure = writer->writeRows(std::vector<std::uint32_t>(pixels.begin(), pixels.end()));
    }
    return failure || writer->finish() ? QByteArray() : buffer.data();
}

// The kinds of files that have a reader of their own.
const std::vector<std::tuple<const char*, PictureFile, Depth>> readKinds{
    {"WebP", PictureFile::WebP, Depth::Bits8},
    {"TIFF", PictureFile::Tiff, Depth::Bits8},
    {"TIFF of 16 bits", PictureFile::Tiff, Depth::Bits16},
    {"OpenEXR, half", PictureFile::ExrHalf, Depth::Bits16},
    {"OpenEXR, float", PictureFile::ExrFloat, Depth::Bits16},
};

QByteArray little16(int value) {
    QByteArray bytes(2, 0);
    qToLittleEndian(quint16(value), bytes.data());
    return bytes;
}

QByteArray little32(qint64 value) {
    QByteArray bytes(4, 0);
    qToLittleEndian(quint32(value), bytes.data());
    return bytes;
}

// With the value of an entry of the directory exchanged.
QByteArray withTag(QByteArray tiff, int tag, qint64 value) {
    for (const int type : {3, 4}) { // SHORT, LONG
        const QByteArray entry = little16(tag) + little16(type) + little32(1);
        if (const qsizetype at = tiff.lastIndexOf(entry); at >= 0)
            return tiff.replace(at, 12, little16(tag) + little16(4) + little32(1) + little32(value));
    }
    return {};
}

QByteArray withAttribute(QByteArray exr, const QByteArray& nameAndType, const QByteArray& value) {
    const qsizetype at = exr.indexOf(nameAndType);
    return at < 0 ? QByteArray() : exr.replace(at + nameAndType.size() + 4, value.size(), value);
}

const QByteArray dataWindow("dataWindow\0box2i\0", 17), displayWindow("displayWindow\0box2i\0", 20);

QByteArray window(qint64 left, qint64 top, qint64 right, qint64 bottom) {
    return little32(left) + little32(top) + little32(right) + little32(bottom);
}

QByteArray wholeFile(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

// Of one pixel: the bits of each sample, as whole numbers or floating point, and a profile if there is one.
QByteArray tiffOf(const std::vector<std::uint8_t>& pixel, int samples, int format,
                  const QByteArray& profile = {}) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.tif"));
    TIFF* tiff = TIFFOpen(QFile::encodeName(path).constData(), "w");
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 1);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 1);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, samples);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, int(pixel.size()) / samples * 8);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, format);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    if (!profile.isEmpty())
        TIFFSetField(tiff, TIFFTAG_ICCPROFILE, std::uint32_t(profile.size()), profile.constData());
    std::vector<std::uint8_t> row = pixel;
    TIFFWriteScanline(tiff, row.data(), 0, 0);
    TIFFClose(tiff);
    return wholeFile(path);
}

// In grey, with a strip for each row, or tiles of this width and 16 rows: all of them the same bytes, so
// many.
QByteArray greyTiff(int across, int down, int tileWidth, int shared) {
    const int pieces = tileWidth == 0 ? down : (down + 15) / 16;
    QByteArray entries;
    int count = 0;
    const auto add = [&](int tag, qint64 value, int values = 1) {
        entries += little16(tag) + little16(4) + little32(values) + little32(value);
        ++count;
    };
    const bool isTiled = tileWidth != 0;
    const int header = 8, tables = header + 2 + 12 * (isTiled ? 10 : 9) + 4;
    add(TIFFTAG_IMAGEWIDTH, across);
    add(TIFFTAG_IMAGELENGTH, down);
    add(TIFFTAG_BITSPERSAMPLE, 8);
    add(TIFFTAG_COMPRESSION, COMPRESSION_NONE);
    add(TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    if (!isTiled) add(TIFFTAG_STRIPOFFSETS, tables, pieces);
    add(TIFFTAG_SAMPLESPERPIXEL, 1);
    if (!isTiled) {
        add(TIFFTAG_ROWSPERSTRIP, 1);
        add(TIFFTAG_STRIPBYTECOUNTS, tables + 4 * pieces, pieces);
    } else {
        add(TIFFTAG_TILEWIDTH, tileWidth);
        add(TIFFTAG_TILELENGTH, 16);
        add(TIFFTAG_TILEOFFSETS, tables, pieces);
        add(TIFFTAG_TILEBYTECOUNTS, tables + 4 * pieces, pieces);
    }
    const int pixels = tables + 8 * pieces;
    return "II*" + QByteArray(1, 0) + little32(header) + little16(count) + entries + little32(0) +
           little32(pixels).repeated(pieces) + little32(shared).repeated(pieces) + QByteArray(shared, '\x55');
}

// Channels of ½ in the data window.
QByteArray exrOf(const Imf::Header& plain, const std::vector<const char*>& channels) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.exr"));
    Imf::Header header = plain;
    const auto& data = header.dataWindow();
    std::vector<float> values(std::size_t(data.max.x + 1), .5F); // from the origin on, the same for each row
    Imf::FrameBuffer frame;
    for (const char* channel : channels) {
        header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
        frame.insert(channel,
                     Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float), 0));
    }
    {
        Imf::OutputFile file(QFile::encodeName(path).constData(), header);
        file.setFrameBuffer(frame);
        file.writePixels(data.max.y - data.min.y + 1);
    }
    return wholeFile(path);
}

} // namespace

// Pictures that the user gives as WebP, TIFF or OpenEXR.
class RasterReadersTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void pixelsComeBack_data();
    void pixelsComeBack();
    void cutFilesAreRefused_data();
    void cutFilesAreRefused();
    void damagedFilesEndInASentence_data();
    void damagedFilesEndInASentence();
    void hugeHeadersAreRefused_data();
    void hugeHeadersAreRefused();
    void bombsAreRefused();
    void stopsEndReading();
    void whatIsNotReadIsSaid();
    void tiffsAreTurnedUpright_data();
    void tiffsAreTurnedUpright();
    void profilesAreConverted();
    void exrIsSeenInItsDisplayWindow();
    void everySuffixHasAReader();
};

void RasterReadersTest::initTestCase() {
#if !defined(__SANITIZE_ADDRESS__)
    const rlimit twoGigabytes{2UL << 30, 2UL << 30};
    QCOMPARE(setrlimit(RLIMIT_AS, &twoGigabytes), 0);
#endif
}

void RasterReadersTest::pixelsComeBack_data() {
    QTest::addColumn<PictureFile>("file");
    QTest::addColumn<int>("depth");
    QTest::addColumn<bool>("isOpaque");
    for (const auto& [name, file, depth] : readKinds)
        for (const bool isOpaque : {true, false})
            QTest::addRow("%s, %s", name, isOpaque ? "opaque" : "transparent")
                << file << int(depth) << isOpaque;
}

void RasterReadersTest::pixelsComeBack() {
    QFETCH(PictureFile, file);
    QFETCH(int, depth);
    QFETCH(bool, isOpaque);
    const auto pixels = randomPixels(isOpaque);
    const QByteArray bytes = written(file, Depth(depth), isOpaque ? Kind::Opaque : Kind::Transparent, pixels,
                                     "a { .5 0 0 .5 0 0 }");
    const DecodedPicture decoded = decodedPicture(bytes);
    QVERIFY2(!decoded.flaw, qUtf8Printable(decoded.flaw.value_or(QString())));
    QCOMPARE(decoded.image.size(), QSize(readWidth, readHeight));
    const QImage image = decoded.image.convertToFormat(QImage::Format_ARGB32);
    for (int y = 0; y < readHeight; ++y)
        for (int x = 0; x < readWidth; ++x) {
            const QRgb expected = pixels[std::size_t(y * readWidth + x)], found = image.pixel(x, y);
            QCOMPARE(qAlpha(found), qAlpha(expected));
            if (qAlpha(expected) == 0) continue;
            const int tolerance = file == PictureFile::ExrHalf ? 1 : 0; // 11 bits of linear light
            QVERIFY(std::abs(qRed(found) - qRed(expected)) <= tolerance);
            QVERIFY(std::abs(qGreen(found) - qGreen(expected)) <= tolerance);
            QVERIFY(std::abs(qBlue(found) - qBlue(expected)) <= tolerance);
        }
}

void RasterReadersTest::cutFilesAreRefused_data() {
    QTest::addColumn<QByteArray>("whole");
    for (const auto& [name, file, depth] : readKinds)
        QTest::newRow(name) << written(file, depth, Kind::Transparent, randomPixels(false));
}

void RasterReadersTest::cutFilesAreRefused() {
    QFETCH(QByteArray, whole);
    const QImage picture = decodedPicture(whole).image;
    QVERIFY(!picture.isNull());
    constexpr qsizetype magic = 12; // shorter ones are of no kind
    qsizetype refused = 0;
    for (qsizetype size = magic; size < whole.size(); ++size) {
        const DecodedPicture decoded = decodedPicture(whole.first(size));
        // What is behind the pixels, such as the name of the program, may be missing.
        if (decoded.flaw)
            QCOMPARE(*decoded.flaw, damaged);
        else
            QCOMPARE(decoded.image, picture);
        refused += decoded.flaw ? 1 : 0;
    }
    QVERIFY(refused > (whole.size() - magic) * 8 / 10);
}

void RasterReadersTest::damagedFilesEndInASentence_data() {
    cutFilesAreRefused_data();
}

void RasterReadersTest::damagedFilesEndInASentence() {
    QFETCH(QByteArray, whole);
    int refused = 0;
    for (const char change : {'\x55', '\xff', '\x01'})
        for (qsizetype at = 0; at < whole.size(); ++at) {
            QByteArray bytes = whole;
            bytes[at] = char(bytes[at] ^ change);
            const DecodedPicture decoded = decodedPicture(bytes);
            QCOMPARE(decoded.image.isNull(), decoded.flaw.has_value());
            QVERIFY(!decoded.flaw || decoded.flaw->endsWith(u'.'));
            refused += decoded.flaw ? 1 : 0;
        }
    QVERIFY(refused > 0);
}

// Nothing is made room for before it is refused.
void RasterReadersTest::hugeHeadersAreRefused_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("sentence");
    const auto tooLarge = [](qint64 across, qint64 down) {
        return QStringLiteral(
                   "The picture has %1 × %2 pixels. At most 32 million pixels can be read; scale it "
                   "down.")
            .arg(across)
            .arg(down);
    };
    const QByteArray webp = written(PictureFile::WebP, Depth::Bits8, Kind::Opaque, randomPixels(true));
    QByteArray large = webp;
    large.replace(21, 4, little32(16382 | 16382 << 14)); // behind RIFF, WEBP, VP8L and a signature
    QTest::newRow("WebP") << large << tooLarge(16383, 16383);
    const QByteArray tiff = written(PictureFile::Tiff, Depth::Bits8, Kind::Opaque, randomPixels(true));
    QTest::newRow("TIFF") << withTag(withTag(tiff, TIFFTAG_IMAGEWIDTH, 100'000), TIFFTAG_IMAGELENGTH, 100'000)
                          << tooLarge(100'000, 100'000);
    QTest::newRow("long TIFF") << withTag(tiff, TIFFTAG_IMAGELENGTH, 1'000'000) << damaged;
    QTest::newRow("TIFF of 60,000 samples") << withTag(tiff, TIFFTAG_SAMPLESPERPIXEL, 60000) << damaged;
    const QByteArray exr = written(PictureFile::ExrHalf, Depth::Bits16, Kind::Opaque, randomPixels(true));
    QTest::newRow("OpenEXR") << withAttribute(exr, dataWindow, window(0, 0, 999'999, 999'999))
                             << tooLarge(1'000'000, 1'000'000);
    QTest::newRow("display of OpenEXR")
        << withAttribute(exr, displayWindow, window(-1'000'000, 0, 0, 999'999))
        << tooLarge(1'000'001, 1'000'000);
    QTest::newRow("OpenEXR without end")
        << withAttribute(exr, dataWindow, window(-2147483647, 0, 2147483647, 0)) << damaged;
    QTest::newRow("OpenEXR turned inside out")
        << withAttribute(exr, dataWindow, window(9, 9, 0, 0)) << damaged;
    std::vector<QByteArray> names;
    for (int k = 0; k < 40; ++k)
        names.push_back("c" + QByteArray::number(k));
    std::vector<const char*> channels{"R", "G", "B"};
    for (const QByteArray& name : names)
        channels.push_back(name.constData());
    Imf::Header header(8, 8);
    header.compression() = Imf::DWAB_COMPRESSION;
    const QByteArray layers = exrOf(header, channels);
    QTest::newRow("layers of OpenEXR")
        << withAttribute(layers, dataWindow, window(0, 0, 99'999, 299)) << unreadable;
}

void RasterReadersTest::hugeHeadersAreRefused() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, sentence);
    QVERIFY(!bytes.isEmpty());
    for (const LargePicture large : {LargePicture::Refused, LargePicture::Reduced}) {
        const DecodedPicture decoded = decodedPicture(bytes, large);
        QVERIFY(decoded.image.isNull());
        QCOMPARE(decoded.flaw.value_or(QString()), sentence);
    }
}

// Small files that would keep a reader busy for long: rows that share their bytes, tiles that reach far
// beyond the picture, channels that are not seen.
void RasterReadersTest::bombsAreRefused() {
    constexpr int rows = 2000, shared = 900'000;
    QCOMPARE(decodedPicture(greyTiff(1, 100, 0, shared)).flaw.value_or(QString()), QString());
    QCOMPARE(decodedPicture(greyTiff(1, rows, 0, shared)).flaw.value_or(QString()), unreadable);
    QCOMPARE(decodedPicture(greyTiff(1, 4096, 1 << 20, shared)).flaw.value_or(QString()), unreadable);
    std::vector<QByteArray> names;
    for (int k = 0; k < 40; ++k)
        names.push_back("c" + QByteArray::number(k));
    std::vector<const char*> channels{"R", "G", "B"};
    for (const QByteArray& name : names)
        channels.push_back(name.constData());
    const QByteArray layers =
        withAttribute(exrOf(Imf::Header(8, 8), channels), dataWindow, window(0, 0, 999, 31'999));
    QCOMPARE(decodedPicture(layers).flaw.value_or(QString()), unreadable);
}

void RasterReadersTest::stopsEndReading() {
    std::stop_source stop;
    for (const bool isStopped : {false, true}) {
        if (isStopped) stop.request_stop();
        for (const auto& [name, file, depth] : readKinds) {
            const QByteArray bytes = written(file, depth, Kind::Transparent, randomPixels(false));
            const DecodedPicture decoded = decodedPicture(bytes, LargePicture::Refused, stop.get_token());
            QVERIFY2(decoded.flaw.has_value() == isStopped, name);
        }
    }
}

void RasterReadersTest::whatIsNotReadIsSaid() {
    const QByteArray floating = tiffOf(std::vector<std::uint8_t>(12), 3, SAMPLEFORMAT_IEEEFP);
    QCOMPARE(decodedPicture(floating).flaw.value_or(QString()), unreadable);
    for (const int samples : {16, 17}) {
        const QByteArray layers =
            tiffOf(std::vector<std::uint8_t>(std::size_t(samples)), samples, SAMPLEFORMAT_UINT);
        QCOMPARE(decodedPicture(layers).flaw.value_or(QString()), samples > 16 ? unreadable : QString());
    }
    QCOMPARE(decodedPicture(exrOf(Imf::Header(4, 4), {"Z"})).flaw.value_or(QString()), unreadable);
    QByteArray moving =
        written(PictureFile::WebP, Depth::Bits8, Kind::Opaque, randomPixels(true), "a { .5 0 0 .5 0 0 }");
    QCOMPARE(moving.mid(12, 4), QByteArray("VP8X"));
    moving[20] = char(moving[20] | 2); // the flag of an animation
    const QString sentence = decodedPicture(moving).flaw.value_or(QString());
    QVERIFY2(sentence.startsWith(QStringLiteral("The picture is animated.")), qUtf8Printable(sentence));
}

void RasterReadersTest::tiffsAreTurnedUpright_data() {
    QTest::addColumn<int>("orientation");
    QTest::addColumn<QPoint>("first");  // where the first pixel of the file is seen
    QTest::addColumn<QPoint>("second"); // and the one right of it
    const int right = readWidth - 1, bottom = readHeight - 1;
    QTest::newRow("top left") << 1 << QPoint(0, 0) << QPoint(1, 0);
    QTest::newRow("top right") << 2 << QPoint(right, 0) << QPoint(right - 1, 0);
    QTest::newRow("bottom right") << 3 << QPoint(right, bottom) << QPoint(right - 1, bottom);
    QTest::newRow("bottom left") << 4 << QPoint(0, bottom) << QPoint(1, bottom);
    QTest::newRow("left top") << 5 << QPoint(0, 0) << QPoint(0, 1);
    QTest::newRow("right top") << 6 << QPoint(bottom, 0) << QPoint(bottom, 1);
    QTest::newRow("right bottom") << 7 << QPoint(bottom, right) << QPoint(bottom, right - 1);
    QTest::newRow("left bottom") << 8 << QPoint(0, right) << QPoint(0, right - 1);
}

void RasterReadersTest::tiffsAreTurnedUpright() {
    QFETCH(int, orientation);
    QFETCH(QPoint, first);
    QFETCH(QPoint, second);
    std::vector<QRgb> pixels(readWidth * readHeight, qRgb(9, 9, 9));
    pixels[0] = qRgb(255, 0, 0);
    pixels[1] = qRgb(0, 0, 255);
    QByteArray tiff = written(PictureFile::Tiff, Depth::Bits8, Kind::Opaque, pixels);
    const QByteArray entry = little16(TIFFTAG_ORIENTATION) + little16(3) + little32(1);
    const qsizetype at = tiff.lastIndexOf(entry);
    QVERIFY(at > 0);
    tiff.replace(at + entry.size(), 2, little16(orientation));
    const DecodedPicture decoded = decodedPicture(tiff);
    QVERIFY(!decoded.flaw);
    QCOMPARE(decoded.image.size(),
             orientation > 4 ? QSize(readHeight, readWidth) : QSize(readWidth, readHeight));
    QCOMPARE(decoded.image.pixel(first), pixels[0]);
    QCOMPARE(decoded.image.pixel(second), pixels[1]);
}

// Of linear light, as a TIFF of a photographer may be.
void RasterReadersTest::profilesAreConverted() {
    const QByteArray profile = QColorSpace(QColorSpace::SRgbLinear).iccProfile();
    constexpr std::uint8_t light = 55; // of 255, which is 128 in sRGB
    const DecodedPicture decoded =
        decodedPicture(tiffOf({light, light, light}, 3, SAMPLEFORMAT_UINT, profile));
    QVERIFY(!decoded.flaw);
    QVERIFY(std::abs(qGreen(decoded.image.pixel(0, 0)) - 128) <= 1);
}

// The data reach out of it to the left, and leave the rest of it empty.
void RasterReadersTest::exrIsSeenInItsDisplayWindow() {
    using Imath::Box2i;
    using Imath::V2i;
    const Imf::Header header(Box2i(V2i(10, 20), V2i(15, 23)), Box2i(V2i(8, 21), V2i(12, 22)));
    for (const auto& channels : {std::vector<const char*>{"R", "G", "B"}, {"Y"}}) {
        const DecodedPicture decoded = decodedPicture(exrOf(header, channels));
        QVERIFY(!decoded.flaw);
        QCOMPARE(decoded.image.size(), QSize(6, 4));
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 6; ++x) {
                const bool isFilled = x <= 2 && (y == 1 || y == 2);
                QCOMPARE(qAlpha(decoded.image.pixel(x, y)), isFilled ? 255 : 0);
                if (isFilled) QCOMPARE(qGreen(decoded.image.pixel(x, y)), 188); // ½ of linear light
            }
    }
}

void RasterReadersTest::everySuffixHasAReader() {
    for (const QString& suffix : pictureSuffixes()) {
        const auto file = pictureFileOf(suffix);
        QByteArray bytes;
        if (suffix == u"gif") {
            bytes = QByteArray::fromHex("47494638396101000100800000ff0000000000"
                                        "2c00000000010001000002024401003b");
        } else if (file) {
            const bool isExr = *file == PictureFile::ExrHalf;
            bytes = written(*file, isExr ? Depth::Bits16 : Depth::Bits8, Kind::Opaque, randomPixels(true));
        } else {
            QBuffer buffer(&bytes);
            QImage image(3, 3, QImage::Format_RGB32);
            image.fill(Qt::red);
            const QString format = suffix == u"pnm" ? QStringLiteral("ppm") : suffix;
            QVERIFY(image.save(&buffer, format.toUpper().toLatin1().constData()));
        }
        const DecodedPicture decoded = decodedPicture(bytes);
        QVERIFY2(!decoded.flaw && !decoded.image.isNull(), qUtf8Printable(suffix));
    }
}

BARYCAGE_TEST(RasterReadersTest, QCoreApplication);
#include "raster_readers_test.moc"
